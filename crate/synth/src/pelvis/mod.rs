//! From the feet to the pelvis: where the body is carried.

mod balance;
mod height;
mod leap;
mod reach;
mod support;

pub(crate) use reach::hip;

use crate::character::Build;
use crate::curve::{Track, blur, drift};
use crate::feet::{FootPath, FootPose};
use crate::grid::{GRID_RATE, Grid};
use crate::maths::{Rot, Vec3, forward, heading, leftward, turn};
use crate::plan::Plan;
use crate::random::Random;

/// The pelvis at one moment, with what the upper body follows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PelvisPose {
    /// The pelvis joint, in metres.
    pub position: Vec3,
    /// Its orientation.
    pub rotation: Rot,
    /// Turn of the body to the left, in radians.
    pub heading: f64,
    /// How far the left foot is ahead of the right, in metres.
    pub stride: f64,
    /// Share of the weight on the left foot less that on the right.
    pub balance: f64,
}

/// Frequency below which a standing body sways, in hertz.
const SWAY_BAND: f64 = 0.35;

/// Seconds over which the body follows a change of the ground's height.
const CLIMB: f64 = 0.11;

/// Rounds in which flights are fitted to the reach of the legs.
const LEAP_ROUNDS: usize = 3;

/// Greatest distance of the feet that the body answers to, in metres.
const GREATEST_STRIDE: f64 = 0.75;

/// The pelvis at each point of `grid`.
pub fn track(
    plan: &Plan,
    build: &Build,
    grid: &Grid,
    paths: &[FootPath; 2],
    feet: &[Vec<FootPose>; 2],
) -> Vec<PelvisPose> {
    let support = support::Support::new(paths, grid, build);
    let mean = |n: usize| (feet[0][n].heading + feet[1][n].heading) / 2.0;
    let headings = blur(&(0..grid.len()).map(mean).collect::<Vec<_>>(), Grid::points(0.14));
    let ahead = |n: usize| {
        let apart = feet[0][n].ankle - feet[1][n].ankle;
        apart.dot(&forward(headings[n])).clamp(-GREATEST_STRIDE, GREATEST_STRIDE)
    };
    let strides = blur(&(0..grid.len()).map(ahead).collect::<Vec<_>>(), Grid::points(0.05));
    let balances = blur(&support.balance, Grid::points(0.07));
    // On stairs the body rises with the foot that takes the weight.
    let steps: Vec<f64> = support.pressure.iter().map(|pressure| pressure.y).collect();
    let ground = blur(&steps, Grid::points(CLIMB));

    let pose = |height: &Track<1>| -> Vec<PelvisPose> {
        let heights: Vec<f64> = grid.times().map(|t| height.at(t)[0] - plan.body.sink.at(t)[0]).collect();
        let ways = balance::ways(&support, &heights);
        let pose = |n: usize| {
            let time = grid.time(n);
            let [tilt, yaw, lean] = plan.body.pelvis.at(time).map(f64::to_radians);
            let yaw = yaw - (plan.body.pelvis_turn * strides[n]).to_radians();
            let lean = lean + (plan.body.pelvis_drop * balances[n]).to_radians();
            let rotation = heading(headings[n] + yaw) * turn(0, tilt) * turn(2, lean);
            let offset = counterweight(plan, build, time);
            let position = Vec3::new(ways[0][n], heights[n] + ground[n], ways[1][n])
                + offset[0] * leftward(headings[n])
                + offset[1] * forward(headings[n]);
            PelvisPose { position, rotation, heading: headings[n], stride: strides[n], balance: balances[n] }
        };
        (0..grid.len()).map(pose).collect()
    };

    // Where the body is at the ends of a flight shows how high it may be there, and that
    // in turn moves the body a little.
    let mut leaps = leap::leaps(plan, build, paths);
    let mut poses = pose(&height::track(plan, build, paths, &leaps));
    for _ in 0..LEAP_ROUNDS {
        for leap in &mut leaps {
            let [off, land] = [leap.time.start, leap.time.end]
                .map(|time| reach::shortfall(&poses, feet, build, grid, time));
            leap.lower(off, land);
        }
        poses = pose(&height::track(plan, build, paths, &leaps));
    }
    reach::lower(&mut poses, feet, build);
    poses
}

/// Sways the pelvis a little, as a body does even when it stands: `amount` is the
/// standard deviation in metres.
pub fn sway(poses: &mut [PelvisPose], amount: f64, random: &mut Random) {
    let [left, ahead] = std::array::from_fn(|_| drift(random, poses.len(), GRID_RATE as f64, SWAY_BAND));
    for (n, pose) in poses.iter_mut().enumerate() {
        pose.position += amount * (left[n] * leftward(pose.heading) + ahead[n] * forward(pose.heading));
    }
}

/// Lifts the pelvis with the feet that carry it, `moved` metres each: a leg that stands
/// on noisy ground does not shake at the knee.
pub fn lift(poses: &mut [PelvisPose], moved: &[Vec<f64>; 2]) {
    for (n, pose) in poses.iter_mut().enumerate() {
        let left = (1.0 + pose.balance) / 2.0;
        pose.position.y += left * moved[0][n] + (1.0 - left) * moved[1][n];
    }
}

/// How far the pelvis gives way to the trunk: what is balanced is the body, and a
/// trunk that bends forward takes the pelvis back. Left and forward, in metres.
fn counterweight(plan: &Plan, build: &Build, time: f64) -> [f64; 2] {
    let [pitch, _, lean] = plan.body.trunk.at(time).map(f64::to_radians);
    let [left, ahead] = plan.body.shift.at(time);
    let lever = 0.5 * build.trunk;
    [left + lever * libm::sin(lean), ahead - lever * libm::sin(pitch)]
}
