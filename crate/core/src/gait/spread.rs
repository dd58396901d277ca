//! Means with their spread.

use serde::Deserialize;
use serde::Serialize;

/// Mean and spread of a measure, in its unit.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Spread {
    /// Arithmetic mean.
    pub mean: f64,
    /// Standard deviation with n − 1; `None` of a single value.
    pub sd: Option<f64>,
    /// Number of values.
    pub count: usize,
}

impl Spread {
    /// Mean and spread of values; `None` where there are none.
    pub(crate) fn of(values: &[f64]) -> Option<Spread> {
        let count = values.len();
        let mean = (count > 0).then(|| values.iter().sum::<f64>() / count as f64)?;
        let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
        let sd = (count > 1).then(|| (squares / (count - 1) as f64).sqrt());
        Some(Spread { mean, sd, count })
    }
}

/// A measure of each foot; `None` where nothing measures it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct PerSide {
    /// The left foot's.
    pub left: Option<Spread>,
    /// The right foot's.
    pub right: Option<Spread>,
}

impl PerSide {
    pub(crate) fn of([left, right]: &[Vec<f64>; 2]) -> PerSide {
        PerSide { left: Spread::of(left), right: Spread::of(right) }
    }

    /// The means of left and right, if there are both.
    pub(crate) fn means(&self) -> Option<[f64; 2]> {
        Some([self.left?.mean, self.right?.mean])
    }
}
