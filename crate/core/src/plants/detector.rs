//! Repeated detection on one clip.

use crate::plants::detect::{self, Function};
use crate::plants::methods::DetectionCache;
use crate::plants::{Detection, Feet, ValidParams};

/// Detects plants of one clip repeatedly and reuses intermediate results.
///
/// The labels are those of [`detect`](crate::plants::detect). Results that depend on no parameter or
/// on the window alone are cached: about 240 bytes per frame with the feet, and at most 20 MB for the
/// samples of one window.
pub struct Detector {
    feet: Feet,
    cache: DetectionCache,
}

impl Detector {
    /// Creates a detector for these feet.
    pub fn new(feet: Feet) -> Detector {
        Detector { feet, cache: DetectionCache::default() }
    }

    /// Returns the feet.
    pub fn feet(&self) -> &Feet {
        &self.feet
    }

    /// Detects the plants; see [`detect`](crate::plants::detect).
    pub fn detect(&mut self, params: ValidParams) -> Detection {
        self.run(params.method().function(), params)
    }

    /// Detects like [`Detector::detect`] with the default method. A program that calls no other function that
    /// detects does not contain the other methods.
    ///
    /// # Panics
    /// If the parameters name another method.
    pub fn detect_by_default(&mut self, params: ValidParams) -> Detection {
        self.run(detect::default_function(params), params)
    }

    fn run(&mut self, function: Function, params: ValidParams) -> Detection {
        detect::run(function, &self.feet, None, params, Some(&mut self.cache))
    }
}
