//! Labels from elsewhere: documents, truth files and tables.

use serde::Deserialize;
use serde::de::DeserializeOwned;
use serde_json::Value;

use crate::foot::{Part, Side};
use crate::formats::{Document, FORMAT, VERSION, csv, npz};
use crate::plants::Annotation;

/// Why labels cannot be read.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum LabelsError {
    /// Neither JSON nor a table.
    #[error(
        "these are no labels: neither a labels document, a truth file, a table per frame nor an archive of arrays"
    )]
    Unknown,
    /// Neither JSON with segments nor a table of them.
    #[error("these are no segments: neither a segments document, BABEL's, a truth file nor a table")]
    NoSegments,
    /// Segments of other clips.
    #[error("there are no segments of {0} in it")]
    NoClip(String),
    /// A document of a version to come.
    #[error("the document has version {0}, and this program knows version {VERSION}")]
    Version(u32),
    /// JSON or a table with something wrong in it.
    #[error("the labels cannot be read: {0}")]
    Wrong(String),
    /// Labels of another clip.
    #[error("the labels are of {found} frames, and the clip has {frames}")]
    Length {
        /// Frames of the labels.
        found: usize,
        /// Frames of the clip.
        frames: usize,
    },
}

/// A truth file: contact per frame, 1, 0 or −1 for unknown.
#[derive(Deserialize)]
struct TruthFile {
    left: Vec<i8>,
    right: Vec<i8>,
}

/// Reads labels of a clip of so many frames: a labels document, a truth file with
/// contact as `{"left": [0, 1, -1, ...], "right": [...]}`, or a table with a row
/// per frame and columns such as `left_toe`.
///
/// # Errors
/// If the text is none of these, or is of another number of frames.
pub fn read(text: &str, frames: usize) -> Result<Annotation, LabelsError> {
    let labelling = match text.trim_start().chars().next() {
        Some('{') => json(text)?,
        Some(_) if text.lines().next().is_some_and(|head| head.contains("left_")) => table(text)?,
        _ => return Err(LabelsError::Unknown),
    };
    checked(labelling, frames)
}

/// Reads labels of a clip of so many frames, as [`read`] does, or an archive of arrays as
/// [`npz`](crate::formats::npz()) writes it.
///
/// Of an archive the arrays `contacts` with its names in `columns` and `contact` with
/// `contact_columns` are read: booleans or numbers, 0, 1 or −1 (or NaN) for unknown. It may be
/// of [`npz`](crate::formats::npz()), `numpy.savez` or `numpy.savez_compressed`.
///
/// # Errors
/// If the bytes are none of these, or of another number of frames.
pub fn read_bytes(bytes: &[u8], frames: usize) -> Result<Annotation, LabelsError> {
    if npz::is_archive(bytes) {
        checked(npz::read(bytes, frames)?, frames)
    } else {
        let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        read(str::from_utf8(text).map_err(|_| LabelsError::Unknown)?, frames)
    }
}

/// Labels that are of a clip of so many frames.
fn checked(labelling: Annotation, frames: usize) -> Result<Annotation, LabelsError> {
    for labels in labelling.parts.iter().flat_map(|(_, feet)| feet) {
        if labels.len() != frames {
            return Err(LabelsError::Length { found: labels.len(), frames });
        }
    }
    if labelling.parts.is_empty() { Err(LabelsError::Unknown) } else { Ok(labelling) }
}

impl From<serde_json::Error> for LabelsError {
    fn from(error: serde_json::Error) -> LabelsError {
        LabelsError::Wrong(error.to_string())
    }
}

fn json(text: &str) -> Result<Annotation, LabelsError> {
    let value: Value = serde_json::from_str(text)?;
    if value["format"] == FORMAT {
        return Ok(of_document(&document(value)?));
    }
    let TruthFile { left, right } = serde_json::from_value(value).map_err(|_| LabelsError::Unknown)?;
    let known = |labels: Vec<i8>| labels.into_iter().map(|label| (label >= 0).then_some(label > 0)).collect();
    Ok(Annotation { parts: vec![(Part::Contact, [known(left), known(right)])] })
}

