//! Segments as a Python script for the editor of Unreal Engine.

use std::fmt::Write;

use crate::formats::format_info::FormatInfo;
use crate::formats::scripts::{RUN_IN_UNREAL, UNREAL, identifier, unreal_constants};
use crate::formats::segments::document::SegmentsDocument;
use crate::formats::segments::engines::names::{duration, named_segments};
use crate::formats::segments::export::{Reader, Writer};

pub(crate) const FORMAT_INFO: FormatInfo<Writer, Reader> = FormatInfo {
    name: "unreal",
    title: "Unreal",
    description: "A Python script that adds a notify state for each segment to an animation in Unreal.",
    extension: "segments.unreal.py",
    media_type: "text/x-python",
    write: |export| script(&export.documents).into_bytes(),
    read: None,
};

/// Last part of the script, which uses the data of the first part.
const BODY: &str = include_str!("unreal.py");

/// Returns a Python script that adds a notify state for each segment to the animation sequences that are
/// selected in the content browser.
///
/// A state `Segment_walk` lasts from the first frame of the segment to its end; all segments of one name have
/// one class, a Blueprint in a folder of the project. Times are scaled if the animation has another duration. A
/// second run replaces what the first one added; with `REMOVE = True` the script only removes it.
fn script(documents: &[SegmentsDocument]) -> String {
    let header = &documents[0].header;
    let mut script = format!("# Segments for Unreal Engine: {RUN_IN_UNREAL}");
    script.push_str(&unreal_constants(&header.source.name, header.rate, duration(&documents[0])));
    script.push_str("# Start and end in seconds, and name of each segment.\nSEGMENTS = [\n");
    for (name, segment) in named_segments(documents) {
        let [start, end] = [segment.frames.start, segment.frames.end].map(|frame| frame as f64 / header.rate);
        // Writing to a String cannot fail.
        let _ = writeln!(script, "    ({start:.6}, {end:.6}, \"Segment_{}\"),", identifier(&name));
    }
    script.push_str("]\n");
    script.push_str(UNREAL);
    script.push_str(BODY);
    script
}
