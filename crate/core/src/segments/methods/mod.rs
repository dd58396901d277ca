//! Segmentation methods: one file or folder per method, and their registry.

mod auto;
mod growing_window;
mod lsd;
mod method_info;
mod mvu;
mod pca;
mod ppca;

pub use method_info::MethodOption;
pub(crate) use method_info::{Input, Output, Settings};

use crate::registry::registry;
use crate::segments::SegmentError;
use method_info::MethodInfo;

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
    with {
        /// Returns the parameters that the method uses.
        options: &'static [MethodOption],
    }
}

impl Method {
    /// True if cuts are refined within their transitions.
    pub(crate) fn refines_cuts(self) -> bool {
        self.entry().refines_cuts
    }

    pub(crate) fn segment(self, input: &mut Input) -> Result<Output, SegmentError> {
        (self.entry().segment)(input)
    }
}
