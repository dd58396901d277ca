//! Parts shared by the documents of plants and of segments.

use std::ops::Range;

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::bvh::Clip;
use crate::skeleton::Skeleton;

/// Version of the documents that this library reads and writes.
pub const VERSION: u32 = 1;

/// Header of a document.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Header {
    /// Name of the document's format.
    pub format: String,
    /// Version of the document's format; [`VERSION`] in written documents.
    pub version: u32,
    /// The clip.
    pub source: Source,
    /// Name of the root joint, if the clip has several skeletons.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub root: Option<String>,
    /// Number of frames of the clip.
    pub frames: usize,
    /// Frame rate, in Hz, after any override.
    pub rate: f64,
}

impl Header {
    /// Creates the header of a document about one skeleton of a clip.
    pub(crate) fn new(format: &str, source: Source, clip: &Clip, skeleton: &Skeleton) -> Header {
        let has_several = clip.roots().count() > 1;
        Header {
            format: format.into(),
            version: VERSION,
            source,
            root: has_several.then(|| clip.joints()[skeleton.root].name.clone()),
            frames: clip.frame_count(),
            rate: clip.rate(),
        }
    }
}

/// The clip that a document belongs to.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Source {
    /// File name without folders.
    pub name: String,
    /// SHA-256 of the file in lower-case hexadecimal, if known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sha256: Option<String>,
    /// Encoding of the joint names in the file, as in `Shift_JIS`, if they are not Unicode. Encoding
    /// the names of the document with it returns their bytes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name_encoding: Option<String>,
}

/// Half-open frame range with its times.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FrameRange {
    /// First frame.
    pub start: usize,
    /// First frame after the range.
    pub end: usize,
    /// Time of `start`, in seconds from the start of the clip.
    pub start_s: f64,
    /// Time of `end`, in seconds from the start of the clip.
    pub end_s: f64,
}

impl FrameRange {
    /// Creates a range of frames at `rate` Hz.
    pub fn new(frames: Range<usize>, rate: f64) -> FrameRange {
        let [start_s, end_s] = [frames.start, frames.end].map(|frame| frame as f64 / rate);
        FrameRange { start: frames.start, end: frames.end, start_s, end_s }
    }
}

/// Origin of a plant or a segment.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Origin {
    /// A method.
    Auto,
    /// A person.
    Edited,
    /// A measurement or the generator of the motion.
    Truth,
}

/// A file cannot be read as plants or segments.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ReadError {
    /// The file has no plants.
    #[error(
        "the file has no plants: expected a plants document, annotated contacts, a table with one row per frame or plant, or a NumPy archive"
    )]
    NoPlants,
    /// The file has the labels of several skeletons.
    #[error("the file has the labels of several skeletons: use a file with those of one skeleton")]
    SeveralSkeletons,
    /// The file has no segments.
    #[error(
        "the file has no segments: expected a segments document, a BABEL file, annotated segments, or a table"
    )]
    NoSegments,
    /// The document has the labels of a method only.
    #[error(
        "the document has no edits of a person: correct labels and save them, or annotate contact with -1 for unknown frames"
    )]
    NoEdits,
    /// The file has segments of other clips only.
    #[error("the file has no segments of {0}")]
    NoClip(String),
    /// The document has an unknown version.
    #[error("the document has version {0}, but this program supports version {VERSION}")]
    Version(u32),
    /// The file is malformed.
    #[error("the file cannot be read: {0}")]
    Invalid(String),
    /// The file belongs to another clip.
    #[error("the file has {found} frames, but the clip has {frames}")]
    Length {
        /// Number of frames of the file.
        found: usize,
        /// Number of frames of the clip.
        frames: usize,
    },
}

impl From<serde_json::Error> for ReadError {
    fn from(error: serde_json::Error) -> ReadError {
        ReadError::Invalid(error.to_string())
    }
}

/// Returns the document of an array that has one; other values are returned unchanged.
///
/// # Errors
/// If the array has several documents.
pub(crate) fn only_document(value: Value) -> Result<Value, ReadError> {
    match value {
        Value::Array(mut documents) if documents.first().is_some_and(|first| first["format"].is_string()) => {
            let last = documents.swap_remove(0);
            if documents.is_empty() { Ok(last) } else { Err(ReadError::SeveralSkeletons) }
        }
        value => Ok(value),
    }
}

/// Returns documents or other values as indented JSON with a line end.
pub fn to_json(value: &(impl Serialize + ?Sized)) -> String {
    let mut text = serde_json::to_string_pretty(value).expect("documents have text, numbers and lists only");
    text.push('\n');
    text
}

/// Reads a document of the supported version.
pub(crate) fn from_json<T: DeserializeOwned>(value: Value) -> Result<T, ReadError> {
    let version = value["version"].as_u64().unwrap_or(0) as u32;
    if version == VERSION { Ok(serde_json::from_value(value)?) } else { Err(ReadError::Version(version)) }
}
