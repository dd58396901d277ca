//! Joint positions of a generated clip, in metres, y up.

use nalgebra::{Rotation3, Vector3};
use plantigrade::bvh::{Axis, Channel, Clip};
use plantigrade_synth::character::{Bone, Character, Up};

/// Positions of every joint over time.
pub struct Positions {
    tracks: Vec<Vec<Vector3<f64>>>,
    joint_names: Vec<String>,
    character: Character,
}

impl Positions {
    /// Returns the positions of the joint that rotates `bone`.
    pub fn track(&self, bone: Bone) -> &[Vector3<f64>] {
        let name = self.character.naming.name(bone);
        let index = self.joint_names.iter().position(|n| *n == name).expect("a joint of the clip");
        &self.tracks[index]
    }
}

/// Computes forward kinematics of `clip` in the generator's coordinates.
pub fn positions(clip: &Clip, character: &Character) -> Positions {
    let metres = 1.0 / character.unit.per_metre();
    let mut tracks = vec![Vec::new(); clip.joints().len()];
    for frame in 0..clip.frame_count() {
        let row = clip.row(frame);
        let mut world: Vec<(Vector3<f64>, Rotation3<f64>)> = Vec::new();
        for (index, joint) in clip.joints().iter().enumerate() {
            let (mut position, mut rotation) = (joint.offset, Rotation3::identity());
            for (channel, &value) in joint.channels.iter().zip(&row[clip.channel_range(index)]) {
                match channel {
                    Channel::Position(axis) => position[axis.index()] = value,
                    Channel::Rotation(axis) => rotation *= axis_rotation(*axis, value.to_radians()),
                    Channel::Scale(_) => {}
                }
            }
            let (origin, frame) = joint.parent.map_or_else(Default::default, |parent| world[parent]);
            world.push((origin + frame * position, frame * rotation));
            let position = metres * world[index].0;
            tracks[index].push(match character.up {
                Up::Y => position,
                Up::Z => Vector3::new(position.x, position.z, -position.y),
            });
        }
    }
    let joint_names = clip.joints().iter().map(|joint| joint.name.clone()).collect();
    Positions { tracks, joint_names, character: character.clone() }
}

fn axis_rotation(axis: Axis, angle: f64) -> Rotation3<f64> {
    let axis = match axis {
        Axis::X => Vector3::x_axis(),
        Axis::Y => Vector3::y_axis(),
        Axis::Z => Vector3::z_axis(),
    };
    Rotation3::from_axis_angle(&axis, angle)
}
