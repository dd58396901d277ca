//! Labels from elsewhere.

use crate::foot::{Part, Side};
use crate::plants::Edit;

/// Labels of one clip by someone else, per frame; `None` where they are not known.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Annotation {
    /// The parts that were labelled, with the left foot's labels and the right's.
    pub parts: Vec<(Part, [Vec<Option<bool>>; 2])>,
}

impl Annotation {
    /// The labels of one part: the left foot's, then the right's.
    pub fn part(&self, part: Part) -> Option<&[Vec<Option<bool>>; 2]> {
        self.parts.iter().find(|(other, _)| *other == part).map(|(_, feet)| feet)
    }

    /// The labels as edits that make them one's own, wherever they are known.
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
