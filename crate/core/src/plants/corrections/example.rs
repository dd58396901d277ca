//! Labels that a person corrected or confirmed.

use crate::foot::{Part, Side};
use crate::plants::{Edit, FootLabels};

/// Minimum affinity of motion to which a correction applies.
pub(super) const MIN_AFFINITY: f64 = 0.5;

/// Labels of one part of one foot before and after a person corrected them.
pub(super) struct Example<'a> {
    pub part: Part,
    pub side: Side,
    pub before: &'a FootLabels,
    pub after: &'a FootLabels,
    /// Frames whose label a person stated.
    pub stated: Vec<bool>,
}

impl<'a> Example<'a> {
    pub fn new(
        part: Part,
        side: Side,
        before: &'a FootLabels,
        after: &'a FootLabels,
        edits: &[Edit],
    ) -> Example<'a> {
        let of_part = edits.iter().filter(|edit| edit.part == part).copied().collect::<Vec<_>>();
        let stated = edited_frames(&of_part, part, side, before.planted.len());
        let stated = stated.iter().map(Option::is_some).collect();
        Example { part, side, before, after, stated }
    }

    /// True if no frame was stated.
    pub fn is_empty(&self) -> bool {
        !self.stated.contains(&true)
    }
}

/// Returns the label that edits imply, per frame.
pub(super) fn edited_frames(edits: &[Edit], part: Part, side: Side, frames: usize) -> Vec<Option<bool>> {
    let mut edited = vec![None; frames];
    for edit in edits.iter().filter(|edit| edit.side == side) {
        let Some(planted) = edit.implied(part) else { continue };
        let end = edit.end.min(frames);
        edited[edit.start.min(end)..end].fill(Some(planted));
    }
    edited
}
