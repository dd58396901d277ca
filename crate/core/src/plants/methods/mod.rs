//! The methods of detection: one file each.
//!
//! [`Method::Robust`] is the one to use. The others stand beside it: the
//! published method, its relatives in spectral clustering, and what is commonly
//! done instead.

mod displacement;
mod fixed_scale;
mod gmm;
mod height_speed;
mod hmm;
mod local_scale;
mod median_speed;
mod min_speed;
mod ncut;
mod njw;
mod paper;
mod robust;
mod sparse;
mod thresholds;
mod toes;

use std::cell::Cell;
use std::fmt;
use std::str::FromStr;

pub(crate) use height_speed::LIMITS as HEIGHT_SPEED;
pub(crate) use median_speed::LIMITS as MEDIAN_SPEED;
pub(crate) use robust::Kept;

use crate::foot::Part;
use crate::lookup::named;
use crate::notice::Notice;
use crate::plants::{Feet, PartLabels, ValidParams};

/// How plants are found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Method {
    /// Contact, toe and heel by anchored degrees: the one to use.
    #[default]
    Robust,
    /// The published method, word for word.
    Paper,
    /// The published method with the same scale for every clip (paper, section 3.4).
    FixedScale,
    /// Two eigenvectors with rows of unit length (Ng, Jordan and Weiss 2002).
    Njw,
    /// The second eigenvector: normalised cut (Shi and Malik 2000).
    Ncut,
    /// A scale for each sample (Zelnik-Manor and Perona 2005).
    LocalScale,
    /// Likeness cut off at a distance (paper, section 3.3).
    Sparse,
    /// Two Gaussians on the logarithms of height and speed.
    Gmm,
    /// Two Gaussian states in a hidden Markov model.
    Hmm,
    /// Lower than a threshold.
    Height,
    /// Slower than a threshold.
    Speed,
    /// Both lower and slower than thresholds.
    Dual,
    /// The slower of toe and ankle slower than a threshold.
    MinSpeed,
    /// Slower than 0.15 m/s after a median filter.
    MedianSpeed,
    /// Moved by less than √0.002 of a unit from frame to frame.
    Displacement,
    /// Lower than 0.114 m and slower than 0.93 m/s.
    HeightSpeed,
}

/// What kind of method it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Family {
    /// It clusters a graph of likenesses.
    Spectral,
    /// It fits distributions to each clip.
    Mixture,
    /// It compares heights or speeds in metres with thresholds.
    Threshold,
}

/// What a method is told.
pub(crate) struct Task<'a> {
    pub feet: &'a Feet,
    /// The feet of the same character standing still, to be clustered along.
    pub still: Option<&'a Feet>,
    pub params: ValidParams,
    /// What was kept from one detection of these feet to the next, where there may be one.
    pub kept: Option<&'a Cell<Option<Kept>>>,
}

/// What a method finds.
pub(crate) struct Found {
    pub parts: Vec<PartLabels>,
    pub notices: Vec<Notice>,
}

/// What a method's file says of it.
pub(crate) struct Entry {
    name: &'static str,
    title: &'static str,
    about: &'static str,
    family: Family,
    /// The parts that it labels, the one that says best when a foot is down first.
    parts: &'static [Part],
    detect: fn(&Task) -> Found,
}

impl Method {
    /// All methods, the default first.
    pub const ALL: [Method; 16] = [
        Method::Robust,
        Method::Paper,
        Method::FixedScale,
        Method::Njw,
        Method::Ncut,
        Method::LocalScale,
        Method::Sparse,
        Method::Gmm,
        Method::Hmm,
        Method::Height,
        Method::Speed,
        Method::Dual,
        Method::MinSpeed,
        Method::MedianSpeed,
        Method::Displacement,
        Method::HeightSpeed,
    ];

    fn entry(self) -> &'static Entry {
        match self {
            Method::Robust => &robust::METHOD,
            Method::Paper => &paper::METHOD,
            Method::FixedScale => &fixed_scale::METHOD,
            Method::Njw => &njw::METHOD,
            Method::Ncut => &ncut::METHOD,
            Method::LocalScale => &local_scale::METHOD,
            Method::Sparse => &sparse::METHOD,
            Method::Gmm => &gmm::METHOD,
            Method::Hmm => &hmm::METHOD,
            Method::Height => &thresholds::HEIGHT,
            Method::Speed => &thresholds::SPEED,
            Method::Dual => &thresholds::DUAL,
            Method::MinSpeed => &min_speed::METHOD,
            Method::MedianSpeed => &median_speed::METHOD,
            Method::Displacement => &displacement::METHOD,
            Method::HeightSpeed => &height_speed::METHOD,
        }
    }

    /// The method's name on the command line and in documents, as in `robust`.
    pub fn name(self) -> &'static str {
        self.entry().name
    }

    /// The method's name for people, as in `Robust spectral`.
    pub fn title(self) -> &'static str {
        self.entry().title
    }

    /// What the method does, in a sentence.
    pub fn about(self) -> &'static str {
        self.entry().about
    }

    /// What kind of method it is.
    pub fn family(self) -> Family {
        self.entry().family
    }

    /// The parts that it labels, the one that says best when a foot is down first.
    pub fn parts(self) -> &'static [Part] {
        self.entry().parts
    }

    pub(crate) fn detect(self, task: &Task) -> Found {
        (self.entry().detect)(task)
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
