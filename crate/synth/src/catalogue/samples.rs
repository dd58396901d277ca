//! The clips in `samples/`.

use crate::generate::ClipSpec;
use crate::motion::{Motion, PlanFn};
use crate::sample_motions;

/// Returns the thirteen sample clips. `noise_level` is the factor on the characters' foot noise.
///
/// Motions, lengths and frame rates are those of the files in table 2 of the plant detector's
/// paper.
pub fn samples(noise_level: f64) -> Vec<ClipSpec> {
    let spec = |name, character_name, motion: PlanFn, frames, rate| {
        ClipSpec::new(name, character_name, Motion::from_plan(motion), frames, rate, noise_level)
    };
    vec![
        spec("frog-jumps", "ada", sample_motions::frog_jumps, 500, 30),
        spec("curved-walk", "ben", sample_motions::curved_walk, 245, 120),
        spec("run-and-jump", "ben", sample_motions::run_and_jump, 370, 120),
        spec("drunken-stagger", "chen", sample_motions::drunken_stagger, 791, 24),
        ClipSpec {
            leading_t_pose: true,
            ..spec("straight-jog", "chen", sample_motions::straight_jog, 361, 24)
        },
        spec("foot-drag-walk", "dora", sample_motions::foot_drag_walk, 1000, 120),
        spec("modern-dance", "emil", sample_motions::modern_dance, 300, 60),
        spec("bowling", "gus", sample_motions::bowling, 316, 30),
        spec("ballet", "fay", sample_motions::ballet, 298, 24),
        spec("limp-to-run", "fay", sample_motions::limp_to_run, 744, 24),
        spec("one-leg-hop", "fay", sample_motions::one_leg_hop, 336, 24),
        spec("skipping", "fay", sample_motions::skipping, 462, 24),
        spec("sword-and-shield", "hana", sample_motions::sword_and_shield, 171, 30),
    ]
}
