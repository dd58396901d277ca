//! The segments document: the actions of a clip as the JSON that is saved, shared and read back.

use std::ops::Range;

use serde::{Deserialize, Serialize};

use crate::bvh::Clip;
use crate::formats::plants::pretty;
use crate::formats::{Source, SpanSource, VERSION};
use crate::notice::Notice;
use crate::segments::{Kind, MethodOption, Segmentation, ValidParams};
use crate::skeleton::Skeleton;

/// What [`SegmentsDocument::format`] says.
pub const SEGMENTS_FORMAT: &str = "plantigrade-segments";

/// Actions of one clip with where they come from.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SegmentsDocument {
    /// Always [`SEGMENTS_FORMAT`].
    pub format: String,
    /// Always [`VERSION`] in what is written.
    pub version: u32,
    /// The clip that the segments belong to.
    pub source: Source,
    /// Name of the root joint, where the clip has several skeletons.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub root: Option<String>,
    /// Number of frames in the clip.
    pub frames: usize,
    /// Frames per second, after any override.
    pub rate: f64,
    /// How the segments were made.
    pub method: SegmentsMethod,
    /// The segments in order: they tile the clip, from frame 0 to the last.
    pub segments: Vec<SegmentSpan>,
    /// Frames in which one action goes over into the next; the cut lies within.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub transitions: Vec<Stretch>,
    /// The pieces of motion between turning points.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub motifs: Vec<MotifSpan>,
    /// What the reader and the method had to say.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub notices: Vec<Notice>,
}

/// The method that made the segments, with those of its parameters that matter to it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SegmentsMethod {
    /// `auto`, `lsd`, ...; `truth` where the segments are known from elsewhere.
    pub name: String,
    /// Dimensions kept.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub dims: Option<usize>,
    /// `absolute` or `ratio`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub residual: Option<String>,
    /// `mean`, `tpose` or the number of a frame.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub template: Option<String>,
    /// Whether the method kept to the letter of what was published.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub published: Option<bool>,
}

/// A run of frames: `[start, end)`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Stretch {
    /// First frame.
    pub start: usize,
    /// First frame after it.
    pub end: usize,
    /// `start` in seconds from the clip's start.
    pub start_s: f64,
    /// `end` in seconds from the clip's start.
    pub end_s: f64,
}

/// One action.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SegmentSpan {
    /// When it happens.
    #[serde(flatten)]
    pub stretch: Stretch,
    /// What kind of action it is.
    pub kind: Kind,
    /// Its name; empty where there is none.
    #[serde(default)]
    pub label: String,
    /// Who says so.
    pub source: SpanSource,
}

/// The motion from one turning point to the next: `[start, end)`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MotifSpan {
    /// First frame.
    pub start: usize,
    /// First frame after it.
    pub end: usize,
    /// Motifs that are alike have the same number, from 1.
    pub class: usize,
    /// How far the method's curve goes in it; negative where it falls.
    pub amplitude: f64,
}

impl Stretch {
    /// Frames at `rate` frames per second.
    pub fn of(frames: Range<usize>, rate: f64) -> Stretch {
        let [start_s, end_s] = [frames.start, frames.end].map(|frame| frame as f64 / rate);
        Stretch { start: frames.start, end: frames.end, start_s, end_s }
    }
}

impl SegmentsMethod {
    fn of(params: &ValidParams) -> SegmentsMethod {
        let method = params.method();
        let matters = |option| method.options().contains(&option);
        SegmentsMethod {
            name: method.name().into(),
            dims: params.dims(),
            residual: matters(MethodOption::Residual).then(|| params.residual().to_string()),
            template: matters(MethodOption::Template).then(|| params.template().to_string()),
            published: matters(MethodOption::Published).then(|| params.published()),
        }
    }
}

impl SegmentsDocument {
    /// The document of the actions that were found in a clip, whose reader gave `notices`.
    pub fn of(
        source: Source,
        clip: &Clip,
        skeleton: &Skeleton,
        segmentation: &Segmentation,
        notices: &[Notice],
    ) -> SegmentsDocument {
        let rate = clip.rate();
        let segments = segmentation.segments.iter().map(|segment| SegmentSpan {
            stretch: Stretch::of(segment.frames.clone(), rate),
            kind: segment.kind,
            label: segment.label.clone(),
            source: SpanSource::Auto,
        });
        let motifs = segmentation.motifs.iter().map(|motif| MotifSpan {
            start: motif.frames.start,
            end: motif.frames.end,
            class: motif.class,
            amplitude: motif.amplitude,
        });
        let several = clip.roots().count() > 1;
        SegmentsDocument {
            format: SEGMENTS_FORMAT.into(),
            version: VERSION,
            source,
            root: several.then(|| clip.joints()[skeleton.root].name.clone()),
            frames: clip.frame_count(),
            rate,
            method: SegmentsMethod::of(&segmentation.params),
            segments: segments.collect(),
            transitions: segmentation
                .transitions
                .iter()
                .map(|range| Stretch::of(range.clone(), rate))
                .collect(),
            motifs: motifs.collect(),
            notices: [notices, &skeleton.notices, &segmentation.notices].concat(),
        }
    }

    /// Gives the segments a person's names, in order; those that change are [`SpanSource::Edited`].
    pub fn with_labels(&mut self, labels: &[String]) {
        for (segment, label) in self.segments.iter_mut().zip(labels) {
            if segment.label != *label {
                segment.label.clone_from(label);
                segment.source = SpanSource::Edited;
            }
        }
    }

    /// The document as JSON, indented, with a line end.
    pub fn to_json(&self) -> String {
        pretty(self)
    }

    /// Several documents as a JSON array: one for each skeleton of a clip.
    pub fn all_to_json(documents: &[SegmentsDocument]) -> String {
        pretty(documents)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::segments::{Method, Params, Template};

    #[test]
    fn only_what_matters_to_the_method_is_told() {
        let of = |method| {
            let params = Params { method, dims: Some(3), template: Template::Frame(7), ..Params::default() };
            let json = serde_json::to_value(SegmentsMethod::of(&params.check().unwrap())).unwrap();
            json.as_object()
                .unwrap()
                .iter()
                .map(|(name, value)| format!("{name}={value}"))
                .collect::<Vec<_>>()
        };
        assert_eq!(of(Method::Auto), ["name=\"auto\""]);
        assert_eq!(of(Method::Lsd), ["name=\"lsd\"", "published=false", "template=\"7\""]);
        assert_eq!(of(Method::PcaTail), ["dims=3", "name=\"pca-tail\""]);
        assert_eq!(of(Method::Mvu), ["dims=3", "name=\"mvu\"", "published=false", "residual=\"absolute\""]);
    }

    #[test]
    fn names_that_change_are_a_persons() {
        let text = r#"{"format": "plantigrade-segments", "version": 1, "source": {"name": "a.bvh"},
            "frames": 3, "rate": 30, "method": {"name": "auto"}, "segments": [
            {"start": 0, "end": 1, "start_s": 0, "end_s": 0.1, "kind": "action", "source": "auto"},
            {"start": 1, "end": 3, "start_s": 0.1, "end_s": 0.2, "kind": "periodic", "label": "1 2",
             "source": "auto"}]}"#;
        let mut document: SegmentsDocument = serde_json::from_str(text).unwrap();
        document.with_labels(&["walk".into(), "1 2".into(), "one too many".into()]);
        let told: Vec<_> = document.segments.iter().map(|span| (span.label.as_str(), span.source)).collect();
        assert_eq!(told, [("walk", SpanSource::Edited), ("1 2", SpanSource::Auto)]);
    }
}
