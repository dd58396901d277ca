//! Plausibility of labels and frame rate.

use crate::foot::Part;
use crate::notice::{Code, Notice};
use crate::numeric::stats;
use crate::plants::{Feet, PartLabels};

/// Maximum plausible speed of a foot, in leg lengths per second.
const MAX_SPEED: f64 = 25.0;
/// Minimum plausible speed of feet during travel, in leg lengths per second.
const MIN_SPEED: f64 = 2.0;
/// Minimum travel of the hips for that check, in leg lengths.
const MIN_TRAVEL: f64 = 2.0;
/// Maximum plausible fraction of frames with both feet off the ground; sprinting reaches a third.
const MAX_AIRBORNE: f64 = 0.5;

/// Returns a notice if the feet are implausibly fast or slow at the frame rate.
pub(crate) fn rate(feet: &Feet) -> Option<Notice> {
    let legs_per_second =
        |pair: &[nalgebra::Vector3<f64>]| (pair[1] - pair[0]).norm() / (feet.frame_time * feet.leg);
    let mut speeds: Vec<f64> =
        feet.tracks.iter().flat_map(|foot| foot.ankle.windows(2).map(legs_per_second)).collect();
    let start = feet.hips.first()?;
    if speeds.is_empty() {
        return None;
    }
    // An added pose is one fast step and does not count.
    let index = (speeds.len() as f64 * 0.98) as usize;
    let fastest = stats::nth_smallest(&mut speeds, index);
    let travel = feet.hips.iter().map(|hips| (hips - start).norm()).fold(0.0, f64::max) / feet.leg;
    let problem = if fastest > MAX_SPEED {
        "implausibly fast"
    } else if fastest < MIN_SPEED && travel > MIN_TRAVEL {
        "too slow for the distance that the hips travel"
    } else {
        return None;
    };
    let text = format!(
        "At {:.4} Hz the feet are {problem} ({fastest:.1} leg lengths per second); \
         the file may state a wrong frame time. Set the frame rate if you know it.",
        1.0 / feet.frame_time
    );
    Some(Notice::new(Code::ImplausibleRate, text))
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
