//! Foot events as a Python script for the editor of Unreal Engine.

use std::fmt::Write;

use crate::formats::format_info::FormatInfo;
use crate::formats::plants::engines::timed_event::{TimedEvent, duration, name, timed_events};
use crate::formats::plants::events::EventKind;
use crate::formats::plants::export::{PlantExport, Reader, Writer};
use crate::formats::plants::tables::columns;
use crate::formats::scripts::{RUN_IN_UNREAL, UNREAL, unreal_constants};
use crate::intervals::intervals;

pub(crate) const FORMAT_INFO: FormatInfo<Writer, Reader> = FormatInfo {
    name: "unreal",
    title: "Unreal",
    description: "A Python script that adds notifies, sync markers and contact curves to an animation in Unreal.",
    extension: "unreal.py",
    media_type: "text/x-python",
    write: |export| script(export).into_bytes(),
    read: None,
};

/// Last part of the script, which uses the data of the first part.
const BODY: &str = include_str!("unreal.py");

/// Returns a Python script that adds the foot events of a clip to the animation sequences that are selected in
/// the content browser.
///
/// Adds a notify `FootStrike_L`, `HeelStrike_L`, … at each event, whose classes are Blueprints in a folder of
/// the project; a sync marker at each foot strike; and a curve `Contact_L`, `Heel_L`, `Toe_L`, … that is 1 while
/// the part is planted. Times are those of the clip, in seconds; they are scaled if the animation has another
/// duration. A second run replaces what the first one added; with `REMOVE = True` the script only removes it.
/// Bones, root motion and other notifies, markers and curves are not changed.
fn script(export: &PlantExport) -> String {
    let (rate, duration) = (1.0 / export.clip.frame_time(), duration(export));
    let mut script = format!("# Foot events for Unreal Engine: {RUN_IN_UNREAL}");
    script.push_str(&unreal_constants(&export.source.name, rate, duration));
    // Writing to a String cannot fail.
    let _ = writeln!(
        script,
        "# Time in seconds and name of each event; True for those that are sync markers, too."
    );
    let _ = writeln!(script, "EVENTS = [");
    for TimedEvent { time, name, kind } in timed_events(export) {
        let is_marker = if matches!(kind, EventKind::Strike) { "True" } else { "False" };
        let _ = writeln!(script, "    ({time:.6}, \"{name}\", {is_marker}),");
    }
    let _ = writeln!(script, "]\n\n# Curves with their plants: start and end in seconds.\nCURVES = [");
    let frame_time = export.clip.frame_time();
    for labelled in export.labelled() {
        for (side, part) in columns(labelled.detection) {
            let Some(labels) = labelled.detection.part(part).map(|labels| labels.foot(side)) else {
                continue;
            };
            let title = match part.name() {
                "contact" => "Contact",
                "heel" => "Heel",
                _ => "Toe",
            };
            let _ = write!(script, "    (\"{}\", [", name(labelled.root, title, side));
            for run in intervals(&labels.planted) {
                let start = if run.start == 0 { 0.0 } else { labels.boundary_time(run.start, frame_time) };
                let is_last = run.end == labels.planted.len();
                let end = if is_last { duration } else { labels.boundary_time(run.end, frame_time) };
                let _ = write!(script, "({:.6}, {:.6}), ", start.max(0.0), end);
            }
            let _ = writeln!(script, "]),");
        }
    }
    script.push_str("]\n");
    script.push_str(UNREAL);
    script.push_str(BODY);
    script
}
