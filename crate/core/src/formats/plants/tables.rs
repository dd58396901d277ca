//! Plants as CSV tables with named columns.
//!
//! With several skeletons, every table begins with a column `root`.

use std::fmt::Write;

use crate::foot::{Part, Side};
use crate::formats::csv::{self, root_field, seconds, table_header};
use crate::formats::document::ReadError;
use crate::formats::format_info::{FormatInfo, text_of};
use crate::formats::plants::events::{GaitEvent, events, part_events};
use crate::formats::plants::export::{DetectionRef, PlantExport, Reader, Writer};
use crate::intervals::intervals;
use crate::plants::{Annotation, Detection};

pub(super) const FRAMES: FormatInfo<Writer, Reader> = FormatInfo {
    name: "csv",
    title: "Every frame",
    description: "One row per frame, with a column of 0 and 1 per foot and part.",
    extension: "frames.csv",
    media_type: "text/csv",
    write: |export| frames_csv(export).into_bytes(),
    read: Some(Reader { recognises: is_frames_csv, read: read_frames_csv }),
};

pub(super) const INTERVALS: FormatInfo<Writer, Reader> = FormatInfo {
    name: "intervals",
    title: "Every plant",
    description: "One row per plant, with its frames and times.",
    extension: "intervals.csv",
    media_type: "text/csv",
    write: |export| intervals_csv(export).into_bytes(),
    read: Some(Reader { recognises: is_intervals_csv, read: read_intervals_csv }),
};

pub(super) const EVENTS: FormatInfo<Writer, Reader> = FormatInfo {
    name: "events",
    title: "Gait events",
    description: "One row per foot strike and foot off.",
    extension: "events.csv",
    media_type: "text/csv",
    write: |export| events_csv(export, |detection, _| events(detection)).into_bytes(),
    read: None,
};

pub(super) const PART_EVENTS: FormatInfo<Writer, Reader> = FormatInfo {
    name: "part-events",
    title: "Heel and toe events",
    description: "Gait events, with heel strike, toe strike, foot flat, heel off and toe off.",
    extension: "part-events.csv",
    media_type: "text/csv",
    write: |export| events_csv(export, part_events).into_bytes(),
    read: None,
};

/// Returns one row per frame: `frame,time,left_contact,left_heel,left_toe,right_contact,...`.
///
/// Labels are 0 or 1; parts without labels have no columns. Times are in seconds.
fn frames_csv(export: &PlantExport) -> String {
    let labelled = export.labelled();
    let mut text = table_header(labelled.iter().map(|labelled| labelled.root), "frame,time");
    let Some(first) = labelled.first() else { return text };
    for (side, part) in columns(first.detection) {
        let _ = write!(text, ",{}_{}", side.name(), part.name());
    }
    text.push('\n');
    for DetectionRef { root, detection } in labelled {
        let columns: Vec<&[bool]> = columns(detection)
            .filter_map(|(side, part)| Some(detection.part(part)?.foot(side).planted.as_slice()))
            .collect();
        for frame in 0..columns.first().map_or(0, |labels| labels.len()) {
            let time = seconds(frame, export.clip.frame_time());
            let _ = write!(text, "{}{frame},{time}", root_field(root));
            for labels in &columns {
                let _ = write!(text, ",{}", u8::from(labels[frame]));
            }
            text.push('\n');
        }
    }
    text
}

/// Returns one row per plant: `foot,part,start_frame,end_frame,start_s,end_s`, half-open.
fn intervals_csv(export: &PlantExport) -> String {
    let labelled = export.labelled();
    let roots = labelled.iter().map(|labelled| labelled.root);
    let mut text = table_header(roots, "foot,part,start_frame,end_frame,start_s,end_s\n");
    for DetectionRef { root, detection } in labelled {
        for (side, part) in columns(detection) {
            let labels = detection.part(part).map(|labels| labels.foot(side).planted.as_slice());
            for range in intervals(labels.unwrap_or_default()) {
                let [start_s, end_s] =
                    [range.start, range.end].map(|frame| seconds(frame, export.clip.frame_time()));
                let _ = writeln!(
                    text,
                    "{}{},{},{},{},{start_s},{end_s}",
                    root_field(root),
                    side.name(),
                    part.name(),
                    range.start,
                    range.end,
                );
            }
        }
    }
    text
}

