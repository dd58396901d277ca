//! Labels as a script for Blender.

use std::fmt::Write;

use crate::formats::Labelled;
use crate::formats::tables::{columns, events};
use crate::intervals::intervals;

/// What the script does with its numbers.
const BODY: &str = include_str!("blender.py");

/// The longest name that Blender gives a property, in bytes.
const NAME_BYTES: usize = 63;

/// A Python script that marks the labels of a clip called `source` in Blender, on the armature
/// that its file was imported as: select it and run the script.
///
/// Timeline markers `Left Foot Strike`, `Left Foot Off`, ... stand at the gait events. Custom
/// properties `left_contact`, `left_heel`, `left_toe`, ... of the armature object are keyed 1
/// where the part is planted and 0 elsewhere, with constant interpolation. With several
/// skeletons the root's name comes before each. The clip's frame 0 is the scene's frame
/// `FRAME_START`, a constant at the script's top, and each frame of the clip is one of the
/// scene, as Blender's importer has it unless it is told to scale to the scene's rate: then
/// `SCALED = True` is for the script.
pub fn blender_script(labelled: &[Labelled], source: &str, frame_time: f64) -> String {
    let (mut marks, mut plants) = (Vec::new(), Vec::new());
    for Labelled { root, detection } in labelled {
        let named = |name: &str| root.map_or_else(|| name.into(), |root| format!("{root} {name}"));
        for (frame, context, event) in events(detection) {
            marks.push((frame, named(&format!("{context} {event}"))));
        }
        for (side, part) in columns(detection) {
            let labels = detection.part(part).map(|labels| labels.foot(side).planted.as_slice());
            let runs = intervals(labels.unwrap_or_default()).into_iter().map(|run| (run.start, run.end));
            let name = named(&format!("{}_{}", side.name(), part.name()));
            plants.push((ending(&name).to_owned(), runs.collect::<Vec<_>>()));
        }
    }
    let frames = labelled.first().map_or(0, |first| first.detection.principal().feet[0].planted.len());
    let mut script = String::from(
        "# Foot plants for Blender: select the armature that the clip was imported as, and run this.\n\n",
    );
    // Writing to a String cannot fail.
    let _ = writeln!(script, "# The clip's file, its frames per second and its number of frames.");
    let _ = writeln!(script, "SOURCE = {}", literal(source));
    let _ = writeln!(script, "RATE = {:?}", 1.0 / frame_time);
    let _ = writeln!(script, "FRAMES = {frames}\n");
    let _ = writeln!(script, "# The scene's frame at which the clip's first frame was imported.");
    let _ = writeln!(script, "FRAME_START = 1\n");
    let _ = writeln!(script, "# Whether it was imported with \"Scale FPS\".\nSCALED = False\n");
    let _ = writeln!(script, "# Frame and name of each marker, frames counted from 0.\nEVENTS = [");
    for (frame, name) in marks {
        let _ = writeln!(script, "    ({frame}, {}),", literal(&name));
    }
    let _ =
        writeln!(script, "]\n\n# Each property with its plants: first frame, first frame after.\nPLANTS = [");
    for (name, runs) in plants {
        let runs: String = runs.iter().map(|(start, end)| format!("({start}, {end}), ")).collect();
        let _ = writeln!(script, "    ({}, [{}]),", literal(&name), runs.trim_end());
    }
    script.push_str("]\n");
    script.push_str(BODY);
    script
}

/// A text as a literal of Python, which a string of JSON in ASCII always is.
fn literal(text: &str) -> String {
    let json = serde_json::Value::from(text).to_string();
    let mut literal = String::with_capacity(json.len());
    for c in json.chars() {
        match c {
            ' '..='~' => literal.push(c),
            _ => {
                let _ = write!(literal, "\\U{:08x}", u32::from(c));
            }
        }
    }
    literal
}

/// The end of a name that is too long, which tells the properties of one root apart.
fn ending(name: &str) -> &str {
    let from = name.len().saturating_sub(NAME_BYTES);
    let start = (from..=name.len()).find(|&start| name.is_char_boundary(start));
    &name[start.unwrap_or(0)..]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_are_literals_whatever_is_in_them() {
        assert_eq!(literal("walk.bvh"), "\"walk.bvh\"");
        assert_eq!(literal("\"\"\"\\\n\r"), r#""\"\"\"\\\n\r""#);
        assert_eq!(literal("à\u{2028}\u{7f}𝄞\0"), r#""\U000000e0\U00002028\U0000007f\U0001d11e\u0000""#);
        assert_eq!(ending(&"é".repeat(40)).len(), 62);
        assert_eq!(ending("left_toe"), "left_toe");
    }
}
