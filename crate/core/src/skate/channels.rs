//! Corrections as channel values.

use nalgebra::{Matrix3, Rotation3, Vector3};

use crate::bvh::{Channel, Clip, Limits};
use crate::kinematics::Kinematics;
use crate::skate::constraints::Correction;
use crate::skate::leg::{Joints, Leg};
use crate::skate::{euler, knee};
use crate::skeleton::{Role, Skeleton};

/// Movements smaller than this count as zero, in leg lengths.
const NEGLIGIBLE: f64 = 1e-9;

/// True if the joints of a leg can rotate as the solution requires.
pub(super) fn can_rotate(clip: &Clip, [thigh, shank]: [usize; 2], ankle: usize) -> bool {
    let channels = |joint: usize| &clip.joints()[joint].channels;
    let rotates =
        |joint: usize| channels(joint).iter().any(|channel| matches!(channel, Channel::Rotation(_)));
    euler::is_ball_joint(channels(thigh)) && rotates(shank) && rotates(ankle)
}

/// Returns the joint that translates the hips: the lowest common ancestor of both legs with three
/// position channels.
pub(super) fn translating_joint(clip: &Clip, skeleton: &Skeleton, legs: [Joints; 2]) -> Option<usize> {
    let above = |joint: usize| std::iter::successors(Some(joint), |&j| clip.joints()[j].parent);
    let tops = legs.map(|leg| leg.upper.map_or(leg.ankle, |[thigh, _]| thigh));
    let can_translate = |joint: usize| {
        let positions = clip.joints()[joint].channels.iter();
        positions.filter(|channel| matches!(channel, Channel::Position(_))).count() == 3
    };
    let hips = skeleton.roles.get(Role::Hips).unwrap_or(skeleton.root);
    let is_common_ancestor =
        |joint: usize| tops.iter().all(|&top| top != joint && above(top).any(|j| j == joint));
    above(hips).find(|&joint| is_common_ancestor(joint) && can_translate(joint))
}

/// Writes corrections into the channels of a clip.
pub(super) struct ChannelWriter<'a> {
    pub clip: &'a Clip,
    pub legs: &'a [Leg; 2],
    pub corrections: &'a [Correction; 2],
    pub translating_joint: Option<usize>,
    pub hip_offset: &'a [Vector3<f64>],
    /// Leg length, in file units.
    pub length: f64,
}

impl ChannelWriter<'_> {
    pub fn write(&self) -> Clip {
        let clip = self.clip;
        let (mut values, width) = (clip.values().to_vec(), clip.channel_count());
        let joints: Vec<usize> =
            self.legs.iter().map(|leg| leg.joints.ankle).chain(self.translating_joint).collect();
        let mut kinematics = Kinematics::for_joints(clip, &joints);
        for (frame, row) in values.chunks_exact_mut(width.max(1)).enumerate() {
            kinematics.pose(frame);
            let rotations = kinematics.rotations();
            self.translate_hips(frame, rotations, row);
            for (leg, correction) in self.legs.iter().zip(self.corrections) {
                self.rotate_leg(leg, correction, frame, rotations, row);
            }
            // A file with larger values could not be read.
            if !row.iter().all(|value| value.abs() <= Limits::default().value) {
                row.copy_from_slice(clip.row(frame));
            }
        }
        Clip::new(clip.joints().to_vec(), clip.frame_time(), values).with_position_rule(clip.position_rule())
    }

    /// Translates the hips.
    fn translate_hips(&self, frame: usize, rotations: &[Matrix3<f64>], row: &mut [f64]) {
        let Some(translating_joint) = self.translating_joint else { return };
        let offset = self.hip_offset[frame];
        if offset.norm() <= NEGLIGIBLE * self.length || !offset.norm().is_finite() {
            return;
        }
        let joint = &self.clip.joints()[translating_joint];
        let offset = joint.parent.map_or(offset, |parent| rotations[parent].transpose() * offset);
        for (value, channel) in
            row[self.clip.channel_range(translating_joint)].iter_mut().zip(&joint.channels)
        {
            if let Channel::Position(axis) = channel {
                *value += offset[axis.index()];
            }
        }
    }

    /// Rotates the joints of one leg.
    fn rotate_leg(
        &self,
        leg: &Leg,
        correction: &Correction,
        frame: usize,
        rotations: &[Matrix3<f64>],
        row: &mut [f64],
    ) {
        let Joints { upper: Some([thigh, shank]), ankle, .. } = leg.joints else { return };
        if !can_rotate(self.clip, [thigh, shank], ankle) {
            return;
        }
        let (translation, rotation_vector) =
            (correction.ankle[frame] - self.hip_offset[frame], correction.foot[frame]);
        if translation.norm() <= NEGLIGIBLE * self.length && rotation_vector.norm() <= NEGLIGIBLE {
            return;
        }
        let hip_to_ankle = leg.ankle[frame] - leg.hip[frame] + translation;
        let [upper, lower] = knee::rotations(leg, frame, rotations[thigh] * leg.hinge, hip_to_ankle);
        let foot = Rotation3::new(rotation_vector).into_inner();
        // Joints in between follow the joint above them.
        let mut above: Matrix3<f64> = Matrix3::identity();
        for (joint, rotation) in [(thigh, upper), (shank, lower), (ankle, foot)] {
            let parent = self.clip.joints()[joint].parent.map_or(Matrix3::identity(), |p| rotations[p]);
            let target = (above * parent).transpose() * rotation * rotations[joint];
            let channels = &self.clip.joints()[joint].channels;
            euler::set_rotation(channels, &mut row[self.clip.channel_range(joint)], &target);
            above = rotation;
        }
    }
}
