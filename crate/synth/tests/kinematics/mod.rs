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

/// Times after foot strike and before foot off in which a planted foot may move, in seconds: the
/// ground stops it, and it accelerates while its load decreases.
const END_MOTION_TIMES: (f64, f64) = (0.035, 0.125);

/// Returns the frames in which a foot with the given contact is planted and at rest. The end of the
/// clip counts as foot off.
pub fn at_rest(planted: &[bool], contact: &[bool], frame_time: f64) -> Vec<bool> {
    let frames = |time: f64| (time / frame_time).ceil() as usize;
    let (after, before) = (frames(END_MOTION_TIMES.0), frames(END_MOTION_TIMES.1));
    let is_at_rest = |frame: usize| {
        let around = contact.get(frame.saturating_sub(after)..frame + before + 1);
        planted[frame] && around.is_some_and(|around| around.iter().all(|&contact| contact))
    };
    (0..planted.len()).map(is_at_rest).collect()
}

fn axis_rotation(axis: Axis, angle: f64) -> Rotation3<f64> {
    let axis = match axis {
        Axis::X => Vector3::x_axis(),
        Axis::Y => Vector3::y_axis(),
        Axis::Z => Vector3::z_axis(),
    };
    Rotation3::from_axis_angle(&axis, angle)
}
