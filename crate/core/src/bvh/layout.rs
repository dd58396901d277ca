//! Layout of a file: where its numbers are, and how they are written.

use std::ops::Range;

/// Byte positions and formats of the numbers of a file, with which a [`Rewriter`](crate::bvh::Rewriter)
/// changes some of them.
///
/// Offsets are byte indices in the text of the file: decoded, without a byte order mark.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Layout {
    /// Name of the encoding of the joint names; `None` if they are UTF-8 or UTF-16.
    pub(crate) name_encoding: Option<&'static str>,
    /// The number after `Frames:`.
    pub(crate) frame_count: Option<Range<u64>>,
    /// The text after `Frame Time:`, with its unit.
    pub(crate) frame_time_text: Option<Range<u64>>,
    /// Frame time that the reader used, in seconds.
    pub(crate) frame_time: f64,
    /// Start of each frame: of its first line, or of its first number if other text precedes it.
    pub(crate) frames: Vec<u64>,
    /// End of the lines of the last frame; `None` until it has been read.
    pub(crate) frames_end: Option<u64>,
    /// Decimal places of each channel.
    pub(crate) decimals: Vec<u8>,
    /// True if the decimal mark is a comma.
    pub(crate) has_decimal_commas: bool,
}

impl Layout {
    /// Returns the name of the encoding of the joint names, as in `Shift_JIS`, if they are not
    /// Unicode. Encoding a name of the clip with it returns the bytes of the file.
    pub fn name_encoding(&self) -> Option<&'static str> {
        self.name_encoding
    }
}
