//! Invalid arguments to the bindings.

use std::fmt;

/// An argument from JavaScript that names something that does not exist or is out of range.
#[derive(Debug, Clone, PartialEq)]
pub enum ArgumentError {
    /// The labels read from a file do not cover this part.
    MissingPart(String),
    /// The detection method does not label this part.
    UnlabelledPart(String),
    /// A side other than `left` and `right`.
    Side(String),
    /// An unknown role.
    Role(String),
    /// A joint index beyond the joints of the clip.
    Joint(usize),
    /// A name that the core does not accept, with its reason.
    Name(String),
    /// A quantity beyond its limits.
    OutOfRange {
        /// Name of the quantity.
        name: &'static str,
        /// The value given.
        value: f64,
        /// Least and largest value.
        range: [f64; 2],
    },
    /// A frame range that is empty or extends beyond the clip.
    FrameRange {
        /// First frame.
        start: usize,
        /// First frame after the range.
        end: usize,
        /// Number of frames of the clip.
        frames: usize,
    },
    /// The detection method did not cluster the samples of this part.
    NoEvidence,
    /// The detection method has no decision value for arbitrary heights and speeds.
    NoField,
    /// A JavaScript object that does not have the expected fields.
    Conversion(String),
}

impl fmt::Display for ArgumentError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::MissingPart(part) => write!(f, "the labels do not include {part:?}"),
            Self::UnlabelledPart(part) => write!(f, "this method does not label {part:?}"),
            Self::Side(name) => write!(f, "the side must be left or right, not {name:?}"),
            Self::Role(name) => write!(f, "unknown role {name:?}"),
            Self::Joint(index) => write!(f, "unknown joint {index}"),
            Self::OutOfRange { name, value, range: [least, largest] } => {
                write!(f, "the {name} must be from {least} to {largest}, not {value}")
            }
            Self::FrameRange { start, end, frames } => {
                write!(f, "invalid frame range {start} to {end}: the clip has {frames} frames")
            }
            Self::NoEvidence => f.write_str("this part was not clustered"),
            Self::NoField => f.write_str("this method has no decision field"),
            Self::Name(reason) | Self::Conversion(reason) => f.write_str(reason),
        }
    }
}

impl std::error::Error for ArgumentError {}
