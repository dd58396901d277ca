//! Gait measures: how a person walks or runs, from when the feet are planted and where.
//!
//! The definitions are those of clinical gait analysis (Perry and Burnfield, *Gait Analysis:
//! Normal and Pathological Function*, 2nd edition, 2010). A *stride* or gait cycle goes from
//! one foot strike to the next of the same foot, a *step* from the strike of one foot to that
//! of the other; a step is called by the foot that takes it. *Stance* is from foot strike to
//! foot off, *swing* from there to the next strike. Strikes and offs are the ends of contact,
//! as the labels have them, rather than extremes of a marker's track (Zeni, Richards and
//! Higginson, Gait & Posture 27(4), 2008).
//!
//! Only whole strides count, so nothing that the clip's ends cut is taken for short. And only
//! strides that are gait: the other foot steps once in between, the stride takes no longer than
//! [`LONGEST_STRIDE`], and it takes the foot on by [`SHORTEST_STRIDE`]. Standing, turning on the
//! spot, hopping and jumping leave no such strides; nor does a treadmill, whose clip shows feet
//! that strike where they struck before.

mod footfall;
mod spread;
mod symmetry;
mod table;
#[cfg(test)]
mod tests;

pub use spread::PerSide;
pub use spread::Spread;
pub use symmetry::Symmetry;

use nalgebra::Vector2;
use serde::Deserialize;
use serde::Serialize;

use crate::foot::Side;
use crate::plants::{Detection, Feet};
use footfall::Footfall;
use footfall::footfalls;

/// Seconds that a stride may take: at 48 steps a minute, less than half of a usual cadence
/// (100 to 120), one stands between the steps rather than walks.
pub const LONGEST_STRIDE: f64 = 2.5;

/// How far a stride takes the foot at least, in leg lengths: about 36 cm for an adult, two steps
/// that are each shorter than a foot. Feet that shift weight, turn or box on the spot move by less.
pub const SHORTEST_STRIDE: f64 = 0.4;

/// The gait measures of one skeleton of a clip.
///
/// Lengths are in metres by the skeleton's scale, times in seconds, shares from 0 to 1.
/// A measure is `None` where the clip has nothing to take it from: no stride that counts, or for
/// step length and width no step with a footfall before and after it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Gait {
    /// Whole strides of both feet that the measures of time are taken from.
    pub strides: usize,
    /// Steps per minute: two in the mean stride time.
    pub cadence_steps_per_min: Option<f64>,
    /// Speed over ground: what the strides add up to in length, over what they take.
    pub speed_m_per_s: Option<f64>,
    /// Foot strike to foot off.
    pub stance_s: PerSide,
    /// Foot off to the next foot strike of the same foot.
    pub swing_s: PerSide,
    /// Foot strike to the next one of the same foot.
    pub stride_time_s: PerSide,
    /// From heel to heel of one foot's successive footfalls.
    pub stride_length_m: PerSide,
    /// The other foot's strike to this foot's.
    pub step_time_s: PerSide,
    /// How far the heel lands ahead of the other one, along the direction of progression.
    pub step_length_m: PerSide,
    /// How far the heel lands to its own side of the other one, across the direction of
    /// progression; negative where the feet cross.
    pub step_width_m: PerSide,
    /// Time in which both feet are down, in each stride: two periods of a walk, none of a run.
    pub double_support_s: Option<Spread>,
    /// The share of a stride in which both feet are down.
    pub double_support_share: Option<Spread>,
    /// Time in which neither foot is down, in each stride: what a run has for double support.
    pub flight_s: Option<Spread>,
    /// The share of a stride in which neither foot is down.
    pub flight_share: Option<Spread>,
    /// Left against right.
    pub symmetry: Symmetry,
}

impl Gait {
    /// The measures by what was detected: contact, or else the part that says best when a foot
    /// is down.
    ///
    /// Cadence, lengths and widths hardly depend on when exactly a foot strikes and leaves.
    /// Stance, swing, double support and flight do: they are as good as the labels, and those of
    /// labels that a person set right are had from [`Gait::measure`].
    pub fn of(feet: &Feet, detection: &Detection) -> Gait {
        let labels = detection.principal();
        Gait::measure(feet, Side::BOTH.map(|side| labels.foot(side).planted.as_slice()))
    }

