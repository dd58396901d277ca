//! Several actions in one clip, with the cuts between them known.

use crate::act::{Action, Actor, Performed};
use crate::character::character;
use crate::motion::Motion;
use crate::recipe::{Generated, Recipe, generate, stream};

/// Actions to be done in a row.
#[derive(Clone, Debug, PartialEq)]
pub struct Sequence {
    /// The clip's name.
    pub name: String,
    /// Who acts: the name of a performer.
    pub performer: &'static str,
    /// What is done, each for about how many seconds.
    pub actions: Vec<(Action, f64)>,
}

/// A clip of several actions.
#[derive(Clone, Debug, PartialEq)]
pub struct Chain {
    /// The clip with its plants.
    pub generated: Generated,
    /// The actions in order.
    pub actions: Vec<Action>,
    /// Where each action but the last goes over into the next.
    pub cuts: Vec<Cut>,
}

/// Where one action goes over into the next: frames.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cut {
    /// The first frame that can be called the cut: the action before is done.
    pub earliest: usize,
    /// The frame in the middle.
    pub middle: usize,
    /// The last frame that can be called the cut: the action after is under way.
    pub latest: usize,
}

/// Frames per second of chains.
const RATE: usize = 120;

/// Seconds before the clip begins in which the actor stands.
const BEFORE: f64 = 1.0;

/// Seconds at the end and at the beginning of an action in which hardly anything moves.
const QUIET: f64 = 0.25;

/// The clip of `sequence` at 120 Hz, planned as one motion; another `seed` gives other
/// steps. The noise of the feet is `noise_level` times that of the performer.
///
/// Walking and jogging go over into each other within some steps; in all else the actor
/// comes to rest for a moment between two actions.
///
/// # Panics
/// If the sequence has no actions, or its performer is unknown.
pub fn chained(sequence: &Sequence, seed: u64, noise_level: f64) -> Chain {
    let Sequence { name, performer, actions } = sequence;
    // The plan is written twice: here to know the times, and again for the clip.
    let mut random = stream(name, seed, "motion");
    let mut actor = Actor::standing(&character(performer).build, &mut random, -BEFORE);
    let performed = perform(&mut actor, actions);
    let end = performed.last().expect("at least one action").end;

    let frame = |time: f64| (time * RATE as f64).round() as usize;
    let cut = |pair: &[Performed]| {
        let (from, to) = (pair[0].end - QUIET, pair[1].begin + QUIET);
        Cut { earliest: frame(from), middle: frame((from + to) / 2.0), latest: frame(to) }
    };
    let planned = actions.clone();
    let motion = Motion::acted(BEFORE, move |actor, _| {
        perform(actor, &planned);
    });
    let recipe = Recipe::new(name, performer, motion, frame(end), RATE, noise_level);
    Chain {
        generated: generate(&recipe, seed),
        actions: actions.iter().map(|&(action, _)| action).collect(),
        cuts: performed.windows(2).map(cut).collect(),
    }
}

/// Does one action after the other and comes to rest.
fn perform(actor: &mut Actor, actions: &[(Action, f64)]) -> Vec<Performed> {
    actor.wait(BEFORE);
    let performed = actions.iter().map(|&(action, seconds)| actor.perform(action, seconds)).collect();
    actor.stop();
    performed
}

/// Ten sequences of four to eight actions, 20 to 60 s each, by all performers.
pub fn sequences() -> Vec<Sequence> {
    use Action::*;
    let sequence = |number: usize, performer, actions: &[(Action, f64)]| Sequence {
        name: format!("sequence-{number:02}"),
        performer,
        actions: actions.to_vec(),
    };
    vec![
        sequence(1, "ada", &[(Walk, 6.0), (Jump, 5.0), (Walk, 4.0), (Kick, 6.0), (Box, 7.0)]),
        sequence(
            2,
            "ben",
            &[(Walk, 5.0), (Jog, 7.0), (Walk, 5.0), (Stretch, 8.0), (Squat, 7.0), (Walk, 4.0)],
        ),
        sequence(3, "chen", &[(Stand, 4.0), (SwingArms, 6.0), (Jacks, 7.0), (Hop, 5.0)]),
        sequence(
            4,
            "dora",
            &[(Box, 9.0), (Turn, 2.0), (Walk, 6.0), (Squat, 7.0), (Jump, 6.0), (Stretch, 8.0)],
        ),
        sequence(5, "emil", &[(Jog, 8.0), (Crouch, 6.0), (Jog, 6.0), (Kick, 7.0), (SideSteps, 6.0)]),
        sequence(
            6,
            "fay",
            &[
                (Walk, 6.0),
                (Squat, 5.0),
                (Walk, 5.0),
                (Hop, 5.0),
                (Jog, 7.0),
                (Stand, 4.0),
                (SwingArms, 6.0),
                (Jacks, 6.0),
            ],
        ),
        sequence(7, "gus", &[(Stretch, 9.0), (SideSteps, 6.0), (Box, 8.0), (Walk, 5.0), (Jump, 5.0)]),
        sequence(8, "hana", &[(Hop, 5.0), (Jacks, 6.0), (Squat, 7.0), (Kick, 7.0), (Walk, 6.0), (Turn, 2.0)]),
        sequence(9, "ben", &[(Crouch, 7.0), (Walk, 6.0), (Jog, 6.0), (Walk, 5.0)]),
        sequence(
            10,
            "emil",
            &[
                (Stand, 5.0),
                (Walk, 6.0),
                (SwingArms, 7.0),
                (Jump, 6.0),
                (Box, 8.0),
                (Jog, 6.0),
                (Stretch, 8.0),
            ],
        ),
    ]
}
