//! Errors of a segmentation.

use crate::segments::progress::Cancelled;

/// Error: a clip cannot be segmented.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SegmentError {
    /// The clip is a rest pose.
    #[error("the clip has no motion to segment")]
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
