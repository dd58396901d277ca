//! Where the heel is: skeletons have no joint for it.

use std::ops::Range;

use nalgebra::{Matrix3, Vector3};

use crate::skate::leg::{Leg, median, upright};
use crate::skate::phases::{Phase, runs};
use crate::skeleton::Up;

/// What a frame's say in the fit is set against, in squared radians: how much a guess weighs.
const DOUBT: f64 = 1e-3;

/// How far from the guess the fit may be, in legs.
const NEAR: f64 = 0.12;

/// The point of the foot that it rolls about on its heel, in the ankle's axes from the ankle.
///
/// The one that moves least while the heel alone stands (least squares over all such frames);
/// where these say little, the point of the sole right under the ankle of the flat foot.
pub(crate) fn heel(
    leg: &Leg,
    phases: &[Phase],
    plants: &[Range<usize>],
    up: Up,
    length: f64,
) -> Vector3<f64> {
    let below = below(leg, phases, up);
    let (mut matrix, mut vector, mut count) = (Matrix3::zeros(), Vector3::zeros(), 0.0);
    for run in plants.iter().flat_map(|plant| runs(phases, plant, |phase| phase == Phase::Heel)) {
        let share = 1.0 / run.len() as f64;
        let foot = run.clone().map(|frame| leg.foot[frame]).sum::<Matrix3<f64>>() * share;
        let ankle = run.clone().map(|frame| leg.ankle[frame]).sum::<Vector3<f64>>() * share;
        for frame in run {
            let turned = (leg.foot[frame] - foot).transpose();
            matrix += turned * turned.transpose();
            vector -= turned * (leg.ankle[frame] - ankle);
            count += 1.0;
        }
    }
    let doubt = DOUBT * count;
    let fit = (matrix + Matrix3::identity() * doubt).lu().solve(&(vector + below * doubt));
    fit.filter(|fit| (fit - below).norm() <= NEAR * length).unwrap_or(below)
}

/// From the ankle straight down to the level of toe or tip, as the flat foot stands.
fn below(leg: &Leg, phases: &[Phase], up: Up) -> Vector3<f64> {
    let flat = || (0..phases.len()).filter(|&frame| phases[frame] == Phase::Flat);
    let height = |frame: usize| {
        up.height(&leg.ankle[frame]) - up.height(&leg.toe[frame]).min(up.height(&leg.tip[frame]))
    };
    let Some(height) = median(flat().map(height)) else { return Vector3::zeros() };
    let upwards: Vector3<f64> = flat().map(|frame| leg.foot[frame].transpose() * upright(up)).sum();
    upwards.try_normalize(1e-9).unwrap_or_default() * -height.max(0.0)
}
