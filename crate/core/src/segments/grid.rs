//! Sampling instants of a clip at a fixed rate, independent of the frame rate.

use std::ops::Range;

use crate::bvh::Clip;
use crate::numeric::interpolate;

/// Maximum number of samples per frame, which 30 samples per second reach at 6 Hz. More samples of the curve
/// between two frames would tell nothing.
const MAX_SAMPLES_PER_FRAME: f64 = 5.0;

/// Maximum number of frames per sample. No clip has as many, but frame times may be 0.
const MAX_FRAMES_PER_SAMPLE: f64 = 1e9;

/// Sampling instants over a range of frames.
#[derive(Debug)]
pub(crate) struct SampleGrid {
    first: usize,
    last: usize,
    /// Frames per sample.
    step: f64,
    frame_time: f64,
}

impl SampleGrid {
    /// Creates a grid of `rate` samples per second over a range of frames.
    pub fn new(clip: &Clip, frames: &Range<usize>, rate: f64) -> SampleGrid {
        let step = clip.rate() / rate;
        let step =
            if step.is_nan() { 1.0 } else { step.clamp(1.0 / MAX_SAMPLES_PER_FRAME, MAX_FRAMES_PER_SAMPLE) };
        let last = frames.end.saturating_sub(1).max(frames.start);
        SampleGrid { first: frames.start, last, step, frame_time: clip.frame_time() }
    }

    /// Returns the number of samples.
    pub fn count(&self) -> usize {
        // The margin includes the last sample for frame times such as 0.0083333.
        ((self.last - self.first) as f64 / self.step + 1e-2) as usize + 1
    }

    /// Returns the position of a sample, in fractional frames.
    pub fn position(&self, sample: usize) -> f64 {
        (self.first as f64 + sample as f64 * self.step).min(self.last as f64)
    }

    /// Returns the frame nearest to a sample.
    pub fn frame(&self, sample: usize) -> usize {
        self.position(sample).round() as usize
    }

    /// Returns the first sample at or after a frame.
    pub fn sample_from(&self, frame: usize) -> usize {
        // The margin is for frame times such as 0.0083333; casts saturate.
        (frame.saturating_sub(self.first) as f64 / self.step - 1e-2).ceil() as usize
    }

    /// Returns the time from the first sample to another, in seconds.
    pub fn seconds(&self, sample: usize) -> f64 {
        sample as f64 * self.step * self.frame_time
    }

    /// Returns the four frames around a sample and its position between the second and the third,
    /// from 0 to 1.
    pub fn neighbours(&self, sample: usize) -> ([usize; 4], f64) {
        let position = self.position(sample);
        let before = position as usize;
        let at = |ahead: usize| (before + ahead).saturating_sub(1).clamp(self.first, self.last);
        ([at(0), at(1), at(2), at(3)], position.fract())
    }

    /// Samples a curve that has one value per frame.
    pub fn sample_curve(&self, values: &[f64]) -> Vec<f64> {
        let sample = |sample: usize| {
            let (frames, t) = self.neighbours(sample);
            interpolate::catmull_rom(frames.map(|frame| values[frame - self.first]), t)
        };
        (0..self.count()).map(sample).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sampled(rate: f64, seconds: f64) -> (SampleGrid, Vec<f64>) {
        let clip = Clip::new(Vec::new(), 1.0 / rate, Vec::new());
        let frames = 1..(seconds * rate) as usize + 2;
        let grid = SampleGrid::new(&clip, &frames, 120.0);
        let curve: Vec<f64> = (0..frames.len()).map(|frame| (frame as f64 / rate * 6.0).sin()).collect();
        let values = grid.sample_curve(&curve);
        (grid, values)
    }

    #[test]
    fn common_rates_give_the_same_samples() {
        for rate in [24.0, 30.0, 59.94, 60.0, 120.0, 1.0 / 0.0083333, 240.0] {
            let (grid, values) = sampled(rate, 4.0);
            assert!(values.len().abs_diff(481) <= 3, "{rate} Hz: {}", values.len());
            for (sample, value) in values.iter().enumerate().take(470).skip(10) {
                let true_value = (grid.seconds(sample) * 6.0).sin();
                assert!((value - true_value).abs() < 0.06 * (10.0 / rate).powi(2), "{rate} Hz: {value}");
            }
            assert!(grid.frame(values.len() - 1).abs_diff(grid.last) <= 1);
        }
    }

    #[test]
    fn implausible_rates_have_samples() {
        for (frame_time, count) in [(0.0, 1), (1e-300, 1), (f64::NAN, 10), (-1.0, 46), (1e9, 46)] {
            let clip = Clip::new(Vec::new(), frame_time, Vec::new());
            let grid = SampleGrid::new(&clip, &(0..10), 120.0);
            assert_eq!(grid.sample_curve(&[1.0; 10]), vec![1.0; count], "{frame_time}");
        }
    }
}
