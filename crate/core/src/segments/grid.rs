//! Instants at which a clip is sampled: as many in a second whatever its rate.

use std::ops::Range;

use crate::bvh::Clip;
use crate::numeric::interpolate;

/// Most samples from one frame to the next: clips of a few frames a second have fewer per second.
const DENSEST: f64 = 12.0;

/// Most frames from one sample to the next: no clip has as many, but frame times may be 0.
const SPARSEST: f64 = 1e9;

/// Samples over some frames of a clip.
#[derive(Debug)]
pub(crate) struct Grid {
    first: usize,
    last: usize,
    /// Frames from one sample to the next.
    step: f64,
    frame_time: f64,
}

impl Grid {
    /// `rate` samples per second over some frames.
    pub fn over(clip: &Clip, frames: &Range<usize>, rate: f64) -> Grid {
        let step = clip.rate() / rate;
        let step = if step.is_nan() { 1.0 } else { step.clamp(1.0 / DENSEST, SPARSEST) };
        let last = frames.end.saturating_sub(1).max(frames.start);
        Grid { first: frames.start, last, step, frame_time: clip.frame_time() }
    }

    /// How many samples there are.
    pub fn count(&self) -> usize {
        // The margin keeps frame times such as 0.0083333 from losing the last sample.
        ((self.last - self.first) as f64 / self.step + 1e-2) as usize + 1
    }

    /// Where a sample lies among the clip's frames.
    pub fn place(&self, sample: usize) -> f64 {
        (self.first as f64 + sample as f64 * self.step).min(self.last as f64)
    }

    /// The frame next to a sample.
    pub fn frame(&self, sample: usize) -> usize {
        self.place(sample).round() as usize
    }

    /// Seconds from the first sample to another.
    pub fn seconds(&self, sample: usize) -> f64 {
        sample as f64 * self.step * self.frame_time
    }

    /// The frames about a sample, two on either side, and how far it is from the second to the third.
    pub fn about(&self, sample: usize) -> ([usize; 4], f64) {
        let place = self.place(sample);
        let before = place as usize;
        let at = |ahead: usize| (before + ahead).saturating_sub(1).clamp(self.first, self.last);
        ([at(0), at(1), at(2), at(3)], place.fract())
    }

    /// The samples of a curve that has a value for each frame from the first on.
    pub fn sampled(&self, values: &[f64]) -> Vec<f64> {
        let sample = |sample: usize| {
            let (frames, t) = self.about(sample);
            interpolate::cubic(frames.map(|frame| values[frame - self.first]), t)
        };
        (0..self.count()).map(sample).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sampled(rate: f64, seconds: f64) -> (Grid, Vec<f64>) {
        let clip = Clip::new(Vec::new(), 1.0 / rate, Vec::new());
        let frames = 1..(seconds * rate) as usize + 2;
        let grid = Grid::over(&clip, &frames, 120.0);
        let curve: Vec<f64> = (0..frames.len()).map(|frame| (frame as f64 / rate * 6.0).sin()).collect();
        let values = grid.sampled(&curve);
        (grid, values)
    }

    #[test]
    fn any_rate_gives_the_same_samples() {
        for rate in [10.0, 24.0, 30.0, 59.94, 60.0, 120.0, 1.0 / 0.0083333, 240.0] {
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
    fn absurd_rates_have_samples() {
        for (frame_time, count) in [(0.0, 1), (1e-300, 1), (f64::NAN, 10), (-1.0, 109), (1e9, 109)] {
            let clip = Clip::new(Vec::new(), frame_time, Vec::new());
            let grid = Grid::over(&clip, &(0..10), 120.0);
            assert_eq!(grid.sampled(&[1.0; 10]), vec![1.0; count], "{frame_time}");
        }
    }
}
