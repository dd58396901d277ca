//! Accuracy of labels against a reference: plants with fuzzy boundaries (paper, section 3.1), cuts and
//! classes of actions.

mod assignment;
mod classes;
mod compare;
mod cuts;
mod events;

pub use classes::{ClassScore, classes};
pub use compare::{AccuracyRow, Disagreement, DisagreementKind, FUZZY_PERIODS, PartScore, compare};
pub use cuts::{CutTally, Tolerance, TrueCut, cuts};
pub use events::{EventScore, Events, events};

use std::ops::AddAssign;

/// Reference labels of one foot per frame; `None` if unknown.
pub type Truth = Vec<Option<bool>>;

/// Numbers of correct labels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Labels that agree with the reference or are within a fuzzy period.
    pub correct: usize,
    /// Labels whose reference is known.
    pub total: usize,
}

impl Tally {
    /// Returns the fraction of correct labels, from 0 to 1; 1 if none is known.
    pub fn accuracy(self) -> f64 {
        if self.total == 0 { 1.0 } else { self.correct as f64 / self.total as f64 }
    }
}

impl AddAssign for Tally {
    fn add_assign(&mut self, other: Tally) {
        self.correct += other.correct;
        self.total += other.total;
    }
}

/// Returns the lenient accuracy of one foot's labels.
///
/// A boundary between frames k − 1 and k is at k − ½. Every label within `fuzzy` / 2 seconds of a
/// boundary is correct. Frames with unknown reference do not count and have no boundaries; the ends
/// of the clip are not boundaries.
///
/// # Panics
/// If `labels` and `truth` differ in length.
pub fn lenient(labels: &[bool], truth: &[Option<bool>], frame_time: f64, fuzzy: f64) -> Tally {
    assert_eq!(labels.len(), truth.len(), "labels and truth must have the same length");
    let mut tolerated = vec![false; truth.len()];
    for k in 1..truth.len() {
        if let (Some(before), Some(after)) = (truth[k - 1], truth[k])
            && before != after
        {
            // |i − (k − ½)| ≤ radius, in frames; the margin is for rounding.
            let radius = (fuzzy / 2.0 + 1e-9) / frame_time;
            let width = (radius + 0.5).floor() as usize;
            tolerated[k.saturating_sub(width)..(k + width).min(truth.len())].fill(true);
        }
    }
    let mut tally = Tally::default();
    for ((label, truth), tolerated) in labels.iter().zip(truth).zip(tolerated) {
        if let Some(truth) = truth {
            tally.total += 1;
            tally.correct += usize::from(tolerated || label == truth);
        }
    }
    tally
}

/// Returns the strict accuracy of one foot's labels.
///
/// Each boundary moves by at most `fuzzy` / 2 seconds, and at most to the middle of a neighbouring
/// run, to where it agrees best with the labels; then labels and reference are compared frame by
/// frame. Unlike [`lenient`], a plant that is missed entirely never counts as correct.
///
/// # Panics
/// If `labels` and `truth` differ in length.
pub fn strict(labels: &[bool], truth: &[Option<bool>], frame_time: f64, fuzzy: f64) -> Tally {
    assert_eq!(labels.len(), truth.len(), "labels and truth must have the same length");
    let max = (fuzzy / 2.0 / frame_time + 1e-9).floor() as isize;
    let mut moved = truth.to_vec();
    let mut runs: Vec<std::ops::Range<usize>> = Vec::new();
    for run in truth.chunk_by(|a, b| a == b) {
        let start = runs.last().map_or(0, |run| run.end);
        runs.push(start..start + run.len());
    }
    for pair in runs.windows(2) {
        let (before, after) = (&pair[0], &pair[1]);
        let (Some(left), Some(right)) = (truth[before.start], truth[after.start]) else { continue };
        let boundary = after.start as isize;
        let back = max.min((before.len() / 2) as isize);
        let ahead = max.min((after.len() / 2) as isize);
        let range = (boundary - back) as usize..(boundary + ahead) as usize;
        let agreement = |shift: isize| {
            let split = (boundary + shift) as usize;
            range.clone().filter(|&frame| labels[frame] == if frame < split { left } else { right }).count()
        };
        let best = (-back..=ahead).max_by_key(|&shift| (agreement(shift), -shift.abs())).unwrap_or(0);
        for frame in range {
            moved[frame] = Some(if (frame as isize) < boundary + best { left } else { right });
        }
    }
    lenient(labels, &moved, frame_time, 0.0)
}

