//! Foot events as an editor script of Unity.

use std::fmt::Write;

use crate::formats::format_info::FormatInfo;
use crate::formats::plants::engines::timed_event::{TimedEvent, duration, timed_events};
use crate::formats::plants::export::{PlantExport, Reader, Writer};
use crate::formats::scripts::{UNITY, unity_class};

pub(crate) const FORMAT_INFO: FormatInfo<Writer, Reader> = FormatInfo {
    name: "unity",
    title: "Unity",
    description: "An editor script that adds animation events to a clip in Unity.",
    extension: "unity.cs",
    media_type: "text/x-csharp",
    write: |export| script(export).into_bytes(),
    read: None,
};

/// Last part of the script, which uses the data of the first part.
const BODY: &str = include_str!("unity.cs");

/// Returns an editor script, with a menu command that adds the foot events of a clip to the animation clip, or
/// the imported model, that is selected in the project window.
///
/// Each event calls `OnFootEvent` with its name, `FootStrike_L`, `HeelStrike_L`, …, and requires no receiver.
/// Times are those of the clip, in seconds; they are scaled if the animation has another duration. A second run
/// replaces what the first one added; another command removes it. Curves, root motion and other events are not
/// changed.
fn script(export: &PlantExport) -> String {
    let target = "the animation clip, or the model with the clip,";
    let mut script = unity_class("FootEvents", "foot events", target, &export.source.name);
    // Writing to a String cannot fail.
    let _ = writeln!(script, "        // Frame rate in Hz, and duration in seconds.");
    let _ = writeln!(script, "        const float Rate = {:?}f;", (1.0 / export.clip.frame_time()) as f32);
    let _ = writeln!(script, "        const float Duration = {:?}f;", duration(export) as f32);
    let _ = writeln!(
        script,
        "        // Time in seconds and name of each event, which calls OnFootEvent(string name) of the scripts of\n        // the animated object, if there is one."
    );
    let _ = writeln!(script, "        static readonly KeyValuePair<float, string>[] Events =\n        {{");
    for TimedEvent { time, name, .. } in timed_events(export) {
        let _ = writeln!(script, "            new KeyValuePair<float, string>({time:.6}f, \"{name}\"),");
    }
    script.push_str("        };\n");
    script.push_str(UNITY);
    script.push_str(BODY);
    script
}
