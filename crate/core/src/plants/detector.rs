//! Detecting again and again in one clip.

use std::cell::Cell;

use crate::plants::methods::{Kept, Task};
use crate::plants::{Detection, Feet, ValidParams};

/// A clip's feet, with what need not be found anew when parameters change.
///
/// Labels are those of [`detect`](crate::plants::detect). What depends on no parameter is kept, and so is what
/// depends on the window alone: about 240 bytes for each frame with the feet, and at most
/// 20 MB for the samples of one window.
pub struct Detector {
    feet: Feet,
    kept: Cell<Option<Kept>>,
}

impl Detector {
    /// A detector of plants of these feet.
    pub fn new(feet: Feet) -> Detector {
        Detector { feet, kept: Cell::new(None) }
    }

    /// The feet.
    pub fn feet(&self) -> &Feet {
        &self.feet
    }

    /// Finds the frames in which each foot is planted; see [`detect`](crate::plants::detect).
    pub fn detect(&self, params: ValidParams) -> Detection {
        crate::plants::run(Task { feet: &self.feet, still: None, params, kept: Some(&self.kept) })
    }
}
