//! A detection beside another labelling of the same clip.

use serde::Serialize;

use crate::foot::{Part, Side};
use crate::intervals::intervals;
use crate::numeric::sort;
use crate::plants::{Annotation, Detection};
use crate::score::{EventScore, Events, Tally, events, lenient, strict};

/// The fuzzy periods that accuracy is reported for, in seconds.
pub const FUZZY: [f64; 5] = [0.0, 0.1, 0.2, 0.3, 0.4];

/// How well one part agrees.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PartScore {
    /// The part that both have labelled.
    pub part: Part,
    /// Accuracy for each period of [`FUZZY`].
    pub rows: Vec<Row>,
    /// Plants as events, of both feet.
    pub events: EventScore,
    /// Where the labels differ.
    pub disagreements: Vec<Disagreement>,
}

/// Accuracy for one fuzzy period; shares from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Row {
    /// The fuzzy period in seconds.
    pub fuzzy: f64,
    /// [`lenient`], both feet.
    pub lenient: f64,
    /// [`strict`], both feet.
    pub strict: f64,
    /// [`lenient`], left foot.
    pub left: f64,
    /// [`lenient`], right foot.
    pub right: f64,
}

/// A run of frames in which the labels differ.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Disagreement {
    /// The foot.
    pub side: Side,
    /// The part.
    pub part: Part,
    /// First frame.
    pub start: usize,
    /// First frame after.
    pub end: usize,
    /// Whether the plant was missed or is too much.
    pub kind: DisagreementKind,
}

/// In which way labels differ.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum DisagreementKind {
    /// The other labelling has the foot planted.
    Missed,
    /// Only the detection has.
    Extra,
}

/// Compares every part that both have labelled.
///
/// # Panics
/// If they are of different numbers of frames.
pub fn compare(detection: &Detection, other: &Annotation, frame_time: f64) -> Vec<PartScore> {
    let score = |(part, truth): &(Part, [Vec<Option<bool>>; 2])| {
        let labels = detection.part(*part)?;
        let feet = Side::BOTH.map(|side| (&labels.foot(side).planted, &truth[side as usize]));
        let rows = FUZZY.map(|fuzzy| {
            let [left, right] = feet.map(|(labels, truth)| lenient(labels, truth, frame_time, fuzzy));
            let mut exact = Tally::default();
            feet.iter().for_each(|(labels, truth)| exact += strict(labels, truth, frame_time, fuzzy));
            let mut both = left;
            both += right;
            Row {
                fuzzy,
                lenient: both.accuracy(),
                strict: exact.accuracy(),
                left: left.accuracy(),
                right: right.accuracy(),
            }
        });
        let mut all = Events::default();
        feet.iter().for_each(|(labels, truth)| all += events(labels, truth, frame_time));
        let mut disagreements: Vec<Disagreement> = Vec::new();
        for (side, (labels, truth)) in Side::BOTH.into_iter().zip(feet) {
            for (kind, known) in [(DisagreementKind::Missed, true), (DisagreementKind::Extra, false)] {
                let differ: Vec<bool> = labels
                    .iter()
                    .zip(truth)
                    .map(|(label, truth)| *truth == Some(known) && *label != known)
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
        Some(PartScore { part: *part, rows: rows.to_vec(), events: all.score(), disagreements })
    };
    other.parts.iter().filter_map(score).collect()
}
