//! Segmentation of a clip.

use std::ops::Range;

use crate::bvh::Clip;
use crate::notice::{Code, Notice};
use crate::segments::methods::{Input, Output};
use crate::segments::{Curve, Motif, Progress, Segment, SegmentError, ValidParams, pose};
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

/// Segments a clip into actions.
///
/// Accepts any frame rate, unit, axes and skeleton with enough joints. `progress` receives the
/// completed fraction, from 0 to 1, and may cancel. A clip too short to cut is one segment.
///
/// # Errors
/// If the clip has no motion, too few joints are known, or `progress` cancels.
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
    let frames = first..clip.frame_count();
    let mut input = Input { clip, skeleton, settings: params.settings(), frames, progress };
    let Output { segments, transitions, motifs, curve, mut notices } = params.method().segment(&mut input)?;
    if first > 0 {
        let text = "The first frame is an added pose; it belongs to the first segment.";
        notices.push(Notice::new(Code::Trimmed, text));
    }
    Ok(Segmentation { params, segments, transitions, motifs, curve, notices })
}
