//! Samples: windows of height and speed, the points to cluster.

use std::ops::Range;

use crate::plants::signal;

/// Points with `dimension` coordinates: all frames of the left foot, then those of the right foot
/// (paper, section 2.3, steps 2 to 4).
///
/// Windows of neighbouring frames overlap, and shared values are stored once, so that the memory
/// does not grow with the window.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Samples {
    pub dimension: usize,
    /// Distance of each sample from the origin, which represents standing on the ground.
    pub norms: Vec<f64>,
    values: Vec<f32>,
    runs: Vec<Run>,
}

/// Samples whose coordinates begin at every `step`-th value.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Run {
    /// Index of the first sample.
    sample: usize,
    /// Index of its first value.
    start: usize,
    step: usize,
}

/// Ranges of height and speed, by which they are divided.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ranges {
    pub height: f64,
    pub speed: f64,
}

impl Ranges {
    /// Returns maximum minus minimum over both feet; a zero range counts as 1. `at` returns height and speed of a
    /// foot at a frame.
    pub fn new(spans: &[Range<usize>], at: impl Fn(usize, usize) -> [f64; 2]) -> Ranges {
        let mut limits = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        for values in signal::values_within(spans, at) {
            for ([low, high], value) in limits.iter_mut().zip(values) {
                (*low, *high) = (low.min(value), high.max(value));
            }
        }
        let [height, speed] = limits.map(|[low, high]| if high > low { high - low } else { 1.0 });
        Ranges { height, speed }
    }

    /// Limits the ranges, so that one jump or kick does not compress all other samples.
    pub fn capped(self, height: f64, speed: f64) -> Ranges {
        Ranges { height: self.height.min(height), speed: self.speed.min(speed) }
    }
}

impl Samples {
    /// Creates samples from their concatenated coordinates.
    pub fn new(dimension: usize, points: Vec<f64>) -> Samples {
        let mut samples = Samples { dimension, ..Samples::default() };
        samples.add(&points, dimension);
        samples
    }

    /// Creates a sample of every `stride`-th frame with `window` frames on either side, within its
    /// span and foot. `at` returns height and speed of a foot at a frame.
    ///
    /// Coordinates are divided by `ranges` and limited to 1. Frames beyond the end of a span repeat
    /// its last frame.
    pub fn from_signals(
        at: impl Fn(usize, usize) -> [f64; 2],
        spans: &[Range<usize>],
        ranges: Ranges,
        window: usize,
        stride: usize,
    ) -> Samples {
        let width = 2 * window + 1;
        let mut samples = Samples { dimension: 2 * width, ..Samples::default() };
        let count = |span: &Range<usize>| span.len().div_ceil(stride);
        samples.norms.reserve_exact(2 * spans.iter().map(count).sum::<usize>());
        // Frames between windows that do not overlap are left out.
        let step = stride.min(width);
        let values = |span: &Range<usize>| 2 * ((count(span) - 1) * step + width);
        samples.values.reserve_exact(2 * spans.iter().map(values).sum::<usize>());
        for foot in 0..2 {
            for span in spans {
                let last = span.start + (count(span) - 1) * stride;
                let mut points = Vec::with_capacity(values(span));
                for sample in span.clone().step_by(stride) {
                    let used = if sample == last { width } else { step };
                    for frame in sample..sample + used {
                        let frame = frame.saturating_sub(window).clamp(span.start, span.end - 1);
                        let [height, speed] = at(foot, frame);
                        points.push(limit_to_one(height / ranges.height));
                        points.push(limit_to_one(speed / ranges.speed));
                    }
                }
                samples.add(&points, 2 * step);
            }
        }
        samples
    }

    /// Adds the samples whose coordinates begin at every `step`-th value.
    fn add(&mut self, values: &[f64], step: usize) {
        self.runs.push(Run { sample: self.norms.len(), start: self.values.len(), step });
        // The norms determine the bandwidth; they are computed before rounding to single precision.
        let points = values.windows(self.dimension).step_by(step);
        self.norms.extend(points.map(|point| point.iter().map(|x| x * x).sum::<f64>().sqrt()));
        self.values.extend(values.iter().map(|&value| value as f32));
    }

