//! From poses to the rows of a clip, in a character's own conventions.

use nalgebra::Matrix3;
use plantigrade::bvh::{Axis, Channel, Clip, END_SITE, Joint, JointKind};

use crate::character::{Character, Positions, Rig, Up};
use crate::maths::{Rot, Vec3, turn};
use crate::pose::Pose;

/// The clip in which `character` goes through `poses`, `frame_time` seconds apart.
///
/// Values are rounded as they will be written, so that the clip equals its file.
pub fn clip(character: &Character, poses: &[Pose], frame_time: f64) -> Clip {
    let rig = Rig::new(&character.build, character.spine_joints);
    let joints: Vec<Joint> = (0..rig.joints.len()).map(|index| joint(character, &rig, index)).collect();
    let axes = character.rotation_order.map(Axis::index);
    let mut values = Vec::new();
    let mut last = vec![[0.0; 3]; joints.len()];
    for pose in poses {
        for (index, joint) in joints.iter().enumerate() {
            let Some(bone) = rig.joints[index].bone else { continue };
            let angles = nearest_angles(&(to_file(character, pose.turn(bone))), axes, last[index]);
            last[index] = angles;
            let place = if index == 0 { length(character, pose.root) } else { joint.offset };
            values.extend(joint.channels.iter().map(|channel| match channel {
                Channel::Position(axis) => place[axis.index()],
                Channel::Rotation(axis) => {
                    let slot = axes.iter().position(|&a| a == axis.index()).expect("one of three axes");
                    rounded(angles[slot].to_degrees(), character.decimals.of_angles())
                }
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
    if kind == JointKind::Root || kind == JointKind::Joint && character.positions == Positions::All {
        channels.extend(Axis::ALL.map(Channel::Position));
    }
    if kind != JointKind::EndSite {
        channels.extend(character.rotation_order.map(Channel::Rotation));
    }
    Joint { name, kind, parent: joint.parent, offset: length(character, joint.offset), channels }
}

/// A vector in the axes and the unit of the file, rounded.
fn length(character: &Character, vector: Vec3) -> Vec3 {
    let scaled = character.unit.per_metre() * vector;
    let turned = match character.up {
        Up::Y => scaled,
        Up::Z => Vec3::new(scaled.x, -scaled.z, scaled.y),
    };
    turned.map(|value| rounded(value, character.decimals.of_lengths(character.unit)))
}

/// A rotation in the axes of the file.
fn to_file(character: &Character, rotation: Rot) -> Rot {
    match character.up {
        Up::Y => rotation,
        Up::Z => {
            let tip = turn(0, std::f64::consts::FRAC_PI_2);
            tip * rotation * tip.inverse()
        }
    }
}

fn rounded(value: f64, decimals: usize) -> f64 {
    let scale: f64 = std::iter::repeat_n(10.0, decimals).product();
    // Adding zero turns −0 into 0.
    (value * scale).round() / scale + 0.0
}

/// The angles about `axes`, applied in that order, that are nearest to `last`, in radians.
fn nearest_angles(rotation: &Rot, axes: [usize; 3], last: [f64; 3]) -> [f64; 3] {
    let first = angles(rotation.to_rotation_matrix().matrix(), axes);
    let pi = std::f64::consts::PI;
    // The same rotation with the middle angle past the vertical.
    let second = [first[0] + pi, pi - first[1], first[2] + pi];
    let unwrapped = |angles: [f64; 3]| -> [f64; 3] {
        std::array::from_fn(|n| angles[n] + 2.0 * pi * ((last[n] - angles[n]) / (2.0 * pi)).round())
    };
    let distance = |angles: &[f64; 3]| (0..3).map(|n| (angles[n] - last[n]).abs()).sum::<f64>();
    let [first, second] = [first, second].map(unwrapped);
    if distance(&first) <= distance(&second) { first } else { second }
}

/// The angles of R = R(axes[0])·R(axes[1])·R(axes[2]) for three different axes.
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
    fn angles_give_the_rotation_back_in_every_order() {
        let rotation = turn(0, 0.7) * turn(1, -1.9) * turn(2, 2.5);
        for axes in [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
            let found = nearest_angles(&rotation, axes, [3.0, 0.0, -9.0]);
            let back = (0..3).fold(Rot::identity(), |r, n| r * turn(axes[n], found[n]));
            assert!(back.angle_to(&rotation) < 1e-7, "{axes:?}");
        }
    }
}