/// Returns force-plate reference labels without frames that may be off the plate.
///
/// Outside of a plate, no force does not mean no contact: a frame without contact within 0.1 s of
/// an unknown one becomes unknown.
pub fn mask_near_unknown(truth: &[Option<bool>], frame_time: f64) -> Truth {
    let unknown: Vec<usize> = (0..truth.len()).filter(|&frame| truth[frame].is_none()).collect();
    let is_near = |frame: usize| {
        let after = unknown.partition_point(|&other| other < frame);
        unknown[after.saturating_sub(1)..(after + 1).min(unknown.len())]
            .iter()
            .any(|&other| (other.abs_diff(frame) as f64) * frame_time <= 0.1 + 1e-9)
    };
    truth
        .iter()
        .enumerate()
        .map(|(frame, &label)| if label == Some(false) && is_near(frame) { None } else { label })
        .collect()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn truth(text: &str) -> Truth {
        text.chars().map(|c| (c != '?').then_some(c == '#')).collect()
    }

    fn labels(text: &str) -> Vec<bool> {
        text.chars().map(|c| c == '#').collect()
    }

    #[test]
    fn boundaries_are_tolerated_by_time() {
        let truth = truth("....####....");
        let detected = labels("......######");
        // Boundaries are at 3.5 and 7.5; frames 4, 5 and 8 to 11 are wrong.
        assert_eq!(lenient(&detected, &truth, 0.1, 0.0), Tally { correct: 6, total: 12 });
        assert_eq!(lenient(&detected, &truth, 0.1, 0.1), Tally { correct: 8, total: 12 });
        assert_eq!(lenient(&detected, &truth, 0.1, 0.3), Tally { correct: 10, total: 12 });
    }

    #[test]
    fn strict_moves_boundaries_but_counts_missed_plants() {
        let late = truth("....####....");
        assert_eq!(strict(&labels("......####.."), &late, 0.1, 0.4), Tally { correct: 12, total: 12 });
        assert_eq!(strict(&labels("......####.."), &late, 0.1, 0.2), Tally { correct: 10, total: 12 });
        let missed = labels("............");
        assert_eq!(lenient(&missed, &late, 0.1, 0.4).correct, 12);
        // Each boundary moves at most to the middle of the plant, which is not enough to remove it.
        assert_eq!(strict(&missed, &late, 0.1, 0.2), Tally { correct: 10, total: 12 });
    }

    proptest! {
        #[test]
        fn a_longer_fuzzy_period_never_lowers_accuracy(
            pairs in prop::collection::vec((any::<bool>(), prop::option::weighted(0.9, any::<bool>())), 1..60),
            fuzzy in 0.0..0.4_f64,
        ) {
            let (labels, truth): (Vec<bool>, Truth) = pairs.into_iter().unzip();
            for score in [lenient, strict] {
                let less = score(&labels, &truth, 0.02, fuzzy);
                let more = score(&labels, &truth, 0.02, fuzzy + 0.1);
                prop_assert!(less.correct <= more.correct && less.total == more.total);
            }
            let plain = lenient(&labels, &truth, 0.02, 0.0);
            prop_assert_eq!(strict(&labels, &truth, 0.02, 0.0), plain);
            prop_assert!(strict(&labels, &truth, 0.02, fuzzy).correct >= plain.correct);
        }
    }

    #[test]
    fn unknown_frames_do_not_count() {
        let truth = truth("?#.?");
        assert_eq!(lenient(&labels("...."), &truth, 0.1, 0.0), Tally { correct: 1, total: 2 });
        assert_eq!(Tally::default().accuracy(), 1.0);
    }

    #[test]
    fn masking_preserves_contact_and_distant_frames() {
        let masked = mask_near_unknown(&truth("..#.?...."), 0.04);
        assert_eq!(masked, truth("..#????.."));
    }
}
