//! Forward kinematics: channel values to joint positions.

use std::ops::Range;

use nalgebra::{Matrix3, Vector3};

use crate::bvh::{Axis, Channel, Clip, PositionRule};

/// Position of a joint in each frame, in file units and file axes.
pub type Track = Vec<Vector3<f64>>;

/// Computes the poses of a clip, for all joints or some of them.
///
/// Reuses its working memory for every frame.
#[derive(Debug)]
pub struct Kinematics<'a> {
    clip: &'a Clip,
    /// First joint of the poses.
    first: usize,
    /// Joints to compute: the requested ones and all their ancestors, parents first.
    needed: Vec<usize>,
    rotations: Vec<Matrix3<f64>>,
    positions: Vec<Vector3<f64>>,
}

impl<'a> Kinematics<'a> {
    /// Creates the kinematics of all joints.
    pub fn new(clip: &'a Clip) -> Kinematics<'a> {
        Kinematics::for_joints(clip, &(0..clip.joints().len()).collect::<Vec<_>>())
    }

    /// Creates the kinematics of `joints` and their ancestors; other joints stay at the origin.
    pub fn for_joints(clip: &'a Clip, joints: &[usize]) -> Kinematics<'a> {
        let count = clip.joints().len();
        let mut is_needed = vec![false; count];
        for &joint in joints {
            let mut next = Some(joint);
            while let Some(joint) = next.filter(|&joint| !is_needed[joint]) {
                is_needed[joint] = true;
                next = clip.joints()[joint].parent;
            }
        }
        let needed = (0..count).filter(|&joint| is_needed[joint]).collect();
        Kinematics::of(clip, 0..count, needed)
    }

    /// Creates the kinematics of the skeleton with the joints `members`; its poses contain them only.
    ///
    /// Takes time and memory for these joints only, as a clip may have many skeletons.
    pub fn for_skeleton(clip: &'a Clip, members: Range<usize>) -> Kinematics<'a> {
        Kinematics::of(clip, members.clone(), members.collect())
    }

    fn of(clip: &'a Clip, joints: Range<usize>, needed: Vec<usize>) -> Kinematics<'a> {
        Kinematics {
            clip,
            first: joints.start,
            needed,
            rotations: vec![Matrix3::identity(); joints.len()],
            positions: vec![Vector3::zeros(); joints.len()],
        }
    }

    /// Returns the position of every joint in `frame`, in file units and axes, indexed by joint. The poses
    /// of a skeleton begin with its root.
    ///
    /// A clip without motion has one frame: its rest pose, with all rotations zero.
    ///
    /// # Panics
    /// If `frame` is not a frame of the clip.
    pub fn pose(&mut self, frame: usize) -> &[Vector3<f64>] {
        let rule = self.clip.position_rule();
        let row = if frame == 0 && self.clip.frame_count() == 0 { &[][..] } else { self.clip.row(frame) };
        for &index in &self.needed {
            let joint = &self.clip.joints()[index];
            let is_added = joint.parent.is_some() && rule == PositionRule::Add;
            let mut position = joint.offset;
            let mut rotation = Matrix3::identity();
            // A rest pose has no values: its joints have their offset and the identity rotation.
            let values = row.get(self.clip.channel_range(index)).unwrap_or_default();
            for (channel, value) in joint.channels.iter().zip(values) {
                match channel {
                    Channel::Position(axis) if is_added => position[axis.index()] += value,
                    Channel::Position(axis) => position[axis.index()] = *value,
                    Channel::Rotation(axis) => rotate_about(&mut rotation, *axis, value.to_radians()),
                    Channel::Scale(_) => {}
                }
            }
            if let Some(parent) = joint.parent.filter(|_| rule != PositionRule::Global) {
                let (at, parent) = (index - self.first, parent - self.first);
                self.positions[at] = self.positions[parent] + self.rotations[parent] * position;
                self.rotations[at] = self.rotations[parent] * rotation;
            } else {
                self.positions[index - self.first] = position;
                self.rotations[index - self.first] = rotation;
            }
        }
        &self.positions
    }

    /// Returns the global rotation of every joint in the pose computed last, in the order of the pose.
    pub fn rotations(&self) -> &[Matrix3<f64>] {
        &self.rotations
    }
}

/// Multiplies `rotation` from the right by a rotation of `angle` radians about `axis`.
fn rotate_about(rotation: &mut Matrix3<f64>, axis: Axis, angle: f64) {
    let (sin, cos) = angle.sin_cos();
    // The column of the axis does not change; the two others rotate in their plane.
    let (a, b) = match axis {
        Axis::X => (1, 2),
        Axis::Y => (2, 0),
        Axis::Z => (0, 1),
    };
    let (from_a, from_b) = (rotation.column(a).into_owned(), rotation.column(b).into_owned());
    rotation.set_column(a, &(from_a * cos + from_b * sin));
    rotation.set_column(b, &(from_b * cos - from_a * sin));
}

/// Returns the number of poses: frames, or 1 for a rest pose.
pub fn pose_count(clip: &Clip) -> usize {
    clip.frame_count().max(1)
}

/// Returns the track of each of `joints` over all frames, or over the rest pose.
pub fn tracks(clip: &Clip, joints: &[usize]) -> Vec<Track> {
    tracks_at(clip, joints, 0..pose_count(clip))
}

/// Returns the track of each of `joints` over the given frames.
pub fn tracks_at(clip: &Clip, joints: &[usize], frames: impl ExactSizeIterator<Item = usize>) -> Vec<Track> {
    let mut kinematics = Kinematics::for_joints(clip, joints);
    // Cloning an empty vector would lose its capacity.
    let mut tracks: Vec<Track> = joints.iter().map(|_| Track::with_capacity(frames.len())).collect();
    for frame in frames {
        let pose = kinematics.pose(frame);
        for (track, &joint) in tracks.iter_mut().zip(joints) {
            track.push(pose[joint]);
        }
    }
    tracks
}

/// Returns at most `max` frames at equal distances over the clip.
pub fn sample_frames(clip: &Clip, max: usize) -> impl ExactSizeIterator<Item = usize> + Clone {
    let count = pose_count(clip);
    let samples = count.min(max);
    (0..samples).map(move |index| index * count / samples)
}

#[cfg(test)]
mod tests {
    use nalgebra::{Rotation3, Unit};
    use proptest::prelude::*;

    use super::*;
    use crate::bvh::{END_SITE, Joint, JointKind};

    fn arm(channels: Vec<Channel>, values: Vec<f64>) -> Clip {
        let joint = |name: &str, kind, parent, offset, channels| Joint {
            name: name.into(),
            kind,
            parent,
            offset,
            channels,
        };
        Clip::new(
            vec![
                joint("root", JointKind::Root, None, Vector3::new(9.0, 9.0, 9.0), vec![]),
                joint("elbow", JointKind::Joint, Some(0), Vector3::new(1.0, 0.0, 0.0), channels),
                joint(END_SITE, JointKind::EndSite, Some(1), Vector3::new(0.0, 2.0, 0.0), vec![]),
            ],
            0.01,
            values,
        )
    }

    #[test]
    fn rotations_apply_in_channel_order() {
        use Axis::{X, Z};
        let order = vec![Channel::Rotation(Z), Channel::Rotation(X)];
        let clip = arm(order, vec![90.0, 90.0]);
        let tip = tracks(&clip, &[2])[0][0];
        // X first rotates the tip to +Z of the elbow; Z then does not move it.
        assert!((tip - Vector3::new(10.0, 9.0, 11.0)).norm() < 1e-12, "{tip}");
    }

    #[test]
    fn positions_replace_the_offset_or_add_to_it() {
        let clip = arm(vec![Channel::Position(Axis::Y)], vec![5.0]);
        assert_eq!(tracks(&clip, &[1])[0][0], Vector3::new(10.0, 14.0, 9.0));
        let moved = arm(vec![Channel::Position(Axis::X)], vec![0.5]);
        assert_eq!(tracks(&moved, &[1])[0][0].x, 9.5);
        assert_eq!(tracks(&moved.with_position_rule(PositionRule::Add), &[1])[0][0].x, 10.5);
    }

    #[test]
    fn global_positions_are_the_values_of_the_channels() {
        let channels = Axis::ALL.map(Channel::Position).to_vec();
        let clip = arm(channels, vec![5.0, 0.1, 0.3]).with_position_rule(PositionRule::Global);
        assert_eq!(tracks(&clip, &[1])[0][0], Vector3::new(5.0, 0.1, 0.3));
    }

    #[test]
    fn a_clip_without_motion_has_its_rest_pose() {
        let clip = arm(vec![Channel::Position(Axis::X)], vec![]);
        assert_eq!(tracks(&clip, &[2])[0], vec![Vector3::new(10.0, 11.0, 9.0)]);
    }

    proptest! {
        #[test]
        fn rotations_agree_with_nalgebra(
            axes in prop::collection::vec((0_usize..3, -720.0..720.0_f64), 0..6),
        ) {
            let (mut rotation, mut expected) = (Matrix3::identity(), Rotation3::identity());
            for (axis, degrees) in axes {
                rotate_about(&mut rotation, Axis::ALL[axis], degrees.to_radians());
                let unit = Unit::new_normalize(Vector3::ith(axis, 1.0));
                expected *= Rotation3::from_axis_angle(&unit, degrees.to_radians());
            }
            prop_assert!((rotation - expected.matrix()).amax() < 1e-12);
        }
    }
}
