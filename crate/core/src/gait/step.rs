//! Steps: one row per foot strike, with the step that it ends and the stride that it begins.

use std::ops::Range;

use nalgebra::Vector2;
use serde::{Deserialize, Serialize};

use crate::foot::Side;
use crate::gait::footfall::{Footfall, Footfalls};
use crate::gait::{MAX_STRIDE_TIME, MIN_STRIDE_LENGTH};
use crate::plants::Feet;

/// One foot strike: the step that it ends and the stride that it begins.
///
/// A measure is `None` if an event that it requires is missing.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Step {
    /// The foot that strikes.
    pub side: Side,
    /// First frame of contact.
    pub strike_frame: usize,
    /// Time of the foot strike, in seconds from the first frame of the clip.
    pub strike_s: f64,
    /// First frame after contact; `None` if the clip ends before.
    pub off_frame: Option<usize>,
    /// Time of the foot off, in seconds from the first frame of the clip.
    pub off_s: Option<f64>,
    /// Time from the other foot's strike to this strike.
    pub step_time_s: Option<f64>,
    /// Distance of the heel ahead of the other heel, along the direction of progression.
    pub step_length_m: Option<f64>,
    /// Distance of the heel to its own side of the other heel, across the direction of progression;
    /// negative if the feet cross.
    pub step_width_m: Option<f64>,
    /// The stride that the strike begins, if it counts.
    pub stride: Option<Stride>,
    /// Reason why the stride does not count.
    pub left_out: Option<Omission>,
}

/// Measures of one stride, from foot strike to the next foot strike of the same foot.
///
/// Percentages are those of the stride time, the gait cycle. Stance and swing add up to 100; so do, in a
/// walk, swing, single support and double support.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Stride {
    /// Stride time.
    pub time_s: f64,
    /// Distance between the heels of both footfalls.
    pub length_m: f64,
    /// Time from foot strike to foot off.
    pub stance_s: f64,
    /// Time from foot off to the next foot strike.
    pub swing_s: f64,
    /// Time of the stance in which the other foot is in the air.
    pub single_support_s: f64,
    /// Time with both feet down: two periods in a walk, none in a run.
    pub double_support_s: f64,
    /// Time with neither foot down: the flight phases of a run.
    pub flight_s: f64,
    /// Stance as a percentage of the gait cycle.
    pub stance_percent: f64,
    /// Swing as a percentage of the gait cycle.
    pub swing_percent: f64,
    /// Single support of this foot as a percentage of the gait cycle.
    pub single_support_percent: f64,
    /// Double support as a percentage of the gait cycle.
    pub double_support_percent: f64,
}

/// Reason why a stride does not count.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Omission {
    /// The clip, or the action, begins or ends within the stride.
    CutOff,
    /// The other foot does not strike exactly once in between.
    MissingEvent,
    /// The stride is longer than [`MAX_STRIDE_TIME`]: the person stands.
    Pause,
    /// The stride is shorter than [`MIN_STRIDE_LENGTH`]: the person steps on the spot.
    OnTheSpot,
}

impl Omission {
    /// Returns a description of the reason, such as `cut off`.
    pub fn description(self) -> &'static str {
        match self {
            Omission::CutOff => "cut off",
            Omission::MissingEvent => "missing event",
            Omission::Pause => "pause",
            Omission::OnTheSpot => "on the spot",
        }
    }
}

/// A stride that begins with a footfall.
pub(crate) enum Candidate {
    /// The stride counts; its last footfall is the second one after the first.
    Counts,
    /// The stride is complete except that its foot strike is before the clip: its steps count.
    Unbegun,
    LeftOut(Omission),
}

impl Candidate {
    /// True if the steps of the stride count.
    pub fn has_steps(&self) -> bool {
        matches!(self, Candidate::Counts | Candidate::Unbegun)
    }
}

/// Returns the stride that begins with each footfall; `None` for footfalls outside of `ranges`.
///
/// A stride belongs to a range if both of its strikes are within. `frames` is the number of frames of the
/// clip.
pub(crate) fn candidates(
    feet: &Feet,
    footfalls: &[Footfall],
    ranges: &[Range<usize>],
) -> Vec<Option<Candidate>> {
    let candidate = |(index, first): (usize, &Footfall)| {
        let range = ranges.iter().find(|range| range.contains(&first.frames.start))?;
        let next = (index + 1..footfalls.len()).find(|&other| footfalls[other].side == first.side);
        let end = next
            .map_or_else(|| feet.frame_count() as f64 * feet.frame_time, |next| footfalls[next].times.start);
        let result = if end - first.times.start > MAX_STRIDE_TIME {
            Err(Omission::Pause)
        } else if let Some(next) = next {
            let has_one_step = next == index + 2 && {
                let other = &footfalls[index + 1];
                // Feet that strike together jump. If the first foot was down when the clip begins, its
                // stride time is a lower bound.
                (first.frames.start < other.frames.start || first.frames.start == 0)
                    && other.frames.start < footfalls[next].frames.start
            };
            let length = (footfalls[next].heel - first.heel).norm();
            if !has_one_step {
                Err(Omission::MissingEvent)
            } else if length < MIN_STRIDE_LENGTH * feet.leg * feet.metres_per_unit {
                Err(Omission::OnTheSpot)
            } else if range.contains(&footfalls[next].frames.start) {
                Ok(())
            } else {
                Err(Omission::CutOff)
            }
        } else {
            Err(Omission::CutOff)
        };
        Some(match result {
            Ok(()) if first.frames.start > 0 => Candidate::Counts,
            Ok(()) => Candidate::Unbegun,
            Err(omission) => Candidate::LeftOut(omission),
        })
    };
    footfalls.iter().enumerate().map(candidate).collect()
}

