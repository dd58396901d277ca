//! A long mix of everyday motion.

use crate::act::{Action, Actor};
use crate::character::Decimals;
use crate::motion::Motion;
use crate::recipe::Recipe;

/// What happens in a long recording, how often, and for how many seconds.
const DAY: [(Action, f64, [f64; 2]); 10] = [
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

/// A long recording at 120 Hz: walking, standing, turning, jogging, now and then something
/// else. It is written with six decimals, as recording software does: an hour has 432,000 frames
/// and more than 200 MB.
pub fn long(frames: usize, noise_level: f64) -> Recipe {
    let motion = Motion::acted(1.0, |actor, seconds| {
        while actor.now() < seconds + 2.0 {
            something(actor);
        }
    });
    let mut recipe = Recipe::new("long", "emil", motion, frames, 120, noise_level);
    recipe.character.decimals = Decimals::Six;
    recipe
}

fn something(actor: &mut Actor) {
    let mut chance = actor.random.between(0.0, 1.0);
    for (action, share, [least, most]) in DAY {
        chance -= share;
        if chance < 0.0 {
            let seconds = actor.random.between(least, most);
            actor.perform(action, seconds);
            return;
        }
    }
}
