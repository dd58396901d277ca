//! The segments document, annotated segments and BABEL files as JSON.

use serde_json::{Map, Value};

use crate::formats::document::{ReadError, from_json, only_document, to_json};
use crate::formats::format_info::FormatInfo;
use crate::formats::segments::babel;
use crate::formats::segments::document::SegmentsDocument;
use crate::formats::segments::export::{Reader, SegmentExport, Writer};
use crate::formats::segments::file::SegmentFile;

pub(super) const FORMAT_INFO: FormatInfo<Writer, Reader> = FormatInfo {
    name: "json",
    title: "Segments",
    description: "Segments with the parameters that were used.",
    extension: "segments.json",
    media_type: "application/json",
    write,
    read: Some(Reader { recognises: |text| text.starts_with(['{', '[']), read }),
};

fn write(export: &SegmentExport) -> Vec<u8> {
    if export.as_array { to_json(&export.documents) } else { to_json(&export.documents[0]) }.into_bytes()
}

fn read(text: &str, clip: &str) -> Result<SegmentFile, ReadError> {
    let mut value = only_document(serde_json::from_str(text)?)?;
    if value["format"] == SegmentsDocument::FORMAT {
        return Ok(SegmentFile::Document(Box::new(from_json(value)?)));
    }
    let is_bare = value.get_mut("segments").is_some_and(is_annotation);
    let clips = value.as_object_mut().ok_or(ReadError::NoSegments)?;
    match key_of(clips, clip).and_then(|name| clips.remove(&name)) {
        Some(sequence) if babel::is_sequence(&sequence) => {
            Ok(SegmentFile::Timed(babel::read_sequence(sequence)?))
        }
        Some(mut actions) => {
            Ok(SegmentFile::Annotation(serde_json::from_value(action_list(&mut actions).take())?))
        }
        None if is_bare => Ok(SegmentFile::Annotation(serde_json::from_value(value["segments"].take())?)),
        None if clips.values_mut().any(|value| babel::is_sequence(value) || is_annotation(value)) => {
            Err(ReadError::NoClip(clip.into()))
        }
        None => Err(ReadError::NoSegments),
    }
}

/// Returns the key of a clip in a BABEL file or in annotated segments.
fn key_of(clips: &mut Map<String, Value>, clip: &str) -> Option<String> {
    let has_segments = |value: &mut Value| babel::is_sequence(value) || is_annotation(value);
    if clips.get_mut(clip).is_some_and(has_segments) {
        return Some(clip.into());
    }
    // The keys of BABEL's sequences are not clip names.
    let is_only = clips.len() == 1;
    let mut sequences = clips.iter().filter(|(_, value)| babel::is_sequence(value));
    sequences.find(|(_, value)| is_only || babel::belongs_to(value, clip)).map(|(name, _)| name.clone())
}

/// Returns the list of actions in an entry of annotated segments.
fn action_list(entry: &mut Value) -> &mut Value {
    if entry.get("segments").is_some() { &mut entry["segments"] } else { entry }
}

fn is_annotation(entry: &mut Value) -> bool {
    action_list(entry).get(0).is_some_and(|action| action["end"].is_number())
}
