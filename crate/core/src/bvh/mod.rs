//! BVH files: bytes to [`Clip`] and back.
//!
//! [`Reader`] accepts every variant of the format that has one sensible reading and reports repairs
//! as notices. It rejects all other files with an [`Error`] that names line and column.
//! [`write`](fn@write) is its inverse.

mod clip;
mod encoding;
mod error;
mod fast_row;
mod hierarchy;
mod lines;
mod motion_section;
mod number;
mod options;
mod reader;
#[cfg(test)]
mod tests;
mod writer;

pub use clip::{Axis, Channel, Clip, END_SITE, Joint, JointKind, PositionRule};
pub use error::{Error, ErrorKind, Excerpt};
pub use options::{Limits, Options};
pub use reader::{Parsed, Reader, parse};
pub use writer::write;
