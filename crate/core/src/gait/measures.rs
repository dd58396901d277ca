//! Means of the steps and strides of a clip.

use serde::{Deserialize, Serialize};

use crate::foot::Side;
use crate::gait::step::{Candidate, Stride};
use crate::gait::{Omission, PerSide, Spread, Step, Symmetry};

/// Gait measures of one skeleton of a clip.
///
/// Lengths are in metres by the skeleton's scale, times in seconds, fractions from 0 to 1, percentages of
/// the stride time. A measure is `None` if the clip has nothing to measure: no stride that counts or, for
/// step length and width, no step with a footfall before and after it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Gait {
    /// Number of complete strides of both feet.
    pub strides: usize,
    /// Number of strides that were left out, by reason.
    pub left_out: LeftOut,
    /// Steps per minute: 120 s over the mean stride time.
    pub cadence_steps_per_min: Option<f64>,
    /// Speed over ground, or relative to the belt of a treadmill: total stride length over total stride time.
    pub speed_m_per_s: Option<f64>,
    /// Speed of the belt of a treadmill; `None` over ground.
    pub belt_m_per_s: Option<f64>,
    /// Time from foot strike to foot off.
    pub stance_s: PerSide,
    /// Time from foot off to the next foot strike of the same foot.
    pub swing_s: PerSide,
    /// Time of the stance in which the other foot is in the air.
    pub single_support_s: PerSide,
    /// Stance as a percentage of the gait cycle.
    pub stance_percent: PerSide,
    /// Swing as a percentage of the gait cycle.
    pub swing_percent: PerSide,
    /// Single support as a percentage of the gait cycle.
    pub single_support_percent: PerSide,
    /// Double support as a percentage of the gait cycle.
    pub double_support_percent: PerSide,
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

/// Number of strides that were left out, by reason; see [`Omission`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct LeftOut {
    /// Strides that the ends of the clip, or of the action, cut off.
    pub cut_off: usize,
    /// Strides in which the other foot does not strike exactly once.
    pub missing_event: usize,
    /// Strides in which the person stands.
    pub pause: usize,
    /// Strides on the spot.
    pub on_the_spot: usize,
}

impl LeftOut {
    /// Counts the strides that do not count.
    pub(crate) fn new(candidates: &[Option<Candidate>]) -> LeftOut {
        let mut left_out = LeftOut::default();
        for candidate in candidates.iter().flatten() {
            match candidate {
                Candidate::Counts => {}
                Candidate::Unbegun | Candidate::LeftOut(Omission::CutOff) => left_out.cut_off += 1,
                Candidate::LeftOut(Omission::MissingEvent) => left_out.missing_event += 1,
                Candidate::LeftOut(Omission::Pause) => left_out.pause += 1,
                Candidate::LeftOut(Omission::OnTheSpot) => left_out.on_the_spot += 1,
            }
        }
        left_out
    }

    /// Returns the number of all strides that were left out.
    pub fn total(&self) -> usize {
        self.cut_off + self.missing_event + self.pause + self.on_the_spot
    }
}

impl Gait {
    /// Returns the means of steps. `belt_m_per_s` is the speed of the belt of a treadmill.
    pub(crate) fn from_steps(steps: &[Step], left_out: LeftOut, belt_m_per_s: Option<f64>) -> Gait {
        let of_steps = |value: fn(&Step) -> Option<f64>| {
            PerSide::new(&Side::BOTH.map(|side| {
                steps.iter().filter(|step| step.side == side).filter_map(value).collect::<Vec<_>>()
            }))
        };
        let of_strides = |value: fn(&Stride) -> f64| {
            PerSide::new(&Side::BOTH.map(|side| {
                let strides = steps.iter().filter(|step| step.side == side).filter_map(|step| step.stride);
                strides.map(|stride| value(&stride)).collect::<Vec<_>>()
            }))
        };
        let strides: Vec<Stride> = steps.iter().filter_map(|step| step.stride).collect();
        let of_both = |value: fn(&Stride) -> f64| Spread::new(&strides.iter().map(value).collect::<Vec<_>>());
        let total = |value: fn(&Stride) -> f64| strides.iter().map(value).sum::<f64>();
        let time = total(|stride| stride.time_s);
        let per_time = |amount: f64| (!strides.is_empty()).then_some(amount / time);
        let stance_s = of_strides(|stride| stride.stance_s);
        let swing_s = of_strides(|stride| stride.swing_s);
        let step_time_s = of_steps(|step| step.step_time_s);
        let step_length_m = of_steps(|step| step.step_length_m);
        Gait {
            strides: strides.len(),
            left_out,
            cadence_steps_per_min: per_time(120.0 * strides.len() as f64),
            speed_m_per_s: per_time(total(|stride| stride.length_m)),
            belt_m_per_s,
            symmetry: Symmetry::new(&stance_s, &swing_s, &step_time_s, &step_length_m),
            stance_s,
            swing_s,
            single_support_s: of_strides(|stride| stride.single_support_s),
            stance_percent: of_strides(|stride| stride.stance_percent),
            swing_percent: of_strides(|stride| stride.swing_percent),
            single_support_percent: of_strides(|stride| stride.single_support_percent),
            double_support_percent: of_strides(|stride| stride.double_support_percent),
            stride_time_s: of_strides(|stride| stride.time_s),
            stride_length_m: of_strides(|stride| stride.length_m),
            step_time_s,
            step_length_m,
            step_width_m: of_steps(|step| step.step_width_m),
            double_support_s: of_both(|stride| stride.double_support_s),
            double_support_share: of_both(|stride| stride.double_support_percent / 100.0),
            flight_s: of_both(|stride| stride.flight_s),
            flight_share: of_both(|stride| stride.flight_s / stride.time_s),
        }
    }
}
