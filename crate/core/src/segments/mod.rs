//! Segmentation of a clip into actions.
//!
//! Six methods share one interface, [`Method`], and one result, [`Segmentation`]. [`Method::Auto`]
//! is the default; the others are published methods for comparison and a variant of one of them,
//! [`Method::PcaTail`]. None needs the number of actions.
//!
//! Data flow: clip → poses (joint rotations or joint positions) → a curve → cuts → [`Segment`]s →
//! actions. Segments of all methods are then grouped by what is done in them, see [`Segment::action`].
//! All durations are in seconds, so results do not depend on the frame rate.

mod actions;
mod body;
mod edit_cuts;
mod error;
mod grid;
mod linkage;
mod methods;
mod movement;
mod options;
mod params;
mod pose;
mod progress;
mod refine;
mod segment;
mod segmentation;

pub use actions::{ActionMovements, common_names};
pub use edit_cuts::{CutEdit, edit_cuts};
pub use error::SegmentError;
pub use methods::{Method, MethodOption};
pub use options::{OptionError, Residual, Template};
pub use params::{ParamError, Params, ValidParams};
pub use progress::{Cancelled, Progress};
pub use segment::{Curve, Cycles, Kind, Motif, Segment};
pub use segmentation::{Segmentation, segment};

#[cfg(test)]
mod tests;