    /// Creates samples of constant height and speed over the whole window: for each height all
    /// speeds.
    pub fn at_constant(heights: &[f64], speeds: &[f64], ranges: Ranges, dimension: usize) -> Samples {
        let mut points = Vec::with_capacity(heights.len() * speeds.len() * dimension);
        for height in heights {
            for speed in speeds {
                for _ in 0..dimension / 2 {
                    points.push(limit_to_one(height / ranges.height));
                    points.push(limit_to_one(speed / ranges.speed));
                }
            }
        }
        Samples::new(dimension, points)
    }

    /// Appends the samples of another clip.
    pub fn append(&mut self, other: Samples) {
        let (sample, start) = (self.norms.len(), self.values.len());
        let shifted = |run: Run| Run { sample: sample + run.sample, start: start + run.start, ..run };
        self.runs.extend(other.runs.into_iter().map(shifted));
        self.values.extend(other.values);
        self.norms.extend(other.norms);
    }

    /// Returns the given samples.
    pub fn select(&self, samples: impl Iterator<Item = usize>) -> Samples {
        let points = samples.flat_map(|sample| self.point(sample)).map(|&value| f64::from(value));
        Samples::new(self.dimension, points.collect())
    }

    /// Returns the number of samples.
    pub fn len(&self) -> usize {
        self.norms.len()
    }

    /// Returns the coordinates of one sample.
    pub fn point(&self, sample: usize) -> &[f32] {
        self.point_in(&self.runs[self.runs.partition_point(|run| run.sample <= sample) - 1], sample)
    }

    fn point_in(&self, run: &Run, sample: usize) -> &[f32] {
        let start = run.start + (sample - run.sample) * run.step;
        &self.values[start..start + self.dimension]
    }

    /// Returns the squared distance of two samples.
    pub fn squared_distance(&self, one: usize, other: usize) -> f64 {
        let pairs = self.point(one).iter().zip(self.point(other));
        pairs.map(|(&a, &b)| (f64::from(a) - f64::from(b)).powi(2)).sum()
    }

    /// Returns the coordinates of all samples in order.
    pub fn points(&self) -> impl ExactSizeIterator<Item = &[f32]> + Clone {
        let mut run = 0;
        (0..self.len()).map(move |sample| {
            while self.runs.get(run + 1).is_some_and(|next| next.sample <= sample) {
                run += 1;
            }
            self.point_in(&self.runs[run], sample)
        })
    }
}

/// Limits a value to 1. In WebAssembly, calling `min` costs more than the comparison.
fn limit_to_one(value: f64) -> f64 {
    if value < 1.0 { value } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants::signal::Signal;

    #[test]
    fn windows_stay_within_foot_and_span() {
        let signal = |from: f64| Signal {
            height: (0..4).map(|frame| from + f64::from(frame)).collect(),
            speed: vec![0.0; 4],
        };
        let signals = [signal(0.0), signal(0.0)];
        let at = |foot: usize, frame| signals[foot].at(frame);
        let spans = [0..2, 2..4];
        let ranges = Ranges::new(&spans, at);
        assert_eq!(ranges, Ranges { height: 3.0, speed: 1.0 });
        let samples = Samples::from_signals(at, &spans, Ranges { height: 10.0, speed: 1.0 }, 1, 1);
        let heights: Vec<Vec<f64>> = (0..4)
            .map(|sample| {
                samples.point(sample).iter().step_by(2).map(|x| f64::from((x * 10.0).round())).collect()
            })
            .collect();
        assert_eq!(heights, [[0.0, 0.0, 1.0], [0.0, 1.0, 1.0], [2.0, 2.0, 3.0], [2.0, 3.0, 3.0]]);
        assert_eq!(samples.len(), 8);
    }
}
