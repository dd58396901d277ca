//! Left against right.

use serde::Deserialize;
use serde::Serialize;

use crate::gait::PerSide;

/// Symmetry indices of a gait, in percent: 0 where both sides are alike, positive where the
/// right side's measure is the greater.
///
/// The index is that of Robinson, Herzog and Nigg (Journal of Manipulative and Physiological
/// Therapeutics 10(4), 1987): the difference of right and left over their mean,
/// 100 · (R − L) / ((R + L) / 2). `None` where a side has no measure, or both add up to nothing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Symmetry {
    /// Of stance times: a foot that is spared stands for less.
    pub stance_percent: Option<f64>,
    /// Of swing times.
    pub swing_percent: Option<f64>,
    /// Of step times.
    pub step_time_percent: Option<f64>,
    /// Of step lengths.
    pub step_length_percent: Option<f64>,
}

impl Symmetry {
    pub(crate) fn of(
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
