//! Swings that capture noise explains.
//!
//! Clustering finds two classes even if nothing steps: then the second class holds the fastest noise.
//! A step is faster than the noise of planted feet, or it takes the foot somewhere else.

use std::ops::Range;

use crate::foot::Part;
use crate::intervals::intervals;
use crate::kinematics::Track;
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

/// Labels all swings as planted in stretches of a clip in which neither foot takes a step.
///
/// Their confidence becomes minimum because the clustering disagrees. Returns true if there were any.
pub(crate) fn fill_swings(feet: &Feet, labels: &mut PartLabels) -> bool {
    let speeds_of_planted = labels.feet.iter().flat_map(|foot| {
        let speeds = foot.planted.iter().zip(&foot.speed);
        speeds.filter(|(planted, _)| **planted).map(|(_, speed)| f64::from(*speed))
    });
    let Some(noise) = stats::median_high(speeds_of_planted) else { return false };
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
    let mut was_filled = false;
    for (labels, swings) in labels.feet.iter_mut().zip(swings) {
        for swing in swings.into_iter().filter(|swing| !is_stepping[swing.clone()].contains(&true)) {
            labels.planted[swing.clone()].fill(true);
            labels.confidence[swing].fill(0.5);
            was_filled = true;
        }
    }
    was_filled
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
        fill_swings(&feet, &mut labels);
        labels.feet[0].planted.clone()
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
