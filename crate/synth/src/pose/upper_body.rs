//! Upper body: spine, head and arms, driven by pelvis and plan.

use plantigrade::foot::Side;

use super::Pose;
use crate::character::{Bone, lateral_sign};
use crate::math::Random;
use crate::math::smooth_noise;
use crate::math::{GRID_RATE, TimeGrid};
use crate::math::{Rot, heading_rotation, nlerp, rotation_about};
use crate::pelvis::PelvisPose;
use crate::plan::BodyTracks;

/// Time by which the gaze leads the body, in seconds.
const LOOK_AHEAD: f64 = 0.25;

/// Counter-rotation of the shoulders as a multiple of the pelvic rotation.
const COUNTER_TURN: f64 = 2.3;

/// Idle noise: slow smooth noise for each angle of the upper body.
pub struct IdleNoise([Vec<f64>; 9]);

impl IdleNoise {
    /// Generates noise for the points of `grid`.
    pub fn new(grid: &TimeGrid, random: &mut Random) -> IdleNoise {
        IdleNoise(std::array::from_fn(|_| smooth_noise(random, grid.len(), GRID_RATE as f64, 0.5)))
    }
}

/// Poses spine, head and arms at the grid point `index`.
pub fn solve_upper_body(
    pose: &mut Pose,
    track: &[PelvisPose],
    index: usize,
    grid: &TimeGrid,
    body: &BodyTracks,
    spine: usize,
    idle_noise: &IdleNoise,
) {
    let time = grid.time(index);
    let pelvis = &track[index];
    let noise = |n: usize| body.sway * idle_noise.0[n][index];

    let [pitch, yaw, lean] = body.trunk.at(time);
    let [tilt, pelvis_yaw, pelvis_lean] = body.pelvis.at(time);
    let step_turn = body.pelvic_rotation * pelvis.stride;
    let step_lean = body.pelvic_drop * pelvis.balance;
    // The plan gives the trunk relative to upright, so the rotation of the pelvis is subtracted.
    let chest = trunk(
        pitch - tilt + noise(0),
        yaw - pelvis_yaw + COUNTER_TURN * step_turn + noise(1),
        lean - pelvis_lean - 1.1 * step_lean + noise(2),
        spine,
    );
    let mut upper = pelvis.rotation;
    for n in 0..spine {
        pose.set_rotation(Bone::Spine(n), chest);
        upper *= chest;
    }

    let ahead = &track[(index + TimeGrid::points(LOOK_AHEAD) as usize).min(track.len() - 1)];
    let [look_yaw, look_down] = body.gaze.at(time).map(f64::to_radians);
    let gaze = heading_rotation(ahead.heading + look_yaw + noise(3).to_radians())
        * rotation_about(0, look_down + 0.3 * pitch.to_radians() + noise(4).to_radians());
    let needed = upper.inverse() * gaze;
    let neck = nlerp(&Rot::identity(), &needed, 0.5);
    pose.set_rotation(Bone::Neck, neck);
    pose.set_rotation(Bone::Head, neck.inverse() * needed);

    let swing = body.arm_swing.at(time)[0] * pelvis.stride;
    for side in Side::BOTH {
        let mut angles = body.arms[side as usize].at(time);
        let forward = -lateral_sign(side) * swing;
        angles[0] += forward + noise(5 + side as usize);
        angles[1] += 0.5 * noise(7 + side as usize);
        angles[3] += 0.55 * forward.max(0.0) + 0.1 * forward.min(0.0);
        arm(pose, side, angles);
    }
}

/// Returns the rotation of one spine joint from the angles of the trunk: forward pitch, left
/// rotation, left lean, in degrees.
fn trunk(pitch: f64, yaw: f64, lean: f64, parts: usize) -> Rot {
    let part = |degrees: f64| degrees.to_radians() / parts as f64;
    rotation_about(1, part(yaw)) * rotation_about(0, part(pitch)) * rotation_about(2, part(lean))
}

/// Poses one arm; angles in degrees as in [`BodyTracks::arms`].
fn arm(pose: &mut Pose, side: Side, angles: [f64; 5]) {
    let out = lateral_sign(side);
    let [flexion, abduction, twist, elbow, wrist] = angles.map(f64::to_radians);
    // Raised arms lift the collar bone.
    let raised = (abduction.max(0.6 * flexion) - 0.5).max(0.0);
    let shrug = 0.28 * raised * raised / (0.5 + raised);
    let quarter = std::f64::consts::FRAC_PI_2;
    let hanging = rotation_about(2, -out * (quarter - abduction + shrug));
    pose.set_rotation(Bone::Clavicle(side), rotation_about(2, out * shrug));
    pose.set_rotation(Bone::UpperArm(side), rotation_about(0, -flexion) * hanging * rotation_about(0, twist));
    pose.set_rotation(
        Bone::Forearm(side),
        rotation_about(1, -out * elbow.max(0.05)) * rotation_about(0, 0.4),
    );
    pose.set_rotation(Bone::Hand(side), rotation_about(2, -out * wrist));
}