/// Returns one row per event that `events_of` returns, given the time between frames:
/// `time,frame,context,event,uncertainty_ms` with `Left` or `Right` and a name such as `Foot Strike`, in
/// order of time.
///
/// Times are in seconds; if an event is known to the frame only, its time is that of the frame and its
/// uncertainty is empty. The frame is the first one after the event. Contact that begins or ends with the
/// clip is not an event.
fn events_csv(export: &PlantExport, events_of: fn(&Detection, f64) -> Vec<GaitEvent>) -> String {
    let labelled = export.labelled();
    let roots = labelled.iter().map(|labelled| labelled.root);
    let mut text = table_header(roots, "time,frame,context,event,uncertainty_ms\n");
    for DetectionRef { root, detection } in labelled {
        for event in events_of(detection, export.clip.frame_time()) {
            let (root, time) = (root_field(root), event.time(export.clip.frame_time()));
            let uncertainty =
                event.instant.map_or_else(String::new, |instant| instant.uncertainty_ms.to_string());
            let (frame, context, name) = (event.frame, event.context(), event.kind.title());
            let _ = writeln!(text, "{root}{time},{frame},{context},{name},{uncertainty}");
        }
    }
    text
}

/// Returns sides and parts in the order of the columns: left before right, contact, heel, toe.
pub(super) fn columns(detection: &Detection) -> impl Iterator<Item = (Side, Part)> + '_ {
    let parts =
        [Part::Contact, Part::Heel, Part::Toe].into_iter().filter(|&part| detection.part(part).is_some());
    Side::BOTH.into_iter().flat_map(move |side| parts.clone().map(move |part| (side, part)))
}

fn is_frames_csv(bytes: &[u8]) -> bool {
    header_has(bytes, &["left_"])
}

fn is_intervals_csv(bytes: &[u8]) -> bool {
    header_has(bytes, &["foot", "part", "start_frame"])
}

/// True if the first line of a file contains the names.
fn header_has(bytes: &[u8], names: &[&str]) -> bool {
    let header = text_of(bytes).and_then(|text| text.lines().next());
    header.is_some_and(|header| names.iter().all(|name| header.contains(name)))
}

/// Reads plants; a part that occurs is not planted in the other frames. A table without rows states that no
/// foot is in contact.
fn read_intervals_csv(bytes: &[u8], frames: usize) -> Result<Annotation, ReadError> {
    let (header, rows) = csv::table(text_of(bytes).unwrap_or_default())?;
    let columns = ["foot", "part", "start_frame", "end_frame"].map(|name| csv::column(&header, name));
    let mut labels = Part::ALL.map(|part| (part, Side::BOTH.map(|_| vec![Some(false); frames])));
    let mut occurs = Part::ALL.map(|_| false);
    for row in rows {
        let fields = columns.map(|column| row.field(column?));
        let [foot, part, start, end] = fields;
        let side = Side::BOTH.iter().position(|side| Some(side.name()) == foot);
        let side = side.ok_or_else(|| row.unexpected("left or right", foot))?;
        let part_index = Part::ALL.iter().position(|other| Some(other.name()) == part);
        let part = part_index.ok_or_else(|| row.unexpected("contact, toe or heel", part))?;
        let [start, end] = [start, end].map(|field| field.and_then(|text| text.parse::<usize>().ok()));
        match (start, end) {
            (Some(start), Some(end)) if start < end && end <= frames => {
                labels[part].1[side][start..end].fill(Some(true));
            }
            _ => {
                let expected = format!("start_frame before end_frame, and end_frame at most {frames}");
                return Err(row.unexpected(&expected, fields[3]));
            }
        }
        occurs[part] = true;
    }
    occurs[0] |= occurs == [false; 3];
    Ok(Annotation {
        parts: labels.into_iter().zip(occurs).filter_map(|(part, occurs)| occurs.then_some(part)).collect(),
    })
}

/// Reads a table with one row per frame.
fn read_frames_csv(bytes: &[u8], _frames: usize) -> Result<Annotation, ReadError> {
    let (header, rows) = csv::table(text_of(bytes).unwrap_or_default())?;
    let column = |side: Side, part: Part| csv::column(&header, &format!("{}_{}", side.name(), part.name()));
    let columns: Vec<(Part, [usize; 2])> = Part::ALL
        .into_iter()
        .filter_map(|part| Some((part, [column(Side::Left, part)?, column(Side::Right, part)?])))
        .collect();
    let frame_column = csv::column(&header, "frame");
    let mut parts: Vec<_> = columns.iter().map(|(part, _)| (*part, [Vec::new(), Vec::new()])).collect();
    for (frame, row) in rows.into_iter().enumerate() {
        if let Some(column) = frame_column {
            let found = row.field(column);
            if found.and_then(|text| text.parse().ok()) != Some(frame) {
                return Err(row.unexpected(&format!("frame {frame}"), found));
            }
        }
        for ((_, indices), (_, feet)) in columns.iter().zip(&mut parts) {
            for (index, labels) in indices.iter().zip(feet) {
                labels.push(match row.field(*index) {
                    Some("1") => Some(true),
                    Some("0") => Some(false),
                    Some("-1" | "") => None,
                    found => return Err(row.unexpected("0, 1 or -1", found)),
                });
            }
        }
    }
    Ok(Annotation { parts })
}
