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
/// Minimum travel of the hips for that check, in leg lengths.
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
    } else if let Some(swing) =
        swing.filter(|&swing| fastest < SLOW_SPEED && travel > MIN_TRAVEL && swing > MAX_SWING)
    {
        format!("the feet swing implausibly slowly (for {swing:.1} s)")
    } else {
        return None;
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
