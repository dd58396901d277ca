//! Annotations: labels assigned by a person or a measurement and taken as true.

use crate::foot::{Part, Side};
use crate::plants::Edit;

/// Annotated labels of one clip, per frame; `None` where the label is unknown.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Annotation {
    /// Annotated parts with the labels of the left foot and of the right foot.
    pub parts: Vec<(Part, [Vec<Option<bool>>; 2])>,
}

impl Annotation {
    /// Returns the labels of one part: the left foot's and the right foot's.
    pub fn part(&self, part: Part) -> Option<&[Vec<Option<bool>>; 2]> {
        self.parts.iter().find(|(other, _)| *other == part).map(|(_, feet)| feet)
    }

    /// Returns the edits that set every known label.
    pub fn edits(&self) -> Vec<Edit> {
        let mut edits = Vec::new();
        for (part, feet) in &self.parts {
            for (side, labels) in Side::BOTH.into_iter().zip(feet) {
                let mut start = 0;
                for run in labels.chunk_by(|a, b| a == b) {
                    let end = start + run.len();
                    edits.extend(run[0].map(|planted| Edit { side, part: *part, start, end, planted }));
                    start = end;
                }
            }
        }
        edits
    }
}
