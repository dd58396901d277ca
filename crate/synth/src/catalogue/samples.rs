//! The clips of `samples/`.

use crate::motion::{self, Motion, Written};
use crate::recipe::Recipe;

/// The thirteen sample clips, their characters' noise `noise_level` times as strong.
///
/// Motions, lengths and rates are those of the files that the plant detector's paper
/// reports one by one (its table 2).
pub fn catalogue(noise_level: f64) -> Vec<Recipe> {
    let recipe = |name, performer, motion: Written, frames, rate| {
        Recipe::new(name, performer, Motion::new(motion), frames, rate, noise_level)
    };
    vec![
        recipe("frog-jumps", "ada", motion::frog_jumps, 500, 30),
        recipe("curved-walk", "ben", motion::curved_walk, 245, 120),
        recipe("run-and-jump", "ben", motion::run_and_jump, 370, 120),
        recipe("drunken-stagger", "chen", motion::drunken_stagger, 791, 24),
        Recipe { leading_t_pose: true, ..recipe("straight-jog", "chen", motion::straight_jog, 361, 24) },
        recipe("foot-drag-walk", "dora", motion::foot_drag_walk, 1000, 120),
        recipe("modern-dance", "emil", motion::modern_dance, 300, 60),
        recipe("bowling", "gus", motion::bowling, 316, 30),
        recipe("ballet", "fay", motion::ballet, 298, 24),
        recipe("limp-to-run", "fay", motion::limp_to_run, 744, 24),
        recipe("one-leg-hop", "fay", motion::one_leg_hop, 336, 24),
        recipe("skipping", "fay", motion::skipping, 462, 24),
        recipe("sword-and-shield", "hana", motion::sword_and_shield, 171, 30),
    ]
}
