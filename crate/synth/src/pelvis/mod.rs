//! Motion of the pelvis, computed from the feet.

mod balance;
mod flight;
mod height;
mod pelvis_pose;
mod reach;
mod support;

pub use pelvis_pose::PelvisPose;
pub(crate) use reach::hip;

use crate::character::Proportions;
use crate::foot_path::{FootPath, FootPose};
use crate::math::{
    GRID_RATE, Random, TimeGrid, Track, Vec3, forward, gaussian_blur, heading_rotation, leftward,
    rotation_about, smooth_noise,
};
use crate::plan::Plan;

/// Cut-off frequency of standing sway, in Hz.
const SWAY_CUTOFF: f64 = 0.35;

/// Time in which the body follows a change of ground height, in seconds.
const CLIMB_TIME: f64 = 0.11;

/// Iterations that fit flights to the reach of the legs.
const FLIGHT_ITERATIONS: usize = 3;

/// Maximum foot distance to which the pelvis responds, in metres.
const MAX_STRIDE: f64 = 0.75;

/// Returns the pose of the pelvis at each point of `grid`.
pub fn track(
    plan: &Plan,
    proportions: &Proportions,
    grid: &TimeGrid,
    paths: &[FootPath; 2],
    feet: &[Vec<FootPose>; 2],
) -> Vec<PelvisPose> {
    let support = support::Support::new(paths, grid, proportions);
    let mean = |n: usize| (feet[0][n].heading + feet[1][n].heading) / 2.0;
    let headings = gaussian_blur(&(0..grid.len()).map(mean).collect::<Vec<_>>(), TimeGrid::points(0.14));
    let stride = |n: usize| {
        let separation = feet[0][n].ankle - feet[1][n].ankle;
        separation.dot(&forward(headings[n])).clamp(-MAX_STRIDE, MAX_STRIDE)
    };
    let strides = gaussian_blur(&(0..grid.len()).map(stride).collect::<Vec<_>>(), TimeGrid::points(0.05));
    let balances = gaussian_blur(&support.balance, TimeGrid::points(0.07));
    // On stairs the body rises with the foot that bears the weight.
    let steps: Vec<f64> =
        support.centre_of_pressure.iter().map(|centre_of_pressure| centre_of_pressure.y).collect();
    let ground = gaussian_blur(&steps, TimeGrid::points(CLIMB_TIME));

    let pose = |height: &Track<1>| -> Vec<PelvisPose> {
        let heights: Vec<f64> = grid.times().map(|t| height.at(t)[0] - plan.body.lowering.at(t)[0]).collect();
        let positions = balance::horizontal_positions(&support, &heights);
        let pose = |n: usize| {
            let time = grid.time(n);
            let [tilt, yaw, lean] = plan.body.pelvis.at(time).map(f64::to_radians);
            let yaw = yaw - (plan.body.pelvic_rotation * strides[n]).to_radians();
            let lean = lean + (plan.body.pelvic_drop * balances[n]).to_radians();
            let rotation =
                heading_rotation(headings[n] + yaw) * rotation_about(0, tilt) * rotation_about(2, lean);
            let offset = counterweight(plan, proportions, time);
            let position = Vec3::new(positions[0][n], heights[n] + ground[n], positions[1][n])
                + offset[0] * leftward(headings[n])
                + offset[1] * forward(headings[n]);
            PelvisPose { position, rotation, heading: headings[n], stride: strides[n], balance: balances[n] }
        };
        (0..grid.len()).map(pose).collect()
    };

    // The position of the body at the ends of a flight limits its height there; lower heights in
    // turn change the position slightly.
    let mut flights = flight::flights_with_heights(plan, proportions, paths);
    let mut poses = pose(&height::track(plan, proportions, paths, &flights));
    for _ in 0..FLIGHT_ITERATIONS {
        for flight in &mut flights {
            let [excess_at_take_off, excess_at_landing] = [flight.time.start, flight.time.end]
                .map(|time| reach::excess_height(&poses, feet, proportions, grid, time));
            flight.lower(excess_at_take_off, excess_at_landing);
        }
        poses = pose(&height::track(plan, proportions, paths, &flights));
    }
    reach::lower_pelvis(&mut poses, feet, proportions);
    poses
}

/// Adds standing sway to the pelvis; `amount` is the standard deviation, in metres.
pub fn add_sway(poses: &mut [PelvisPose], amount: f64, random: &mut Random) {
    let [left, ahead] =
        std::array::from_fn(|_| smooth_noise(random, poses.len(), GRID_RATE as f64, SWAY_CUTOFF));
    for (n, pose) in poses.iter_mut().enumerate() {
        pose.position += amount * (left[n] * leftward(pose.heading) + ahead[n] * forward(pose.heading));
    }
}

/// Raises the pelvis by the noise heights of the loaded feet, so that noise of a standing foot does
/// not shake the knee. `heights` holds one value per foot and point, in metres.
pub fn follow_foot_noise(poses: &mut [PelvisPose], heights: &[Vec<f64>; 2]) {
    for (n, pose) in poses.iter_mut().enumerate() {
        let left = (1.0 + pose.balance) / 2.0;
        pose.position.y += left * heights[0][n] + (1.0 - left) * heights[1][n];
    }
}

/// Returns the horizontal shift of the pelvis that balances the trunk: left and forward, in metres.
/// A trunk that bends forward moves the pelvis back.
fn counterweight(plan: &Plan, proportions: &Proportions, time: f64) -> [f64; 2] {
    let [pitch, _, lean] = plan.body.trunk.at(time).map(f64::to_radians);
    let [left, ahead] = plan.body.shift.at(time);
    let lever = 0.5 * proportions.trunk;
    [left + lever * libm::sin(lean), ahead - lever * libm::sin(pitch)]
}
