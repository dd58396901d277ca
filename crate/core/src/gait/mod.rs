//! Gait measures: how a person walks or runs, from the times and locations of the plants.
//!
//! Definitions follow clinical gait analysis (Perry and Burnfield, *Gait Analysis: Normal and
//! Pathological Function*, 2nd edition, 2010). A *stride* (gait cycle) lasts from one foot strike
//! to the next of the same foot, a *step* from the strike of one foot to the strike of the other; a
//! step is named after the foot that takes it. *Stance* lasts from foot strike to foot off, *swing*
//! from foot off to the next strike. Foot strike and foot off are the ends of contact rather than
//! extremes of a marker's track (Zeni, Richards and Higginson, Gait & Posture 27(4), 2008).
//!
//! Only complete strides count; strides cut off by the clip are not measured. A stride counts if
//! the other foot steps once in between, if it takes at most [`MAX_STRIDE_TIME`] and if it moves
//! the foot by at least [`MIN_STRIDE_LENGTH`]. Standing, turning on the spot, hopping and jumping
//! contain no such stride. Lengths are measured along the plane of the ground, and on a treadmill relative
//! to its belt ([`Ground`](crate::plants::Ground)).

mod footfall;
mod spread;
mod symmetry;
mod table;
#[cfg(test)]
mod tests;

pub use spread::{PerSide, Spread};
pub use symmetry::Symmetry;

use nalgebra::Vector2;
use serde::{Deserialize, Serialize};

use crate::foot::Side;
use crate::plants::{Detection, Feet};
use footfall::{Footfall, footfalls};

/// Maximum stride time, in seconds. At 48 steps per minute, less than half of the usual cadence
/// (100 to 120), a person stands between steps.
pub const MAX_STRIDE_TIME: f64 = 2.5;

/// Minimum stride length, in leg lengths: about 36 cm for an adult, or two steps shorter than a
/// foot each. Feet that shift weight, turn or box on the spot move less.
pub const MIN_STRIDE_LENGTH: f64 = 0.4;

/// Gait measures of one skeleton of a clip.
///
/// Lengths are in metres by the skeleton's scale, times in seconds, fractions from 0 to 1. A
/// measure is `None` if the clip has nothing to measure: no stride that counts or, for step length
/// and width, no step with a footfall before and after it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Gait {
    /// Number of complete strides of both feet.
    pub strides: usize,
    /// Steps per minute: 120 s over the mean stride time.
    pub cadence_steps_per_min: Option<f64>,
    /// Speed over ground, or relative to the belt of a treadmill: total stride length over total stride time.
    pub speed_m_per_s: Option<f64>,
    /// Time from foot strike to foot off.
    pub stance_s: PerSide,
    /// Time from foot off to the next foot strike of the same foot.
    pub swing_s: PerSide,
    /// Time from foot strike to the next foot strike of the same foot.
    pub stride_time_s: PerSide,
    /// Distance between the heels of successive footfalls of one foot.
    pub stride_length_m: PerSide,
    /// Time from the other foot's strike to this foot's strike.
    pub step_time_s: PerSide,
    /// Distance of the heel ahead of the other heel, along the direction of progression.
    pub step_length_m: PerSide,
    /// Distance of the heel to its own side of the other heel, across the direction of progression;
    /// negative if the feet cross.
    pub step_width_m: PerSide,
    /// Time per stride with both feet down: two periods in a walk, none in a run.
    pub double_support_s: Option<Spread>,
    /// Fraction of a stride with both feet down.
    pub double_support_share: Option<Spread>,
    /// Time per stride with neither foot down: the flight phases of a run.
    pub flight_s: Option<Spread>,
    /// Fraction of a stride with neither foot down.
    pub flight_share: Option<Spread>,
    /// Comparison of left and right.
    pub symmetry: Symmetry,
}

impl Gait {
    /// Returns the measures of a detection, by its principal part.
    ///
    /// Cadence, lengths and widths depend little on the exact frames of foot strike and foot off.
    /// Stance, swing, double support and flight do: they are as accurate as the labels. For labels
    /// that a person corrected, use [`Gait::measure`].
    pub fn from_detection(feet: &Feet, detection: &Detection) -> Gait {
        let labels = detection.principal();
        Gait::measure(feet, Side::BOTH.map(|side| labels.foot(side).planted.as_slice()))
    }

    /// Returns the measures of labels per frame, the left foot's and the right's.
    ///
    /// # Panics
    /// If the number of labels of a foot differs from the number of frames.
    pub fn measure(feet: &Feet, planted: [&[bool]; 2]) -> Gait {
        let frames = feet.frame_count();
        assert!(planted.iter().all(|labels| labels.len() == frames), "one label per frame");
        let footfalls = footfalls(feet, planted);
        let is_stride: Vec<bool> = footfalls.windows(3).map(|three| is_stride(feet, three)).collect();
        let mut samples = Samples::default();
        for (three, _) in footfalls.windows(3).zip(&is_stride).filter(|(_, is_stride)| **is_stride) {
            samples.add_stride(feet, planted, three);
        }
        for (index, step) in footfalls.windows(2).enumerate() {
            let before = index.checked_sub(1).is_some_and(|before| is_stride[before]);
            let after = is_stride.get(index).is_some_and(|&after| after);
            if (before || after) && step[0].frames.start > 0 {
                let frames = step[1].frames.start - step[0].frames.start;
                samples.step_time[step[1].side as usize].push(frames as f64 * feet.frame_time);
            }
            if before && after {
                samples.add_step(&footfalls[index - 1..index + 3]);
            }
        }
        samples.into_gait()
    }
}

