//! Capture noise of feet: jitter, slow sliding and vertical offset of each plant.

use crate::foot_path::{FootPath, FootPose};
use crate::math::Random;
use crate::math::Vec3;
use crate::math::{GRID_RATE, TimeGrid};
use crate::math::{smooth_noise, smooth_step};

/// Standard deviations of foot noise, in metres.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Noise {
    /// Jitter below 12 Hz, per axis.
    pub jitter: f64,
    /// Slow horizontal sliding below 0.8 Hz, per axis.
    pub slide: f64,
    /// Vertical offset of each plant.
    pub float: f64,
}

/// Cut-off frequencies of jitter and sliding, in Hz.
const JITTER_CUTOFF: f64 = 12.0;
const SLIDE_CUTOFF: f64 = 0.8;

/// Pitch and heading noise per metre of jitter, in radians: markers about 10 cm apart move
/// independently.
const ROTATION_PER_METRE: f64 = 2.5;

impl Noise {
    /// Returns the noise scaled by `level`.
    pub fn scaled(self, level: f64) -> Noise {
        Noise { jitter: self.jitter * level, slide: self.slide * level, float: self.float * level }
    }

    /// Adds noise to the feet of one side, one pose per point of `grid`. Returns the added height
    /// per point, in metres.
    pub fn apply(
        &self,
        feet: &mut [FootPose],
        path: &FootPath,
        grid: &TimeGrid,
        random: &mut Random,
    ) -> Vec<f64> {
        let rate = GRID_RATE as f64;
        let [x, y, z, pitch, yaw] =
            std::array::from_fn(|_| smooth_noise(random, grid.len(), rate, JITTER_CUTOFF));
        let [slide_x, slide_z] =
            std::array::from_fn(|_| smooth_noise(random, grid.len(), rate, SLIDE_CUTOFF));
        let floats: Vec<f64> = path.stances().iter().map(|_| random.normal().clamp(-2.0, 2.0)).collect();
        let heights = feet.iter_mut().enumerate().map(|(n, foot)| {
            let jitter = self.jitter * Vec3::new(x[n], y[n], z[n]);
            let slide = self.slide * Vec3::new(slide_x[n], 0.0, slide_z[n]);
            let float = self.float * Vec3::y() * float_at(path, &floats, grid.time(n));
            foot.ankle += jitter + slide + float;
            foot.pitch += ROTATION_PER_METRE * self.jitter * pitch[n];
            foot.heading += ROTATION_PER_METRE * self.jitter * yaw[n];
            jitter.y + float.y
        });
        heights.collect()
    }
}

/// Returns the vertical offset at `time`, interpolated smoothly between stances.
fn float_at(path: &FootPath, floats: &[f64], time: f64) -> f64 {
    let stances = path.stances();
    let index = stances.partition_point(|stance| stance.strike <= time).max(1) - 1;
    let Some(next) = stances.get(index + 1) else { return floats[index] };
    let u = smooth_step((time - stances[index].toe_off) / (next.strike - stances[index].toe_off));
    floats[index] + (floats[index + 1] - floats[index]) * u
}
