//! The plants document and contact annotations as JSON.

use serde::Deserialize;
use serde_json::Value;

use crate::foot::{Part, Side};
use crate::formats::document::{FrameRange, ReadError, from_json, only_document, to_json};
use crate::formats::format_info::{FormatInfo, text_of};
use crate::formats::plants::document::{Plant, PlantsDocument};
use crate::formats::plants::export::{PlantExport, Reader, Writer};
use crate::plants::Annotation;

pub(super) const FORMAT_INFO: FormatInfo<Writer, Reader> = FormatInfo {
    name: "json",
    title: "Labels",
    description: "Plants per foot and part, with the parameters that were used.",
    extension: "plants.json",
    media_type: "application/json",
    write,
    read: Some(Reader { recognises, read }),
};

/// Annotated contact per frame: 1, 0, or −1 for unknown.
#[derive(Deserialize)]
struct ContactFile {
    left: Vec<i8>,
    right: Vec<i8>,
}

fn write(export: &PlantExport) -> Vec<u8> {
    let documents = export.documents();
    if export.as_array { to_json(&documents) } else { to_json(&documents[0]) }.into_bytes()
}

fn recognises(bytes: &[u8]) -> bool {
    text_of(bytes).is_some_and(|text| text.trim_start().starts_with(['{', '[']))
}

fn read(bytes: &[u8], frames: usize) -> Result<Annotation, ReadError> {
    let value = only_document(serde_json::from_str(text_of(bytes).unwrap_or_default())?)?;
    if value["format"] == PlantsDocument::FORMAT {
        let document: PlantsDocument = from_json(value)?;
        // Checked first, as memory is used for the stated number of frames.
        return match document.header.frames {
            found if found == frames => document_annotation(&document),
            found => Err(ReadError::Length { found, frames }),
        };
    }
    if value["left"].is_null() || value["right"].is_null() {
        return Err(ReadError::NoPlants);
    }
    let ContactFile { left, right } = serde_json::from_value(value)?;
    if let Some(label) = left.iter().chain(&right).find(|label| !(-1..=1).contains(*label)) {
        return Err(ReadError::Invalid(format!("expected 0, 1 or -1, found {label}")));
    }
    let known = |labels: Vec<i8>| labels.into_iter().map(|label| (label >= 0).then_some(label > 0)).collect();
    Ok(Annotation { parts: vec![(Part::Contact, [known(left), known(right)])] })
}

/// Reads a plants document; `None` if the bytes are something else.
///
/// # Errors
/// If the document is malformed or has an unknown version.
pub(super) fn document(bytes: &[u8]) -> Result<Option<PlantsDocument>, ReadError> {
    let value: Option<Value> = text_of(bytes).and_then(|text| serde_json::from_str(text).ok());
    value.filter(|value| value["format"] == PlantsDocument::FORMAT).map(from_json).transpose()
}

/// Returns the labels of a document for the parts that both feet have.
///
/// # Errors
/// If a plant is empty or ends after the clip.
fn document_annotation(document: &PlantsDocument) -> Result<Annotation, ReadError> {
    let frames = document.header.frames;
    let parts = Side::BOTH.into_iter().flat_map(|side| Part::ALL.map(|part| document.foot(side).part(part)));
    for Plant { frames: range, .. } in parts.flatten().flatten() {
        if range.start >= range.end || range.end > frames {
            let FrameRange { start, end, .. } = range;
            let message = format!("a plant cannot last from frame {start} to {end} of {frames} frames");
            return Err(ReadError::Invalid(message));
        }
    }
    let part = |part: Part| {
        let [left, right] = Side::BOTH.map(|side| document.labels(side, part));
        let known = |labels: Vec<bool>| labels.into_iter().map(Some).collect();
        Some((part, [known(left?), known(right?)]))
    };
    Ok(Annotation { parts: Part::ALL.into_iter().filter_map(part).collect() })
}
