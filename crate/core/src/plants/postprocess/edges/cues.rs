//! Cues of an edge.

use crate::numeric::stats;

/// Times at which an edge may be, according to several cues.
pub(super) struct Cues {
    /// Ascending times, in seconds.
    times: Vec<f64>,
    /// Standard deviation of the error of their median, in seconds.
    pub uncertainty: f64,
}

impl Cues {
    /// Creates cues; `uncertainty` of their median is given half the range of the times, both in
    /// seconds.
    pub fn new(mut times: Vec<f64>, uncertainty: impl Fn(f64) -> f64) -> Cues {
        times.sort_unstable_by(f64::total_cmp);
        let range = times.last().zip(times.first()).map_or(0.0, |(last, first)| last - first);
        Cues { uncertainty: uncertainty(range / 2.0), times }
    }

    /// Returns the median; `None` without cues.
    pub fn median(&self) -> Option<f64> {
        (!self.times.is_empty()).then(|| stats::median_of_sorted(&self.times))
    }
}
