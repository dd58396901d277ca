//! Instant of foot strike.

use std::ops::Range;

use crate::plants::postprocess::edges::cues::Cues;
use crate::plants::postprocess::edges::series::{SMOOTHING, TrackSpan};
use crate::skeleton::Up;

/// Standard deviation of the blur that interpolation adds to an impact, in frames: the shift of the
/// peak of the jerk of ideal impacts sampled at 24 to 300 Hz.
const INTERPOLATION_BLUR: f64 = 0.6;
/// Standard deviation of the error per half range of the cues, and per duration of the impact; fitted on
/// generated motion (seeds 0 to 3).
const ERROR_PER_RANGE: f64 = 0.31;
const ERROR_PER_DURATION: f64 = 0.39;

/// Returns the times in `period` at which parts of a foot show an impact.
///
/// The ground stops a falling foot: its downward velocity is largest just before the force sets in, and
/// the upward jerk is largest as it does. The order in which ankle and toe land depends on the gait. The
/// shorter the impact, the more exactly it tells the instant.
pub(super) fn cues(parts: &[TrackSpan], up: Up, period: &Range<f64>) -> Cues {
    let mut times = Vec::new();
    let mut duration = f64::INFINITY;
    for part in parts {
        let depth = |position: &_| -up.height(position);
        let [fall, acceleration, jerk] = part.derivatives(period, [1, 2, 3], depth);
        // Blur moves the peak of the jerk to earlier times.
        let delay = SMOOTHING.hypot(INTERPOLATION_BLUR * part.frame_time) - SMOOTHING;
        times.extend(fall.time_of_peak());
        times.extend(jerk.negated().time_of_peak().map(|time| time + delay));
        // The time in which the largest deceleration would stop the foot.
        duration = duration.min(fall.maximum().max(0.0) / acceleration.negated().maximum());
    }
    Cues::new(times, |range| (ERROR_PER_RANGE * range).hypot(ERROR_PER_DURATION * duration))
}
