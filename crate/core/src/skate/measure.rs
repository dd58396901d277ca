//! Foot skate: the slide of planted feet.

use std::ops::Range;

use nalgebra::Vector3;

use crate::foot::Side;
use crate::skate::leg::Leg;
use crate::skate::phases::{Phase, runs};
use crate::skeleton::Up;

/// Slide of every plant of a clip.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Skate {
    /// Plants of the left foot in order of time, then of the right foot.
    pub plants: Vec<Slide>,
}

/// Horizontal slide of one plant; on a treadmill, relative to the belt.
///
/// The part that is planted is measured: the toe joint during toe contact, the heel during heel
/// contact; the larger value counts.
#[derive(Clone, Debug, PartialEq)]
pub struct Slide {
    /// The foot.
    pub side: Side,
    /// Frames in which heel or toe is planted.
    pub frames: Range<usize>,
    /// Maximum horizontal distance of the part from its mean position over the plant, in metres.
    pub distance: f64,
    /// Frame of that distance.
    pub frame: usize,
    /// Length of the path of the part, in metres; jitter increases it with every frame.
    pub path: f64,
}

impl Skate {
    /// Returns the mean of [`Slide::distance`] over all plants, in metres; 0 without plants.
    pub fn mean(&self) -> f64 {
        let sum: f64 = self.plants.iter().map(|plant| plant.distance).sum();
        sum / self.plants.len().max(1) as f64
    }

    /// Returns the maximum of [`Slide::distance`] over all plants, in metres; 0 without plants.
    pub fn worst(&self) -> f64 {
        self.plants.iter().map(|plant| plant.distance).fold(0.0, f64::max)
    }
}

/// Returns distance, its frame, and path of one plant in file units: the maximum of toe and heel.
pub(crate) fn slide(
    leg: &Leg,
    phases: &[Phase],
    frames: &Range<usize>,
    heel: Vector3<f64>,
    up: Up,
) -> (f64, usize, f64) {
    let up = up.vector();
    let horizontal = |position: Vector3<f64>| position - up * up.dot(&position);
    let slide_of = |condition: fn(Phase) -> bool, part: &dyn Fn(usize) -> Vector3<f64>| {
        let mut max = (0.0_f64, frames.start, 0.0);
        for run in runs(phases, frames, condition) {
            let positions = || run.clone().map(|frame| horizontal(part(frame)));
            let mean = positions().sum::<Vector3<f64>>() / run.len() as f64;
            let distances = positions().map(|position| (position - mean).norm());
            for (frame, distance) in run.clone().zip(distances) {
                if distance > max.0 {
                    max = (distance, frame, max.2);
                }
            }
            let path = positions().zip(positions().skip(1)).map(|(a, b)| (b - a).norm()).sum::<f64>();
            max.2 += path;
        }
        max
    };
    let toe = slide_of(Phase::has_toe, &|frame| leg.toe[frame]);
    let heel = slide_of(Phase::has_heel, &|frame| leg.ankle[frame] + leg.foot[frame] * heel);
    let (distance, frame, _) = if heel.0 > toe.0 { heel } else { toe };
    (distance, frame, toe.2.max(heel.2))
}
