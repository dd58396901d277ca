//! Result of a detection.

use std::ops::Range;

use crate::foot::{Part, Side};
use crate::notice::Notice;
use crate::plants::edit::Edit;
use crate::plants::ground::Ground;
use crate::plants::labels::{Edge, PartLabels};
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

    /// Returns the first frame of a plant from which heel and toe are both planted, with the instant of foot
    /// flat, if that is known more exactly; `None` if they never are.
    pub fn foot_flat(&self, side: Side, plant: &Range<usize>) -> Option<(usize, Option<&Edge>)> {
        let [heel, toe] = [self.part(Part::Heel)?, self.part(Part::Toe)?].map(|part| part.foot(side));
        let frame = plant.clone().find(|&frame| heel.planted[frame] && toe.planted[frame])?;
        let landings = [heel, toe].into_iter().filter_map(|labels| labels.edge(frame));
        Some((frame, landings.max_by(|a, b| a.time.total_cmp(&b.time))))
    }

    /// Returns the labels that define the plants: contact, or the toe if there is no contact.
    pub fn principal(&self) -> &PartLabels {
        &self.parts[0]
    }
}
