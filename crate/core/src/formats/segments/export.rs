//! Segments to write, and the interface of writers and readers.

use crate::formats::document::ReadError;
use crate::formats::segments::document::SegmentsDocument;
use crate::formats::segments::file::SegmentFile;

/// Writes segments as the bytes of a file.
pub(crate) type Writer = fn(&SegmentExport) -> Vec<u8>;

/// Reads segments of a clip, by its name without extension.
pub(crate) struct Reader {
    /// True if the text looks like this format.
    pub recognises: fn(&str) -> bool,
    pub read: fn(&str, &str) -> Result<SegmentFile, ReadError>,
}

/// Segments to write.
#[derive(Clone, Debug)]
pub struct SegmentExport {
    /// One document per skeleton.
    pub documents: Vec<SegmentsDocument>,
    /// If true, JSON is an array with one document per skeleton; if false, the first document.
    pub as_array: bool,
}
