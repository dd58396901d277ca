//! Interface of segmentation methods.

use std::ops::Range;

use crate::bvh::Clip;
use crate::notice::Notice;
use crate::segments::progress::Progress;
use crate::segments::{Curve, Kind, Motif, Residual, Segment, SegmentError, Template};
use crate::skeleton::Skeleton;

/// Parameter that a method uses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MethodOption {
    /// [`Params::dims`](crate::segments::Params::dims), with its default.
    Dims(usize),
    /// [`Params::residual`](crate::segments::Params::residual)
    Residual,
    /// [`Params::template`](crate::segments::Params::template)
    Template,
    /// [`Params::published`](crate::segments::Params::published)
    Published,
}

/// Registry entry of a method.
pub(crate) struct MethodInfo {
    pub name: &'static str,
    pub title: &'static str,
    pub description: &'static str,
    /// Parameters that the method uses.
    pub options: &'static [MethodOption],
    /// True if cuts are refined within their transitions; methods of publications are not changed.
    pub refines_cuts: bool,
    pub segment: fn(&mut Input) -> Result<Output, SegmentError>,
}

/// Parameters as a method receives them; see [`Params`](crate::segments::Params).
#[derive(Clone, Copy)]
pub(crate) struct Settings {
    /// The given number of dimensions or the default of the method; 0 if it does not use it.
    pub dims: usize,
    pub residual: Residual,
    pub template: Template,
    pub published: bool,
}

/// Input of a method.
pub(crate) struct Input<'a> {
    pub clip: &'a Clip,
    pub skeleton: &'a Skeleton,
    pub settings: Settings,
    /// Frames of motion, without an added first pose.
    pub frames: Range<usize>,
    pub progress: &'a mut Progress<'a>,
}

/// Output of a method.
pub(crate) struct Output {
    pub segments: Vec<Segment>,
    pub transitions: Vec<Range<usize>>,
    pub motifs: Vec<Motif>,
    pub curve: Curve,
    pub notices: Vec<Notice>,
}

impl Output {
    /// Creates segments without kinds or labels from cuts.
    pub fn from_cuts(frames: usize, cuts: &[usize], curve: Curve, notices: Vec<Notice>) -> Output {
        let segments = partition(frames, cuts).map(|frames| Segment::new(frames, Kind::Action, "")).collect();
        Output { segments, transitions: Vec::new(), motifs: Vec::new(), curve, notices }
    }
}

/// Returns the frame ranges between ascending cuts, from frame 0; cuts at the ends of the clip are ignored.
pub(crate) fn partition(frames: usize, cuts: &[usize]) -> impl Iterator<Item = Range<usize>> {
    let inner = cuts.iter().copied().filter(move |&cut| cut > 0 && cut < frames);
    let starts: Vec<usize> = std::iter::once(0).chain(inner).collect();
    let ends: Vec<usize> = starts[1..].iter().copied().chain([frames]).collect();
    starts.into_iter().zip(ends).map(|(start, end)| start..end)
}
