//! Labels per frame.

use crate::foot::{Part, Side};
use crate::plants::spectral::threshold::Evidence;

/// Labels of one part of both feet.
#[derive(Clone, Debug, PartialEq)]
pub struct PartLabels {
    /// The part.
    pub part: Part,
    /// Labels of the left foot and of the right foot.
    pub feet: [FootLabels; 2],
    /// Evidence of the clustering; `None` if the part was not clustered.
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

impl PartLabels {
    /// Returns the labels of one foot.
    pub fn foot(&self, side: Side) -> &FootLabels {
        &self.feet[side as usize]
    }
}
