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
    /// Height above the ground, in file units: the ground under the foot for `robust`, the lowest height of both
    /// feet for other methods.
    pub height: Vec<f32>,
    /// Speed, in file units per second.
    pub speed: Vec<f32>,
    /// Instants at which plants begin and end according to the mechanics of the foot, in order of
    /// frames; see [`FootLabels::edge`].
    pub edges: Vec<Edge>,
}

/// Instant at which a plant begins or ends.
///
/// Contact changes with the first frame after the instant. The labels of heel and toe come from the
/// clustering, for which a part that rolls slowly is planted: they change up to 0.3 s before or after the
/// instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edge {
    /// Frame at which the label changes.
    pub frame: usize,
    /// Time from the first frame of the clip, in seconds.
    pub time: f64,
    /// Standard deviation of the error of `time`, in seconds.
    pub uncertainty: f64,
}

/// Instant of a boundary of one part of one foot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Instant {
    /// The foot.
    pub side: Side,
    /// The part of the foot.
    pub part: Part,
    /// The instant.
    pub edge: Edge,
}

impl FootLabels {
    /// True if the label changes at `frame`.
    pub(crate) fn is_boundary(&self, frame: usize) -> bool {
        frame.checked_sub(1).is_some_and(|before| self.planted.get(before) != self.planted.get(frame))
            && frame < self.planted.len()
    }

    /// Returns the edge that is known at the boundary before `frame`.
    ///
    /// Boundaries of an edit have none, nor have those of methods that label frames only.
    pub fn edge(&self, frame: usize) -> Option<&Edge> {
        let index = self.edges.binary_search_by_key(&frame, |edge| edge.frame).ok()?;
        Some(&self.edges[index])
    }

    /// Returns the time of the boundary before `frame`, in seconds from the first frame of the clip:
    /// that of its edge, or midway between the frames.
    pub fn boundary_time(&self, frame: usize, frame_time: f64) -> f64 {
        self.edge(frame).map_or((frame as f64 - 0.5) * frame_time, |edge| edge.time)
    }
}

impl PartLabels {
    /// Returns the labels of one foot.
    pub fn foot(&self, side: Side) -> &FootLabels {
        &self.feet[side as usize]
    }
}
