//! Self-check of the clean-up: frames that a correction makes worse.
//!
//! The constants were chosen on the samples and on recorded clips with ordinary foot skate, so that their
//! corrections remain: one or two of a hundred are withdrawn.

use std::ops::Range;

use nalgebra::Vector3;

use crate::intervals::intervals;
use crate::kinematics::Track;
use crate::numeric::stats::percentile;
use crate::skate::leg::Leg;
use crate::skeleton::Up;

/// Maximum distance by which the hips may move, in leg lengths.
const MAX_HIP_OFFSET: f64 = 0.15;

/// Maximum ratio of the accelerations of a joint after and before the clean-up.
const MAX_ROUGHNESS: f64 = 4.0;

/// Acceleration that never counts as harm, in leg lengths per second squared: that of gravity.
const HARMLESS_ACCELERATION: f64 = 10.0;

/// Second difference of a position that never counts as harm, in leg lengths.
const HARMLESS_STEP: f64 = 0.03;

/// Fraction of the accelerations of the original that is ordinary; defects are beyond it.
const ORDINARY: f64 = 0.9;

/// Fraction of the heights of the toes in the original that are below the ground, by defects.
const GROUND: f64 = 0.05;

/// Maximum depth of a toe below the ground, or below its place in the original, in leg lengths.
const MAX_DEPTH: f64 = 0.05;

/// Time around a frame in which the original may be as rough, in seconds.
const WINDOW: f64 = 0.1;

/// Returns the frame ranges in which the hips move too far, a toe gets below the ground, or a joint of a leg
/// accelerates much more than in the original motion. `length` is the leg length.
pub(super) fn harmful_frames(
    before: &[Leg; 2],
    after: &[Leg; 2],
    hip_offset: &[Vector3<f64>],
    up: Up,
    length: f64,
    frame_time: f64,
) -> Vec<Range<usize>> {
    let mut is_harmful: Vec<bool> =
        hip_offset.iter().map(|offset| offset.norm() > MAX_HIP_OFFSET * length).collect();
    let heights = before.iter().flat_map(|leg| &leg.toe).map(|toe| up.height(toe));
    let ground = percentile(heights.collect(), GROUND);
    let half = (WINDOW / frame_time).round() as usize;
    let harmless = length * HARMLESS_STEP.max(HARMLESS_ACCELERATION * frame_time * frame_time);
    for (before, after) in before.iter().zip(after) {
        for (is_harmful, (before, after)) in is_harmful.iter_mut().zip(before.toe.iter().zip(&after.toe)) {
            *is_harmful |= up.height(after) < ground.min(up.height(before)) - MAX_DEPTH * length;
        }
        for (before, after) in tracks(before).into_iter().zip(tracks(after)) {
            mark_rough(&accelerations(before), &accelerations(after), half, harmless, &mut is_harmful);
        }
    }
    intervals(&is_harmful)
}

fn tracks(leg: &Leg) -> [&Track; 4] {
    [&leg.hip, &leg.knee, &leg.ankle, &leg.toe]
}

/// Marks the frames whose acceleration after the clean-up exceeds the largest one of the original nearby and
/// what is ordinary in the whole original, and is not `harmless`.
fn mark_rough(before: &[f64], after: &[f64], half: usize, harmless: f64, is_rough: &mut [bool]) {
    if before.is_empty() {
        return;
    }
    let high = percentile(before.to_vec(), ORDINARY).max(harmless / MAX_ROUGHNESS);
    for (frame, &after) in after.iter().enumerate() {
        if after <= MAX_ROUGHNESS * high {
            continue;
        }
        let window = frame.saturating_sub(half)..(frame + half + 1).min(before.len());
        let original = before[window].iter().copied().fold(high, f64::max);
        if after > MAX_ROUGHNESS * original {
            // The acceleration at the second of three frames.
            is_rough[frame + 1] = true;
        }
    }
}

/// Returns the norms of the second differences: the accelerations, in file units per squared frame.
fn accelerations(track: &Track) -> Vec<f64> {
    track.windows(3).map(|window| (window[0] - 2.0 * window[1] + window[2]).norm()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn defects_of_the_original_do_not_hide_new_ones() {
        let mut before = vec![0.01; 200];
        before[50..58].fill(4.0);
        let mut after = before.clone();
        after[120] = 1.0;
        let mut is_rough = vec![false; 202];
        mark_rough(&before, &after, 12, 0.03, &mut is_rough);
        assert_eq!(intervals(&is_rough), [121..122]);
    }
}
