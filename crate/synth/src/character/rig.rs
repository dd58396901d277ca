//! Skeleton in the generator's coordinates: metres, y up, z forward, x left, T-pose as the rest
//! pose.

use plantigrade::foot::Side;

use super::Proportions;
use crate::math::Vec3;

/// A bone, identified by the joint that rotates it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bone {
    /// The pelvis: the root.
    Hips,
    /// A spine joint, counted from the bottom.
    Spine(usize),
    /// The neck.
    Neck,
    /// The head.
    Head,
    /// The collar bone.
    Clavicle(Side),
    /// The upper arm, rotated by the shoulder.
    UpperArm(Side),
    /// The forearm, rotated by the elbow.
    Forearm(Side),
    /// The hand, rotated by the wrist.
    Hand(Side),
    /// The thigh, rotated by the hip joint.
    Thigh(Side),
    /// The shank, rotated by the knee.
    Shank(Side),
    /// The foot, rotated by the ankle.
    Foot(Side),
    /// The toes, rotated at the ball of the foot.
    Toe(Side),
}

/// Number of bone indices; see [`Bone::index`].
pub const BONE_COUNT: usize = 22;

impl Bone {
    /// Returns the index of the bone, less than [`BONE_COUNT`].
    pub fn index(self) -> usize {
        let pair = |first: usize, side: Side| first + usize::from(side == Side::Right);
        match self {
            Bone::Hips => 0,
            Bone::Spine(n) => 1 + n,
            Bone::Neck => 4,
            Bone::Head => 5,
            Bone::Clavicle(side) => pair(6, side),
            Bone::UpperArm(side) => pair(8, side),
            Bone::Forearm(side) => pair(10, side),
            Bone::Hand(side) => pair(12, side),
            Bone::Thigh(side) => pair(14, side),
            Bone::Shank(side) => pair(16, side),
            Bone::Foot(side) => pair(18, side),
            Bone::Toe(side) => pair(20, side),
        }
    }

    /// Iterates over all bones that a body may have.
    pub fn all() -> impl Iterator<Item = Bone> {
        let sided = [Bone::Clavicle, Bone::UpperArm, Bone::Forearm, Bone::Hand]
            .into_iter()
            .chain([Bone::Thigh, Bone::Shank, Bone::Foot, Bone::Toe])
            .flat_map(|bone: fn(Side) -> Bone| Side::BOTH.map(bone));
        [Bone::Hips, Bone::Neck, Bone::Head].into_iter().chain((0..3).map(Bone::Spine)).chain(sided)
    }
}

/// A joint or an end site of the rig.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigJoint {
    /// The bone that the joint rotates; `None` for an end site.
    pub bone: Option<Bone>,
    /// Index of the parent joint; `None` for the root.
    pub parent: Option<usize>,
    /// Rest position relative to the parent, in metres.
    pub offset: Vec3,
}

/// A skeleton in depth-first order: legs, spine, head, arms.
#[derive(Clone, Debug, PartialEq)]
pub struct Rig {
    /// Joints and end sites, parents before children.
    pub joints: Vec<RigJoint>,
}

impl Rig {
    /// Creates the skeleton of a body with 2 or 3 spine joints.
    pub fn new(proportions: &Proportions, spine_joints: usize) -> Rig {
        let mut rig = Rig { joints: Vec::new() };
        let hips = rig.add(Some(Bone::Hips), None, Vec3::zeros());
        for side in Side::BOTH {
            rig.add_leg(proportions, side, hips);
        }
        let mut spine = hips;
        for n in 0..spine_joints {
            let rise = if n == 0 { 0.2 } else { 0.48 / (spine_joints - 1) as f64 };
            spine = rig.add(Some(Bone::Spine(n)), Some(spine), Vec3::new(0.0, rise * proportions.trunk, 0.0));
        }
        let neck = rig.add(Some(Bone::Neck), Some(spine), Vec3::new(0.0, 0.32 * proportions.trunk, 0.0));
        let head = Vec3::new(0.0, 0.33 * proportions.head, 0.06 * proportions.head);
        let head = rig.add(Some(Bone::Head), Some(neck), head);
        rig.add(None, Some(head), Vec3::new(0.0, 0.67 * proportions.head, 0.0));
        for side in Side::BOTH {
            rig.add_arm(proportions, side, spine);
        }
        rig
    }

    fn add_leg(&mut self, proportions: &Proportions, side: Side, hips: usize) {
        let out = lateral_sign(side);
        let hip = Vec3::new(out * proportions.hip, -proportions.pelvis_above_hips(), 0.0);
        let thigh = self.add(Some(Bone::Thigh(side)), Some(hips), hip);
        let shank = self.add(Some(Bone::Shank(side)), Some(thigh), Vec3::new(0.0, -proportions.thigh, 0.0));
        let foot = self.add(Some(Bone::Foot(side)), Some(shank), Vec3::new(0.0, -proportions.shank, 0.0));
        let ball = Vec3::new(0.0, proportions.ball - proportions.ankle, proportions.instep);
        let toe = self.add(Some(Bone::Toe(side)), Some(foot), ball);
        self.add(None, Some(toe), Vec3::new(0.0, -0.4 * proportions.ball, proportions.toes));
    }

    fn add_arm(&mut self, proportions: &Proportions, side: Side, chest: usize) {
        let out = lateral_sign(side);
        let collar = Vec3::new(out * 0.15 * proportions.shoulder, 0.24 * proportions.trunk, 0.0);
        let along = |length: f64| Vec3::new(out * length, 0.0, 0.0);
        let clavicle = self.add(Some(Bone::Clavicle(side)), Some(chest), collar);
        let shoulder = along(0.85 * proportions.shoulder);
        let upper_arm = self.add(Some(Bone::UpperArm(side)), Some(clavicle), shoulder);
        let forearm = self.add(Some(Bone::Forearm(side)), Some(upper_arm), along(proportions.upper_arm));
        let hand = self.add(Some(Bone::Hand(side)), Some(forearm), along(proportions.forearm));
        self.add(None, Some(hand), along(proportions.hand));
    }

    fn add(&mut self, bone: Option<Bone>, parent: Option<usize>, offset: Vec3) -> usize {
        self.joints.push(RigJoint { bone, parent, offset });
        self.joints.len() - 1
    }
}

/// Returns 1 for the left side and −1 for the right.
pub(crate) fn lateral_sign(side: Side) -> f64 {
    match side {
        Side::Left => 1.0,
        Side::Right => -1.0,
    }
}
