//! Result of a detection.

use crate::foot::{Part, Side};
use crate::notice::Notice;
use crate::plants::{Edit, Evidence, ValidParams};

/// Labels of a clip, with their evidence.
#[derive(Clone, Debug, PartialEq)]
pub struct Detection {
    /// Parameters of the detection.
    pub params: ValidParams,
    /// Labels of contact, toe and heel; some methods label the toe only.
    pub parts: Vec<PartLabels>,
    /// Height of the ground along the up axis, in file units.
    pub ground_height: f64,
    /// Assumptions and doubts.
    pub notices: Vec<Notice>,
    /// Edits that were applied; empty in the result of a method.
    pub edits: Vec<Edit>,
}

/// Labels of one part of both feet.
#[derive(Clone, Debug, PartialEq)]
pub struct PartLabels {
    /// The part.
    pub part: Part,
    /// Labels of the left foot and of the right foot.
    pub feet: [FootLabels; 2],
    /// Evidence of the clustering; `None` if nothing was clustered.
    pub evidence: Option<Evidence>,
}

/// Labels of one part of one foot, per frame of the clip.
#[derive(Clone, Debug, PartialEq)]
pub struct FootLabels {
    /// True while the part is planted.
    pub planted: Vec<bool>,
    /// Probability that the label is right, from 0.5 to 1.
    pub confidence: Vec<f32>,
    /// Height above the lowest point of the clip, in file units.
    pub height: Vec<f32>,
    /// Speed, in file units per second.
    pub speed: Vec<f32>,
}

impl Detection {
    /// Returns the labels of one part, if the method labels it.
    pub fn part(&self, part: Part) -> Option<&PartLabels> {
        self.parts.iter().find(|labels| labels.part == part)
    }

    /// Returns the labels that define the plants: contact, or the toe if there is no contact.
    pub fn principal(&self) -> &PartLabels {
        &self.parts[0]
    }
}

impl PartLabels {
    /// Returns the labels of one foot.
    pub fn foot(&self, side: Side) -> &FootLabels {
        &self.feet[side as usize]
    }
}
