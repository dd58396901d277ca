//! Segmentation methods: one file or folder per method, and their registry.

mod auto;
mod growing_window;
mod lsd;
mod mvu;
mod pca;
mod ppca;

use std::ops::Range;

use crate::bvh::Clip;
use crate::notice::Notice;
use crate::registry::registry;
use crate::segments::progress::Progress;
use crate::segments::{Curve, Kind, Motif, Segment, SegmentError, ValidParams};
use crate::skeleton::Skeleton;

registry! {
    /// Method of segmentation.
    pub enum Method: MethodInfo as "method" {
        /// Gaussian segments whose number is determined by the data; the default.
        #[default]
        Auto => auto::METHOD,
        /// Least-squares distances to a template pose (Zhang, Liu and Wei 2012).
        Lsd => lsd::METHOD,
        /// Jumps of the residual of maximum variance unfolding (Zhang and Wang).
        Mvu => mvu::METHOD,
        /// Jumps of the error of a linear subspace (Barbič et al. 2004, section 3.1).
        Pca => pca::PCA,
        /// Jumps of the variance beyond two dimensions.
        PcaTail => pca::PCA_TAIL,
        /// Peaks of the Mahalanobis distance of the next poses (Barbič et al. 2004, section 3.2).
        Ppca => ppca::METHOD,
    }
}

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
    pub segment: fn(&mut Input) -> Result<Output, SegmentError>,
}

/// Input of a method.
pub(crate) struct Input<'a> {
    pub clip: &'a Clip,
    pub skeleton: &'a Skeleton,
    pub params: ValidParams,
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
        let segments = partition(frames, cuts)
            .map(|frames| Segment { frames, kind: Kind::Action, label: String::new() })
            .collect();
        Output { segments, transitions: Vec::new(), motifs: Vec::new(), curve, notices }
    }
}

impl Method {
    /// Returns the parameters that the method uses.
    pub fn options(self) -> &'static [MethodOption] {
        self.entry().options
    }

    pub(crate) fn segment(self, input: &mut Input) -> Result<Output, SegmentError> {
        (self.entry().segment)(input)
    }
}

/// Returns the frame ranges between ascending cuts, from frame 0; cuts at the ends of the clip are ignored.
pub(crate) fn partition(frames: usize, cuts: &[usize]) -> impl Iterator<Item = Range<usize>> {
    let inner = cuts.iter().copied().filter(move |&cut| cut > 0 && cut < frames);
    let starts: Vec<usize> = std::iter::once(0).chain(inner).collect();
    let ends: Vec<usize> = starts[1..].iter().copied().chain([frames]).collect();
    starts.into_iter().zip(ends).map(|(start, end)| start..end)
}
