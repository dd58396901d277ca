//! Legs of a clip: their joints and tracks.

use nalgebra::{Matrix3, Quaternion, Rotation3, UnitQuaternion, Vector3};

use crate::bvh::Clip;
use crate::foot::Side;
use crate::kinematics::{self, Kinematics, Track};
use crate::plants::Ground;
use crate::skeleton::{LegRoles, Skeleton};

/// Joints of one leg.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Joints {
    /// Hip joint and knee, if both are known and ancestors of the ankle.
    pub upper: Option<[usize; 2]>,
    /// Ankle.
    pub ankle: usize,
    /// Toe base or the joint that replaces it; the ankle if there is none.
    pub toe: usize,
    /// Tip of the foot, or the toe if there is none.
    tip: usize,
}

impl Joints {
    /// Returns the joints of one leg; `None` without an ankle.
    pub fn new(clip: &Clip, skeleton: &Skeleton, side: Side) -> Option<Joints> {
        let roles = LegRoles::for_side(side);
        let role = |role| skeleton.roles.get(role).filter(|&joint| joint < clip.joints().len());
        let ankle = role(roles.ankle)?;
        let is_below = |joint: usize, above: usize| {
            joint != above
                && std::iter::successors(Some(joint), |&j| clip.joints()[j].parent).any(|j| j == above)
        };
        let upper = role(roles.thigh).zip(role(roles.shank));
        let upper = upper.filter(|&(thigh, shank)| is_below(shank, thigh) && is_below(ankle, shank));
        let toe = skeleton.toe(side).filter(|&toe| toe < clip.joints().len() && is_below(toe, ankle));
        let toe = toe.unwrap_or(ankle);
        let tip = role(roles.tip).filter(|&tip| is_below(tip, ankle)).unwrap_or(toe);
        Some(Joints { upper: upper.map(|(thigh, shank)| [thigh, shank]), ankle, toe, tip })
    }
}

/// Tracks of one leg, in file units and axes.
pub(crate) struct Leg {
    /// Joints of the leg.
    pub joints: Joints,
    /// Hip joint and knee; at the ankle if they are unknown.
    pub hip: Track,
    pub knee: Track,
    pub ankle: Track,
    pub toe: Track,
    /// Tip of the foot, or the toe if there is none.
    pub tip: Track,
    /// Global orientation of the ankle.
    pub foot: Vec<Matrix3<f64>>,
    /// Axis about which the knee bends, in the thigh's axes: the mean over the clip, weighted by
    /// the bend of the knee.
    pub hinge: Vector3<f64>,
}

impl Leg {
    /// Makes the positions relative to the belt on which the feet stand, if there is one; it starts at its place
    /// in the file.
    pub fn subtract_belt(&mut self, ground: &Ground, frame_time: f64) {
        if ground.belt.is_none() {
            return;
        }
        for track in [&mut self.hip, &mut self.knee, &mut self.ankle, &mut self.toe, &mut self.tip] {
            for (frame, position) in track.iter_mut().enumerate() {
                *position -= ground.displacement(frame, frame_time);
            }
        }
    }
}

/// Computes both legs of a clip in one pass.
pub(crate) fn legs(clip: &Clip, joints: [Joints; 2]) -> [Leg; 2] {
    let count = kinematics::pose_count(clip);
    let mut legs = joints.map(|joints| Leg {
        joints,
        hip: Track::with_capacity(count),
        knee: Track::with_capacity(count),
        ankle: Track::with_capacity(count),
        toe: Track::with_capacity(count),
        tip: Track::with_capacity(count),
        foot: Vec::with_capacity(count),
        hinge: Vector3::zeros(),
    });
    let tracked: Vec<usize> = joints.iter().flat_map(|leg| [leg.ankle, leg.toe, leg.tip]).collect();
    let mut kinematics = Kinematics::for_joints(clip, &tracked);
    for frame in 0..count {
        let pose = kinematics.pose(frame).to_vec();
        for leg in &mut legs {
            let Joints { upper, ankle, toe, tip } = leg.joints;
            let [thigh, shank] = upper.unwrap_or([ankle; 2]);
            let bend = (pose[shank] - pose[thigh]).cross(&(pose[ankle] - pose[shank]));
            leg.hinge += kinematics.rotations()[thigh].transpose() * bend;
            leg.hip.push(pose[thigh]);
            leg.knee.push(pose[shank]);
            leg.ankle.push(pose[ankle]);
            leg.toe.push(pose[toe]);
            leg.tip.push(pose[tip]);
            leg.foot.push(kinematics.rotations()[ankle]);
        }
    }
    for leg in &mut legs {
        leg.hinge = leg.hinge.try_normalize(1e-12).unwrap_or_default();
    }
    legs
}

impl Leg {
    /// True if the foot has no toe to rotate about.
    pub fn is_point(&self) -> bool {
        self.joints.toe == self.joints.ankle
    }

    /// Returns the vector from the ankle to the toe.
    pub fn sole(&self, frame: usize) -> Vector3<f64> {
        self.toe[frame] - self.ankle[frame]
    }
}

/// Returns a rotation as axis times angle. It is exact for small rotations, for which the trace of
/// the matrix is inaccurate.
pub(crate) fn scaled_axis(rotation: Matrix3<f64>) -> Vector3<f64> {
    UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(rotation)).scaled_axis()
}

/// Returns the smallest rotation from the direction of `from` to that of `to`; the identity if it
/// is undefined.
pub(crate) fn smallest_rotation(from: Vector3<f64>, to: Vector3<f64>) -> Rotation3<f64> {
    let lengths = from.norm() * to.norm();
    let quaternion = Quaternion::from_parts(lengths + from.dot(&to), from.cross(&to)) / lengths;
    UnitQuaternion::try_new(quaternion, 1e-9).unwrap_or_default().to_rotation_matrix()
}
