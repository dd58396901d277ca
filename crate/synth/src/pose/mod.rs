//! From pelvis and feet to the turn of every joint.

mod leg;
mod upper;

pub use leg::{STRETCH_LIMIT, hold, leg};
pub use upper::{Restlessness, upper};

use crate::character::{BONE_COUNT, Bone};
use crate::maths::{Rot, Vec3};

/// A pose: where the pelvis is and how each bone is turned against its parent.
#[derive(Clone, Debug, PartialEq)]
pub struct Pose {
    /// The pelvis joint, in metres.
    pub root: Vec3,
    turns: [Rot; BONE_COUNT],
}

impl Pose {
    /// The T-pose with the pelvis at `root`.
    pub fn rest(root: Vec3) -> Pose {
        Pose { root, turns: [Rot::identity(); BONE_COUNT] }
    }

    /// The turn of `bone` against its parent.
    pub fn turn(&self, bone: Bone) -> Rot {
        self.turns[bone.index()]
    }

    /// Turns `bone` against its parent.
    pub fn set(&mut self, bone: Bone, turn: Rot) {
        self.turns[bone.index()] = turn;
    }
}
