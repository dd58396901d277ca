//! Joint rotations, computed from pelvis and feet.

mod leg;
mod upper_body;

pub use leg::{MAX_LEG_EXTENSION, apply_leg_pose, solve_leg};
pub use upper_body::{IdleNoise, solve_upper_body};

use crate::character::{BONE_COUNT, Bone};
use crate::math::{Rot, Vec3};

/// Pose: position of the pelvis and rotation of each bone relative to its parent.
#[derive(Clone, Debug, PartialEq)]
pub struct Pose {
    /// Position of the pelvis joint, in metres.
    pub root: Vec3,
    rotations: [Rot; BONE_COUNT],
}

impl Pose {
    /// Returns the T-pose with the pelvis at `root`.
    pub fn t_pose(root: Vec3) -> Pose {
        Pose { root, rotations: [Rot::identity(); BONE_COUNT] }
    }

    /// Returns the rotation of `bone` relative to its parent.
    pub fn rotation(&self, bone: Bone) -> Rot {
        self.rotations[bone.index()]
    }

    /// Sets the rotation of `bone` relative to its parent.
    pub fn set_rotation(&mut self, bone: Bone, rotation: Rot) {
        self.rotations[bone.index()] = rotation;
    }
}
