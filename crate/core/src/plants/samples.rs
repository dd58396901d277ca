//! Samples: the windows of height and speed that become points to cluster.

use std::ops::Range;

use super::signal::{self, Signals};

/// Points in a space of `dimension` coordinates: all kept frames of the left
/// foot, then those of the right (paper, section 2.3, steps 2 to 4).
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Samples {
    pub dimension: usize,
    /// Samples × dimension.
    pub points: Vec<f64>,
    /// Distance of each sample from the origin: from standing still on the ground.
    pub norms: Vec<f64>,
}

/// What heights and speeds are divided by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Ranges {
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
        let norms =
            points.chunks_exact(dimension).map(|point| point.iter().map(|x| x * x).sum::<f64>().sqrt());
        Samples { norms: norms.collect(), dimension, points }
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
        let dimension = 2 * (2 * window + 1);
        let mut points = Vec::new();
        for signal in signals {
            for piece in pieces {
                for frame in piece.clone().step_by(stride) {
                    // Positions in the window count from `frame − window`.
                    for place in 0..=2 * window {
                        let neighbour =
                            (frame + place).saturating_sub(window).clamp(piece.start, piece.end - 1);
                        let [height, speed] = signal.at(neighbour);
                        points.push(limited(height / ranges.height));
                        points.push(limited(speed / ranges.speed));
                    }
                }
            }
        }
        Samples::new(dimension, points)
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
        self.points.extend(other.points);
        self.norms.extend(other.norms);
    }

    /// Number of samples.
    pub fn len(&self) -> usize {
        self.norms.len()
    }

    /// The coordinates of one sample.
    pub fn point(&self, sample: usize) -> &[f64] {
        &self.points[sample * self.dimension..(sample + 1) * self.dimension]
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
            .map(|sample| samples.point(sample).iter().step_by(2).map(|x| x * 10.0).collect())
            .collect();
        assert_eq!(heights, [[0.0, 0.0, 1.0], [0.0, 1.0, 1.0], [2.0, 2.0, 3.0], [2.0, 3.0, 3.0]]);
        assert_eq!(samples.len(), 8);
    }
}
