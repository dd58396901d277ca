//! Motion of one foot around an instant, for the comparison of instants.

use crate::foot::Side;
use crate::plants::{Detection, Feet};

/// Height that counts as 1, in leg lengths; that of the cap of the clustering.
const HEIGHT_UNIT: f64 = 0.4;
/// Speed from which speeds are compared by their ratio rather than by their difference, in leg lengths per
/// second: that below which a foot is still.
const SLOW_SPEED: f64 = 0.35;
/// Speed that counts as 1, in leg lengths per second; that of the cap of the clustering.
const SPEED_UNIT: f64 = 8.0;

/// Heights and speeds of the labelled parts of one foot.
#[derive(Debug)]
pub(super) struct Profile {
    /// Scaled heights and speeds, one series per quantity.
    series: Vec<Vec<f32>>,
    pub frame_time: f64,
}

impl Profile {
    pub fn new(feet: &Feet, detection: &Detection, side: Side) -> Profile {
        let [height, slow] = [HEIGHT_UNIT, SLOW_SPEED].map(|value| value * feet.leg);
        let speed_unit = (1.0 + SPEED_UNIT / SLOW_SPEED).ln();
        let scaled = |values: &[f32], scale: &dyn Fn(f64) -> f64| {
            values.iter().map(|&value| scale(f64::from(value)) as f32).collect::<Vec<f32>>()
        };
        let series = detection.parts.iter().flat_map(|labels| {
            let foot = labels.foot(side);
            [
                scaled(&foot.height, &|value| value / height),
                scaled(&foot.speed, &|value| (1.0 + value / slow).ln() / speed_unit),
            ]
        });
        Profile { series: series.collect(), frame_time: feet.frame_time }
    }

    /// Returns all quantities at the given times, in seconds; constant beyond the ends of the clip.
    pub fn window(&self, times: impl Iterator<Item = f64> + Clone) -> Vec<f32> {
        let mut window = Vec::new();
        for series in &self.series {
            let last = series.len() - 1;
            window.extend(times.clone().map(|time| {
                let position = (time / self.frame_time).clamp(0.0, last as f64);
                let index = (position as usize).min(last.saturating_sub(1));
                let fraction = (position - index as f64) as f32;
                series[index] + fraction * (series[(index + 1).min(last)] - series[index])
            }));
        }
        window
    }
}

/// Returns the mean square difference of two windows; infinite if they have different quantities.
pub(super) fn difference(a: &[f32], b: &[f32]) -> f64 {
    if a.len() != b.len() {
        return f64::INFINITY;
    }
    a.iter().zip(b).map(|(a, b)| f64::from(a - b).powi(2)).sum::<f64>() / a.len() as f64
}

/// Returns the affinity of two windows: a Gaussian of their root mean square difference.
pub(super) fn affinity(a: &[f32], b: &[f32], bandwidth: f64) -> f64 {
    (-difference(a, b) / bandwidth.powi(2)).exp()
}
