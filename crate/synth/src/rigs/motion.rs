//! Motion of rigs: simple postures, with the lowest joint on the ground.

use nalgebra::{Matrix3, Rotation3, Vector3};
use plantigrade::bvh::Clip;
use plantigrade::kinematics::Kinematics;

use super::bone::Bone;
use super::posture::Angles;
use super::skeleton::Built;
use super::spec::{BodyKind, Rig};
use crate::math::Random;

/// Frame rate, in Hz.
const RATE: f64 = 30.0;

/// Frames of one posture.
const FRAMES: usize = 40;

/// Returns the angles of the channels Z, X, Y of a rotation, in degrees.
fn zxy_degrees(matrix: &Matrix3<f64>) -> [f64; 3] {
    let x = matrix[(2, 1)].clamp(-1.0, 1.0).asin();
    let z = (-matrix[(0, 1)]).atan2(matrix[(1, 1)]);
    let y = (-matrix[(2, 0)]).atan2(matrix[(2, 2)]);
    [z, x, y].map(f64::to_degrees)
}

/// Lets the joints of a rig move.
pub(super) fn animate(rig: &Rig, built: &Built, random: &mut Random) -> Clip {
    let axes = rig.up.from_y_up();
    let scale = 1.0 / rig.metres_per_unit;
    let mut joints = built.joints.clone();
    for joint in &mut joints {
        joint.offset *= scale;
        if !rig.rest_is_y_up {
            joint.offset = axes * joint.offset;
        }
    }
    let is_spare = |bone: Bone| {
        matches!(bone, Bone::Wing(..) | Bone::Tail(_))
            || rig.kind == BodyKind::SpareLimbs && matches!(bone, Bone::Hind(..))
    };
    let sway: Vec<[f64; 3]> = joints
        .iter()
        .map(|_| [random.uniform(0.0, 0.02), random.uniform(0.5, 2.0), random.uniform(0.0, 6.0)])
        .collect();
    let place = Vector3::new(random.uniform(-1.0, 1.0), 0.0, random.uniform(-1.0, 1.0));
    let frames = FRAMES * rig.postures.len();
    let width: usize = joints.iter().map(|joint| joint.channels.len()).sum();
    let mut values = Vec::with_capacity(frames * width);
    for frame in 0..frames {
        let seconds = frame as f64 / RATE;
        let phase = seconds * std::f64::consts::TAU / 1.1;
        let index = frame / FRAMES;
        let mut angles = Angles::of(rig.postures[index], phase);
        if index > 0 {
            // The first third of a posture is the way into it.
            let part = ((frame % FRAMES) as f64 / (FRAMES as f64 / 3.0)).min(1.0);
            angles =
                Angles::of(rig.postures[index - 1], phase).blend(angles, part * part * (3.0 - 2.0 * part));
        }
        for (joint, (&bone, sway)) in joints.iter().zip(built.bones.iter().zip(&sway)) {
            if joint.channels.is_empty() {
                continue;
            }
            let mut rotation = *angles.rotation(bone).matrix();
            if !is_spare(bone) {
                let tilt = sway[0] * (sway[1] * seconds * 2.0 + sway[2]).sin();
                rotation *= Rotation3::from_euler_angles(tilt, 0.0, tilt).matrix();
            }
            if !rig.rest_is_y_up {
                rotation = axes * rotation * axes.transpose();
            } else if joint.parent.is_none() {
                rotation = axes * rotation;
            }
            if joint.parent.is_none() {
                values.extend([0.0; 3]);
            }
            values.extend(zxy_degrees(&rotation));
        }
    }
    let clip = Clip::new(joints.clone(), 1.0 / RATE, values.clone());
    // The lowest joint rests on the ground.
    let mut kinematics = Kinematics::new(&clip);
    let mut root: Vector3<f64> = axes * (place * scale);
    let mut support: Option<(usize, Vector3<f64>)> = None;
    for frame in 0..frames {
        let pose = kinematics.pose(frame);
        let height = |joint: usize| rig.up.height(&pose[joint]);
        let lowest = (0..pose.len()).min_by(|&a, &b| height(a).total_cmp(&height(b))).unwrap_or(0);
        if let Some((joint, position)) = support {
            root = position - pose[joint];
        }
        let up = axes * Vector3::y();
        root += up * (-height(lowest) - up.dot(&root));
        support = Some((lowest, root + pose[lowest]));
        values[frame * width..frame * width + 3].copy_from_slice(root.as_slice());
    }
    Clip::new(joints, 1.0 / RATE, values)
}
