//! Conversion of poses to a BVH clip in the file conventions of a character.

use nalgebra::Matrix3;
use plantigrade::bvh::{Axis, Channel, Clip, END_SITE, Joint, JointKind};

use crate::character::{Character, PositionChannels, Rig, Up};
use crate::math::{Rot, Vec3, rotation_about};
use crate::pose::Pose;

/// Returns the clip of `character` with these `poses`, `frame_time` seconds apart.
///
/// Values are rounded to the decimals of the file, so that parsing the written file gives an equal
/// clip.
pub fn to_clip(character: &Character, poses: &[Pose], frame_time: f64) -> Clip {
    let rig = Rig::new(&character.proportions, character.spine_joints);
    let joints: Vec<Joint> = (0..rig.joints.len()).map(|index| joint(character, &rig, index)).collect();
    let axes = character.rotation_order.map(Axis::index);
    let mut values = Vec::new();
    let mut previous = vec![[0.0; 3]; joints.len()];
    for pose in poses {
        for (index, joint) in joints.iter().enumerate() {
            let Some(bone) = rig.joints[index].bone else { continue };
            let angles =
                nearest_angles(&(to_file_rotation(character, pose.rotation(bone))), axes, previous[index]);
            previous[index] = angles;
            let position = if index == 0 { to_file_vector(character, pose.root) } else { joint.offset };
            values.extend(joint.channels.iter().map(|channel| match channel {
                Channel::Position(axis) => position[axis.index()],
                Channel::Rotation(axis) => {
                    let slot = axes.iter().position(|&a| a == axis.index()).expect("one of three axes");
                    rounded(angles[slot].to_degrees(), character.decimals.for_angles())
                }
                Channel::Scale(_) => 1.0,
            }));
        }
    }
    Clip::new(joints, frame_time, values)
}

fn joint(character: &Character, rig: &Rig, index: usize) -> Joint {
    let joint = &rig.joints[index];
    let (name, kind) = match (joint.bone, joint.parent) {
        (Some(bone), None) => (character.naming.name(bone), JointKind::Root),
        (Some(bone), Some(_)) => (character.naming.name(bone), JointKind::Joint),
        (None, _) => (END_SITE.to_string(), JointKind::EndSite),
    };
    let mut channels = Vec::new();
    if kind == JointKind::Root
        || kind == JointKind::Joint && character.position_channels == PositionChannels::All
    {
        channels.extend(Axis::ALL.map(Channel::Position));
    }
    if kind != JointKind::EndSite {
        channels.extend(character.rotation_order.map(Channel::Rotation));
    }
    Joint { name, kind, parent: joint.parent, offset: to_file_vector(character, joint.offset), channels }
}

/// Converts a vector to the axes and the length unit of the file, rounded.
fn to_file_vector(character: &Character, vector: Vec3) -> Vec3 {
    let scaled = character.unit.per_metre() * vector;
    let rotated = match character.up {
        Up::Y => scaled,
        Up::Z => Vec3::new(scaled.x, -scaled.z, scaled.y),
    };
    rotated.map(|value| rounded(value, character.decimals.for_lengths(character.unit)))
}

/// Converts a rotation to the axes of the file.
fn to_file_rotation(character: &Character, rotation: Rot) -> Rot {
    match character.up {
        Up::Y => rotation,
        Up::Z => {
            let tilt = rotation_about(0, std::f64::consts::FRAC_PI_2);
            tilt * rotation * tilt.inverse()
        }
    }
}

fn rounded(value: f64, decimals: usize) -> f64 {
    let scale: f64 = std::iter::repeat_n(10.0, decimals).product();
    // Adding zero turns −0 into 0.
    (value * scale).round() / scale + 0.0
}

/// Returns the Euler angles about `axes`, in radians, that are nearest to `last`.
fn nearest_angles(rotation: &Rot, axes: [usize; 3], previous: [f64; 3]) -> [f64; 3] {
    let first = angles(rotation.to_rotation_matrix().matrix(), axes);
    let pi = std::f64::consts::PI;
    // The second solution has the middle angle beyond ±90°.
    let second = [first[0] + pi, pi - first[1], first[2] + pi];
    let unwrapped = |angles: [f64; 3]| -> [f64; 3] {
        std::array::from_fn(|n| angles[n] + 2.0 * pi * ((previous[n] - angles[n]) / (2.0 * pi)).round())
    };
    let distance = |angles: &[f64; 3]| (0..3).map(|n| (angles[n] - previous[n]).abs()).sum::<f64>();
    let [first, second] = [first, second].map(unwrapped);
    if distance(&first) <= distance(&second) { first } else { second }
}

/// Returns the Euler angles of R = R(axes[0])·R(axes[1])·R(axes[2]) for three distinct axes.
fn angles(matrix: &Matrix3<f64>, [i, j, k]: [usize; 3]) -> [f64; 3] {
    let sign = if (i + 1) % 3 == j { 1.0 } else { -1.0 };
    let at = |row: usize, column: usize| matrix[(row, column)];
    [
        libm::atan2(-sign * at(j, k), at(k, k)),
        libm::asin((sign * at(i, k)).clamp(-1.0, 1.0)),
        libm::atan2(-sign * at(i, j), at(i, i)),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_reproduce_the_rotation_in_every_order() {
        let rotation = rotation_about(0, 0.7) * rotation_about(1, -1.9) * rotation_about(2, 2.5);
        for axes in [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
            let angles = nearest_angles(&rotation, axes, [3.0, 0.0, -9.0]);
            let back = (0..3).fold(Rot::identity(), |r, n| r * rotation_about(axes[n], angles[n]));
            assert!(back.angle_to(&rotation) < 1e-7, "{axes:?}");
        }
    }
}
