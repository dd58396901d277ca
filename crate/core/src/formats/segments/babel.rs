//! Segments in the format of BABEL (Punnakkal et al., CVPR 2021): an object of sequences, each with
//! actions in seconds. Unknown values are null.

use std::collections::BTreeMap;
use std::path::Path;

use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::formats::document::{ReadError, to_json};
use crate::formats::format_info::FormatInfo;
use crate::formats::segments::document::SegmentsDocument;
use crate::formats::segments::export::{Reader, Writer};
use crate::formats::segments::file::{TimedAction, TimedActions};

pub(super) const FORMAT_INFO: FormatInfo<Writer, Reader> = FormatInfo {
    name: "babel",
    title: "BABEL",
    description: "Actions in the format of BABEL.",
    extension: "babel.json",
    media_type: "application/json",
    write: |export| babel_json(&export.documents).into_bytes(),
    // BABEL files are JSON and are read with the other JSON files.
    read: None,
};

/// One motion with its actions.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
struct Sequence {
    babel_sid: Value,
    /// Path of the motion.
    feat_p: Option<String>,
    /// Duration, in seconds.
    dur: Option<f64>,
    /// Labels of the whole motion.
    seq_ann: Option<Annotation>,
    /// Labels with times.
    frame_ann: Option<Annotation>,
}

#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
struct Annotation {
    babel_lid: Value,
    anntr_id: Value,
    mul_act: Option<bool>,
    labels: Vec<Action>,
}

#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
struct Action {
    raw_label: Option<String>,
    proc_label: Option<String>,
    seg_id: Value,
    act_cat: Option<Vec<String>>,
    start_t: Option<f64>,
    end_t: Option<f64>,
}

/// Returns a BABEL file with one sequence per document, under the name of its clip.
///
/// If the clip has several skeletons, the name of the root follows. Segments without a label are named
/// by their number, as in `segment 3`. Their category is the name of the action.
fn babel_json(documents: &[SegmentsDocument]) -> String {
    let mut sequences = BTreeMap::new();
    // Collecting would sort, which is compiled for each type of items.
    sequences.extend(documents.iter().map(sequence));
    to_json(&sequences)
}

fn sequence(document: &SegmentsDocument) -> (String, Sequence) {
    let stem = stem(&document.header.source.name);
    let name = match &document.header.root {
        Some(root) => format!("{stem} {root}"),
        None => stem.into(),
    };
    let labels = document.segments.iter().enumerate().map(|(index, segment)| Action {
        raw_label: Some(if segment.label.is_empty() { default_name(index) } else { segment.label.clone() }),
        proc_label: (!segment.label.is_empty()).then(|| segment.label.clone()),
        seg_id: (index + 1).to_string().into(),
        act_cat: (!segment.action.is_empty()).then(|| vec![segment.action.clone()]),
        start_t: Some(segment.frames.start_s),
        end_t: Some(segment.frames.end_s),
    });
    let annotation = Annotation { mul_act: Some(document.segments.len() > 1), ..Annotation::default() };
    let sequence = Sequence {
        babel_sid: Value::Null,
        feat_p: Some(document.header.source.name.clone()),
        dur: Some(document.header.frames as f64 / document.header.rate),
        frame_ann: Some(Annotation { labels: labels.collect(), ..annotation.clone() }),
        seq_ann: Some(annotation),
    };
    (name, sequence)
}

/// Returns the name of a segment without a label.
fn default_name(index: usize) -> String {
    format!("segment {}", index + 1)
}

/// Reads the actions of a sequence that have times.
pub(crate) fn read_sequence(sequence: Value) -> Result<TimedActions, ReadError> {
    let sequence: Sequence = serde_json::from_value(sequence)?;
    let labels = sequence.frame_ann.unwrap_or_default().labels;
    let actions = labels.into_iter().enumerate().filter_map(|(index, action)| {
        Some(TimedAction {
            start: action.start_t?,
            end: action.end_t?,
            label: action.raw_label.filter(|label| *label != default_name(index)).unwrap_or_default(),
            action: action.act_cat.unwrap_or_default().join(", "),
        })
    });
    Ok(TimedActions { duration: sequence.dur, actions: actions.collect() })
}

/// True if a value is a sequence.
pub(crate) fn is_sequence(value: &Value) -> bool {
    value["frame_ann"]["labels"].is_array()
}

/// True if a sequence belongs to a clip, by the name of its motion as in `.../86_01_poses.npz`.
pub(crate) fn belongs_to(value: &Value, clip: &str) -> bool {
    let motion = stem(value["feat_p"].as_str().unwrap_or_default());
    motion.strip_suffix("_poses").unwrap_or(motion) == clip
}

/// Returns the name of a file without folders and extension.
fn stem(path: &str) -> &str {
    Path::new(path).file_stem().and_then(|stem| stem.to_str()).unwrap_or(path)
}
