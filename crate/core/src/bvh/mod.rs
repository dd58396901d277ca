//! BVH: bytes to [`Clip`] and back.
//!
//! [`Reader`] takes files as they occur: it accepts what a person would
//! accept, says what it did in notices, and refuses the rest with an [`Error`]
//! that names line and column. [`write`](fn@write) is its inverse.

mod clip;
mod decode;
mod error;
mod hierarchy;
mod lines;
mod number;
mod plain;
mod read;
mod rows;
#[cfg(test)]
mod tests;
mod write;

pub use clip::{Axis, Channel, Clip, END_SITE, Joint, JointKind, PositionRule};
pub use error::{Error, Excerpt, Problem};
pub use read::{Limits, Options, Parsed, Reader, parse};
pub use write::write;
