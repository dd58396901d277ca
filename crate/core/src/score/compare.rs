//! Comparison of a detection with an annotation of the same clip.

use serde::Serialize;

use crate::foot::{Part, Side};
use crate::intervals::intervals;
use crate::numeric::sort;
use crate::plants::{Annotation, Detection};
use crate::score::{EventScore, Events, Tally, events, lenient, strict};

/// Fuzzy periods for which accuracy is reported, in seconds: the tolerance around boundaries, see
/// [`lenient`].
pub const FUZZY_PERIODS: [f64; 5] = [0.0, 0.1, 0.2, 0.3, 0.4];

/// Agreement of detection and annotation in one part.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PartScore {
    /// The part.
    pub part: Part,
    /// Accuracy for each period of [`FUZZY_PERIODS`].
    pub rows: Vec<AccuracyRow>,
    /// Agreement of plants as events, over both feet.
    pub events: EventScore,
    /// Frame ranges in which the labels differ and the annotation is known.
    pub disagreements: Vec<Disagreement>,
}

/// Accuracy for one fuzzy period, as fractions from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct AccuracyRow {
    /// Fuzzy period, in seconds.
    pub fuzzy: f64,
    /// [`lenient`] accuracy of both feet.
    pub lenient: f64,
    /// [`strict`] accuracy of both feet.
    pub strict: f64,
    /// [`lenient`] accuracy of the left foot.
    pub left: f64,
    /// [`lenient`] accuracy of the right foot.
    pub right: f64,
}

/// Frame range in which the labels differ.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Disagreement {
    /// The foot.
    pub side: Side,
    /// The part.
    pub part: Part,
    /// First frame.
    pub start: usize,
    /// First frame after the range.
    pub end: usize,
    /// Kind: the detection misses contact or has extra contact.
    pub kind: DisagreementKind,
}

/// Kind of a disagreement.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum DisagreementKind {
    /// Only the annotation has contact.
    Missed,
    /// Only the detection has contact.
    Extra,
}

/// Compares every part that both have labelled.
///
/// # Panics
/// If the numbers of frames differ.
pub fn compare(detection: &Detection, annotation: &Annotation, frame_time: f64) -> Vec<PartScore> {
    let score = |(part, truth): &(Part, [Vec<Option<bool>>; 2])| {
        let labels = detection.part(*part)?;
        let feet = Side::BOTH.map(|side| (&labels.foot(side).planted, &truth[side as usize]));
        let rows = FUZZY_PERIODS.map(|fuzzy| {
            let [left, right] = feet.map(|(labels, truth)| lenient(labels, truth, frame_time, fuzzy));
            let mut strict_tally = Tally::default();
            feet.iter().for_each(|(labels, truth)| strict_tally += strict(labels, truth, frame_time, fuzzy));
            let mut both = left;
            both += right;
            AccuracyRow {
                fuzzy,
                lenient: both.accuracy(),
                strict: strict_tally.accuracy(),
                left: left.accuracy(),
                right: right.accuracy(),
            }
        });
        let mut all_events = Events::default();
        feet.iter().for_each(|(labels, truth)| all_events += events(labels, truth, frame_time));
        let mut disagreements: Vec<Disagreement> = Vec::new();
        for (side, (labels, truth)) in Side::BOTH.into_iter().zip(feet) {
            for (kind, annotated) in [(DisagreementKind::Missed, true), (DisagreementKind::Extra, false)] {
                let differ: Vec<bool> = labels
                    .iter()
                    .zip(truth)
                    .map(|(label, truth)| *truth == Some(annotated) && *label != annotated)
                    .collect();
                disagreements.extend(intervals(&differ).into_iter().map(|run| Disagreement {
                    side,
                    part: *part,
                    start: run.start,
                    end: run.end,
                    kind,
                }));
            }
        }
        let disagreements = sort::sort_by_frames(disagreements, |run| (run.start, run.end));
        Some(PartScore { part: *part, rows: rows.to_vec(), events: all_events.score(), disagreements })
    };
    annotation.parts.iter().filter_map(score).collect()
}
