//! Skeletons of every kind, whose roles, up axis and unit are known.
//!
//! A [`Rig`] combines a naming convention, extra bones, a posture, axes and a unit at random.
//! [`generate`] builds it and lets it move.

mod bone;
mod motion;
mod names;
mod posture;
mod skeleton;
mod spec;

use plantigrade::bvh::Clip;
use plantigrade::skeleton::Role;

use crate::math::Random;
pub use names::NAMINGS;
pub use posture::Posture;
pub use spec::{BodyKind, Rig};

/// A generated clip with what is true of it.
pub struct GeneratedRig {
    /// The clip.
    pub clip: Clip,
    /// Joints of the roles, several where each is right.
    pub roles: Vec<(Role, Vec<usize>)>,
    /// Joints of arms, hands, fingers, fore limbs and other parts that are no leg.
    pub no_legs: Vec<usize>,
}

/// Builds a rig and lets it move.
pub fn generate(rig: &Rig, seed: u64) -> GeneratedRig {
    let built = skeleton::build(rig);
    let clip = motion::animate(rig, &built, &mut Random::new(seed, "rig motion"));
    let roles = built.roles(rig);
    let no_legs = built.no_legs();
    GeneratedRig { clip, roles, no_legs }
}
