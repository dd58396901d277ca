//! One leg of a clip: its joints and where they are in each frame.

use nalgebra::{Matrix3, Quaternion, Rotation3, UnitQuaternion, Vector3};

use crate::bvh::Clip;
use crate::foot::Side;
use crate::kinematics;
use crate::kinematics::{Kinematics, Track};
use crate::skeleton::{LegRoles, Skeleton, Up};

/// The joints of one leg.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Joints {
    /// Hip joint and knee, where both are known and in one chain with the ankle.
    pub upper: Option<[usize; 2]>,
    /// The ankle.
    pub ankle: usize,
    /// The toe base or what stands in for it: in a foot without either, the ankle.
    pub toe: usize,
    /// The tip of the foot, or else the toe again.
    tip: usize,
}

impl Joints {
    /// The leg of one side; `None` without an ankle.
    pub fn of(clip: &Clip, skeleton: &Skeleton, side: Side) -> Option<Joints> {
        let roles = LegRoles::of(side);
        let role = |role| skeleton.roles.get(role).filter(|&joint| joint < clip.joints().len());
        let ankle = role(roles.ankle)?;
        let hangs = |joint: usize, above: usize| {
            joint != above
                && std::iter::successors(Some(joint), |&j| clip.joints()[j].parent).any(|j| j == above)
        };
        let upper = role(roles.thigh).zip(role(roles.shank));
        let upper = upper.filter(|&(thigh, shank)| hangs(shank, thigh) && hangs(ankle, shank));
        let toe = skeleton.toe(side).filter(|&toe| toe < clip.joints().len() && hangs(toe, ankle));
        let toe = toe.unwrap_or(ankle);
        let tip = role(roles.tip).filter(|&tip| hangs(tip, ankle)).unwrap_or(toe);
        Some(Joints { upper: upper.map(|(thigh, shank)| [thigh, shank]), ankle, toe, tip })
    }
}

/// One leg in motion, in file units and axes.
pub(crate) struct Leg {
    /// Its joints.
    pub joints: Joints,
    /// Hip joint and knee; at the ankle where they are not known.
    pub hip: Track,
    pub knee: Track,
    pub ankle: Track,
    pub toe: Track,
    /// The tip of the foot, or else the toe.
    pub tip: Track,
    /// How the ankle is turned against the file's axes.
    pub foot: Vec<Matrix3<f64>>,
    /// The axis that the knee bends about, in the thigh's axes: the mean over the clip, most of
    /// it from frames with the knee well bent.
    pub hinge: Vector3<f64>,
}

/// Both legs of a clip, in one pass over it.
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
    let needed: Vec<usize> = joints.iter().flat_map(|leg| [leg.ankle, leg.toe, leg.tip]).collect();
    let mut kinematics = Kinematics::for_joints(clip, &needed);
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
    /// Whether the foot is a point: there is no toe to turn about.
    pub fn is_point(&self) -> bool {
        self.joints.toe == self.joints.ankle
    }

    /// From the ankle to the toe.
    pub fn sole(&self, frame: usize) -> Vector3<f64> {
        self.toe[frame] - self.ankle[frame]
    }
}

/// The unit vector that points up.
pub(crate) fn upright(up: Up) -> Vector3<f64> {
    Vector3::ith(up.axis.index(), if up.negative { -1.0 } else { 1.0 })
}

/// The middle value, the lower of two; `None` of none.
pub(crate) fn median(values: impl Iterator<Item = f64>) -> Option<f64> {
    let mut values: Vec<f64> = values.collect();
    let middle = values.len().checked_sub(1)? / 2;
    Some(*values.select_nth_unstable_by(middle, f64::total_cmp).1)
}

/// A rotation as axis times angle; small ones exactly, for which the trace of the matrix says little.
pub(crate) fn scaled_axis(rotation: Matrix3<f64>) -> Vector3<f64> {
    UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(rotation)).scaled_axis()
}

/// The smallest rotation that turns `from` to point along `to`; none where there is no such one.
pub(crate) fn smallest_turn(from: Vector3<f64>, to: Vector3<f64>) -> Rotation3<f64> {
    let lengths = from.norm() * to.norm();
    let turn = Quaternion::from_parts(lengths + from.dot(&to), from.cross(&to)) / lengths;
    UnitQuaternion::try_new(turn, 1e-9).unwrap_or_default().to_rotation_matrix()
}
