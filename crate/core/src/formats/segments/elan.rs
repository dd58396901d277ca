//! Segments as tab-delimited text, which ELAN imports and exports: one row per annotation of a tier.

use std::fmt::Write;

use crate::formats::csv::seconds;
use crate::formats::document::ReadError;
use crate::formats::format_info::FormatInfo;
use crate::formats::segments::document::SegmentsDocument;
use crate::formats::segments::export::{Reader, Writer};
use crate::formats::segments::file::{
    SegmentFile, TimedAction, TimedActions, is_tab_delimited, parse_seconds, tab_field,
};

pub(super) const FORMAT_INFO: FormatInfo<Writer, Reader> = FormatInfo {
    name: "elan",
    title: "ELAN tiers",
    description: "Tab-delimited text for ELAN, with a tier of actions and one of labels.",
    extension: "elan.txt",
    media_type: "text/tab-separated-values",
    write: |export| tiers(&export.documents).into_bytes(),
    read: Some(Reader { recognises: |text| is_tab_delimited(text) && text.starts_with("Tier\t"), read }),
};

const COLUMNS: [&str; 4] = ["Tier", "Begin Time - ss.msec", "End Time - ss.msec", "Annotation"];

/// Tier with the names of the actions. Every segment has an annotation in it.
const ACTION: &str = "action";

/// Tier with the labels.
const LABEL: &str = "label";

/// Returns the names of the actions and the labels as tiers. With the tiers of several skeletons, the name of the
/// root precedes that of the tier; those of one skeleton are read back.
fn tiers(documents: &[SegmentsDocument]) -> String {
    let mut text = COLUMNS.join("\t") + "\n";
    for SegmentsDocument { header, segments, .. } in documents {
        let root = header.root.as_ref().filter(|_| documents.len() > 1);
        let root = root.map_or_else(String::new, |root| tab_field(&format!("{root} ")));
        for tier in [ACTION, LABEL] {
            for segment in segments {
                let annotation = if tier == ACTION { &segment.action } else { &segment.label };
                if tier == LABEL && annotation.is_empty() {
                    continue;
                }
                let [start, end] =
                    [segment.frames.start, segment.frames.end].map(|frame| seconds(frame, 1.0 / header.rate));
                let _ = writeln!(text, "{root}{tier}\t{start:.6}\t{end:.6}\t{}", tab_field(annotation));
            }
        }
    }
    text
}

/// Reads annotations; those of other tiers than that of the actions are labels. Without actions, each label
/// is a segment.
fn read(text: &str, _clip: &str) -> Result<SegmentFile, ReadError> {
    let mut lines = text.lines().enumerate();
    let columns: Vec<&str> = lines.next().unwrap_or_default().1.split('\t').map(str::trim).collect();
    let column = |name: &str| columns.iter().position(|column| *column == name).ok_or(ReadError::NoSegments);
    let [start, end, annotation] = [column(COLUMNS[1])?, column(COLUMNS[2])?, column(COLUMNS[3])?];
    let (mut actions, mut labels) = (Vec::new(), Vec::new());
    for (index, line) in lines.filter(|(_, line)| !line.trim().is_empty()) {
        let fields: Vec<&str> = line.split('\t').collect();
        let field = |column: usize| fields.get(column).copied().unwrap_or_default();
        let mut action = TimedAction {
            start: parse_seconds(field(start), index + 1)?,
            end: parse_seconds(field(end), index + 1)?,
            label: field(annotation).trim().to_owned(),
            action: String::new(),
        };
        if field(0) == ACTION {
            std::mem::swap(&mut action.label, &mut action.action);
            actions.push(action);
        } else {
            labels.push(action);
        }
    }
    if actions.is_empty() {
        actions = labels;
    } else {
        for action in &mut actions {
            let label = labels.iter().find(|label| label.start == action.start && label.end == action.end);
            action.label = label.map_or_else(String::new, |label| label.label.clone());
        }
    }
    Ok(SegmentFile::Timed(TimedActions { duration: None, actions }))
}
