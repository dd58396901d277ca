//! Clips of several actions with known cuts.

use crate::actions::{Action, ActionInterval, Actor};
use crate::character::character;
use crate::generate::{ClipSpec, Generated, generate, stream};
use crate::motion::Motion;

/// Actions that are performed one after another.
#[derive(Clone, Debug, PartialEq)]
pub struct ActionSequence {
    /// Name of the clip.
    pub name: String,
    /// Name of the character.
    pub character_name: &'static str,
    /// Actions with their approximate durations, in seconds.
    pub actions: Vec<(Action, f64)>,
}

/// A generated clip of several actions.
#[derive(Clone, Debug, PartialEq)]
pub struct ActionClip {
    /// The clip with its plants.
    pub generated: Generated,
    /// The actions in order.
    pub actions: Vec<Action>,
    /// Cuts between consecutive actions; one fewer than actions.
    pub cuts: Vec<Cut>,
}

/// Tolerance interval of the cut between two actions, in frames.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cut {
    /// First acceptable frame of the cut: the previous action has ended.
    pub earliest: usize,
    /// Middle of the transition.
    pub middle: usize,
    /// Last acceptable frame of the cut: the next action has begun.
    pub latest: usize,
}

/// Frame rate, in Hz.
const RATE: usize = 120;

/// Standing time before the clip begins, in seconds.
const LEAD_IN: f64 = 1.0;

/// Time at the start and the end of an action with almost no movement, in seconds.
const QUIET: f64 = 0.25;

/// Generates the clip of `sequence` at 120 Hz, planned as one motion. `seed` determines the
/// variation of the steps; `noise_level` is the factor on the character's foot noise.
///
/// Walking and jogging change into each other within a few steps. Between all other actions the
/// actor stands still for a moment.
///
/// # Panics
/// If the sequence has no actions or the character is unknown.
pub fn generate_sequence(sequence: &ActionSequence, seed: u64, noise_level: f64) -> ActionClip {
    let ActionSequence { name, character_name, actions } = sequence;
    // The actions are planned twice: once for their times and once for the clip.
    let mut random = stream(name, seed, "motion");
    let mut actor = Actor::standing(&character(character_name).proportions, &mut random, -LEAD_IN);
    let intervals = perform(&mut actor, actions);
    let end = intervals.last().expect("at least one action").end;

    let frame = |time: f64| (time * RATE as f64).round() as usize;
    let cut = |pair: &[ActionInterval]| {
        let (from, to) = (pair[0].end - QUIET, pair[1].start + QUIET);
        Cut { earliest: frame(from), middle: frame((from + to) / 2.0), latest: frame(to) }
    };
    let planned = actions.clone();
    let motion = Motion::from_actions(LEAD_IN, move |actor, _| {
        perform(actor, &planned);
    });
    let spec = ClipSpec::new(name, character_name, motion, frame(end), RATE, noise_level);
    ActionClip {
        generated: generate(&spec, seed),
        actions: actions.iter().map(|&(action, _)| action).collect(),
        cuts: intervals.windows(2).map(cut).collect(),
    }
}

/// Performs the actions in order and stops.
fn perform(actor: &mut Actor, actions: &[(Action, f64)]) -> Vec<ActionInterval> {
    actor.wait(LEAD_IN);
    let intervals = actions.iter().map(|&(action, seconds)| actor.perform(action, seconds)).collect();
    actor.stop();
    intervals
}

/// Returns ten sequences of four to eight actions, 20 to 60 s each, that cover all characters.
pub fn action_sequences() -> Vec<ActionSequence> {
    use Action::*;
    let sequence = |number: usize, character_name, actions: &[(Action, f64)]| ActionSequence {
        name: format!("sequence-{number:02}"),
        character_name,
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
