//! Doubts about labels and rate that a person should hear of.

use crate::foot::Part;
use crate::notice::{Code, Notice};
use crate::plants::{Feet, PartLabels};

/// Nobody's foot is faster, in legs per second.
const FASTEST: f64 = 25.0;
/// Nobody travels with feet slower than this, in legs per second.
const SLOWEST: f64 = 2.0;
/// How far the hips have to come for that to count, in legs.
const TRAVEL: f64 = 2.0;
/// No gait leaves both feet off the ground for longer than this share of the time; sprinting does for a third.
const AIRBORNE: f64 = 0.5;

/// A rate at which nobody moves so.
pub(crate) fn rate(feet: &Feet) -> Option<Notice> {
    let legs_per_second =
        |pair: &[nalgebra::Vector3<f64>]| (pair[1] - pair[0]).norm() / (feet.frame_time * feet.leg);
    let mut speeds: Vec<f64> =
        feet.tracks.iter().flat_map(|foot| foot.ankle.windows(2).map(legs_per_second)).collect();
    let start = feet.hips.first()?;
    if speeds.is_empty() {
        return None;
    }
    // A stuck-on pose is one fast step and says nothing about the rate.
    let most = (speeds.len() as f64 * 0.98) as usize;
    let fastest = *speeds.select_nth_unstable_by(most, f64::total_cmp).1;
    let travel = feet.hips.iter().map(|hips| (hips - start).norm()).fold(0.0, f64::max) / feet.leg;
    let doubt = if fastest > FASTEST {
        "faster than feet can be"
    } else if fastest < SLOWEST && travel > TRAVEL {
        "too slow for how far the hips travel"
    } else {
        return None;
    };
    let text = format!(
        "At {:.4} Hz the feet are {doubt} ({fastest:.1} leg lengths per second): \
         the file may state a wrong frame time. Set the true rate if you know it.",
        1.0 / feet.frame_time
    );
    Some(Notice::new(Code::ImplausibleRate, text))
}

/// Longer in the air than anybody is.
pub(crate) fn airborne(parts: &[PartLabels]) -> Option<Notice> {
    let contact = parts.iter().find(|labels| labels.part == Part::Contact)?;
    let [left, right] = [&contact.feet[0].planted, &contact.feet[1].planted];
    let in_air = left.iter().zip(right).filter(|(left, right)| !**left && !**right).count();
    let share = in_air as f64 / left.len().max(1) as f64;
    (share > AIRBORNE).then(|| {
        let text = format!(
            "Both feet are off the ground in {:.0} % of the frames, more than any gait allows: \
             the clip may hold no plants at all, which motion alone cannot tell.",
            100.0 * share
        );
        Notice::new(Code::ImplausibleAirborne, text)
    })
}
