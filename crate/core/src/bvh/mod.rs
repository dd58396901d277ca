//! BVH files: bytes to [`Clip`] and back.
//!
//! [`Reader`] accepts every variant of the format that has one sensible reading and reports repairs
//! as notices. It rejects all other files with an [`Error`] that names line and column.
//! [`write`](fn@write) is its inverse. [`Rewriter`] writes a clip that was read from a file and
//! changed: it preserves the bytes of the file apart from the numbers that differ.

mod clip;
mod encoding;
mod error;
mod extra_column;
mod fast_row;
mod frame_time;
mod hierarchy;
mod layout;
mod lines;
mod motion_header;
mod motion_section;
mod names;
mod number;
mod options;
mod reader;
mod repairs;
mod rewriter;
#[cfg(test)]
mod tests;
mod writer;

pub use clip::{Axis, Channel, Clip, END_SITE, Joint, JointKind, PositionRule};
pub use error::{Error, ErrorKind, Excerpt};
pub use layout::Layout;
pub use names::{NameDecoder, decode_windows_1252};
pub use options::{FRAME_RATES, Limits, Options};
pub use reader::{Parsed, Reader, parse};
pub use rewriter::{OtherFile, Rewriter, rewrite};
pub use writer::write;