    /// The measures by labels per frame, the left foot's and the right's.
    ///
    /// # Panics
    /// If there is not one label of each foot for each frame.
    pub fn measure(feet: &Feet, planted: [&[bool]; 2]) -> Gait {
        let frames = feet.frame_count();
        assert!(planted.iter().all(|labels| labels.len() == frames), "labels and tracks are of one clip");
        let footfalls = footfalls(feet, planted);
        let is_stride: Vec<bool> = footfalls.windows(3).map(|three| is_stride(feet, three)).collect();
        let mut found = Samples::default();
        for (three, _) in footfalls.windows(3).zip(&is_stride).filter(|(_, is_stride)| **is_stride) {
            found.stride(feet, planted, three);
        }
        for (index, step) in footfalls.windows(2).enumerate() {
            let before = index.checked_sub(1).is_some_and(|before| is_stride[before]);
            let after = is_stride.get(index).is_some_and(|&after| after);
            if (before || after) && step[0].frames.start > 0 {
                let frames = step[1].frames.start - step[0].frames.start;
                found.step_time[step[1].side as usize].push(frames as f64 * feet.frame_time);
            }
            if before && after {
                found.step(&footfalls[index - 1..index + 3]);
            }
        }
        found.gait()
    }
}

/// Whether three footfalls are a stride of the first one's foot.
///
/// Where the first was down when the clip begins, its time is the least that it can be.
fn is_stride(feet: &Feet, three: &[Footfall]) -> bool {
    let [first, other, last] = three else { return false };
    let frames = last.frames.start - first.frames.start;
    first.side == last.side
        && first.side != other.side
        // Feet that land together jump.
        && (first.frames.start < other.frames.start || first.frames.start == 0)
        && other.frames.start < last.frames.start
        && frames as f64 * feet.frame_time <= LONGEST_STRIDE
        && (last.heel - first.heel).norm() >= SHORTEST_STRIDE * feet.leg * feet.metres_per_unit
}

/// What strides and steps measure one by one; by side where they are a foot's.
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
    /// Takes the measures of a stride, if its beginning is known.
    fn stride(&mut self, feet: &Feet, planted: [&[bool]; 2], three: &[Footfall]) {
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
        let both_are =
            |down| (start..end).filter(|&frame| planted.iter().all(|labels| labels[frame] == down)).count();
        let share = |frames: usize| frames as f64 / (end - start) as f64;
        self.double_support.push(seconds(both_are(true)));
        self.double_support_share.push(share(both_are(true)));
        self.flight.push(seconds(both_are(false)));
        self.flight_share.push(share(both_are(false)));
    }

    /// Takes length and width of the step from the second to the third of four footfalls.
    ///
    /// As the spatial parameters of non-linear walking by Huxham, Gong, Baker, Morris and Iansek
    /// (Gait & Posture 23(2), 2006), they are taken along and across the line of the strides
    /// rather than of the room. Of the two strides that share the step the mean direction is
    /// taken: it is that of the way in the middle of the step, so that on a curve the inner
    /// foot's steps are as wide as the outer one's.
    fn step(&mut self, four: &[Footfall]) {
        let (from, to) = (&four[1], &four[2]);
        // Strides that count have a length; of opposite ones there is no middle.
        let strides = (to.heel - four[0].heel).normalize() + (four[3].heel - from.heel).normalize();
        let Some(ahead) = strides.try_normalize(f64::EPSILON) else { return };
        let step = to.heel - from.heel;
        // Who walks backward has the left foot on the right of the way.
        let facing = if ahead.dot(&(from.heading + to.heading)) < 0.0 { -ahead } else { ahead };
        let left = Vector2::new(facing.y, -facing.x);
        let outward = if to.side == Side::Left { left } else { -left };
        self.step_length[to.side as usize].push(step.dot(&ahead));
        self.step_width[to.side as usize].push(step.dot(&outward));
    }

    fn gait(self) -> Gait {
        let total = |values: &[Vec<f64>; 2]| values.iter().flatten().sum::<f64>();
        let strides = self.stride_time.iter().map(Vec::len).sum();
        let time = total(&self.stride_time);
        let per_time = |amount: f64| (strides > 0).then_some(amount / time);
        let [stance_s, swing_s, step_time_s, step_length_m] =
            [&self.stance, &self.swing, &self.step_time, &self.step_length].map(PerSide::of);
        Gait {
            strides,
            cadence_steps_per_min: per_time(120.0 * strides as f64),
            speed_m_per_s: per_time(total(&self.stride_length)),
            symmetry: Symmetry::of(&stance_s, &swing_s, &step_time_s, &step_length_m),
            stance_s,
            swing_s,
            stride_time_s: PerSide::of(&self.stride_time),
            stride_length_m: PerSide::of(&self.stride_length),
            step_time_s,
            step_length_m,
            step_width_m: PerSide::of(&self.step_width),
            double_support_s: Spread::of(&self.double_support),
            double_support_share: Spread::of(&self.double_support_share),
            flight_s: Spread::of(&self.flight),
            flight_share: Spread::of(&self.flight_share),
        }
    }
}
