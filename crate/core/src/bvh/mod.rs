//! BVH: bytes to [`Clip`] and back.
//!
//! [`Reader`] takes files as they occur: it accepts what a person would
//! accept, says what it did in notices, and refuses the rest with an [`Error`]
//! that names line and column. [`write`](fn@write) is its inverse.

mod clip;
mod encoding;
mod error;
mod fast_row;
mod hierarchy;
mod lines;
mod motion_section;
mod number;
mod reader;
#[cfg(test)]
mod tests;
mod writer;

pub use clip::{Axis, Channel, Clip, END_SITE, Joint, JointKind, PositionRule};
pub use error::{Error, Excerpt, Problem};
pub use reader::{Limits, Options, Parsed, Reader, parse};
pub use writer::write;
