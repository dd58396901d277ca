//! Plants as a script for Blender.

use std::fmt::Write;

use crate::formats::format_info::FormatInfo;
use crate::formats::plants::events::events;
use crate::formats::plants::export::{DetectionRef, PlantExport, Reader, Writer};
use crate::formats::plants::tables::columns;
use crate::formats::scripts::python_literal;
use crate::intervals::intervals;

pub(super) const FORMAT_INFO: FormatInfo<Writer, Reader> = FormatInfo {
    name: "blender",
    title: "Blender",
    description: "A Python script that sets markers and contact keys in Blender.",
    extension: "blender.py",
    media_type: "text/x-python",
    write: |export| blender_script(export).into_bytes(),
    read: None,
};

/// Second part of the script, which uses the data of the first part.
const BODY: &str = include_str!("blender.py");

/// Maximum length of a property name in Blender, in bytes.
const MAX_NAME_BYTES: usize = 63;

/// Returns a Python script that marks the plants of a clip in Blender on the armature that its file was
/// imported as. To use it, select the armature and run the script.
///
/// Timeline markers `Left Foot Strike`, `Left Foot Off`, ... are set at the gait events. Custom
/// properties `left_contact`, `left_heel`, `left_toe`, ... of the armature object are keyed 1 while the
/// part is planted and 0 elsewhere, with constant interpolation. With several skeletons the name of the
/// root precedes each name. Frame 0 of the clip is the scene's frame `FRAME_START`, a constant at the
/// top of the script. Each frame of the clip is one frame of the scene, which is the default of
/// Blender's importer; if the clip was imported with "Scale FPS", set `SCALED = True`.
fn blender_script(export: &PlantExport) -> String {
    let labelled = export.labelled();
    let (mut markers, mut plants) = (Vec::new(), Vec::new());
    for DetectionRef { root, detection } in &labelled {
        let with_root = |name: &str| root.map_or_else(|| name.into(), |root| format!("{root} {name}"));
        for event in events(detection) {
            let name = format!("{} {}", event.context(), event.kind.title());
            markers.push((event.frame, with_root(&name)));
        }
        for (side, part) in columns(detection) {
            let labels = detection.part(part).map(|labels| labels.foot(side).planted.as_slice());
            let runs = intervals(labels.unwrap_or_default()).into_iter().map(|run| (run.start, run.end));
            let name = with_root(&format!("{}_{}", side.name(), part.name()));
            plants.push((last_bytes(&name).to_owned(), runs.collect::<Vec<_>>()));
        }
    }
    let frames = labelled.first().map_or(0, |first| first.detection.principal().feet[0].planted.len());
    let mut script = String::from(
        "# Foot plants for Blender: select the armature that the clip was imported as, then run this script.\n\n",
    );
    // Writing to a String cannot fail.
    let _ = writeln!(script, "# File name, frame rate in Hz and number of frames of the clip.");
    let _ = writeln!(script, "SOURCE = {}", python_literal(&export.source.name));
    let _ = writeln!(script, "RATE = {:?}", 1.0 / export.clip.frame_time());
    let _ = writeln!(script, "FRAMES = {frames}\n");
    let _ = writeln!(script, "# Frame of the scene at which the first frame of the clip was imported.");
    let _ = writeln!(script, "FRAME_START = 1\n");
    let _ = writeln!(script, "# True if the clip was imported with \"Scale FPS\".\nSCALED = False\n");
    let _ = writeln!(script, "# Frame (from 0) and name of each marker.\nEVENTS = [");
    for (frame, name) in markers {
        let _ = writeln!(script, "    ({frame}, {}),", python_literal(&name));
    }
    let _ = writeln!(
        script,
        "]\n\n# Properties with their plants: first frame, first frame after the plant.\nPLANTS = ["
    );
    for (name, runs) in plants {
        let runs: String = runs.iter().map(|(start, end)| format!("({start}, {end}), ")).collect();
        let _ = writeln!(script, "    ({}, [{}]),", python_literal(&name), runs.trim_end());
    }
    script.push_str("]\n");
    script.push_str(BODY);
    script
}

/// Returns the end of a name that is too long; the end distinguishes the properties of one root.
fn last_bytes(name: &str) -> &str {
    let from = name.len().saturating_sub(MAX_NAME_BYTES);
    let start = (from..=name.len()).find(|&start| name.is_char_boundary(start));
    &name[start.unwrap_or(0)..]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_names_keep_their_end() {
        assert_eq!(last_bytes(&"é".repeat(40)).len(), 62);
        assert_eq!(last_bytes("left_toe"), "left_toe");
    }
}
