//! Segments as an editor script of Unity.

use std::fmt::Write;

use crate::formats::format_info::FormatInfo;
use crate::formats::scripts::{UNITY, csharp_literal, unity_class};
use crate::formats::segments::document::SegmentsDocument;
use crate::formats::segments::engines::names::{duration, named_segments};
use crate::formats::segments::export::{Reader, Writer};

pub(crate) const FORMAT_INFO: FormatInfo<Writer, Reader> = FormatInfo {
    name: "unity",
    title: "Unity",
    description: "An editor script that divides an imported model into a clip per segment in Unity.",
    extension: "segments.unity.cs",
    media_type: "text/x-csharp",
    write: |export| script(&export.documents).into_bytes(),
    read: None,
};

/// Last part of the script, which uses the data of the first part.
const BODY: &str = include_str!("unity.cs");

/// Returns an editor script, with a menu command that adds a clip for each segment to the imported model that is
/// selected in the project window.
///
/// The clips are named `walk_1 - 2 turn`: the name of the file, and the number and name of the segment. They end
/// at the first frame of the next one. A second run replaces what the first one added; another command removes
/// it. Other clips of the model are not changed.
fn script(documents: &[SegmentsDocument]) -> String {
    let header = &documents[0].header;
    let source = &header.source.name;
    let stem = source.strip_suffix(".bvh").unwrap_or(source);
    let mut script = unity_class("Segments", "segments", "the model with the animation", source);
    // Writing to a String cannot fail.
    let _ = writeln!(script, "        // Start of the names of the added clips.");
    let _ = writeln!(script, "        const string Prefix = {};", csharp_literal(&format!("{stem} - ")));
    let _ = writeln!(script, "        // Duration in seconds.");
    let _ = writeln!(script, "        const float Duration = {:?}f;", duration(&documents[0]) as f32);
    let _ = writeln!(script, "        // Start and end in seconds, and name of each segment.");
    let _ = writeln!(script, "        static readonly Tuple<float, float, string>[] Segments =\n        {{");
    for (index, (name, segment)) in named_segments(documents).into_iter().enumerate() {
        let [start, end] = [segment.frames.start, segment.frames.end].map(|frame| frame as f64 / header.rate);
        let name = csharp_literal(&format!("{} {name}", index + 1));
        let _ = writeln!(script, "            Tuple.Create({start:.6}f, {end:.6}f, {name}),");
    }
    script.push_str("        };\n");
    script.push_str(UNITY);
    script.push_str(BODY);
    script
}
