//! Segments as a CSV table.

use std::fmt::Write;

use crate::formats::csv::{self, root_field, seconds, table_header};
use crate::formats::document::ReadError;
use crate::formats::format_info::FormatInfo;
use crate::formats::segments::document::{self, SegmentsDocument};
use crate::formats::segments::export::{Reader, Writer};
use crate::formats::segments::file::{FileSegment, SegmentFile, is_tab_delimited};
use crate::segments::Kind;

pub(super) const FORMAT_INFO: FormatInfo<Writer, Reader> = FormatInfo {
    name: "csv",
    title: "Table",
    description: "One row per segment.",
    extension: "segments.csv",
    media_type: "text/csv",
    write: |export| segments_csv(&export.documents).into_bytes(),
    read: Some(Reader { recognises: |text| !text.starts_with(['{', '[']) && !is_tab_delimited(text), read }),
};

/// Columns after the name of the root.
const COLUMNS: &str = "start_frame,end_frame,start_s,end_s,kind,label,action,period_s,cycles";

/// Returns one row per segment with [`COLUMNS`]; frames are half-open. The rows cover the clip from frame 0
/// without gaps. Period and number of cycles are empty if the action does not repeat.
///
/// With several skeletons, the table begins with a column `root`.
fn segments_csv(documents: &[SegmentsDocument]) -> String {
    let roots = documents.iter().map(|document| document.header.root.as_deref());
    let mut text = table_header(roots, &format!("{COLUMNS}\n"));
    let number = |number: Option<f64>| number.map_or_else(String::new, |number| number.to_string());
    for SegmentsDocument { header, segments, .. } in documents {
        for segment in segments {
            let (start, end) = (segment.frames.start, segment.frames.end);
            let _ = writeln!(
                text,
                "{}{start},{end},{},{},{},{},{},{},{}",
                root_field(header.root.as_deref()),
                seconds(start, 1.0 / header.rate),
                seconds(end, 1.0 / header.rate),
                segment.kind.name(),
                csv::field(&segment.label),
                csv::field(&segment.action),
                number(segment.period_s),
                number(segment.cycles),
            );
        }
    }
    text
}

fn read(text: &str, _clip: &str) -> Result<SegmentFile, ReadError> {
    let (header, rows) = csv::table(text)?;
    let column = |name| csv::column(&header, name);
    let (Some(start), Some(end), Some(label)) = (column("start_frame"), column("end_frame"), column("label"))
    else {
        return Err(ReadError::NoSegments);
    };
    let kinds = column("kind");
    let [action, period, cycles] = ["action", "period_s", "cycles"].map(column);
    let part = |row: csv::Row| {
        let frame = |column| {
            let found = row.field(column);
            found.and_then(|text| text.parse().ok()).ok_or_else(|| row.unexpected("a frame", found))
        };
        let kind = match kinds.map(|column| row.field(column)) {
            None => Kind::Action,
            Some(found) => Kind::ALL
                .into_iter()
                .find(|kind| Some(kind.name()) == found)
                .ok_or_else(|| row.unexpected("a kind", found))?,
        };
        let number = |column: Option<usize>| match column.and_then(|column| row.field(column)) {
            None | Some("") => Ok(None),
            found => found
                .and_then(|text| text.parse().ok())
                .map(Some)
                .ok_or_else(|| row.unexpected("a number", found)),
        };
        let label = row.field(label).unwrap_or_default();
        let mut part = FileSegment::new(frame(start)?..frame(end)?, kind, label);
        part.segment.action = action.and_then(|column| row.field(column)).unwrap_or_default().into();
        part.segment.cycles = document::cycles(number(period)?, number(cycles)?);
        Ok(part)
    };
    Ok(SegmentFile::Table(rows.into_iter().map(part).collect::<Result<_, ReadError>>()?))
}
