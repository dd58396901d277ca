//! Plausibility of labels and frame rate.

use nalgebra::Vector3;

use crate::foot::Part;
use crate::kinematics::Track;
use crate::notice::{Code, Notice};
use crate::numeric::stats;
use crate::plants::{Feet, PartLabels};

/// Maximum plausible speed of a foot, in leg lengths per second.
const MAX_SPEED: f64 = 25.0;
/// Speed of feet during travel below which their swings are measured, in leg lengths per second.
const SLOW_SPEED: f64 = 2.5;
/// Minimum plausible speed of feet during travel with too few swings, in leg lengths per second.
const MIN_SPEED: f64 = 2.0;
/// Minimum travel of the hips for both checks, in leg lengths.
const MIN_TRAVEL: f64 = 2.0;
/// Maximum plausible median duration of swings, in seconds. The largest of 90 recorded clips with
/// travel is 0.63 s, and slow walks have ordinary swings.
const MAX_SWING: f64 = 0.75;
/// Minimum duration of swings; shorter ones are noise.
const MIN_SWING: f64 = 0.1;
/// Minimum number of swings for a median.
const MIN_SWINGS: usize = 3;
/// Speed of a swinging foot as a fraction of the highest speed.
const SWING_SPEED: f64 = 0.25;
/// Maximum plausible fraction of frames with both feet off the ground; sprinting reaches a third.
const MAX_AIRBORNE: f64 = 0.5;

/// Returns a notice if the feet are implausibly fast, or swing implausibly slowly, at the frame rate.
pub(crate) fn rate(feet: &Feet) -> Option<Notice> {
    // Repeated poses alternate between rest and jumps.
    let repeats = feet.repeats();
    let legs_per_second = |track: &Track| -> Vec<f64> {
        let speed = |(from, to): (&Vector3<f64>, &Vector3<f64>)| {
            (to - from).norm() / (feet.frame_time * repeats as f64 * feet.leg)
        };
        track.iter().zip(track.iter().skip(repeats)).map(speed).collect()
    };
    let speeds = feet.tracks.each_ref().map(|foot| legs_per_second(&foot.ankle));
    let start = feet.hips.first()?;
    let mut all = speeds.concat();
    if all.is_empty() {
        return None;
    }
    // An added pose is one fast step and does not count.
    let index = (all.len() as f64 * 0.98) as usize;
    let fastest = stats::nth_smallest(&mut all, index);
    let travel = feet.hips.iter().map(|hips| (hips - start).norm()).fold(0.0, f64::max) / feet.leg;
    let swing = median_swing(&speeds, SWING_SPEED * fastest, feet.frame_time);
    let problem = if fastest > MAX_SPEED {
        format!("the feet are implausibly fast ({fastest:.1} leg lengths per second)")
    } else if travel < MIN_TRAVEL {
        return None;
    } else {
        match swing {
            Some(swing) if fastest < SLOW_SPEED && swing > MAX_SWING => {
                format!("the feet swing implausibly slowly (for {swing:.1} s)")
            }
            None if fastest < MIN_SPEED => format!(
                "the feet are too slow for the distance that the hips travel ({fastest:.1} leg lengths per second)"
            ),
            _ => return None,
        }
    };
    let text = format!(
        "At {:.4} Hz {problem}; the file may state a wrong frame time. Set the frame rate if you know it.",
        1.0 / feet.frame_time
    );
    Some(Notice::new(Code::ImplausibleRate, text))
}

/// Returns the median duration of the swings within the clip, in seconds, if there are enough of them.
fn median_swing(speeds: &[Vec<f64>; 2], min_speed: f64, frame_time: f64) -> Option<f64> {
    let mut swings: Vec<f64> = Vec::new();
    for speeds in speeds {
        let is_swing: Vec<bool> = speeds.iter().map(|&speed| speed > min_speed).collect();
        let runs = is_swing.chunk_by(|a, b| a == b);
        let mut durations: Vec<f64> =
            runs.map(|run| if run[0] { run.len() as f64 * frame_time } else { 0.0 }).collect();
        // The first and the last swing may be cut off.
        durations.pop();
        swings.extend(durations.iter().skip(1).filter(|&&duration| duration > MIN_SWING));
    }
    let middle = swings.len() / 2;
    (swings.len() >= MIN_SWINGS).then(|| stats::nth_smallest(&mut swings, middle))
}

/// Returns a notice if both feet are in the air for an implausible fraction of the clip.
pub(crate) fn airborne(parts: &[PartLabels]) -> Option<Notice> {
    let contact = parts.iter().find(|labels| labels.part == Part::Contact)?;
    let [left, right] = [&contact.feet[0].planted, &contact.feet[1].planted];
    let in_air = left.iter().zip(right).filter(|(left, right)| !**left && !**right).count();
    let fraction = in_air as f64 / left.len().max(1) as f64;
    (fraction > MAX_AIRBORNE).then(|| {
        let text = format!(
            "Both feet are off the ground in {:.0} % of the frames, more than in any gait; \
             the character may be in the air throughout, which cannot be detected from the motion.",
            100.0 * fraction
        );
        Notice::new(Code::ImplausibleAirborne, text)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants::FootTracks;
    use crate::skeleton::Up;

    /// Feet that step in turn, 0.4 leg lengths in 0.4 s, and rest for `rest` seconds after each step, at
    /// 50 Hz with each pose written `repeats` times.
    fn steps(rest: f64, repeats: usize) -> Feet {
        let period = 0.8 + 2.0 * rest;
        let foot = |delay: f64| -> Track {
            let position = |pose: usize| {
                let time = pose as f64 / 50.0 - delay;
                let (step, within) = ((time / period).floor(), time.rem_euclid(period));
                Vector3::x() * (0.4 * (step + (within / 0.4).min(1.0)))
            };
            (0..(12.0 * period * 50.0) as usize)
                .flat_map(|pose| std::iter::repeat_n(position(pose), repeats))
                .collect()
        };
        let tracks =
            [0.0, 0.4 + rest].map(|delay| FootTracks { ankle: foot(delay), toe: foot(delay), tip: None });
        let hips = tracks[0].ankle.clone();
        let frame_time = 0.02 / repeats as f64;
        Feet { tracks, hips, up: Up::Y, leg: 1.0, metres_per_unit: 1.0, frame_time }
    }

    fn has_notice(feet: &Feet, factor: f64) -> bool {
        rate(&Feet { frame_time: factor * feet.frame_time, ..feet.clone() }).is_some()
    }

    #[test]
    fn slow_walks_have_plausible_rates() {
        for rest in [0.0, 0.5, 3.0] {
            let feet = steps(rest, 1);
            assert!(!has_notice(&feet, 1.0) && !has_notice(&feet, 1.5), "{rest}");
            assert!(has_notice(&feet, 3.0) && has_notice(&feet, 10.0) && has_notice(&feet, 0.03), "{rest}");
        }
    }

    #[test]
    fn repeated_poses_do_not_make_rates_implausible() {
        let feet = steps(0.2, 30);
        assert_eq!(steps(0.2, 4).repeats(), 4);
        assert!(!has_notice(&feet, 1.0));
        assert!(has_notice(&feet, 0.03) && has_notice(&feet, 3.0));
    }
}
