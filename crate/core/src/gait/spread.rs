//! Mean and standard deviation of a measure.

use serde::{Deserialize, Serialize};

/// Mean and standard deviation of a measure, in its unit.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Spread {
    /// Arithmetic mean.
    pub mean: f64,
    /// Standard deviation with divisor n − 1; `None` for a single value.
    pub sd: Option<f64>,
    /// Number of values.
    pub count: usize,
}

impl Spread {
    /// Returns mean and deviation; `None` if there are no values.
    pub(crate) fn new(values: &[f64]) -> Option<Spread> {
        let count = values.len();
        let mean = (count > 0).then(|| values.iter().sum::<f64>() / count as f64)?;
        let sum_of_squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
        let sd = (count > 1).then(|| (sum_of_squares / (count - 1) as f64).sqrt());
        Some(Spread { mean, sd, count })
    }
}

/// A measure of each foot; `None` if there are no values.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct PerSide {
    /// Left foot.
    pub left: Option<Spread>,
    /// Right foot.
    pub right: Option<Spread>,
}

impl PerSide {
    pub(crate) fn new([left, right]: &[Vec<f64>; 2]) -> PerSide {
        PerSide { left: Spread::new(left), right: Spread::new(right) }
    }

    /// Returns the means of left and right, if both exist.
    pub(crate) fn means(&self) -> Option<[f64; 2]> {
        Some([self.left?.mean, self.right?.mean])
    }
}
