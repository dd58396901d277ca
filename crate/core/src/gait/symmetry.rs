//! Symmetry indices: left compared with right.

use serde::{Deserialize, Serialize};

use crate::gait::PerSide;

/// Symmetry indices of a gait, in percent: 0 if both sides are equal, positive if the right side is
/// greater.
///
/// Index of Robinson, Herzog and Nigg (Journal of Manipulative and Physiological Therapeutics
/// 10(4), 1987): the difference of right and left over their mean, 100 · (R − L) / ((R + L) / 2).
/// `None` if a side has no measure or the mean is zero.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Symmetry {
    /// Symmetry of stance times; a foot that is spared has a shorter stance.
    pub stance_percent: Option<f64>,
    /// Symmetry of swing times.
    pub swing_percent: Option<f64>,
    /// Symmetry of step times.
    pub step_time_percent: Option<f64>,
    /// Symmetry of step lengths.
    pub step_length_percent: Option<f64>,
}

impl Symmetry {
    pub(crate) fn new(
        stance: &PerSide,
        swing: &PerSide,
        step_time: &PerSide,
        step_length: &PerSide,
    ) -> Symmetry {
        Symmetry {
            stance_percent: index(stance),
            swing_percent: index(swing),
            step_time_percent: index(step_time),
            step_length_percent: index(step_length),
        }
    }
}

fn index(measure: &PerSide) -> Option<f64> {
    let [left, right] = measure.means()?;
    let mean = (left + right) / 2.0;
    (mean.abs() > f64::EPSILON).then(|| 100.0 * (right - left) / mean)
}
