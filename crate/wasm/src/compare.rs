//! Labels from elsewhere, beside ours.

use plantigrade::labels::{self, Labelling};
use plantigrade::score::{self, DisagreementKind, PartScore};
use serde::{Deserialize, Serialize};
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::records::{EditFacts, Failure, side, to_js};
use crate::{RawClip, RawDetection};

/// Labels of the clip by someone else.
#[wasm_bindgen]
pub struct RawLabelling(Labelling);

#[wasm_bindgen]
impl RawLabelling {
    /// Reads a labels document, a truth file, a table per frame or an NPZ archive, for a clip of
    /// so many frames.
    ///
    /// # Errors
    /// If the file is none of these, or is of another clip.
    #[wasm_bindgen(constructor)]
    pub fn new(file: &[u8], frames: usize) -> Result<RawLabelling, Failure> {
        Ok(RawLabelling(labels::read_bytes(file, frames)?))
    }

    /// The parts that were labelled.
    pub fn parts(&self) -> Vec<String> {
        self.0.parts.iter().map(|(part, _)| part.name().into()).collect()
    }

    /// 1 where the foot is planted, 0 where not, −1 where that is not known, per frame.
    ///
    /// # Errors
    /// If there is no such part or side.
    pub fn planted(&self, part: &str, of: &str) -> Result<Vec<i8>, Failure> {
        let found = self.0.parts.iter().find(|(other, _)| other.name() == part);
        let (_, feet) = found.ok_or_else(|| Failure::from(format!("there are no labels of {part:?}")))?;
        Ok(feet[side(of)? as usize].iter().map(|label| label.map_or(-1, i8::from)).collect())
    }

    /// The labels as edits that make them one's own, wherever they are known.
    ///
    /// # Errors
    /// None that labels can cause.
    pub fn edits(&self) -> Result<Vec<Ts<EditFacts>>, Failure> {
        self.0.edits().into_iter().map(|edit| to_js(&EditFacts::from(edit))).collect()
    }

    /// How well a detection in the clip agrees, for each part that both have.
    ///
    /// # Errors
    /// None that labels can cause.
    pub fn score(&self, clip: &RawClip, detection: &RawDetection) -> Result<Vec<Ts<ScoreFacts>>, Failure> {
        let scores = score::compare(detection.core(), &self.0, clip.core().frame_time());
        scores.into_iter().map(|score| to_js(&ScoreFacts::from(score))).collect()
    }
}

/// How well one part agrees.
#[derive(Debug, Serialize, Deserialize, Tsify)]
pub struct ScoreFacts {
    /// The part.
    #[tsify(type = "\"contact\" | \"toe\" | \"heel\"")]
    pub part: String,
    /// Accuracy for each fuzzy period.
    pub rows: Vec<ScoreRow>,
    /// Plants as events.
    pub events: EventFacts,
    /// Where the labels differ, in order.
    pub disagreements: Vec<DisagreementFacts>,
}

/// Accuracy for one fuzzy period; shares from 0 to 1.
#[derive(Debug, Serialize, Deserialize, Tsify)]
pub struct ScoreRow {
    /// The period in seconds.
    pub fuzzy: f64,
    /// Labels near a boundary are right.
    pub lenient: f64,
    /// Boundaries move to where they agree best.
    pub strict: f64,
    /// Lenient, of the left foot.
    pub left: f64,
    /// Lenient, of the right foot.
    pub right: f64,
}

/// Plants as events; times in seconds, positive is late.
#[derive(Debug, Serialize, Deserialize, Tsify)]
pub struct EventFacts {
    /// Share of the plants found that there are.
    pub precision: f64,
    /// Share of the plants that were found.
    pub recall: f64,
    /// Harmonic mean of both.
    pub f1: f64,
    /// Median error of the beginnings.
    pub onset: f64,
    /// Median error of the ends.
    pub offset: f64,
}

/// A run of frames in which the labels differ.
#[derive(Debug, Serialize, Deserialize, Tsify)]
pub struct DisagreementFacts {
    /// The foot.
    #[tsify(type = "\"left\" | \"right\"")]
    pub side: String,
    /// The part.
    #[tsify(type = "\"contact\" | \"toe\" | \"heel\"")]
    pub part: String,
    /// First frame.
    pub start: usize,
    /// First frame after.
    pub end: usize,
    /// Whether the plant was missed or is too much.
    #[tsify(type = "\"missed\" | \"extra\"")]
    pub kind: String,
}

impl From<PartScore> for ScoreFacts {
    fn from(score: PartScore) -> ScoreFacts {
        let row = |row: &score::Row| ScoreRow {
            fuzzy: row.fuzzy,
            lenient: row.lenient,
            strict: row.strict,
            left: row.left,
            right: row.right,
        };
        let disagreement = |run: &score::Disagreement| DisagreementFacts {
            side: run.side.name().into(),
            part: run.part.name().into(),
            start: run.start,
            end: run.end,
            kind: match run.kind {
                DisagreementKind::Missed => "missed".into(),
                DisagreementKind::Extra => "extra".into(),
            },
        };
        let score::EventScore { precision, recall, f1, onset, offset, .. } = score.events;
        ScoreFacts {
            part: score.part.name().into(),
            rows: score.rows.iter().map(row).collect(),
            events: EventFacts { precision, recall, f1, onset, offset },
            disagreements: score.disagreements.iter().map(disagreement).collect(),
        }
    }
}
