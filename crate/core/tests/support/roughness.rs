//! Smoothness of cleaned motion.

use plantigrade::bvh::Clip;
use plantigrade::foot::Side;
use plantigrade::kinematics::{self, Track};
use plantigrade::skeleton::{LegRoles, Skeleton};

/// Time around a frame in which the original may be as rough, in seconds.
const WINDOW: f64 = 0.1;

/// Returns the maximum ratio of `cleaned` to the original, and its frame. The value of the original is its
/// maximum within `half` frames, but at least its 99th percentile.
fn max_ratio(cleaned: &[f64], original: &[f64], half: usize) -> (f64, usize) {
    let mut sorted = original.to_vec();
    sorted.sort_by(f64::total_cmp);
    let Some(last) = sorted.len().checked_sub(1) else { return (0.0, 0) };
    let high = sorted[last * 99 / 100];
    let ratio = |frame: usize| {
        let window = frame.saturating_sub(half)..(frame + half + 1).min(original.len());
        cleaned[frame] / original[window].iter().copied().fold(high, f64::max).max(1e-9)
    };
    (0..cleaned.len()).map(|frame| (ratio(frame), frame)).fold((0.0, 0), |a, b| if b.0 > a.0 { b } else { a })
}

/// Returns the norms of the second differences.
fn accelerations(track: &Track) -> Vec<f64> {
    track.windows(3).map(|w| (w[0] - 2.0 * w[1] + w[2]).norm()).collect()
}

/// Returns the absolute changes of the knee angle per frame.
fn knee_rates(clip: &Clip, skeleton: &Skeleton, side: Side) -> Vec<f64> {
    let roles = LegRoles::for_side(side);
    let joints = [roles.thigh, roles.shank, roles.ankle]
        .map(|role| skeleton.roles.get(role).expect("a joint of the leg"));
    let [hip, knee, ankle] = <[Track; 3]>::try_from(kinematics::tracks(clip, &joints)).expect("three");
    let bend = |n: usize| (knee[n] - hip[n]).angle(&(ankle[n] - knee[n]));
    (1..hip.len()).map(|n| (bend(n) - bend(n - 1)).abs()).collect()
}

/// Returns by which factor the clean-up increased accelerations and rates of the knee angle, and the
/// joint and frame of the largest acceleration.
pub fn roughness(before: &Clip, after: &Clip, skeleton: &Skeleton) -> (f64, f64, String) {
    let half = (WINDOW / before.frame_time()).round() as usize;
    let joints: Vec<usize> = (0..before.joints().len()).collect();
    let [from, to] = [before, after].map(|clip| kinematics::tracks(clip, &joints));
    let mut worst = (0.0, String::new());
    for joint in joints {
        let (ratio, frame) = max_ratio(&accelerations(&to[joint]), &accelerations(&from[joint]), half);
        if ratio > worst.0 {
            worst = (ratio, format!("{}@{}", before.joints()[joint].name, frame + 1));
        }
    }
    let knees = Side::BOTH.map(|side| {
        max_ratio(&knee_rates(after, skeleton, side), &knee_rates(before, skeleton, side), half).0
    });
    (worst.0, knees[0].max(knees[1]), worst.1)
}

/// Returns the mean; 0 if there is no value.
pub fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len().max(1) as f64
}
