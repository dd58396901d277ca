//! Progress of a segmentation and its cancellation.

/// The segmentation was cancelled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cancelled;

/// Receives the completed fraction, from 0 to 1, and may cancel.
pub type Progress<'a> = dyn FnMut(f64) -> Result<(), Cancelled> + 'a;

/// Called within a long step; may cancel.
pub(crate) type Checkpoint<'a> = dyn FnMut() -> Result<(), Cancelled> + 'a;
