//! Joint positions of a generated clip, in metres, y up.

use nalgebra::{Rotation3, Vector3};
use plantigrade::bvh::{Axis, Channel, Clip};
use plantigrade_synth::character::{Bone, Character, Up};

/// The way of every joint, by the joint's place in the file.
pub struct Positions {
    tracks: Vec<Vec<Vector3<f64>>>,
    names: Vec<String>,
    character: Character,
}

impl Positions {
    /// The way of the joint that turns `bone`.
    pub fn of(&self, bone: Bone) -> &[Vector3<f64>] {
        let name = self.character.naming.name(bone);
        let index = self.names.iter().position(|n| *n == name).expect("a joint of the clip");
        &self.tracks[index]
    }
}

/// Forward kinematics of `clip`, taken back to the generator's frame.
pub fn positions(clip: &Clip, character: &Character) -> Positions {
    let metres = 1.0 / character.unit.per_metre();
    let mut tracks = vec![Vec::new(); clip.joints().len()];
    for frame in 0..clip.frame_count() {
        let row = clip.row(frame);
        let mut world: Vec<(Vector3<f64>, Rotation3<f64>)> = Vec::new();
        for (index, joint) in clip.joints().iter().enumerate() {
            let (mut place, mut turn) = (joint.offset, Rotation3::identity());
            for (channel, &value) in joint.channels.iter().zip(&row[clip.channel_range(index)]) {
                match channel {
                    Channel::Position(axis) => place[axis.index()] = value,
                    Channel::Rotation(axis) => turn *= rotation(*axis, value.to_radians()),
                }
            }
            let (origin, frame) = joint.parent.map_or_else(Default::default, |parent| world[parent]);
            world.push((origin + frame * place, frame * turn));
            let at = metres * world[index].0;
            tracks[index].push(match character.up {
                Up::Y => at,
                Up::Z => Vector3::new(at.x, at.z, -at.y),
            });
        }
    }
    let names = clip.joints().iter().map(|joint| joint.name.clone()).collect();
    Positions { tracks, names, character: character.clone() }
}

fn rotation(axis: Axis, angle: f64) -> Rotation3<f64> {
    let axis = match axis {
        Axis::X => Vector3::x_axis(),
        Axis::Y => Vector3::y_axis(),
        Axis::Z => Vector3::z_axis(),
    };
    Rotation3::from_axis_angle(&axis, angle)
}
