//! Swings that capture noise explains.
//!
//! Clustering finds two classes even if nothing steps: then the second class holds the fastest noise.
//! A step is faster than the noise of planted feet, or it takes the foot somewhere else.

use std::ops::Range;

use crate::foot::Part;
use crate::intervals::intervals;
use crate::kinematics::Track;
use crate::notice::{Code, Notice};
use crate::numeric::stats;
use crate::plants::{Feet, FootTracks, PartLabels};

/// Peak speed of a step, as a multiple of the median speed of planted feet. If each coordinate of a
/// velocity is normally distributed, one speed in 10^12 exceeds 5 times the median. Chosen
/// from 4, 4.5 and 5 on standing, squats and sitting down with noise of video capture, generated and
/// recorded.
const STEP_SPEED: f64 = 5.0;
/// Distance of a step from the place where the foot was planted, in leg lengths: noise of video capture
/// moves a standing foot by up to 0.25 (generated and recorded motion with that noise added).
const STEP_DISTANCE: f64 = 0.3;
/// Time around a step in which other swings are steps as well, in seconds.
const STRETCH: f64 = 2.0;

/// Median absolute value of a normal distribution, in standard deviations.
const MEDIAN_PER_DEVIATION: f64 = 0.6745;
/// Maximum number of frames from which the noise of positions is estimated.
const MAX_FRAMES: usize = 10_000;

/// Noise of planted feet: of the capture, and of feet that roll.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CaptureNoise {
    /// Standard deviation of each coordinate of planted toes, in file units, from second differences of
    /// frames: that of white noise. Smoothed or repeated poses give too low a value, feet that roll at low
    /// frame rates too high a one.
    pub position: f64,
    /// Median speed as detection filters it, in file units per second. A step reaches five times this
    /// speed, unless it takes the foot somewhere else.
    pub speed: f64,
}

impl CaptureNoise {
    /// Estimates the noise from the planted frames; `None` if there are none.
    pub(crate) fn new(feet: &Feet, labels: &PartLabels) -> Option<CaptureNoise> {
        let speed = planted_speed(labels)?;
        let step = (feet.frame_count() / MAX_FRAMES).max(1);
        let differences = labels.feet.iter().zip(&feet.tracks).flat_map(|(labels, tracks)| {
            let track = &tracks.toe;
            let is_planted =
                |frame: &usize| labels.planted[frame - 1..=frame + 1].iter().all(|planted| *planted);
            (1..track.len().saturating_sub(1)).step_by(step).filter(is_planted).flat_map(|frame| {
                let second = track[frame - 1] - 2.0 * track[frame] + track[frame + 1];
                [second.x.abs(), second.y.abs(), second.z.abs()]
            })
        });
        // The second difference of white noise has the variance 6 σ².
        let position = stats::median_high(differences)? / (MEDIAN_PER_DEVIATION * 6.0_f64.sqrt());
        Some(CaptureNoise { position, speed })
    }
}

/// Returns the median speed of planted feet, in file units per second.
fn planted_speed(labels: &PartLabels) -> Option<f64> {
    stats::median_high(labels.feet.iter().flat_map(|foot| {
        let speeds = foot.planted.iter().zip(&foot.speed);
        speeds.filter(|(planted, _)| **planted).map(|(_, speed)| f64::from(*speed))
    }))
}

/// Labels all swings as planted in stretches of a clip in which neither foot takes a step.
///
/// Their confidence becomes minimum because the clustering disagrees. Returns a notice if there were any.
pub(crate) fn fill_swings(feet: &Feet, labels: &mut PartLabels) -> Option<Notice> {
    let noise = planted_speed(labels)?;
    let swings = [0, 1].map(|foot| {
        let in_air: Vec<bool> = labels.feet[foot].planted.iter().map(|planted| !planted).collect();
        intervals(&in_air)
    });
    let is_step = |foot: usize, swing: &Range<usize>| {
        let peak = labels.feet[foot].speed[swing.clone()].iter().copied().fold(0.0, f32::max);
        f64::from(peak) > STEP_SPEED * noise
            || distance(&feet.tracks[foot], labels.part, swing) > STEP_DISTANCE * feet.leg
    };
    let reach = feet.frames_in(STRETCH);
    let mut is_stepping = vec![false; feet.frame_count()];
    for (foot, swings) in swings.iter().enumerate() {
        for swing in swings.iter().filter(|swing| is_step(foot, swing)) {
            let end = (swing.end + reach).min(is_stepping.len());
            is_stepping[swing.start.saturating_sub(reach)..end].fill(true);
        }
    }
    let mut filled = 0;
    for (labels, swings) in labels.feet.iter_mut().zip(swings) {
        for swing in swings.into_iter().filter(|swing| !is_stepping[swing.clone()].contains(&true)) {
            labels.planted[swing.clone()].fill(true);
            labels.confidence[swing].fill(0.5);
            filled += 1;
        }
    }
    let steps = is_stepping.contains(&true);
    let limit = 1e3 * STEP_SPEED * noise * feet.metres_per_unit;
    (filled > 0).then(|| {
        let text = if steps {
            let movements = if filled == 1 { "One movement".into() } else { format!("{filled} movements") };
            format!(
                "{movements} of the feet remained below {limit:.0} mm/s, {STEP_SPEED} times the median speed of \
                 planted feet, which is too slow for a step, and counted as contact."
            )
        } else {
            format!(
                "Neither foot takes a step: all movements remain below {limit:.0} mm/s, {STEP_SPEED} times the \
                 median speed of planted feet; every frame is contact."
            )
        };
        Notice::new(Code::CaptureNoise, text)
    })
}

