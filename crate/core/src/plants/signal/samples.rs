//! Samples: the windows of height and speed that become points to cluster.

use std::ops::Range;

use crate::plants::signal;
use crate::plants::signal::Signals;

/// Points in a space of `dimension` coordinates: all kept frames of the left
/// foot, then those of the right (paper, section 2.3, steps 2 to 4).
///
/// Windows of neighbouring frames overlap, and what they share is stored once: a sample takes
/// as many bytes with a wide window as with none.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Samples {
    pub dimension: usize,
    /// Distance of each sample from the origin: from standing still on the ground.
    pub norms: Vec<f64>,
    values: Vec<f32>,
    runs: Vec<Run>,
}

/// Samples whose coordinates begin `step` values after one another's.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Run {
    /// The first of the samples, and where its coordinates begin among the values.
    sample: usize,
    start: usize,
    step: usize,
}

/// What heights and speeds are divided by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ranges {
    pub height: f64,
    pub speed: f64,
}

impl Ranges {
    /// Largest minus smallest over both feet; a zero range counts as 1.
    pub fn of(signals: &Signals, pieces: &[Range<usize>]) -> Ranges {
        let range = |quantity| {
            let (low, high) = signal::extremes(signal::kept(signals, pieces, quantity));
            if high > low { high - low } else { 1.0 }
        };
        Ranges { height: range(|signal| &signal.height), speed: range(|signal| &signal.speed) }
    }

    /// No more than these, so that one jump or kick does not squeeze the rest.
    pub fn capped(self, height: f64, speed: f64) -> Ranges {
        Ranges { height: self.height.min(height), speed: self.speed.min(speed) }
    }
}

impl Samples {
    /// Samples of given coordinates, one after the other.
    pub fn new(dimension: usize, points: Vec<f64>) -> Samples {
        let mut samples = Samples { dimension, ..Samples::default() };
        samples.add(&points, dimension);
        samples
    }

    /// Every `stride`-th frame with `window` frames to either side, within its piece and foot.
    ///
    /// Coordinates are divided by `ranges` and limited to 1; frames beyond a
    /// piece's end repeat its last.
    pub fn of(
        signals: &Signals,
        pieces: &[Range<usize>],
        ranges: Ranges,
        window: usize,
        stride: usize,
    ) -> Samples {
        let mut samples = Samples { dimension: 2 * (2 * window + 1), ..Samples::default() };
        let count = |piece: &Range<usize>| piece.len().div_ceil(stride);
        samples.norms.reserve_exact(2 * pieces.iter().map(count).sum::<usize>());
        let values = |piece: &Range<usize>| 2 * (piece.len() + 2 * window);
        samples.values.reserve_exact(2 * pieces.iter().map(values).sum::<usize>());
        for signal in signals {
            for piece in pieces {
                let mut points = Vec::with_capacity(values(piece));
                for place in 0..piece.len() + 2 * window {
                    let frame =
                        (piece.start + place).saturating_sub(window).clamp(piece.start, piece.end - 1);
                    let [height, speed] = signal.at(frame);
                    points.push(limited(height / ranges.height));
                    points.push(limited(speed / ranges.speed));
                }
                samples.add(&points, 2 * stride);
            }
        }
        samples
    }

    /// Adds the samples whose coordinates begin at every `step`-th of the values.
    fn add(&mut self, values: &[f64], step: usize) {
        self.runs.push(Run { sample: self.norms.len(), start: self.values.len(), step });
        // Norms decide the scale: they are those of what has not been rounded.
        let points = values.windows(self.dimension).step_by(step);
        self.norms.extend(points.map(|point| point.iter().map(|x| x * x).sum::<f64>().sqrt()));
        self.values.extend(values.iter().map(|&value| value as f32));
    }

    /// Samples of feet that hold a height and a speed over the whole window, for each height all speeds.
    pub fn held(heights: &[f64], speeds: &[f64], ranges: Ranges, dimension: usize) -> Samples {
        let mut points = Vec::with_capacity(heights.len() * speeds.len() * dimension);
        for height in heights {
            for speed in speeds {
                for _ in 0..dimension / 2 {
                    points.push(limited(height / ranges.height));
                    points.push(limited(speed / ranges.speed));
                }
            }
        }
        Samples::new(dimension, points)
    }

    /// Adds the samples of another clip behind these.
    pub fn append(&mut self, other: Samples) {
        let (sample, start) = (self.norms.len(), self.values.len());
        let behind = |run: Run| Run { sample: sample + run.sample, start: start + run.start, ..run };
        self.runs.extend(other.runs.into_iter().map(behind));
        self.values.extend(other.values);
        self.norms.extend(other.norms);
    }

    /// Some of the samples.
    pub fn some(&self, samples: impl Iterator<Item = usize>) -> Samples {
        let points = samples.flat_map(|sample| self.point(sample)).map(|&value| f64::from(value));
        Samples::new(self.dimension, points.collect())
    }

    /// Number of samples.
    pub fn len(&self) -> usize {
        self.norms.len()
    }

    /// The coordinates of one sample.
    pub fn point(&self, sample: usize) -> &[f32] {
        let run = &self.runs[self.runs.partition_point(|run| run.sample <= sample) - 1];
        let start = run.start + (sample - run.sample) * run.step;
        &self.values[start..start + self.dimension]
    }

    /// Squared distance of two samples.
    pub fn square(&self, one: usize, other: usize) -> f64 {
        let between = self.point(one).iter().zip(self.point(other));
        between.map(|(&a, &b)| (f64::from(a) - f64::from(b)).powi(2)).sum()
    }

    /// The coordinates of all samples in turn.
    pub fn points(&self) -> impl ExactSizeIterator<Item = &[f32]> + Clone {
        (0..self.len()).map(|sample| self.point(sample))
    }
}

/// At most 1; a call to `min` costs more than the comparison on wasm.
fn limited(value: f64) -> f64 {
    if value < 1.0 { value } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants::signal::Signal;

    #[test]
    fn windows_stay_within_foot_and_piece() {
        let signal = |from: f64| Signal {
            height: (0..4).map(|frame| from + f64::from(frame)).collect(),
            speed: vec![0.0; 4],
        };
        let signals = [signal(0.0), signal(0.0)];
        let pieces = [0..2, 2..4];
        let ranges = Ranges::of(&signals, &pieces);
        assert_eq!(ranges, Ranges { height: 3.0, speed: 1.0 });
        let samples = Samples::of(&signals, &pieces, Ranges { height: 10.0, speed: 1.0 }, 1, 1);
        let heights: Vec<Vec<f64>> = (0..4)
            .map(|sample| {
                samples.point(sample).iter().step_by(2).map(|x| f64::from((x * 10.0).round())).collect()
            })
            .collect();
        assert_eq!(heights, [[0.0, 0.0, 1.0], [0.0, 1.0, 1.0], [2.0, 2.0, 3.0], [2.0, 3.0, 3.0]]);
        assert_eq!(samples.len(), 8);
    }
}
