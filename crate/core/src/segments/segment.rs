//! Segments, motifs and curves: the parts of a segmentation.

use std::ops::Range;

use serde::{Deserialize, Serialize};

/// One segment: an interval with one action.
#[derive(Clone, Debug, PartialEq)]
pub struct Segment {
    /// Frame range.
    pub frames: Range<usize>,
    /// Kind of action.
    pub kind: Kind,
    /// Label, as the motifs that the action repeats; empty if the method has none.
    pub label: String,
    /// Name of the action: segments in which the same is done share it. Letters in order of first
    /// appearance, from A; empty if unknown.
    pub action: String,
    /// Cycles of the action, if it repeats.
    pub cycles: Option<Cycles>,
}

impl Segment {
    /// Creates a segment whose action is unknown.
    pub fn new(frames: Range<usize>, kind: Kind, label: impl Into<String>) -> Segment {
        Segment { frames, kind, label: label.into(), action: String::new(), cycles: None }
    }
}

/// Cycles of an action: its repeats, as steps or punches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cycles {
    /// Period, in seconds.
    pub period_s: f64,
    /// Number of cycles, at least 2; a fraction if the last one is incomplete.
    pub count: f64,
}

/// Kind of action of a segment.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// The method does not distinguish kinds.
    Action,
    /// The action repeats its motifs.
    Periodic,
    /// The action does not repeat.
    Aperiodic,
}

impl Kind {
    /// All kinds.
    pub const ALL: [Kind; 3] = [Kind::Action, Kind::Periodic, Kind::Aperiodic];

    /// Returns the name: `action`, `periodic` or `aperiodic`.
    pub fn name(self) -> &'static str {
        match self {
            Kind::Action => "action",
            Kind::Periodic => "periodic",
            Kind::Aperiodic => "aperiodic",
        }
    }
}

/// Motion between two turning points.
#[derive(Clone, Debug, PartialEq)]
pub struct Motif {
    /// Frame range.
    pub frames: Range<usize>,
    /// Class of similar motifs, from 1 in order of first appearance.
    pub class: usize,
    /// Change of the curve over the motif, in the unit of the curve; negative for falling motifs.
    pub amplitude: f64,
}

/// Curve of a method, for plots.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Curve {
    /// Quantity, as in `Residual`.
    pub title: &'static str,
    /// Position of each value, in fractional frames, ascending.
    pub frames: Vec<f64>,
    /// Values, all finite.
    pub values: Vec<f64>,
    /// Threshold of each value; empty if the method has none.
    pub threshold: Vec<f64>,
    /// Indices of the turning points, if the method uses them.
    pub extrema: Vec<usize>,
}
