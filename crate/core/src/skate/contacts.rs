//! What is planted when: labels from a detector, a document or a table, seen alike.

use crate::foot::{Part, Side};
use crate::formats::Document;
use crate::plants::{Annotation, Detection};

/// The frames in which each part of each foot is planted; `None` for a part without labels.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Contacts {
    /// The left foot's, then the right's.
    pub feet: [FootContacts; 2],
}

/// The planted frames of one foot, per frame of the clip.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FootContacts {
    /// Any part of the sole carries weight.
    pub contact: Option<Vec<bool>>,
    /// The heel is down.
    pub heel: Option<Vec<bool>>,
    /// The toe is down.
    pub toe: Option<Vec<bool>>,
}

impl Contacts {
    /// The contacts that `labels` gives for each side and part.
    pub fn of(labels: impl Fn(Side, Part) -> Option<Vec<bool>>) -> Contacts {
        let foot = |side| FootContacts {
            contact: labels(side, Part::Contact),
            heel: labels(side, Part::Heel),
            toe: labels(side, Part::Toe),
        };
        Contacts { feet: Side::BOTH.map(foot) }
    }

    /// The contacts of one foot.
    pub fn foot(&self, side: Side) -> &FootContacts {
        &self.feet[side as usize]
    }

    /// The length of labels that are not of `frames` frames, if there are any.
    pub(crate) fn other_length(&self, frames: usize) -> Option<usize> {
        let labels = self.feet.iter().flat_map(|foot| [&foot.contact, &foot.heel, &foot.toe]);
        labels.flatten().map(Vec::len).find(|&length| length != frames)
    }
}

impl From<&Detection> for Contacts {
    fn from(detection: &Detection) -> Contacts {
        Contacts::of(|side, part| Some(detection.part(part)?.foot(side).planted.clone()))
    }
}

impl From<&Document> for Contacts {
    fn from(document: &Document) -> Contacts {
        Contacts::of(|side, part| document.labels(side, part))
    }
}

/// Frames whose label is not known are taken for not planted.
impl From<&Annotation> for Contacts {
    fn from(labelling: &Annotation) -> Contacts {
        Contacts::of(|side, part| {
            let labels = &labelling.part(part)?[side as usize];
            Some(labels.iter().map(|label| *label == Some(true)).collect())
        })
    }
}
