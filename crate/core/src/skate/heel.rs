//! Location of the heel, for which skeletons have no joint.

use std::ops::Range;

use nalgebra::{Matrix3, Vector3};

use crate::numeric::stats::median_low;
use crate::skate::leg::Leg;
use crate::skate::phases::{Phase, runs};
use crate::skeleton::Up;

/// Regularisation of the fit per frame, in squared radians.
const REGULARISATION: f64 = 1e-3;

/// Maximum distance of the fit from the initial guess, in leg lengths.
const MAX_DISTANCE: f64 = 0.12;

/// Returns the point about which the foot rolls on its heel, relative to the ankle in the ankle's
/// axes.
///
/// It is the point that moves least while only the heel is planted (least squares over all such
/// frames). If these frames do not determine it, it is the point of the sole below the ankle of the
/// flat foot.
pub(crate) fn locate_heel(
    leg: &Leg,
    phases: &[Phase],
    plants: &[Range<usize>],
    up: Up,
    length: f64,
) -> Vector3<f64> {
    let guess = point_below_ankle(leg, phases, up);
    let (mut matrix, mut vector, mut count) = (Matrix3::zeros(), Vector3::zeros(), 0.0);
    for run in plants.iter().flat_map(|plant| runs(phases, plant, |phase| phase == Phase::Heel)) {
        let weight = 1.0 / run.len() as f64;
        let foot = run.clone().map(|frame| leg.foot[frame]).sum::<Matrix3<f64>>() * weight;
        let ankle = run.clone().map(|frame| leg.ankle[frame]).sum::<Vector3<f64>>() * weight;
        for frame in run {
            let rotation = (leg.foot[frame] - foot).transpose();
            matrix += rotation * rotation.transpose();
            vector -= rotation * (leg.ankle[frame] - ankle);
            count += 1.0;
        }
    }
    let regularisation = REGULARISATION * count;
    let fit = (matrix + Matrix3::identity() * regularisation).lu().solve(&(vector + guess * regularisation));
    fit.filter(|fit| (fit - guess).norm() <= MAX_DISTANCE * length).unwrap_or(guess)
}

/// Returns the vector from the ankle down to the level of toe or tip, for the flat foot.
fn point_below_ankle(leg: &Leg, phases: &[Phase], up: Up) -> Vector3<f64> {
    let flat = || (0..phases.len()).filter(|&frame| phases[frame] == Phase::Flat);
    let height = |frame: usize| {
        up.height(&leg.ankle[frame]) - up.height(&leg.toe[frame]).min(up.height(&leg.tip[frame]))
    };
    let Some(height) = median_low(flat().map(height)) else { return Vector3::zeros() };
    let upwards: Vector3<f64> = flat().map(|frame| leg.foot[frame].transpose() * up.vector()).sum();
    upwards.try_normalize(1e-9).unwrap_or_default() * -height.max(0.0)
}
