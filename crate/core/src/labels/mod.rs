//! Labels: which frames each foot is planted in, and which action is where, as frames, intervals
//! and documents.

mod babel;
mod blender;
mod csv;
mod document;
mod edits;
mod npz;
mod read;
mod read_segments;
mod segments;
mod tables;

pub use babel::babel_json;
pub use blender::blender_script;
pub use document::{
    Document, FORMAT, Foot, FootJoints, Joints, MethodUsed, Source, Span, SpanSource, VERSION,
};
pub use edits::{Edit, edited};
pub use npz::npz;
pub use read::{Labelling, LabelsError, read, read_bytes};
pub use read_segments::{has_segments, read_cuts, read_segments};
pub use segments::{MotifSpan, SEGMENTS_FORMAT, SegmentSpan, SegmentsDocument, SegmentsMethod, Stretch};
pub use tables::{Labelled, events_csv, frames_csv, intervals_csv, segments_csv};

use serde::{Deserialize, Serialize};

/// Left or right, as the person who moves would say it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Side {
    /// The left foot.
    Left,
    /// The right foot.
    Right,
}

impl Side {
    /// Both sides, left first.
    pub const BOTH: [Side; 2] = [Side::Left, Side::Right];

    /// The side's name: `left` or `right`.
    pub fn name(self) -> &'static str {
        match self {
            Side::Left => "left",
            Side::Right => "right",
        }
    }
}

/// What of the foot a label speaks of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Part {
    /// Any part of the sole carries weight.
    Contact,
    /// The toe is down and still: the paper's foot plant.
    Toe,
    /// The heel is down and still.
    Heel,
}

impl Part {
    /// All parts, contact first.
    pub const ALL: [Part; 3] = [Part::Contact, Part::Toe, Part::Heel];

    /// The part's name: `contact`, `toe` or `heel`.
    pub fn name(self) -> &'static str {
        match self {
            Part::Contact => "contact",
            Part::Toe => "toe",
            Part::Heel => "heel",
        }
    }
}

/// The runs of `true` in `labels` as half-open ranges of frames.
pub fn intervals(labels: &[bool]) -> Vec<std::ops::Range<usize>> {
    let mut found = Vec::new();
    let mut frame = 0;
    for run in labels.chunk_by(|a, b| a == b) {
        if run[0] {
            found.push(frame..frame + run.len());
        }
        frame += run.len();
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn intervals_are_the_runs_of_planted_frames() {
        assert!(intervals(&[]).is_empty());
        assert!(intervals(&[false, false]).is_empty());
        assert_eq!(intervals(&[true, true]), vec![0..2]);
        assert_eq!(intervals(&[true, false, true, true, false]), vec![0..1, 2..4]);
    }
}
