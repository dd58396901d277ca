//! Corrections of labels by a person.

use serde::{Deserialize, Serialize};

use crate::foot::{Part, Side};

/// A frame range in which a person states whether a part of a foot is planted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Edit {
    /// The foot.
    pub side: Side,
    /// The part of the foot.
    pub part: Part,
    /// First frame.
    pub start: usize,
    /// First frame after the range; a range beyond the end of the clip is cut there.
    pub end: usize,
    /// True if the part is planted.
    pub planted: bool,
}

impl Edit {
    /// Returns the label that the edit implies for a part of its foot; `None` if it implies none.
    pub(crate) fn implied(&self, part: Part) -> Option<bool> {
        let follows = match (self.part, part) {
            (Part::Contact, Part::Heel | Part::Toe) => !self.planted,
            (Part::Heel | Part::Toe, Part::Contact) => self.planted,
            (edited, part) => edited == part,
        };
        follows.then_some(self.planted)
    }
}
