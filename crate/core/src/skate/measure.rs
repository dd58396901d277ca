//! How far planted feet slide.

use std::ops::Range;

use nalgebra::Vector3;

use crate::foot::Side;
use crate::skate::leg::{Leg, upright};
use crate::skate::phases::{Phase, runs};
use crate::skeleton::Up;

/// The slide of every plant of a clip.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Skate {
    /// The left foot's plants in order of time, then the right's.
    pub plants: Vec<Slide>,
}

/// How far one plant slides, level with the ground.
///
/// Measured is the part that stands: the toe joint while the toe is down, the heel while the
/// heel is down; of both, the farther.
#[derive(Clone, Debug, PartialEq)]
pub struct Slide {
    /// Which foot.
    pub side: Side,
    /// The frames in which heel or toe stands.
    pub frames: Range<usize>,
    /// Greatest distance of the part from its mean position over the plant, in metres.
    pub farthest: f64,
    /// Length of the part's way, in metres; jitter adds to it with every frame.
    pub path: f64,
}

impl Skate {
    /// Mean of [`Slide::farthest`] over all plants, in metres; 0 without plants.
    pub fn mean(&self) -> f64 {
        let sum: f64 = self.plants.iter().map(|plant| plant.farthest).sum();
        sum / self.plants.len().max(1) as f64
    }

    /// Greatest [`Slide::farthest`] of any plant, in metres; 0 without plants.
    pub fn worst(&self) -> f64 {
        self.plants.iter().map(|plant| plant.farthest).fold(0.0, f64::max)
    }
}

/// The farthest and the path of one plant in file units: of toe or of heel, whichever is more.
pub(crate) fn slide(
    leg: &Leg,
    phases: &[Phase],
    frames: &Range<usize>,
    heel: Vector3<f64>,
    up: Up,
) -> (f64, f64) {
    let upright = upright(up);
    let level = |position: Vector3<f64>| position - upright * upright.dot(&position);
    let of = |wanted: fn(Phase) -> bool, part: &dyn Fn(usize) -> Vector3<f64>| {
        let mut most = (0.0_f64, 0.0);
        for run in runs(phases, frames, wanted) {
            let positions = || run.clone().map(|frame| level(part(frame)));
            let mean = positions().sum::<Vector3<f64>>() / run.len() as f64;
            let farthest = positions().map(|position| (position - mean).norm()).fold(0.0, f64::max);
            let path = positions().zip(positions().skip(1)).map(|(a, b)| (b - a).norm()).sum::<f64>();
            most = (most.0.max(farthest), most.1 + path);
        }
        most
    };
    let toe = of(Phase::has_toe, &|frame| leg.toe[frame]);
    let heel = of(Phase::has_heel, &|frame| leg.ankle[frame] + leg.foot[frame] * heel);
    (toe.0.max(heel.0), toe.1.max(heel.1))
}
