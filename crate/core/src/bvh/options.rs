//! Options of the reader.

use std::ops::RangeInclusive;

use super::names::{self, NameDecoder};

/// Limits of a file. The reader checks them before it uses memory for what exceeds them.
///
/// Within the limits, time and memory of reading grow with the size of the file only.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Bytes of the file; default 1 GiB.
    pub bytes: u64,
    /// Bytes of a line; default 16 MiB.
    pub line_bytes: usize,
    /// Joints and end sites; default 10,000.
    pub joints: usize,
    /// Joints from a root to a tip; default 1,000.
    pub depth: usize,
    /// Magnitude of an offset or a channel value, in file units or degrees; default 10⁹.
    pub value: f64,
}

/// Frame rates that may replace the one of a file, in Hz.
pub const FRAME_RATES: RangeInclusive<f64> = 1.0..=1000.0;

impl Default for Limits {
    fn default() -> Limits {
        Limits { bytes: 1 << 30, line_bytes: 16 << 20, joints: 10_000, depth: 1_000, value: 1e9 }
    }
}

/// Options of the reader.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// If true, a value that is not a number is replaced by the value of the previous frame; if
    /// false, the file is rejected. Default false.
    pub lenient: bool,
    /// Limits of the size of the file.
    pub limits: Limits,
    /// Expected size of the file, in bytes. Memory for the stated number of frames is reserved at
    /// once if the file can contain them; default 0.
    pub expected_bytes: u64,
    /// Decoder of joint names that are not UTF-8. Default: the encoding is guessed; without the feature
    /// `encodings`, it is windows-1252.
    pub decode_names: NameDecoder,
}

impl Default for Options {
    fn default() -> Options {
        Options {
            lenient: false,
            limits: Limits::default(),
            expected_bytes: 0,
            decode_names: names::DEFAULT_DECODER,
        }
    }
}
