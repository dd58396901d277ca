//! File formats.

use plantigrade::formats::{PlantFormat, SegmentFormat};
use serde::{Deserialize, Serialize};
use tsify::Tsify;

/// A file format, for menus and file names.
#[derive(Debug, Serialize, Deserialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct FormatInfo {
    /// Name for `save` or `saveSegments`.
    pub name: String,
    /// Display name.
    pub title: String,
    /// Description in a sentence.
    pub description: String,
    /// File extension, without the leading dot.
    pub extension: String,
    /// Media (MIME) type.
    pub media_type: String,
}

macro_rules! impl_from_format {
    ($($Format:ty),+) => {$(
        impl From<$Format> for FormatInfo {
            fn from(format: $Format) -> FormatInfo {
                FormatInfo {
                    name: format.name().into(),
                    title: format.title().into(),
                    description: format.description().into(),
                    extension: format.extension().into(),
                    media_type: format.media_type().into(),
                }
            }
        }
    )+};
}

impl_from_format!(PlantFormat, SegmentFormat);
