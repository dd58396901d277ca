//! Cutting a clip into actions.
//!
//! Six methods behind one [`Method`], with one [`Segmentation`] as their result:
//! [`Method::Auto`] is the one to use; the others are the published ones that it
//! stands beside. None has to be told how many actions there are.
//!
//! The way of the data: clip → poses (joint rotations, or joint
//! positions) → a curve of the method's own → cuts → [`Segment`]s. All times
//! are in seconds inside, so that the frame rate does not matter.

mod grid;
mod methods;
mod params;
mod pose;
mod task;

mod body;

pub use crate::segments::methods::{Method, MethodOption};
pub use params::ParamError;
pub use params::Params;
pub use params::Residual;
pub use params::Template;
pub use params::ValidParams;
pub use task::Cancelled;
pub use task::Progress;

use std::ops::Range;

use serde::Deserialize;
use serde::Serialize;
use task::Found;
use task::Task;

use crate::bvh::Clip;
use crate::notice::{Code, Notice};
use crate::skeleton::Skeleton;

/// The segments of a clip with how they came about.
#[derive(Clone, Debug, PartialEq)]
pub struct Segmentation {
    /// The parameters that were used.
    pub params: ValidParams,
    /// The segments in order: they tile the clip, from frame 0 to the last.
    pub segments: Vec<Segment>,
    /// Frames in which one action goes over into the next, where the method tells them apart:
    /// the cut lies within.
    pub transitions: Vec<Range<usize>>,
    /// The pieces of motion between turning points, where the method knows such.
    pub motifs: Vec<Motif>,
    /// What the method looks at.
    pub curve: Curve,
    /// What was assumed or left out.
    pub notices: Vec<Notice>,
}

impl Segmentation {
    /// The cuts: the first frame of each segment but the first.
    pub fn cuts(&self) -> Vec<usize> {
        self.segments.iter().skip(1).map(|segment| segment.frames.start).collect()
    }
}

/// One action.
#[derive(Clone, Debug, PartialEq)]
pub struct Segment {
    /// Its frames.
    pub frames: Range<usize>,
    /// What kind of action it is.
    pub kind: Kind,
    /// The method's name for it, as the motifs that it repeats; empty where there is none.
    pub label: String,
}

/// What kind of action a segment is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// An action; the method tells no kinds.
    Action,
    /// An action that repeats its motifs.
    Periodic,
    /// An action that does not.
    Aperiodic,
}

impl Kind {
    /// All kinds.
    pub const ALL: [Kind; 3] = [Kind::Action, Kind::Periodic, Kind::Aperiodic];

    /// The kind's name: `action`, `periodic` or `aperiodic`.
    pub fn name(self) -> &'static str {
        match self {
            Kind::Action => "action",
            Kind::Periodic => "periodic",
            Kind::Aperiodic => "aperiodic",
        }
    }
}

/// The motion from one turning point to the next.
#[derive(Clone, Debug, PartialEq)]
pub struct Motif {
    /// Its frames.
    pub frames: Range<usize>,
    /// Motifs that are alike have the same number; numbers count from 1 as they first appear.
    pub class: usize,
    /// How far the curve goes in it, in the curve's unit; falling motifs have a negative one.
    pub amplitude: f64,
}

/// What a method looks at, for plotting.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Curve {
    /// What it shows, as in `Residual`.
    pub title: &'static str,
    /// Where each value lies: frames of the clip, with fractions, ascending.
    pub frames: Vec<f64>,
    /// The values; they are all finite.
    pub values: Vec<f64>,
    /// What each value was compared with; empty where there is no such threshold.
    pub threshold: Vec<f64>,
    /// Indices of the values at which the curve turns, where that matters.
    pub extrema: Vec<usize>,
}

/// Why a clip could not be cut.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SegmentError {
    /// The clip is a rest pose.
    #[error("the clip has no motion: there is nothing to cut")]
    NoMotion,
    /// Too few of the joints that the method measures are known.
    #[error(
        "only {found} of the {wanted} joints that this method measures were found: name more joints ({missing})"
    )]
    TooFewJoints {
        /// How many are there.
        found: usize,
        /// How many there might be.
        wanted: usize,
        /// The roles that nobody plays, separated by commas.
        missing: String,
    },
    /// The template is to be a frame that is not there.
    #[error("there is no frame {frame} to be the template: the clip has {frames}, counted from 0")]
    NoFrame {
        /// The frame asked for.
        frame: usize,
        /// How many there are.
        frames: usize,
    },
    /// It was cancelled.
    #[error("cancelled")]
    Cancelled,
}

impl From<Cancelled> for SegmentError {
    fn from(_: Cancelled) -> SegmentError {
        SegmentError::Cancelled
    }
}

/// Cuts a clip into actions.
///
/// Any frame rate, unit, axes and skeleton that has enough of a body. `progress` is told the
/// share that is done, from 0 to 1, and may cancel. A clip too short to cut is one segment.
///
/// # Errors
/// If there is no motion, the method's joints are not known, or it was cancelled.
pub fn segment(
    clip: &Clip,
    skeleton: &Skeleton,
    params: ValidParams,
    progress: &mut Progress,
) -> Result<Segmentation, SegmentError> {
    if clip.frame_count() == 0 {
        return Err(SegmentError::NoMotion);
    }
    let first = pose::lead_in(clip, skeleton);
    let mut task = Task { clip, skeleton, params, frames: first..clip.frame_count(), progress };
    let Found { segments, transitions, motifs, curve, mut notices } = params.method().segment(&mut task)?;
    if first > 0 {
        let text = "The first frame is a pose that was stuck on: it belongs to the first segment.";
        notices.push(Notice::new(Code::Trimmed, text));
    }
    Ok(Segmentation { params, segments, transitions, motifs, curve, notices })
}

#[cfg(test)]
mod tests;
