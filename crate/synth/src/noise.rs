//! Capture noise: of the feet of generated clips, and of motion from video.

use plantigrade::bvh::{Channel, Clip};

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

/// Noise of motion that was captured from video: the root wanders and joint rotations are uncertain.
/// Root mean squares over the three axes together.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct VideoNoise {
    /// Position of the root, in metres.
    pub root: f64,
    /// Slow error of joint rotations, in degrees.
    pub slow_rotation: f64,
    /// Fast error of joint rotations, in degrees.
    pub fast_rotation: f64,
}

/// Cut-off frequencies of the noise of video capture, in Hz.
const ROOT_CUTOFF: f64 = 0.7;
const SLOW_ROTATION_CUTOFF: f64 = 1.5;
const FAST_ROTATION_CUTOFF: f64 = 6.0;

impl VideoNoise {
    /// Noise of a typical recording.
    pub const TYPICAL: VideoNoise = VideoNoise { root: 0.02, slow_rotation: 1.5, fast_rotation: 0.4 };

    /// Returns the noise scaled by `level`.
    pub fn scaled(self, level: f64) -> VideoNoise {
        VideoNoise {
            root: self.root * level,
            slow_rotation: self.slow_rotation * level,
            fast_rotation: self.fast_rotation * level,
        }
    }

    /// Returns a clip with noise: on the positions of its roots, whose unit is `metres_per_unit`
    /// metres, and on all rotations.
    pub fn apply(&self, clip: &Clip, metres_per_unit: f64, random: &mut Random) -> Clip {
        let (frames, rate) = (clip.frame_count(), clip.rate());
        let mut values = clip.values().to_vec();
        let mut add = |column: usize, size: f64, cutoff: f64| {
            let (noise, size) = (smooth_noise(random, frames, rate, cutoff), size / 3.0_f64.sqrt());
            for (row, noise) in values.chunks_mut(clip.channel_count()).zip(noise) {
                row[column] += size * noise;
            }
        };
        for (index, joint) in clip.joints().iter().enumerate() {
            for (column, channel) in clip.channel_range(index).zip(&joint.channels) {
                match channel {
                    Channel::Rotation(_) => {
                        add(column, self.slow_rotation, SLOW_ROTATION_CUTOFF);
                        add(column, self.fast_rotation, FAST_ROTATION_CUTOFF);
                    }
                    Channel::Position(_) if joint.parent.is_none() => {
                        add(column, self.root / metres_per_unit, ROOT_CUTOFF);
                    }
                    Channel::Position(_) | Channel::Scale(_) => {}
                }
            }
        }
        Clip::new(clip.joints().to_vec(), clip.frame_time(), values).with_position_rule(clip.position_rule())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{generate, samples};

    #[test]
    fn video_noise_has_its_root_mean_square() {
        let clip = generate(&samples(0.0)[0], 0).clip;
        let rows = 100_000 / clip.channel_count();
        let values: Vec<f64> = (0..rows).flat_map(|_| clip.row(0)).copied().collect();
        let still = Clip::new(clip.joints().to_vec(), clip.frame_time(), values);
        let root_mean_square = |noise: VideoNoise, column: usize| {
            let noisy = noise.apply(&still, 0.01, &mut Random::new(0, "video"));
            let differences = (0..rows).map(|frame| noisy.row(frame)[column] - still.row(0)[column]);
            (3.0 * differences.map(|difference| difference * difference).sum::<f64>() / rows as f64).sqrt()
        };
        let rotation = still.channel_range(1).start;
        assert!((root_mean_square(VideoNoise::TYPICAL, 0) / 2.0 - 1.0).abs() < 0.4);
        assert!((root_mean_square(VideoNoise::TYPICAL, rotation) / 1.55 - 1.0).abs() < 0.3);
        assert_eq!(root_mean_square(VideoNoise::TYPICAL.scaled(0.0), rotation), 0.0);
    }
}
