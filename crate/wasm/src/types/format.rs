//! File formats.

use plantigrade::formats::{GaitFormat, PlantFormat, SegmentFormat};
use serde::{Deserialize, Serialize};
use tsify::Tsify;

/// A file format, for menus and file names.
#[derive(Debug, Serialize, Deserialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct FormatInfo {
    /// Name for `save`, `saveSegments` or `saveGait`.
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

impl FormatInfo {
    // Called for each list of formats: inlined, it would enlarge the module.
    #[inline(never)]
    fn new([name, title, description]: [&str; 3], extension: &str, media_type: &str) -> FormatInfo {
        FormatInfo {
            name: name.into(),
            title: title.into(),
            description: description.into(),
            extension: extension.into(),
            media_type: media_type.into(),
        }
    }
}

macro_rules! impl_from_format {
    ($($Format:ty),+) => {$(
        impl From<$Format> for FormatInfo {
            fn from(format: $Format) -> FormatInfo {
                let names = [format.name(), format.title(), format.description()];
                FormatInfo::new(names, format.extension(), format.media_type())
            }
        }
    )+};
}

impl_from_format!(PlantFormat, SegmentFormat, GaitFormat);
