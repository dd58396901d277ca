//! Segments in the shape of BABEL (Punnakkal et al., CVPR 2021), which others' tools read:
//! an object of sequences, each with actions in seconds. What is not known is null.

use std::collections::BTreeMap;
use std::path::Path;

use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::formats::SegmentsDocument;
use crate::formats::plants::pretty;

/// One motion with its actions.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub(crate) struct Sequence {
    babel_sid: Value,
    /// Path of the motion.
    feat_p: Option<String>,
    /// Duration in seconds.
    dur: Option<f64>,
    /// What happens in the whole.
    seq_ann: Option<Annotation>,
    /// What happens when.
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

/// Segments in BABEL's shape, as JSON: a sequence for each document, under its clip's name.
///
/// Where the clip has several skeletons, the root's name follows. Segments without a name
/// are called `segment 3`.
pub fn babel_json(documents: &[SegmentsDocument]) -> String {
    let sequences: BTreeMap<String, Sequence> = documents.iter().map(sequence).collect();
    pretty(&sequences)
}

fn sequence(document: &SegmentsDocument) -> (String, Sequence) {
    let stem = stem(&document.source.name);
    let name = match &document.root {
        Some(root) => format!("{stem} {root}"),
        None => stem.into(),
    };
    let labels = document.segments.iter().enumerate().map(|(index, segment)| Action {
        raw_label: Some(if segment.label.is_empty() { unnamed(index) } else { segment.label.clone() }),
        proc_label: (!segment.label.is_empty()).then(|| segment.label.clone()),
        seg_id: (index + 1).to_string().into(),
        act_cat: None,
        start_t: Some(segment.stretch.start_s),
        end_t: Some(segment.stretch.end_s),
    });
    let whole = Annotation { mul_act: Some(document.segments.len() > 1), ..Annotation::default() };
    let sequence = Sequence {
        babel_sid: Value::Null,
        feat_p: Some(document.source.name.clone()),
        dur: Some(document.frames as f64 / document.rate),
        frame_ann: Some(Annotation { labels: labels.collect(), ..whole.clone() }),
        seq_ann: Some(whole),
    };
    (name, sequence)
}

/// A segment that nobody named, by its place.
fn unnamed(index: usize) -> String {
    format!("segment {}", index + 1)
}

impl Sequence {
    /// Duration in seconds.
    pub fn seconds(&self) -> Option<f64> {
        self.dur
    }

    /// The actions that have times: start, end and name, which may be empty.
    pub fn actions(self) -> impl Iterator<Item = (f64, f64, String)> {
        let labels = self.frame_ann.unwrap_or_default().labels;
        labels.into_iter().enumerate().filter_map(|(index, action)| {
            let name = action.raw_label.filter(|name| *name != unnamed(index)).unwrap_or_default();
            Some((action.start_t?, action.end_t?, name))
        })
    }
}

/// Whether something is a sequence.
pub(crate) fn is_sequence(value: &Value) -> bool {
    value["frame_ann"]["labels"].is_array()
}

/// Whether a sequence is one of a clip: by the name of its motion, as in `.../86_01_poses.npz`.
pub(crate) fn is_of(value: &Value, clip: &str) -> bool {
    let motion = stem(value["feat_p"].as_str().unwrap_or_default());
    motion.strip_suffix("_poses").unwrap_or(motion) == clip
}

/// The name of a file without folders and ending.
fn stem(path: &str) -> &str {
    Path::new(path).file_stem().and_then(|stem| stem.to_str()).unwrap_or(path)
}
