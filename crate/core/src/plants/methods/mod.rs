//! Detection methods: one file or folder per method, and their registry.
//!
//! [`Method::Robust`] is the default. The others serve as a comparison: the method of the paper,
//! other spectral clusterings, mixture models, and thresholds in common use.

mod displacement;
mod fixed_sigma;
mod gmm;
mod height_speed;
mod hmm;
mod local_sigma;
mod median_speed;
mod method_info;
mod min_speed;
mod ncut;
mod njw;
mod paper;
mod robust;
mod sparse;
mod thresholds;
mod toes;

pub use method_info::{Family, Thresholds};
pub(crate) use method_info::{Input, Output, Settings};
pub(crate) use robust::cache::DetectionCache;

use crate::foot::Part;
use crate::registry::registry;
use method_info::MethodInfo;

registry! {
    /// Method of detection.
    pub enum Method: MethodInfo as "method" {
        /// Contact, toe and heel by weighted degrees; the default.
        #[default]
        Robust => robust::METHOD,
        /// The method of the paper, exactly as published.
        Paper => paper::METHOD,
        /// The method of the paper with one bandwidth for every clip (paper, section 3.4).
        FixedSigma => fixed_sigma::METHOD,
        /// Two eigenvectors with rows of unit length (Ng, Jordan and Weiss 2002).
        Njw => njw::METHOD,
        /// Second eigenvector: normalised cut (Shi and Malik 2000).
        Ncut => ncut::METHOD,
        /// One bandwidth per sample (Zelnik-Manor and Perona 2005).
        LocalSigma => local_sigma::METHOD,
        /// Affinities truncated at a distance (paper, section 3.3).
        Sparse => sparse::METHOD,
        /// Two Gaussians on the logarithms of height and speed.
        Gmm => gmm::METHOD,
        /// Two Gaussian states in a hidden Markov model.
        Hmm => hmm::METHOD,
        /// Threshold on height.
        Height => thresholds::HEIGHT,
        /// Threshold on speed.
        Speed => thresholds::SPEED,
        /// Thresholds on both height and speed.
        Dual => thresholds::DUAL,
        /// Threshold on the speed of the slower of toe and ankle.
        MinSpeed => min_speed::METHOD,
        /// 0.15 m/s after a median filter.
        MedianSpeed => median_speed::METHOD,
        /// Squared displacement of 0.002 m² per frame.
        Displacement => displacement::METHOD,
        /// 0.114 m and 0.93 m/s.
        HeightSpeed => height_speed::METHOD,
    }
    with {
        /// Returns the family of the method.
        family: Family,
        /// Returns the labelled parts; the first one defines the plants.
        parts: &'static [Part],
    }
}

/// The function of the default method.
pub(crate) const DEFAULT_FUNCTION: fn(&mut Input) -> Output = robust::METHOD.detect;

impl Method {
    /// Returns the thresholds that the method compares with, given a height in metres and a speed
    /// in metres per second.
    pub(crate) fn thresholds(self, height: f64, speed: f64) -> Thresholds {
        (self.entry().thresholds)(height, speed)
    }

    /// Returns the function of the method.
    pub(crate) fn function(self) -> fn(&mut Input) -> Output {
        self.entry().detect
    }
}
