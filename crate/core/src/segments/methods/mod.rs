//! The methods of segmentation: one file or folder each.

mod auto;
mod growing_window;
mod lsd;
mod mvu;
mod pca;
mod ppca;

use std::fmt;
use std::str::FromStr;

use crate::lookup::named;
use crate::segments::SegmentError;
use crate::segments::task::{Found, Task};

/// How a clip is cut.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Method {
    /// Gaussian segments whose number the data decide: the one to use.
    #[default]
    Auto,
    /// The curve of least-squares distances to a template pose (Zhang, Liu and Wei 2012).
    Lsd,
    /// Jumps of the residual of maximum variance unfolding (Zhang and Wang).
    Mvu,
    /// Jumps of the error of a linear subspace (Barbič et al. 2004, section 3.1).
    Pca,
    /// Jumps of the variance that two dimensions leave over.
    PcaTail,
    /// How unlikely what comes next is (Barbič et al. 2004, section 3.2).
    Ppca,
}

/// A parameter that matters to a method.
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

/// What a method's file says of it.
pub(crate) struct Entry {
    pub name: &'static str,
    pub title: &'static str,
    pub about: &'static str,
    pub options: &'static [MethodOption],
    pub segment: fn(&mut Task) -> Result<Found, SegmentError>,
}

impl Method {
    /// All methods, the default first.
    pub const ALL: [Method; 6] =
        [Method::Auto, Method::Lsd, Method::Mvu, Method::Pca, Method::PcaTail, Method::Ppca];

    fn entry(self) -> &'static Entry {
        match self {
            Method::Auto => &auto::METHOD,
            Method::Lsd => &lsd::METHOD,
            Method::Mvu => &mvu::METHOD,
            Method::Pca => &pca::BARBIC,
            Method::PcaTail => &pca::TAIL,
            Method::Ppca => &ppca::METHOD,
        }
    }

    /// The method's name on the command line and in documents, as in `auto`.
    pub fn name(self) -> &'static str {
        self.entry().name
    }

    /// The method's name for people, as in `Gaussian segments`.
    pub fn title(self) -> &'static str {
        self.entry().title
    }

    /// What the method does, in a sentence.
    pub fn about(self) -> &'static str {
        self.entry().about
    }

    /// The parameters that matter to the method.
    pub fn options(self) -> &'static [MethodOption] {
        self.entry().options
    }

    pub(crate) fn segment(self, task: &mut Task) -> Result<Found, SegmentError> {
        (self.entry().segment)(task)
    }
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Method {
    type Err = String;

    fn from_str(name: &str) -> Result<Method, String> {
        named("method", &Method::ALL, Method::name, name)
    }
}
