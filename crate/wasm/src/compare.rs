//! Annotations read from files, and the agreement of a detection with them.

use plantigrade::formats;
use plantigrade::plants::Annotation;
use plantigrade::score::{self, DisagreementKind, PartScore};
use serde::{Deserialize, Serialize};
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::second::second_module;
use crate::types::{ArgumentError, EditInfo, Failure, parse_side, to_js};
use crate::{WasmClip, WasmDetection};

/// Labels of the clip read from a file.
#[wasm_bindgen]
pub struct WasmAnnotation(Annotation);

#[wasm_bindgen]
impl WasmAnnotation {
    /// Reads a labels document, a truth file, a table of frames or plants, or an NPZ archive, for a clip
    /// of `frames` frames.
    ///
    /// # Errors
    /// If the file has none of these formats, or belongs to another clip.
    #[wasm_bindgen(constructor)]
    pub fn new(file: &[u8], frames: usize) -> Result<WasmAnnotation, Failure> {
        read(file, frames)
    }

    /// Names of the labelled parts.
    pub fn parts(&self) -> Vec<String> {
        self.0.parts.iter().map(|(part, _)| part.name().into()).collect()
    }

    /// Labels per frame: 1 planted, 0 not planted, −1 unknown.
    ///
    /// # Errors
    /// If the part or the side does not exist.
    pub fn planted(&self, part: &str, side: &str) -> Result<Vec<i8>, Failure> {
        let labels = self.0.parts.iter().find(|(other, _)| other.name() == part);
        let (_, feet) = labels.ok_or_else(|| ArgumentError::MissingPart(part.into()))?;
        Ok(feet[parse_side(side)? as usize].iter().map(|label| label.map_or(-1, i8::from)).collect())
    }

    /// The edits that give a detection these labels in all frames in which they are known.
    ///
    /// # Errors
    /// Only if the conversion to JavaScript fails.
    pub fn edits(&self) -> Result<Vec<Ts<EditInfo>>, Failure> {
        edits(self)
    }

    /// Agreement of a detection with these labels, for each part that both label.
    ///
    /// # Errors
    /// Only if the conversion to JavaScript fails.
    pub fn score(&self, clip: &WasmClip, detection: &WasmDetection) -> Result<Vec<Ts<ScoreInfo>>, Failure> {
        score(self, clip, detection)
    }
}

/// Agreement of one part.
#[derive(Debug, Serialize, Deserialize, Tsify)]
pub struct ScoreInfo {
    /// The part.
    #[tsify(type = "\"contact\" | \"toe\" | \"heel\"")]
    pub part: String,
    /// Accuracy for each fuzzy period.
    pub rows: Vec<ScoreRow>,
    /// Agreement of plants as events.
    pub events: EventScoreInfo,
    /// Frame ranges in which the labels differ, in order.
    pub disagreements: Vec<DisagreementInfo>,
}

/// Accuracy for one fuzzy period; fractions from 0 to 1.
#[derive(Debug, Serialize, Deserialize, Tsify)]
pub struct ScoreRow {
    /// Fuzzy period, in seconds.
    pub fuzzy: f64,
    /// Accuracy if labels within the period around a boundary count as correct.
    pub lenient: f64,
    /// Accuracy after each boundary was moved by at most the period to agree best.
    pub strict: f64,
    /// Lenient accuracy of the left foot.
    pub left: f64,
    /// Lenient accuracy of the right foot.
    pub right: f64,
}

/// Agreement of plants as events; errors in seconds, positive if late.
#[derive(Debug, Serialize, Deserialize, Tsify)]
pub struct EventScoreInfo {
    /// Fraction of the detected plants that are annotated.
    pub precision: f64,
    /// Fraction of the annotated plants that were detected.
    pub recall: f64,
    /// Harmonic mean of precision and recall.
    pub f1: f64,
    /// Median error of the foot strikes.
    pub onset: f64,
    /// Median error of the foot offs.
    pub offset: f64,
}

/// A range of frames in which the labels differ.
#[derive(Debug, Serialize, Deserialize, Tsify)]
pub struct DisagreementInfo {
    /// The foot.
    #[tsify(type = "\"left\" | \"right\"")]
    pub side: String,
    /// The part.
    #[tsify(type = "\"contact\" | \"toe\" | \"heel\"")]
    pub part: String,
    /// First frame.
    pub start: usize,
    /// First frame after the range.
    pub end: usize,
    /// `missed`: only the annotation is planted; `extra`: only the detection is.
    #[tsify(type = "\"missed\" | \"extra\"")]
    pub kind: String,
}

impl From<PartScore> for ScoreInfo {
    fn from(score: PartScore) -> ScoreInfo {
        let row = |row: &score::AccuracyRow| ScoreRow {
            fuzzy: row.fuzzy,
            lenient: row.lenient,
            strict: row.strict,
            left: row.left,
            right: row.right,
        };
        let disagreement = |run: &score::Disagreement| DisagreementInfo {
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
        ScoreInfo {
            part: score.part.name().into(),
            rows: score.rows.iter().map(row).collect(),
            events: EventScoreInfo { precision, recall, f1, onset, offset },
            disagreements: score.disagreements.iter().map(disagreement).collect(),
        }
    }
}

second_module! {
    "05" fn read(file: &[u8], frames: usize) -> Result<WasmAnnotation, Failure> {
        Ok(WasmAnnotation(formats::read_plants(file, frames)?))
    }

    "06" fn edits(annotation: &WasmAnnotation) -> Result<Vec<Ts<EditInfo>>, Failure> {
        annotation.0.edits().into_iter().map(|edit| to_js(&EditInfo::from(edit))).collect()
    }

    "07" fn score(
        annotation: &WasmAnnotation,
        clip: &WasmClip,
        detection: &WasmDetection,
    ) -> Result<Vec<Ts<ScoreInfo>>, Failure> {
        let scores = score::compare(detection.core(), &annotation.0, clip.core().frame_time());
        scores.into_iter().map(|score| to_js(&ScoreInfo::from(score))).collect()
    }
}