/// True if three footfalls are a stride of the first one's foot.
///
/// If the first foot was down when the clip begins, its stride time is a lower bound.
fn is_stride(feet: &Feet, three: &[Footfall]) -> bool {
    let [first, other, last] = three else { return false };
    let frames = last.frames.start - first.frames.start;
    first.side == last.side
        && first.side != other.side
        // Feet that strike together jump.
        && (first.frames.start < other.frames.start || first.frames.start == 0)
        && other.frames.start < last.frames.start
        && frames as f64 * feet.frame_time <= MAX_STRIDE_TIME
        && (last.heel - first.heel).norm() >= MIN_STRIDE_LENGTH * feet.leg * feet.metres_per_unit
}

/// Values of every stride and step; by side if they belong to one foot.
#[derive(Default)]
struct Samples {
    stance: [Vec<f64>; 2],
    swing: [Vec<f64>; 2],
    stride_time: [Vec<f64>; 2],
    stride_length: [Vec<f64>; 2],
    step_time: [Vec<f64>; 2],
    step_length: [Vec<f64>; 2],
    step_width: [Vec<f64>; 2],
    double_support: Vec<f64>,
    double_support_share: Vec<f64>,
    flight: Vec<f64>,
    flight_share: Vec<f64>,
}

impl Samples {
    /// Adds the measures of a stride unless the clip cuts off its beginning.
    fn add_stride(&mut self, feet: &Feet, planted: [&[bool]; 2], three: &[Footfall]) {
        let (first, last) = (&three[0], &three[2]);
        let (start, off, end) = (first.frames.start, first.frames.end, last.frames.start);
        if start == 0 {
            return;
        }
        let side = first.side as usize;
        let seconds = |frames: usize| frames as f64 * feet.frame_time;
        self.stance[side].push(seconds(off - start));
        self.swing[side].push(seconds(end - off));
        self.stride_time[side].push(seconds(end - start));
        self.stride_length[side].push((last.heel - first.heel).norm());
        let frames_with_both =
            |down| (start..end).filter(|&frame| planted.iter().all(|labels| labels[frame] == down)).count();
        let fraction = |frames: usize| frames as f64 / (end - start) as f64;
        self.double_support.push(seconds(frames_with_both(true)));
        self.double_support_share.push(fraction(frames_with_both(true)));
        self.flight.push(seconds(frames_with_both(false)));
        self.flight_share.push(fraction(frames_with_both(false)));
    }

    /// Adds length and width of the step from the second to the third of four footfalls.
    ///
    /// As in the spatial parameters of non-linear walking by Huxham, Gong, Baker, Morris and Iansek
    /// (Gait & Posture 23(2), 2006), they are measured along and across the line of the strides,
    /// not of the laboratory. The direction is the mean of the two strides that share the step,
    /// which is the direction of progression in the middle of the step: on a curve the steps of the
    /// inner foot are as wide as those of the outer foot.
    fn add_step(&mut self, four: &[Footfall]) {
        let (from, to) = (&four[1], &four[2]);
        // Strides that count have a length; opposite strides have no mean direction.
        let strides = (to.heel - four[0].heel).normalize() + (four[3].heel - from.heel).normalize();
        let Some(ahead) = strides.try_normalize(f64::EPSILON) else { return };
        let step = to.heel - from.heel;
        // A person who walks backward has the left foot on the right of the direction of
        // progression.
        let facing = if ahead.dot(&(from.heading + to.heading)) < 0.0 { -ahead } else { ahead };
        let left = Vector2::new(facing.y, -facing.x);
        let outward = if to.side == Side::Left { left } else { -left };
        self.step_length[to.side as usize].push(step.dot(&ahead));
        self.step_width[to.side as usize].push(step.dot(&outward));
    }

    fn into_gait(self) -> Gait {
        let total = |values: &[Vec<f64>; 2]| values.iter().flatten().sum::<f64>();
        let strides = self.stride_time.iter().map(Vec::len).sum();
        let time = total(&self.stride_time);
        let per_time = |amount: f64| (strides > 0).then_some(amount / time);
        let [stance_s, swing_s, step_time_s, step_length_m] =
            [&self.stance, &self.swing, &self.step_time, &self.step_length].map(PerSide::new);
        Gait {
            strides,
            cadence_steps_per_min: per_time(120.0 * strides as f64),
            speed_m_per_s: per_time(total(&self.stride_length)),
            symmetry: Symmetry::new(&stance_s, &swing_s, &step_time_s, &step_length_m),
            stance_s,
            swing_s,
            stride_time_s: PerSide::new(&self.stride_time),
            stride_length_m: PerSide::new(&self.stride_length),
            step_time_s,
            step_length_m,
            step_width_m: PerSide::new(&self.step_width),
            double_support_s: Spread::new(&self.double_support),
            double_support_share: Spread::new(&self.double_support_share),
            flight_s: Spread::new(&self.flight),
            flight_share: Spread::new(&self.flight_share),
        }
    }
}
