//! The skeleton in the generator's own frame: metres, y up, z forward, x left, T-pose.

use plantigrade::foot::Side;

use super::Build;
use crate::maths::Vec3;

/// A moving part of the body, named after the joint that turns it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bone {
    /// The pelvis: the root.
    Hips,
    /// A joint of the spine, counted from below.
    Spine(usize),
    /// The neck.
    Neck,
    /// The head.
    Head,
    /// The collar bone.
    Clavicle(Side),
    /// The upper arm, turned by the shoulder.
    UpperArm(Side),
    /// The forearm, turned by the elbow.
    Forearm(Side),
    /// The hand, turned by the wrist.
    Hand(Side),
    /// The thigh, turned by the hip joint.
    Thigh(Side),
    /// The shank, turned by the knee.
    Shank(Side),
    /// The foot, turned by the ankle.
    Foot(Side),
    /// The toes, turned at the ball of the foot.
    Toe(Side),
}

/// One more than the largest [`Bone::index`].
pub const BONE_COUNT: usize = 22;

impl Bone {
    /// A number for each bone, below [`BONE_COUNT`].
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

    /// All bones that a body may have.
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
    /// The bone that the joint turns; `None` for an end site.
    pub bone: Option<Bone>,
    /// Index of the parent.
    pub parent: Option<usize>,
    /// Rest position in the parent, in metres.
    pub offset: Vec3,
}

/// A skeleton, depth first: legs, then spine, head and arms.
#[derive(Clone, Debug, PartialEq)]
pub struct Rig {
    /// Joints and end sites, parents before children.
    pub joints: Vec<RigJoint>,
}

impl Rig {
    /// The skeleton of a body with 2 or 3 joints in its spine.
    pub fn new(build: &Build, spine_joints: usize) -> Rig {
        let mut rig = Rig { joints: Vec::new() };
        let hips = rig.add(Some(Bone::Hips), None, Vec3::zeros());
        for side in Side::BOTH {
            rig.add_leg(build, side, hips);
        }
        let mut spine = hips;
        for n in 0..spine_joints {
            let rise = if n == 0 { 0.2 } else { 0.48 / (spine_joints - 1) as f64 };
            spine = rig.add(Some(Bone::Spine(n)), Some(spine), Vec3::new(0.0, rise * build.trunk, 0.0));
        }
        let neck = rig.add(Some(Bone::Neck), Some(spine), Vec3::new(0.0, 0.32 * build.trunk, 0.0));
        let head = Vec3::new(0.0, 0.33 * build.head, 0.06 * build.head);
        let head = rig.add(Some(Bone::Head), Some(neck), head);
        rig.add(None, Some(head), Vec3::new(0.0, 0.67 * build.head, 0.0));
        for side in Side::BOTH {
            rig.add_arm(build, side, spine);
        }
        rig
    }

    fn add_leg(&mut self, build: &Build, side: Side, hips: usize) {
        let out = outward(side);
        let hip = Vec3::new(out * build.hip, -build.pelvis_rise(), 0.0);
        let thigh = self.add(Some(Bone::Thigh(side)), Some(hips), hip);
        let shank = self.add(Some(Bone::Shank(side)), Some(thigh), Vec3::new(0.0, -build.thigh, 0.0));
        let foot = self.add(Some(Bone::Foot(side)), Some(shank), Vec3::new(0.0, -build.shank, 0.0));
        let ball = Vec3::new(0.0, build.ball - build.ankle, build.instep);
        let toe = self.add(Some(Bone::Toe(side)), Some(foot), ball);
        self.add(None, Some(toe), Vec3::new(0.0, -0.4 * build.ball, build.toes));
    }

    fn add_arm(&mut self, build: &Build, side: Side, chest: usize) {
        let out = outward(side);
        let collar = Vec3::new(out * 0.15 * build.shoulder, 0.24 * build.trunk, 0.0);
        let along = |length: f64| Vec3::new(out * length, 0.0, 0.0);
        let clavicle = self.add(Some(Bone::Clavicle(side)), Some(chest), collar);
        let shoulder = along(0.85 * build.shoulder);
        let upper_arm = self.add(Some(Bone::UpperArm(side)), Some(clavicle), shoulder);
        let forearm = self.add(Some(Bone::Forearm(side)), Some(upper_arm), along(build.upper_arm));
        let hand = self.add(Some(Bone::Hand(side)), Some(forearm), along(build.forearm));
        self.add(None, Some(hand), along(build.hand));
    }

    fn add(&mut self, bone: Option<Bone>, parent: Option<usize>, offset: Vec3) -> usize {
        self.joints.push(RigJoint { bone, parent, offset });
        self.joints.len() - 1
    }
}

/// 1 for the left side, −1 for the right.
pub(crate) fn outward(side: Side) -> f64 {
    match side {
        Side::Left => 1.0,
        Side::Right => -1.0,
    }
}