/// A document of ours, if this program knows its version.
pub(crate) fn document<T: DeserializeOwned>(value: Value) -> Result<T, LabelsError> {
    let version = value["version"].as_u64().unwrap_or(0) as u32;
    if version == VERSION { Ok(serde_json::from_value(value)?) } else { Err(LabelsError::Version(version)) }
}

/// The labels of a document, for the parts that both feet have.
fn of_document(document: &Document) -> Annotation {
    let part = |part: Part| {
        let [left, right] = Side::BOTH.map(|side| document.labels(side, part));
        let known = |labels: Vec<bool>| labels.into_iter().map(Some).collect();
        Some((part, [known(left?), known(right?)]))
    };
    Annotation { parts: Part::ALL.into_iter().filter_map(part).collect() }
}

fn table(text: &str) -> Result<Annotation, LabelsError> {
    let mut rows = csv::rows(text).into_iter();
    let head = rows.next().unwrap_or_default();
    if csv::column(&head, "root").is_some() {
        return Err(LabelsError::Wrong("tables of several skeletons are not compared".into()));
    }
    let column = |side: Side, part: Part| csv::column(&head, &format!("{}_{}", side.name(), part.name()));
    let columns: Vec<(Part, [usize; 2])> = Part::ALL
        .into_iter()
        .filter_map(|part| Some((part, [column(Side::Left, part)?, column(Side::Right, part)?])))
        .collect();
    let mut parts: Vec<_> = columns.iter().map(|(part, _)| (*part, [Vec::new(), Vec::new()])).collect();
    for row in rows {
        for ((_, places), (_, feet)) in columns.iter().zip(&mut parts) {
            for (place, labels) in places.iter().zip(feet) {
                labels.push(match row.field(*place) {
                    Some("1") => Some(true),
                    Some("0") => Some(false),
                    Some("-1" | "") => None,
                    found => return Err(row.wrong("0, 1 or -1", found)),
                });
            }
        }
    }
    Ok(Annotation { parts })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants::Edit;

    #[test]
    fn a_byte_order_mark_is_no_label() {
        let text = r#"{"left": [0, 1], "right": [1, 0]}"#;
        let marked = [b"\xef\xbb\xbf", text.as_bytes()].concat();
        assert_eq!(read_bytes(&marked, 2), read(text, 2));
        assert_eq!(read_bytes(b"\xff\xfe{", 2), Err(LabelsError::Unknown));
    }

    #[test]
    fn labels_become_ones_own_where_they_are_known() {
        let labelling = read(r#"{"left": [0, 1, 1, -1], "right": [-1, -1, -1, 1]}"#, 4).unwrap();
        let edit = |side, start, end, planted| Edit { side, part: Part::Contact, start, end, planted };
        let expected =
            [edit(Side::Left, 0, 1, false), edit(Side::Left, 1, 3, true), edit(Side::Right, 3, 4, true)];
        assert_eq!(labelling.edits(), expected);
    }

    #[test]
    fn truth_files_are_contact() {
        let read = read(r#"{"fps": 100, "left": [0, 1, -1], "right": [1, 1, 0]}"#, 3).unwrap();
        assert_eq!(read.part(Part::Contact).unwrap()[0], [Some(false), Some(true), None]);
        assert_eq!(read.part(Part::Toe), None);
    }

    #[test]
    fn tables_have_named_columns() {
        let text = "frame,time,left_toe,right_toe\n0,0,1,0\n1,0.1,,1\n";
        assert_eq!(read(text, 2).unwrap().part(Part::Toe).unwrap()[0], [Some(true), None]);
        assert!(matches!(read("left_toe,right_toe\nx,0\n", 1), Err(LabelsError::Wrong(_))));
    }

    #[test]
    fn refusals_say_why() {
        assert_eq!(read("hello", 3), Err(LabelsError::Unknown));
        assert_eq!(read("", 3), Err(LabelsError::Unknown));
        assert_eq!(read("{\"a\": 1}", 3), Err(LabelsError::Unknown));
        let text = format!("{{\"format\": \"{FORMAT}\", \"version\": 99}}");
        assert_eq!(read(&text, 3), Err(LabelsError::Version(99)));
        let truth = r#"{"left": [0], "right": [1]}"#;
        assert_eq!(read(truth, 3), Err(LabelsError::Length { found: 1, frames: 3 }));
    }
}
