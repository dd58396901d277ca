//! Repeated detection on one clip.

use crate::plants::methods::DetectionCache;
use crate::plants::{Detection, Feet, ValidParams, detect};

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
        detect::run(&self.feet, None, params, Some(&mut self.cache))
    }
}
