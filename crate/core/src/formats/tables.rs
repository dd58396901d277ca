//! Labels as CSV tables with named columns.

use std::fmt::Write;

use crate::foot::{Part, Side};
use crate::formats::{SegmentsDocument, csv};
use crate::intervals::intervals;
use crate::numeric::sort;
use crate::plants::Detection;

/// What was detected in one skeleton of a clip.
#[derive(Clone, Copy, Debug)]
pub struct Labelled<'a> {
    /// Name of the root joint; named in the tables where the clip has several skeletons.
    pub root: Option<&'a str>,
    /// Its labels.
    pub detection: &'a Detection,
}

/// One row per frame: `frame,time,left_contact,left_heel,left_toe,right_contact,...`.
///
/// Columns hold 0 or 1; a method that labels toes only has only their columns.
/// With several skeletons a column `root` comes first. Times are in seconds.
pub fn frames_csv(labelled: &[Labelled], frame_time: f64) -> String {
    let mut text = head(labelled.iter().map(|labelled| labelled.root), "frame,time");
    let Some(first) = labelled.first() else { return text };
    for (side, part) in columns(first.detection) {
        let _ = write!(text, ",{}_{}", side.name(), part.name());
    }
    text.push('\n');
    for Labelled { root, detection } in labelled {
        let columns: Vec<&[bool]> = columns(detection)
            .filter_map(|(side, part)| Some(detection.part(part)?.foot(side).planted.as_slice()))
            .collect();
        for frame in 0..columns.first().map_or(0, |labels| labels.len()) {
            let _ = write!(text, "{}{frame},{}", field(*root), seconds(frame, frame_time));
            for labels in &columns {
                let _ = write!(text, ",{}", u8::from(labels[frame]));
            }
            text.push('\n');
        }
    }
    text
}

/// One row per plant: `foot,part,start_frame,end_frame,start_s,end_s`, half-open.
pub fn intervals_csv(labelled: &[Labelled], frame_time: f64) -> String {
    let mut text = head(
        labelled.iter().map(|labelled| labelled.root),
        "foot,part,start_frame,end_frame,start_s,end_s\n",
    );
    for Labelled { root, detection } in labelled {
        for (side, part) in columns(detection) {
            let labels = detection.part(part).map(|labels| labels.foot(side).planted.as_slice());
            for range in intervals(labels.unwrap_or_default()) {
                let _ = writeln!(
                    text,
                    "{}{},{},{},{},{},{}",
                    field(*root),
                    side.name(),
                    part.name(),
                    range.start,
                    range.end,
                    seconds(range.start, frame_time),
                    seconds(range.end, frame_time),
                );
            }
        }
    }
    text
}

/// One row per gait event: `time,frame,context,event` with `Left` or `Right`
/// and `Foot Strike` or `Foot Off`, in order of time.
///
/// Contact that begins or ends with the clip is no event.
pub fn events_csv(labelled: &[Labelled], frame_time: f64) -> String {
    let mut text = head(labelled.iter().map(|labelled| labelled.root), "time,frame,context,event\n");
    for Labelled { root, detection } in labelled {
        for (frame, context, event) in events(detection) {
            let _ =
                writeln!(text, "{}{},{frame},{context},{event}", field(*root), seconds(frame, frame_time));
        }
    }
    text
}

/// One row per action: `start_frame,end_frame,start_s,end_s,kind,label`, half-open; the rows tile
/// the clip from frame 0.
///
/// With several skeletons a column `root` comes first.
pub fn segments_csv(documents: &[SegmentsDocument]) -> String {
    let roots = documents.iter().map(|document| document.root.as_deref());
    let mut text = head(roots, "start_frame,end_frame,start_s,end_s,kind,label\n");
    for document in documents {
        for segment in &document.segments {
            let (start, end) = (segment.stretch.start, segment.stretch.end);
            let _ = writeln!(
                text,
                "{}{start},{end},{},{},{},{}",
                field(document.root.as_deref()),
                seconds(start, 1.0 / document.rate),
                seconds(end, 1.0 / document.rate),
                segment.kind.name(),
                csv::field(&segment.label),
            );
        }
    }
    text
}

/// The gait events of a skeleton in order of time: frame, context and event.
pub(crate) fn events(detection: &Detection) -> Vec<(usize, &'static str, &'static str)> {
    let mut events = Vec::new();
    for (side, context) in [(Side::Left, "Left"), (Side::Right, "Right")] {
        let labels = &detection.principal().foot(side).planted;
        for range in intervals(labels) {
            events.extend((range.start > 0).then_some((range.start, context, "Foot Strike")));
            events.extend((range.end < labels.len()).then_some((range.end, context, "Foot Off")));
        }
    }
    sort::sort_by_frames(events, |event| (event.0, 0))
}

/// Feet and parts in the order of the columns: left before right, contact, heel, toe.
pub(crate) fn columns(detection: &Detection) -> impl Iterator<Item = (Side, Part)> + '_ {
    let parts =
        [Part::Contact, Part::Heel, Part::Toe].into_iter().filter(|&part| detection.part(part).is_some());
    Side::BOTH.into_iter().flat_map(move |side| parts.clone().map(move |part| (side, part)))
}

/// The columns' names, that of the root first where the clip has several.
fn head<'a>(mut roots: impl Iterator<Item = Option<&'a str>>, columns: &str) -> String {
    format!("{}{columns}", if roots.any(|root| root.is_some()) { "root," } else { "" })
}

/// The root's name as a CSV field with its comma.
fn field(root: Option<&str>) -> String {
    root.map_or_else(String::new, |name| format!("{},", csv::field(name)))
}

/// The time of a frame in seconds, to the microsecond.
fn seconds(frame: usize, frame_time: f64) -> f64 {
    (frame as f64 * frame_time * 1e6).round() / 1e6
}
