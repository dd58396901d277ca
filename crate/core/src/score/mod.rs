//! Accuracy of labels against truth whose boundaries are fuzzy (paper, section 3.1).

mod compare;
mod cuts;
mod events;

pub use compare::{Disagreement, DisagreementKind, FUZZY, PartScore, Row, compare};
pub use cuts::{CutTally, Tolerance, TrueCut, cuts};
pub use events::{EventScore, Events, events};

use std::ops::AddAssign;

/// Truth of one foot per frame; `None` where it is not known.
pub type Truth = Vec<Option<bool>>;

/// How many labels were right, of how many.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Labels that agree with the truth, or are forgiven.
    pub right: usize,
    /// Labels whose truth is known.
    pub total: usize,
}

impl Tally {
    /// Share of right labels, from 0 to 1; 1 where nothing is known.
    pub fn accuracy(self) -> f64 {
        if self.total == 0 { 1.0 } else { self.right as f64 / self.total as f64 }
    }
}

impl AddAssign for Tally {
    fn add_assign(&mut self, other: Tally) {
        self.right += other.right;
        self.total += other.total;
    }
}

/// Lenient accuracy of one foot's labels.
///
/// A boundary of the truth between frames k − 1 and k lies at k − ½; every
/// label within `fuzzy` / 2 seconds of one is right. Where the truth is not
/// known, nothing is counted and no boundary lies. The clip's ends are none.
///
/// # Panics
/// If `labels` and `truth` differ in length.
pub fn lenient(labels: &[bool], truth: &[Option<bool>], frame_time: f64, fuzzy: f64) -> Tally {
    assert_eq!(labels.len(), truth.len(), "labels and truth are of one clip");
    let mut forgiven = vec![false; truth.len()];
    for k in 1..truth.len() {
        if let (Some(before), Some(after)) = (truth[k - 1], truth[k])
            && before != after
        {
            // |i − (k − ½)| ≤ reach, in frames; the margin is for rounding.
            let reach = (fuzzy / 2.0 + 1e-9) / frame_time;
            let width = (reach + 0.5).floor() as usize;
            forgiven[k.saturating_sub(width)..(k + width).min(truth.len())].fill(true);
        }
    }
    let mut tally = Tally::default();
    for ((label, truth), forgiven) in labels.iter().zip(truth).zip(forgiven) {
        if let Some(truth) = truth {
            tally.total += 1;
            tally.right += usize::from(forgiven || label == truth);
        }
    }
    tally
}

/// Strict accuracy of one foot's labels.
///
/// Each boundary of the truth moves by at most `fuzzy` / 2 seconds, never past
/// the middle of a segment beside it, to where it agrees best with the labels;
/// then labels and truth are compared frame by frame. Unlike [`lenient`], a plant
/// that was missed altogether is never forgiven.
///
/// # Panics
/// If `labels` and `truth` differ in length.
pub fn strict(labels: &[bool], truth: &[Option<bool>], frame_time: f64, fuzzy: f64) -> Tally {
    assert_eq!(labels.len(), truth.len(), "labels and truth are of one clip");
    let most = (fuzzy / 2.0 / frame_time + 1e-9).floor() as isize;
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
        let back = most.min((before.len() / 2) as isize);
        let ahead = most.min((after.len() / 2) as isize);
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

/// Truth from force plates without the frames that only seem to be off the ground.
///
/// Off a plate, "no force" means only that there is no plate: a frame without
/// contact within 0.1 s of an unknown one becomes unknown too.
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
    fn boundaries_are_forgiven_by_time() {
        let truth = truth("....####....");
        let found = labels("......######");
        // Boundaries at 3.5 and 7.5; frames 4, 5 and 8 to 11 are wrong.
        assert_eq!(lenient(&found, &truth, 0.1, 0.0), Tally { right: 6, total: 12 });
        assert_eq!(lenient(&found, &truth, 0.1, 0.1), Tally { right: 8, total: 12 });
        assert_eq!(lenient(&found, &truth, 0.1, 0.3), Tally { right: 10, total: 12 });
    }

    #[test]
    fn strict_moves_boundaries_but_forgives_no_missed_plant() {
        let late = truth("....####....");
        assert_eq!(strict(&labels("......####.."), &late, 0.1, 0.4), Tally { right: 12, total: 12 });
        assert_eq!(strict(&labels("......####.."), &late, 0.1, 0.2), Tally { right: 10, total: 12 });
        let missed = labels("............");
        assert_eq!(lenient(&missed, &late, 0.1, 0.4).right, 12);
        // Each boundary goes to the middle of the plant at most: nothing is left of it but its place.
        assert_eq!(strict(&missed, &late, 0.1, 0.2), Tally { right: 10, total: 12 });
    }

    proptest! {
        #[test]
        fn a_longer_fuzzy_period_never_costs(
            pairs in prop::collection::vec((any::<bool>(), prop::option::weighted(0.9, any::<bool>())), 1..60),
            fuzzy in 0.0..0.4_f64,
        ) {
            let (labels, truth): (Vec<bool>, Truth) = pairs.into_iter().unzip();
            for score in [lenient, strict] {
                let less = score(&labels, &truth, 0.02, fuzzy);
                let more = score(&labels, &truth, 0.02, fuzzy + 0.1);
                prop_assert!(less.right <= more.right && less.total == more.total);
            }
            let plain = lenient(&labels, &truth, 0.02, 0.0);
            prop_assert_eq!(strict(&labels, &truth, 0.02, 0.0), plain);
            prop_assert!(strict(&labels, &truth, 0.02, fuzzy).right >= plain.right);
        }
    }

    #[test]
    fn what_is_unknown_does_not_count() {
        let truth = truth("?#.?");
        assert_eq!(lenient(&labels("...."), &truth, 0.1, 0.0), Tally { right: 1, total: 2 });
        assert_eq!(Tally::default().accuracy(), 1.0);
    }

    #[test]
    fn masking_spares_contact_and_what_is_far() {
        let masked = mask_near_unknown(&truth("..#.?...."), 0.04);
        assert_eq!(masked, truth("..#????.."));
    }
}
