//! The upper body: spine, head and arms, following pelvis and plan.

use plantigrade::foot::Side;

use super::Pose;
use crate::character::{Bone, outward};
use crate::curve::drift;
use crate::grid::{GRID_RATE, Grid};
use crate::maths::{Rot, between, heading, turn};
use crate::pelvis::PelvisPose;
use crate::plan::Body;
use crate::random::Random;

/// How far ahead of the body the eyes are, in seconds.
const LOOK_AHEAD: f64 = 0.25;

/// Shoulders turn against the pelvis: times the pelvis's own turn.
const COUNTER_TURN: f64 = 2.3;

/// The slow unrest of a living body: smooth noise for each of its angles.
pub struct Restlessness([Vec<f64>; 9]);

impl Restlessness {
    /// Unrest over `grid`.
    pub fn new(grid: &Grid, random: &mut Random) -> Restlessness {
        Restlessness(std::array::from_fn(|_| drift(random, grid.len(), GRID_RATE as f64, 0.5)))
    }
}

/// Poses spine, head and arms at the grid point `index`.
pub fn upper(
    pose: &mut Pose,
    track: &[PelvisPose],
    index: usize,
    grid: &Grid,
    body: &Body,
    spine: usize,
    rest: &Restlessness,
) {
    let time = grid.time(index);
    let pelvis = &track[index];
    let unrest = |n: usize| body.sway * rest.0[n][index];

    let [pitch, yaw, lean] = body.trunk.at(time);
    let [tilt, pelvis_yaw, pelvis_lean] = body.pelvis.at(time);
    let step_turn = body.pelvis_turn * pelvis.stride;
    let step_lean = body.pelvis_drop * pelvis.balance;
    // The plan gives the trunk against upright: what the pelvis does is taken off.
    let chest = trunk(
        pitch - tilt + unrest(0),
        yaw - pelvis_yaw + COUNTER_TURN * step_turn + unrest(1),
        lean - pelvis_lean - 1.1 * step_lean + unrest(2),
        spine,
    );
    let mut upper = pelvis.rotation;
    for n in 0..spine {
        pose.set(Bone::Spine(n), chest);
        upper *= chest;
    }

    let ahead = &track[(index + Grid::points(LOOK_AHEAD) as usize).min(track.len() - 1)];
    let [look_yaw, look_down] = body.look.at(time).map(f64::to_radians);
    let gaze = heading(ahead.heading + look_yaw + unrest(3).to_radians())
        * turn(0, look_down + 0.3 * pitch.to_radians() + unrest(4).to_radians());
    let needed = upper.inverse() * gaze;
    let neck = between(&Rot::identity(), &needed, 0.5);
    pose.set(Bone::Neck, neck);
    pose.set(Bone::Head, neck.inverse() * needed);

    let swing = body.arm_swing.at(time)[0] * pelvis.stride;
    for side in Side::BOTH {
        let mut angles = body.arms[side as usize].at(time);
        let forward = -outward(side) * swing;
        angles[0] += forward + unrest(5 + side as usize);
        angles[1] += 0.5 * unrest(7 + side as usize);
        angles[3] += 0.55 * forward.max(0.0) + 0.1 * forward.min(0.0);
        arm(pose, side, angles);
    }
}

/// A part of the spine's turn: angles in degrees, forward, left, leaning left.
fn trunk(pitch: f64, yaw: f64, lean: f64, parts: usize) -> Rot {
    let part = |degrees: f64| degrees.to_radians() / parts as f64;
    turn(1, part(yaw)) * turn(0, part(pitch)) * turn(2, part(lean))
}

/// Poses one arm; angles in degrees as in [`Body::arms`].
fn arm(pose: &mut Pose, side: Side, angles: [f64; 5]) {
    let out = outward(side);
    let [flex, abduct, twist, elbow, wrist] = angles.map(f64::to_radians);
    // Raised arms take the collar bone up with them.
    let raised = (abduct.max(0.6 * flex) - 0.5).max(0.0);
    let shrug = 0.28 * raised * raised / (0.5 + raised);
    let quarter = std::f64::consts::FRAC_PI_2;
    let hanging = turn(2, -out * (quarter - abduct + shrug));
    pose.set(Bone::Clavicle(side), turn(2, out * shrug));
    pose.set(Bone::UpperArm(side), turn(0, -flex) * hanging * turn(0, twist));
    pose.set(Bone::Forearm(side), turn(1, -out * elbow.max(0.05)) * turn(0, 0.4));
    pose.set(Bone::Hand(side), turn(2, -out * wrist));
}
