//! What a method is told and what it answers.

use std::ops::Range;

use crate::bvh::Clip;
use crate::notice::Notice;
use crate::segments::{Curve, Kind, Motif, Segment, ValidParams};
use crate::skeleton::Skeleton;

/// Somebody wanted no more of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cancelled;

/// Is told the share that is done, from 0 to 1, and may cancel the rest.
pub type Progress<'a> = dyn FnMut(f64) -> Result<(), Cancelled> + 'a;

/// Is told that work on the same goes on, and may cancel it.
pub(crate) type Pause<'a> = dyn FnMut() -> Result<(), Cancelled> + 'a;

/// What a method is told.
pub(crate) struct Task<'a> {
    pub clip: &'a Clip,
    pub skeleton: &'a Skeleton,
    pub params: ValidParams,
    /// The frames that are motion: without a pose stuck on before them.
    pub frames: Range<usize>,
    pub progress: &'a mut Progress<'a>,
}

/// What a method finds.
pub(crate) struct Found {
    pub segments: Vec<Segment>,
    pub transitions: Vec<Range<usize>>,
    pub motifs: Vec<Motif>,
    pub curve: Curve,
    pub notices: Vec<Notice>,
}

impl Found {
    /// Actions without kinds or names, from the frames that they are cut at.
    pub fn of_cuts(frames: usize, cuts: &[usize], curve: Curve, notices: Vec<Notice>) -> Found {
        let segments = tiles(frames, cuts)
            .map(|frames| Segment { frames, kind: Kind::Action, label: String::new() })
            .collect();
        Found { segments, transitions: Vec::new(), motifs: Vec::new(), curve, notices }
    }
}

/// The ranges between ascending cuts, from frame 0 on; cuts at the ends of the clip are none.
pub(crate) fn tiles(frames: usize, cuts: &[usize]) -> impl Iterator<Item = Range<usize>> {
    let inner = cuts.iter().copied().filter(move |&cut| cut > 0 && cut < frames);
    let starts: Vec<usize> = std::iter::once(0).chain(inner).collect();
    let ends: Vec<usize> = starts[1..].iter().copied().chain([frames]).collect();
    starts.into_iter().zip(ends).map(|(start, end)| start..end)
}
