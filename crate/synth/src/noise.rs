//! What recording does to feet: jitter, slow sliding, and plants that float.

use crate::curve::{drift, smooth_step};
use crate::feet::{FootPath, FootPose};
use crate::grid::{GRID_RATE, Grid};
use crate::maths::Vec3;
use crate::random::Random;

/// Standard deviations of a character's foot noise, in metres.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Noise {
    /// Jitter below 12 Hz, along each axis.
    pub jitter: f64,
    /// Slow horizontal sliding below 0.8 Hz, along each axis.
    pub slide: f64,
    /// Height of each plant above or below the ground.
    pub float: f64,
}

/// Cut-off of jitter and of sliding, in hertz.
const JITTER_BAND: f64 = 12.0;
const SLIDE_BAND: f64 = 0.8;

/// Radians of pitch and turn that go with a metre of jitter: markers a hand's
/// breadth apart move independently.
const TILT: f64 = 2.5;

impl Noise {
    /// The same noise, `level` times as strong.
    pub fn times(self, level: f64) -> Noise {
        Noise { jitter: self.jitter * level, slide: self.slide * level, float: self.float * level }
    }

    /// Moves the feet of one side, one pose for each point of `grid`. Returns how far up
    /// each was moved, in metres.
    pub fn disturb(
        &self,
        feet: &mut [FootPose],
        path: &FootPath,
        grid: &Grid,
        random: &mut Random,
    ) -> Vec<f64> {
        let rate = GRID_RATE as f64;
        let [x, y, z, pitch, yaw] = std::array::from_fn(|_| drift(random, grid.len(), rate, JITTER_BAND));
        let [slide_x, slide_z] = std::array::from_fn(|_| drift(random, grid.len(), rate, SLIDE_BAND));
        let floats: Vec<f64> = path.stances().iter().map(|_| random.normal().clamp(-2.0, 2.0)).collect();
        let disturbed = feet.iter_mut().enumerate().map(|(n, foot)| {
            let jitter = self.jitter * Vec3::new(x[n], y[n], z[n]);
            let slide = self.slide * Vec3::new(slide_x[n], 0.0, slide_z[n]);
            let float = self.float * Vec3::y() * float_at(path, &floats, grid.time(n));
            foot.ankle += jitter + slide + float;
            foot.pitch += TILT * self.jitter * pitch[n];
            foot.heading += TILT * self.jitter * yaw[n];
            jitter.y + float.y
        });
        disturbed.collect()
    }
}

/// The float of the stance at `time`, or the way from one to the next.
fn float_at(path: &FootPath, floats: &[f64], time: f64) -> f64 {
    let stances = path.stances();
    let index = stances.partition_point(|stance| stance.strike <= time).max(1) - 1;
    let Some(next) = stances.get(index + 1) else { return floats[index] };
    let u = smooth_step((time - stances[index].off) / (next.strike - stances[index].off));
    floats[index] + (floats[index + 1] - floats[index]) * u
}
