//! Segments with names for engines.

use crate::formats::segments::document::{DocumentSegment, SegmentsDocument};

/// Returns the segments of all skeletons with their names: the label, or else the name of the action; with
/// several skeletons after the name of the root.
pub(super) fn named_segments(documents: &[SegmentsDocument]) -> Vec<(String, &DocumentSegment)> {
    documents.iter().flat_map(of_document).collect()
}

fn of_document(document: &SegmentsDocument) -> Vec<(String, &DocumentSegment)> {
    let root = document.header.root.as_ref().map_or_else(String::new, |root| format!("{root} "));
    document.segments.iter().map(|segment| (format!("{root}{}", name(segment)), segment)).collect()
}

fn name(segment: &DocumentSegment) -> &str {
    match [&segment.label, &segment.action].into_iter().find(|name| !name.is_empty()) {
        Some(name) => name,
        None => segment.kind.name(),
    }
}

/// Returns the time from the first frame to the last, in seconds.
pub(super) fn duration(document: &SegmentsDocument) -> f64 {
    document.header.frames.saturating_sub(1) as f64 / document.header.rate
}