/// Returns the maximum distance of a foot during a swing from its place before it: of the nearer of
/// ankle and toe for contact.
fn distance(tracks: &FootTracks, part: Part, run: &Range<usize>) -> f64 {
    let from = run.start.saturating_sub(1);
    let moved = |track: &Track, frame: usize| (track[frame] - track[from]).norm();
    run.clone()
        .map(|frame| match part {
            Part::Contact => moved(&tracks.ankle, frame).min(moved(&tracks.toe, frame)),
            Part::Toe => moved(&tracks.toe, frame),
            Part::Heel => moved(&tracks.ankle, frame),
        })
        .fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;

    use super::*;
    use crate::plants::FootLabels;
    use crate::skeleton::Up;

    /// Frames of a clip at 60 Hz.
    const FRAMES: usize = 600;

    /// Labels of two feet that stand with a speed of 0.2, except for swings of the left foot: their
    /// frames, speed and distance in leg lengths.
    fn after_filling(swings: &[(Range<usize>, f32, f64)]) -> Vec<bool> {
        let place = |frame: &usize| {
            let distance =
                swings.iter().find(|(swing, ..)| swing.contains(frame)).map_or(0.0, |swing| swing.2);
            Vector3::new(0.0, 0.0, distance)
        };
        let track: Track = (0..FRAMES).map(|frame| place(&frame)).collect();
        let foot = FootTracks { ankle: track.clone(), toe: track.clone(), tip: None };
        let feet = Feet {
            tracks: [foot.clone(), foot],
            hips: track,
            up: Up::Y,
            leg: 1.0,
            metres_per_unit: 1.0,
            frame_time: 1.0 / 60.0,
        };
        let mut left = FootLabels {
            planted: vec![true; FRAMES],
            confidence: vec![1.0; FRAMES],
            height: vec![0.0; FRAMES],
            speed: vec![0.2; FRAMES],
            edges: Vec::new(),
        };
        let right = left.clone();
        for (swing, speed, _) in swings {
            left.planted[swing.clone()].fill(false);
            left.speed[swing.clone()].fill(*speed);
        }
        let mut labels = PartLabels { part: Part::Contact, feet: [left, right], evidence: None };
        let notice = fill_swings(&feet, &mut labels);
        let is_filled = labels.feet[0].planted.iter().filter(|planted| **planted).count()
            > FRAMES - swings.iter().map(|(swing, ..)| swing.len()).sum::<usize>();
        assert_eq!(notice.map(|notice| notice.code), is_filled.then_some(Code::CaptureNoise));
        labels.feet[0].planted.clone()
    }

    #[test]
    fn the_level_of_white_noise_is_estimated() {
        let mut state = 1_u64;
        let mut uniform = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 40) as f64 / (1 << 24) as f64 - 0.5
        };
        let track: Track = (0..2000)
            .map(|_| Vector3::from_fn(|_, _| (0..12).map(|_| uniform()).sum::<f64>() * 0.01))
            .collect();
        let foot = FootTracks { ankle: track.clone(), toe: track, tip: None };
        let feet = Feet {
            tracks: [foot.clone(), foot],
            hips: Track::new(),
            up: Up::Y,
            leg: 1.0,
            metres_per_unit: 1.0,
            frame_time: 1.0 / 60.0,
        };
        let labels = |planted| FootLabels {
            planted: vec![planted; 2000],
            confidence: vec![1.0; 2000],
            height: vec![0.0; 2000],
            speed: vec![0.25; 2000],
            edges: Vec::new(),
        };
        let labels = |planted| PartLabels {
            part: Part::Contact,
            feet: [labels(planted), labels(planted)],
            evidence: None,
        };
        let noise = CaptureNoise::new(&feet, &labels(true)).unwrap();
        assert!((noise.position / 0.01 - 1.0).abs() < 0.05 && noise.speed == 0.25, "{noise:?}");
        assert_eq!(CaptureNoise::new(&feet, &labels(false)), None);
    }

    fn swings_left(swings: &[(Range<usize>, f32, f64)]) -> usize {
        after_filling(swings).chunk_by(|a, b| a == b).filter(|run| !run[0]).count()
    }

    #[test]
    fn noise_of_standing_feet_is_no_swing() {
        assert_eq!(swings_left(&[(100..110, 0.8, 0.1), (300..320, 0.6, 0.2)]), 0);
    }

    #[test]
    fn fast_or_long_swings_are_steps() {
        assert_eq!(swings_left(&[(100..110, 1.2, 0.1)]), 1);
        assert_eq!(swings_left(&[(100..140, 0.8, 0.4)]), 1);
    }

    #[test]
    fn swings_next_to_a_step_remain() {
        assert_eq!(swings_left(&[(100..130, 3.0, 0.8), (190..200, 0.6, 0.05), (400..410, 0.6, 0.05)]), 2);
    }
}