/// Returns a row for each foot strike of the candidates.
pub(crate) fn steps(feet: &Feet, footfalls: &Footfalls, candidates: &[Option<Candidate>]) -> Vec<Step> {
    let list = &footfalls.list;
    let has_steps = |index: Option<usize>| {
        let candidate = index.and_then(|index| candidates.get(index)?.as_ref());
        candidate.is_some_and(Candidate::has_steps)
    };
    let row = |(index, candidate): (usize, &Option<Candidate>)| {
        let candidate = candidate.as_ref()?;
        let footfall = &list[index];
        // Contact that begins with the clip has no foot strike.
        if footfall.frames.start == 0 {
            return None;
        }
        let is_within = footfall.frames.end < feet.frame_count();
        // The strides that share the step which ends here: of the other foot and of this foot.
        let [before, after] = [index.checked_sub(2), index.checked_sub(1)].map(has_steps);
        let previous = index.checked_sub(1).map(|previous| &list[previous]);
        let timed = previous.filter(|previous| (before || after) && previous.frames.start > 0);
        let located = (before && after).then(|| step_vector(&list[index - 2..index + 2])).flatten();
        Some(Step {
            side: footfall.side,
            strike_frame: footfall.frames.start,
            strike_s: footfall.times.start,
            off_frame: is_within.then_some(footfall.frames.end),
            off_s: is_within.then_some(footfall.times.end),
            step_time_s: timed.map(|previous| footfall.times.start - previous.times.start),
            step_length_m: located.map(|step| step.x),
            step_width_m: located.map(|step| step.y),
            stride: matches!(candidate, Candidate::Counts).then(|| stride(list, index)),
            left_out: if let Candidate::LeftOut(omission) = candidate { Some(*omission) } else { None },
        })
    };
    candidates.iter().enumerate().filter_map(row).collect()
}

/// Returns the measures of the stride that begins with a footfall.
fn stride(footfalls: &[Footfall], index: usize) -> Stride {
    let (first, last) = (&footfalls[index], &footfalls[index + 2]);
    let (start, off, end) = (first.times.start, first.times.end, last.times.start);
    let time = end - start;
    let of_other_foot = || {
        let times = footfalls.iter().filter(|other| other.side != first.side).map(|other| &other.times);
        times.filter(|times| times.start < end && times.end > start)
    };
    let overlap = |a: &Range<f64>, b: &Range<f64>| (a.end.min(b.end) - a.start.max(b.start)).max(0.0);
    let double_support_s = of_other_foot().map(|other| overlap(other, &(start..off))).sum();
    let mut flight_s = 0.0;
    let mut covered = off;
    for other in of_other_foot().filter(|other| other.end > off) {
        flight_s += (other.start - covered).max(0.0);
        covered = covered.max(other.end);
    }
    flight_s += (end - covered).max(0.0);
    let (stance_s, swing_s) = (off - start, end - off);
    let single_support_s = stance_s - double_support_s;
    let percent = |part: f64| 100.0 * part / time;
    Stride {
        time_s: time,
        length_m: (last.heel - first.heel).norm(),
        stance_s,
        swing_s,
        single_support_s,
        double_support_s,
        flight_s,
        stance_percent: percent(stance_s),
        swing_percent: percent(swing_s),
        single_support_percent: percent(single_support_s),
        double_support_percent: percent(double_support_s),
    }
}

/// Returns length and width of the step from the second to the third of four footfalls, in metres.
///
/// As in the spatial parameters of non-linear walking by Huxham, Gong, Baker, Morris and Iansek
/// (Gait & Posture 23(2), 2006), they are measured along and across the line of the strides,
/// not of the laboratory. The direction is the mean of the two strides that share the step,
/// which is the direction of progression in the middle of the step: on a curve the steps of the
/// inner foot are as wide as those of the outer foot.
fn step_vector(four: &[Footfall]) -> Option<Vector2<f64>> {
    let (from, to) = (&four[1], &four[2]);
    // Strides that count have a length; opposite strides have no mean direction.
    let strides = (to.heel - four[0].heel).normalize() + (four[3].heel - from.heel).normalize();
    let ahead = strides.try_normalize(f64::EPSILON)?;
    let step = to.heel - from.heel;
    // A person who walks backward has the left foot on the right of the direction of
    // progression.
    let facing = if ahead.dot(&(from.heading + to.heading)) < 0.0 { -ahead } else { ahead };
    let left = Vector2::new(facing.y, -facing.x);
    let outward = if to.side == Side::Left { left } else { -left };
    Some(Vector2::new(step.dot(&ahead), step.dot(&outward)))
}
