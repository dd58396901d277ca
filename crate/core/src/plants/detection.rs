//! Result of a detection.

use crate::foot::Part;
use crate::notice::Notice;
use crate::plants::edit::Edit;
use crate::plants::ground::Ground;
use crate::plants::labels::PartLabels;
use crate::plants::params::ValidParams;
use crate::plants::postprocess::capture_noise::CaptureNoise;

/// Labels of a clip, with their evidence.
#[derive(Clone, Debug, PartialEq)]
pub struct Detection {
    /// Parameters of the detection.
    pub params: ValidParams,
    /// Labels of contact, toe and heel; some methods label the toe only.
    pub parts: Vec<PartLabels>,
    /// Height of the ground along the up axis, in file units.
    pub ground_height: f64,
    /// Ground on which the feet stand: plane, levels and belt.
    pub ground: Ground,
    /// Noise of planted feet; `None` if no foot is planted.
    pub noise: Option<CaptureNoise>,
    /// Assumptions and warnings.
    pub notices: Vec<Notice>,
    /// Edits that were applied; empty in the result of a method.
    pub edits: Vec<Edit>,
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
