//! Long clip of everyday motion.

use crate::actions::{Action, Actor};
use crate::character::Decimals;
use crate::generate::ClipSpec;
use crate::motion::Motion;

/// Action, probability and range of durations in seconds.
const ACTIONS: [(Action, f64, [f64; 2]); 10] = [
    (Action::Walk, 0.36, [4.0, 20.0]),
    (Action::Stand, 0.24, [1.0, 9.0]),
    (Action::Turn, 0.14, [2.0, 3.0]),
    (Action::Jog, 0.10, [4.0, 14.0]),
    (Action::SideSteps, 0.04, [4.0, 6.0]),
    (Action::Stretch, 0.03, [6.0, 10.0]),
    (Action::Squat, 0.03, [2.0, 8.0]),
    (Action::Jump, 0.02, [2.0, 5.0]),
    (Action::Kick, 0.02, [2.0, 5.0]),
    (Action::Box, 0.02, [5.0, 12.0]),
];

/// Returns a clip at 120 Hz of walking, standing, turning, jogging and occasional other actions. It
/// is written with six decimals like the files of recording software: an hour has 432,000 frames
/// and more than 200 MB.
pub fn long_mix(frames: usize, noise_level: f64) -> ClipSpec {
    let motion = Motion::from_actions(1.0, |actor, seconds| {
        while actor.now() < seconds + 2.0 {
            random_action(actor);
        }
    });
    let mut spec = ClipSpec::new("long", "emil", motion, frames, 120, noise_level);
    spec.character.decimals = Decimals::Six;
    spec
}

fn random_action(actor: &mut Actor) {
    let mut chance = actor.random.uniform(0.0, 1.0);
    for (action, probability, [least, most]) in ACTIONS {
        chance -= probability;
        if chance < 0.0 {
            let seconds = actor.random.uniform(least, most);
            actor.perform(action, seconds);
            return;
        }
    }
}
