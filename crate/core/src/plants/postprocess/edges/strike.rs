//! Instant of foot strike.

use std::f64::consts::TAU;
use std::ops::Range;

use crate::plants::postprocess::edges::cues::Cues;
use crate::plants::postprocess::edges::series::{SMOOTHING, TrackSpan};
use crate::skeleton::Up;

/// Standard deviation of the blur that interpolation adds to an impact, in frames: the shift of the
/// peak of the jerk of ideal impacts sampled at 24 to 300 Hz.
const INTERPOLATION_BLUR: f64 = 0.6;
/// Standard deviation of the error per half range of the cues, per duration of the impact, and per time by
/// which noise moves a cue; fitted on generated motion (seeds 0 to 9). That there are three terms was decided
/// with knowledge of foot strikes over force plates.
const ERROR_PER_RANGE: f64 = 0.28;
const ERROR_PER_DURATION: f64 = 0.33;
const ERROR_PER_NOISE: f64 = 3.8;

/// Returns the times in `period` at which parts of a foot show an impact; `stance` is a time in which the foot
/// rests, both in seconds.
///
/// The ground stops a falling foot: its downward velocity is largest just before the force sets in, and
/// the upward jerk is largest as it does. The order in which ankle and toe land depends on the gait. The
/// shorter the impact and the smaller the noise, the more exactly it tells the instant.
pub(super) fn cues(parts: &[TrackSpan], up: Up, period: &Range<f64>, stance: &Range<f64>) -> Cues {
    let mut times = Vec::new();
    let [mut duration, mut noise] = [f64::INFINITY; 2];
    let mut is_stopped = true;
    for part in parts {
        let depth = |position: &_| -up.height(position);
        let derivatives = |period| part.derivatives(period, [1, 2, 3], depth);
        let [fall, acceleration, jerk] = derivatives(period);
        let jerk = jerk.negated();
        // Blur moves the peak of the jerk to earlier times.
        let delay = SMOOTHING.hypot(INTERPOLATION_BLUR * part.frame_time) - SMOOTHING;
        times.extend(fall.time_of_peak());
        times.extend(jerk.time_of_peak().map(|time| time + delay));
        // The time in which the largest deceleration would stop the foot.
        let deceleration = acceleration.negated().maximum();
        // Without a deceleration, the period ends before the ground stops the part.
        is_stopped &= deceleration > 0.0;
        duration = duration.min(fall.maximum().max(0.0) / deceleration);
        // Noise, which alone accelerates a foot at rest, moves a cue by its acceleration divided by the jerk.
        let [_, rest, _] = derivatives(stance);
        noise = noise.min(rest.median_magnitude() / jerk.maximum().max(0.0));
    }
    // Smoothing alone gives this duration to an instantaneous impact.
    let blur = SMOOTHING * TAU.sqrt();
    let duration = (duration.powi(2) - blur.powi(2)).max(0.0).sqrt();
    Cues::new(times, |range| {
        let error = (ERROR_PER_RANGE * range).hypot(ERROR_PER_DURATION * duration);
        if is_stopped { error.hypot(ERROR_PER_NOISE * noise) } else { f64::INFINITY }
    })
}
