//! Segments as a label track of Audacity: start, end and text of each label, separated by tabs.

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
    name: "audacity",
    title: "Audacity labels",
    description: "Label track for Audacity: start, end and label of each segment.",
    extension: "audacity.txt",
    media_type: "text/plain",
    write: |export| label_track(&export.documents).into_bytes(),
    read: Some(Reader {
        recognises: |text| {
            is_tab_delimited(text) && text.starts_with(|c: char| c.is_ascii_digit() || c == '-')
        },
        read,
    }),
};

/// Returns one line per segment: start and end in seconds, and its label or else the name of its action.
/// With the labels of several skeletons, the name of the root precedes the text; those of one skeleton are read back.
fn label_track(documents: &[SegmentsDocument]) -> String {
    let mut text = String::new();
    for SegmentsDocument { header, segments, .. } in documents {
        let root = header.root.as_ref().filter(|_| documents.len() > 1);
        let root = root.map_or_else(String::new, |root| format!("{root}: "));
        for segment in segments {
            let [start, end] =
                [segment.frames.start, segment.frames.end].map(|frame| seconds(frame, 1.0 / header.rate));
            let label = if segment.label.is_empty() { &segment.action } else { &segment.label };
            let _ = writeln!(text, "{start:.6}\t{end:.6}\t{}", tab_field(&format!("{root}{label}")));
        }
    }
    text
}

/// Reads labels. Lines that begin with a backslash have the frequencies of the label before.
fn read(text: &str, _clip: &str) -> Result<SegmentFile, ReadError> {
    let lines = text.lines().enumerate();
    let labels = lines.filter(|(_, line)| !line.trim().is_empty() && !line.starts_with('\\'));
    let action = |(index, line): (usize, &str)| {
        let mut fields = line.splitn(3, '\t');
        let mut next = || fields.next().unwrap_or_default();
        Ok(TimedAction {
            start: parse_seconds(next(), index + 1)?,
            end: parse_seconds(next(), index + 1)?,
            label: next().trim().to_owned(),
            action: String::new(),
        })
    };
    let actions = labels.map(action).collect::<Result<Vec<_>, ReadError>>()?;
    Ok(SegmentFile::Timed(TimedActions { duration: None, actions }))
}
