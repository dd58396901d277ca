//! Segmentation of a clip.

use std::ops::Range;

use crate::bvh::Clip;
use crate::notice::{Code, Notice};
use crate::segments::methods::{Input, Output};
use crate::segments::movement::Movement;
use crate::segments::{
    ActionMovements, Curve, Motif, Progress, Segment, SegmentError, ValidParams, actions, pose, refine,
};
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
    /// Movements of the actions, in order of first appearance; empty if the actions are unknown.
    pub actions: Vec<ActionMovements>,
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
/// completed fraction, from 0 to 1, and may cancel. A clip too short to cut is one segment. The actions
/// are unknown if neither thighs nor arms or fewer than four other joints are known on both sides.
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
    let mut input = Input { clip, skeleton, settings: params.settings(), frames: frames.clone(), progress };
    let Output { mut segments, transitions, motifs, curve, mut notices } =
        params.method().segment(&mut input)?;
    let mut actions = Vec::new();
    if let Some(movement) = Movement::new(clip, skeleton, &frames) {
        if params.method().refines_cuts() {
            refine::refine_cuts(&movement, &mut segments);
        }
        actions = actions::name_actions(&movement, &mut segments, &mut || progress(1.0))?;
    } else {
        let text = "The actions are unknown: too few joints were found on both sides of the body.";
        notices.push(Notice::new(Code::MissingJoints, text));
    }
    if first > 0 {
        let text = "The first frame is an added pose; it belongs to the first segment.";
        notices.push(Notice::new(Code::Trimmed, text));
    }
    Ok(Segmentation { params, segments, transitions, motifs, curve, actions, notices })
}
