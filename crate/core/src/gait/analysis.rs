//! Gait of one skeleton: measures, steps and joint angles.

use std::ops::Range;

use serde::{Deserialize, Serialize};

use crate::foot::Side;
use crate::gait::footfall::Footfalls;
use crate::gait::measures::LeftOut;
use crate::gait::{Contact, Curves, Gait, Legs, Step, curves, step};
use crate::plants::{Detection, Feet};

/// Gait of one skeleton of a clip, or of some frame ranges of it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct GaitAnalysis {
    /// Means of the steps and strides.
    pub gait: Gait,
    /// Steps in order of foot strike, also those that belong to no stride that counts.
    pub steps: Vec<Step>,
    /// Joint angles over the gait cycle; `None` without a stride that counts or without joints of the legs.
    pub curves: Option<Curves>,
}

impl GaitAnalysis {
    /// Analyses the gait of the left foot's contacts and the right's.
    ///
    /// Without `legs` there are no curves. With `ranges`, only strides and steps within one of these frame
    /// ranges count; the ground is always that of the whole clip. Default: the whole clip.
    ///
    /// # Panics
    /// If the number of labels of a foot differs from the number of frames.
    pub fn new(
        feet: &Feet,
        legs: Option<&Legs>,
        contacts: [Contact; 2],
        ranges: Option<&[Range<usize>]>,
    ) -> GaitAnalysis {
        let frames = feet.frame_count();
        assert!(contacts.iter().all(|contact| contact.planted.len() == frames), "one label per frame");
        let whole_clip = [0..frames];
        let footfalls = Footfalls::new(feet, contacts);
        let candidates = step::candidates(feet, &footfalls.list, ranges.unwrap_or(&whole_clip));
        let steps = step::steps(feet, &footfalls, &candidates);
        let belt = footfalls.belt.map(|belt| belt.norm() * feet.metres_per_unit);
        GaitAnalysis {
            gait: Gait::from_steps(&steps, LeftOut::new(&candidates), belt),
            steps,
            curves: legs.and_then(|legs| curves::curves(feet, legs, &footfalls, &candidates)),
        }
    }

    /// Analyses the gait of a detection, by its principal part, with edits applied and with the instants of
    /// its edges; otherwise like [`GaitAnalysis::new`].
    pub fn from_detection(
        feet: &Feet,
        legs: Option<&Legs>,
        detection: &Detection,
        ranges: Option<&[Range<usize>]>,
    ) -> GaitAnalysis {
        let labels = detection.principal();
        let contacts = Side::BOTH.map(|side| Contact::from(labels.foot(side)));
        GaitAnalysis::new(feet, legs, contacts, ranges)
    }
}

impl Gait {
    /// Returns the measures of a detection, by its principal part, with edits applied.
    ///
    /// Cadence, lengths and widths depend little on the exact frames of foot strike and foot off.
    /// Stance, swing, double support and flight do: they are as accurate as the labels.
    pub fn from_detection(feet: &Feet, detection: &Detection) -> Gait {
        GaitAnalysis::from_detection(feet, None, detection, None).gait
    }

    /// Returns the measures of labels per frame, the left foot's and the right's.
    ///
    /// # Panics
    /// If the number of labels of a foot differs from the number of frames.
    pub fn measure(feet: &Feet, planted: [&[bool]; 2]) -> Gait {
        GaitAnalysis::new(feet, None, planted.map(Contact::from_frames), None).gait
    }
}
