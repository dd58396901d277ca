//! Segmentation of a clip into actions.
//!
//! Six methods share one interface, [`Method`], and one result, [`Segmentation`]. [`Method::Auto`]
//! is the default; the others are published methods for comparison. None needs the number of
//! actions.
//!
//! Data flow: clip → poses (joint rotations or joint positions) → a curve → cuts → [`Segment`]s.
//! All constants are in seconds, so results do not depend on the frame rate.

mod body;
mod grid;
mod methods;
mod params;
mod pose;
mod progress;

pub use methods::{Method, MethodOption};
pub use params::{OptionError, ParamError, Params, Residual, Template, ValidParams};
pub use progress::{Cancelled, Progress};

use std::ops::Range;

use methods::{Input, Output};
use serde::{Deserialize, Serialize};

use crate::bvh::Clip;
use crate::notice::{Code, Notice};
use crate::skeleton::Skeleton;

/// Segments of a clip, with the curve that determined them.
#[derive(Clone, Debug, PartialEq)]
pub struct Segmentation {
    /// Parameters of the segmentation.
    pub params: ValidParams,
    /// Segments in order; they cover the clip without gaps.
    pub segments: Vec<Segment>,
    /// Frame ranges in which one action changes into the next, if the method detects them; the cut
    /// lies within.
    pub transitions: Vec<Range<usize>>,
    /// Motifs: motion between turning points, if the method detects them.
    pub motifs: Vec<Motif>,
    /// Curve that determined the cuts.
    pub curve: Curve,
    /// Assumptions and omissions.
    pub notices: Vec<Notice>,
}

impl Segmentation {
    /// Returns the cuts: the first frame of each segment except the first.
    pub fn cuts(&self) -> Vec<usize> {
        self.segments.iter().skip(1).map(|segment| segment.frames.start).collect()
    }
}

/// One segment: an interval with one action.
#[derive(Clone, Debug, PartialEq)]
pub struct Segment {
    /// Frame range.
    pub frames: Range<usize>,
    /// Kind of action.
    pub kind: Kind,
    /// Label, as the motifs that the action repeats; empty if the method has none.
    pub label: String,
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

/// Error: a clip cannot be segmented.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SegmentError {
    /// The clip is a rest pose.
    #[error("the clip has no motion, so there is nothing to segment")]
    NoMotion,
    /// Too few of the joints that the method measures are known.
    #[error(
        "only {found} of the {wanted} joints that this method measures were found; name more joints ({missing})"
    )]
    TooFewJoints {
        /// Number of known joints.
        found: usize,
        /// Number of joints that the method measures.
        wanted: usize,
        /// Roles without a joint, separated by commas.
        missing: String,
    },
    /// The template frame does not exist.
    #[error("frame {frame} cannot be the template; the clip has {frames} frames, counted from 0")]
    NoFrame {
        /// The requested frame.
        frame: usize,
        /// Number of frames.
        frames: usize,
    },
    /// The segmentation was cancelled.
    #[error("cancelled")]
    Cancelled,
}

impl From<Cancelled> for SegmentError {
    fn from(_: Cancelled) -> SegmentError {
        SegmentError::Cancelled
    }
}

/// Segments a clip into actions.
///
/// Accepts any frame rate, unit, axes and skeleton with enough joints. `progress` receives the
/// completed fraction, from 0 to 1, and may cancel. A clip too short to cut is one segment.
///
/// # Errors
/// If there is no motion, too few joints are known, or it was cancelled.
pub fn segment(
    clip: &Clip,
    skeleton: &Skeleton,
    params: ValidParams,
    progress: &mut Progress,
) -> Result<Segmentation, SegmentError> {
    if clip.frame_count() == 0 {
        return Err(SegmentError::NoMotion);
    }
    let first = pose::first_motion_frame(clip, skeleton);
    let mut input = Input { clip, skeleton, params, frames: first..clip.frame_count(), progress };
    let Output { segments, transitions, motifs, curve, mut notices } = params.method().segment(&mut input)?;
    if first > 0 {
        let text = "The first frame is an added pose; it belongs to the first segment.";
        notices.push(Notice::new(Code::Trimmed, text));
    }
    Ok(Segmentation { params, segments, transitions, motifs, curve, notices })
}

#[cfg(test)]
mod tests;
