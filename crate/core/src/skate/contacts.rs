//! Contacts per frame, from any source of labels.

use crate::foot::{Part, Side};
use crate::plants::{Annotation, Detection};

/// Frames in which each part of each foot is planted; `None` for a part without labels.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Contacts {
    /// Contacts of the left foot and of the right foot.
    pub feet: [FootContacts; 2],
}

/// Contacts of one foot, per frame of the clip.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FootContacts {
    /// Any part of the foot bears on the ground.
    pub contact: Option<Vec<bool>>,
    /// The heel is planted.
    pub heel: Option<Vec<bool>>,
    /// The toe is planted.
    pub toe: Option<Vec<bool>>,
}

impl Contacts {
    /// Creates contacts from a function that returns the labels of each side and part.
    pub fn new(labels: impl Fn(Side, Part) -> Option<Vec<bool>>) -> Contacts {
        let foot = |side| FootContacts {
            contact: labels(side, Part::Contact),
            heel: labels(side, Part::Heel),
            toe: labels(side, Part::Toe),
        };
        Contacts { feet: Side::BOTH.map(foot) }
    }

    /// Returns the contacts of one foot.
    pub fn foot(&self, side: Side) -> &FootContacts {
        &self.feet[side as usize]
    }

    /// Returns the length of labels whose length is not `frames`, if any.
    pub(crate) fn mismatched_length(&self, frames: usize) -> Option<usize> {
        let labels = self.feet.iter().flat_map(|foot| [&foot.contact, &foot.heel, &foot.toe]);
        labels.flatten().map(Vec::len).find(|&length| length != frames)
    }
}

impl From<&Detection> for Contacts {
    fn from(detection: &Detection) -> Contacts {
        Contacts::new(|side, part| Some(detection.part(part)?.foot(side).planted.clone()))
    }
}

/// Frames with an unknown label count as not planted.
impl From<&Annotation> for Contacts {
    fn from(annotation: &Annotation) -> Contacts {
        Contacts::new(|side, part| {
            let labels = &annotation.part(part)?[side as usize];
            Some(labels.iter().map(|label| *label == Some(true)).collect())
        })
    }
}
