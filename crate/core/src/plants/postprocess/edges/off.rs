//! Instant of foot off.

use std::ops::Range;

use crate::plants::postprocess::edges::cues::Cues;
use crate::plants::postprocess::edges::series::{Series, TrackSpan};
use crate::skeleton::Up;

/// Standard deviation of the error per half range of the cues; fitted on generated motion (seeds 0 to
/// 2).
const ERROR_PER_RANGE: f64 = 1.5;

/// Part of a foot with the speeds that it exceeds at foot off.
#[derive(Clone, Copy)]
pub(super) struct Part<'a> {
    pub track: TrackSpan<'a>,
    /// Fraction of its peak speed in the following swing.
    pub fraction: f64,
    /// In leg lengths per second.
    pub max_planted_speed: f64,
}

/// Times near a foot off, in seconds.
pub(super) struct OffPeriods {
    /// Middle half of the plant, in which the foot moves with the ground.
    pub stance: Range<f64>,
    /// Times searched for the foot off.
    pub search: Range<f64>,
    /// Swing that follows.
    pub swing: Range<f64>,
    /// Foot off according to the clustering.
    pub estimate: f64,
}

/// Returns the times at which parts of a foot begin to move relative to the ground, in seconds.
///
/// The foot rolls over its toe, so the part in front is at rest until the contact ends, whatever the speed
/// of the gait: the speed that it reaches then is a fraction of its peak speed in the following
/// swing. In a run the foot leaves the ground upwards and accelerates forwards in the air: a part that is
/// too fast for a planted one has left, even if it has not yet reached that fraction. Velocities are relative
/// to that of the stance, which is that of the belt on a treadmill.
///
/// The estimate of the clustering is a further cue, for swings that begin in an unusual way.
pub(super) fn cues(parts: &[Part], up: Up, periods: &OffPeriods) -> Cues {
    let mut times: Vec<f64> = parts.iter().filter_map(|part| cue(part, up, periods)).collect();
    if !times.is_empty() {
        times.push(periods.estimate);
    }
    Cues::new(times, |range| ERROR_PER_RANGE * range)
}

fn cue(part: &Part, up: Up, periods: &OffPeriods) -> Option<f64> {
    let track = &part.track;
    let belt = track.mean_velocity(&periods.stance);
    let velocities = || track.velocities(&periods.swing).map(|velocity| up.to_y_up(velocity - belt));
    let along = Peak::of(velocities().map(|velocity| velocity.x.hypot(velocity.z)));
    let upwards = Peak::of(velocities().map(|velocity| velocity.y));
    let component = |axis: usize| {
        let [velocity] = track.derivatives(&periods.search, [1], |position| up.to_y_up(*position)[axis]);
        velocity.minus(up.to_y_up(belt)[axis])
    };
    let (horizontal, vertical) = (Series::norm(component(0), &component(2)), component(1));
    // Jumps on the spot have no horizontal speed to speak of.
    let (speed, peak) = if along.speed > upwards.speed { (&horizontal, along) } else { (&vertical, upwards) };
    if peak.is_last {
        return None;
    }
    let exceeds_fraction = speed.time_of_rise(part.fraction * peak.speed, periods.estimate);
    let total = Series::norm(horizontal, &vertical);
    let exceeds_limit = total.time_of_rise(part.max_planted_speed * track.leg, periods.estimate);
    exceeds_fraction.into_iter().chain(exceeds_limit).reduce(f64::min)
}

/// Largest speed of a swing.
struct Peak {
    speed: f64,
    /// True if no later speed is smaller, as in a swing that the end of the clip cuts off.
    is_last: bool,
}

impl Peak {
    fn of(speeds: impl Iterator<Item = f64>) -> Peak {
        let (mut peak, mut last) = (f64::NEG_INFINITY, f64::INFINITY);
        for speed in speeds {
            peak = peak.max(speed);
            last = speed;
        }
        Peak { speed: peak, is_last: last >= peak }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;

    use super::*;
    use crate::plants::postprocess::edges::series::Kernels;

    #[test]
    fn velocities_are_relative_to_the_stance() {
        // At rest on a belt of 1 m/s until 1 s, then accelerating at 20 m/s² until 1.2 s and braking.
        let position = |t: f64| {
            let ahead = |t: f64| 10.0 * t.max(0.0).powi(2);
            Vector3::new(-t + ahead(t - 1.0) - 2.0 * ahead(t - 1.2), 0.0, 0.0)
        };
        let track: Vec<_> = (0..200).map(|frame| position(f64::from(frame) * 0.01)).collect();
        let kernels = Kernels::new(0.01);
        let track =
            TrackSpan { track: &track, span: &(0..200), frame_time: 0.01, leg: 1.0, kernels: &kernels };
        let periods = OffPeriods { stance: 0.2..0.7, search: 0.8..1.2, swing: 1.0..1.4, estimate: 1.05 };
        let part = Part { track, fraction: 0.25, max_planted_speed: 9.0 };
        let time = cue(&part, Up::Y, &periods).unwrap();
        // The peak speed is 4 m/s.
        assert!((time - 1.05).abs() < 0.003, "{time}");
        let time = cue(&Part { max_planted_speed: 0.6, ..part }, Up::Y, &periods).unwrap();
        assert!((time - 1.03).abs() < 0.003, "{time}");
        let cut_off = OffPeriods { swing: 1.0..1.15, ..periods };
        assert_eq!(cue(&part, Up::Y, &cut_off), None);
    }
}
