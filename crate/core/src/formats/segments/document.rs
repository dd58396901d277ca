//! The segments document: JSON that is saved, shared and read back.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::bvh::Clip;
use crate::formats::document::{FrameRange, Header, Origin, Source};
use crate::notice::Notice;
use crate::segments::{Cycles, Kind, MethodOption, Segment, Segmentation, ValidParams};
use crate::skeleton::Skeleton;

/// Segments of one clip and their origin.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SegmentsDocument {
    /// Format, clip and frame rate.
    #[serde(flatten)]
    pub header: Header,
    /// Method with its parameters.
    pub method: SegmentsMethod,
    /// Segments in order; they cover the clip without gaps.
    pub segments: Vec<DocumentSegment>,
    /// Frame ranges in which one action changes into the next; the cut lies within.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub transitions: Vec<FrameRange>,
    /// Motion between turning points.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub motifs: Vec<DocumentMotif>,
    /// Notices of the reader and of the method.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub notices: Vec<Notice>,
}

/// Method of the segments, with the parameters that it uses.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SegmentsMethod {
    /// Name of the method; `truth` for annotated or generated segments.
    pub name: String,
    /// Number of dimensions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub dims: Option<usize>,
    /// `absolute` or `ratio`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub residual: Option<String>,
    /// `mean`, `tpose` or a frame number.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub template: Option<String>,
    /// True if the method follows its publication exactly.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub published: Option<bool>,
}

/// One segment.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct DocumentSegment {
    /// Frames and times.
    #[serde(flatten)]
    pub frames: FrameRange,
    /// Kind of action.
    pub kind: Kind,
    /// Label; empty if there is none.
    #[serde(default)]
    pub label: String,
    /// Name of the action, which all segments share in which the same is done; empty if unknown.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub action: String,
    /// Period of the action's cycles, in seconds, if it repeats.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub period_s: Option<f64>,
    /// Number of cycles, if the action repeats.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cycles: Option<f64>,
    /// Origin of the segment.
    pub source: Origin,
}

/// Motion between two turning points, as a half-open frame range.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct DocumentMotif {
    /// First frame.
    pub start: usize,
    /// First frame after the motif.
    pub end: usize,
    /// Class of similar motifs, from 1.
    pub class: usize,
    /// Change of the method's curve; negative if it falls.
    pub amplitude: f64,
}

impl DocumentSegment {
    /// Returns the segment without its times and origin.
    pub(crate) fn segment(self) -> Segment {
        let mut segment = Segment::new(self.frames.start..self.frames.end, self.kind, self.label);
        segment.action = self.action;
        segment.cycles = cycles(self.period_s, self.cycles);
        segment
    }
}

/// Returns the cycles if both their period and their number are known.
pub(crate) fn cycles(period_s: Option<f64>, count: Option<f64>) -> Option<Cycles> {
    Some(Cycles { period_s: period_s?, count: count? })
}

impl SegmentsMethod {
    fn new(params: &ValidParams) -> SegmentsMethod {
        let method = params.method();
        let uses = |option| method.options().contains(&option);
        SegmentsMethod {
            name: method.name().into(),
            dims: params.dims(),
            residual: uses(MethodOption::Residual).then(|| params.residual().to_string()),
            template: uses(MethodOption::Template).then(|| params.template().to_string()),
            published: uses(MethodOption::Published).then(|| params.published()),
        }
    }
}

impl SegmentsDocument {
    /// Value of [`Header::format`].
    pub const FORMAT: &'static str = "plantigrade-segments";

    /// Creates the document of a segmentation of a clip; `notices` are those of the reader.
    pub fn new(
        source: Source,
        clip: &Clip,
        skeleton: &Skeleton,
        segmentation: &Segmentation,
        notices: &[Notice],
    ) -> SegmentsDocument {
        let rate = clip.rate();
        let segments = segmentation.segments.iter().map(|segment| DocumentSegment {
            frames: FrameRange::new(segment.frames.clone(), rate),
            kind: segment.kind,
            label: segment.label.clone(),
            action: segment.action.clone(),
            period_s: segment.cycles.map(|cycles| (cycles.period_s * 1e3).round() / 1e3),
            cycles: segment.cycles.map(|cycles| (cycles.count * 10.0).round() / 10.0),
            source: Origin::Auto,
        });
        let motifs = segmentation.motifs.iter().map(|motif| DocumentMotif {
            start: motif.frames.start,
            end: motif.frames.end,
            class: motif.class,
            amplitude: motif.amplitude,
        });
        let transitions = segmentation.transitions.iter().map(|range| FrameRange::new(range.clone(), rate));
        SegmentsDocument {
            header: Header::new(SegmentsDocument::FORMAT, source, clip, skeleton),
            method: SegmentsMethod::new(&segmentation.params),
            segments: segments.collect(),
            transitions: transitions.collect(),
            motifs: motifs.collect(),
            notices: [notices, &skeleton.notices, &segmentation.notices].concat(),
        }
    }

    /// Renames the actions; names that the map does not have remain.
    pub fn rename_actions(&mut self, names: &BTreeMap<String, String>) {
        for segment in &mut self.segments {
            if let Some(name) = names.get(&segment.action) {
                segment.action.clone_from(name);
            }
        }
    }

    /// Sets the names of the actions of the segments, in order.
    pub fn set_actions(&mut self, names: &[String]) {
        for (segment, name) in self.segments.iter_mut().zip(names) {
            segment.action.clone_from(name);
        }
    }

    /// Sets the labels of the segments in order; segments whose label changes become [`Origin::Edited`].
    pub fn set_labels(&mut self, labels: &[String]) {
        for (segment, label) in self.segments.iter_mut().zip(labels) {
            if segment.label != *label {
                segment.label.clone_from(label);
                segment.source = Origin::Edited;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::segments::{Method, Params, Template};

    #[test]
    fn only_used_parameters_are_written() {
        let fields = |method| {
            let params = Params { method, dims: Some(3), template: Template::Frame(7), ..Params::default() };
            let json = serde_json::to_value(SegmentsMethod::new(&params.check().unwrap())).unwrap();
            json.as_object()
                .unwrap()
                .iter()
                .map(|(name, value)| format!("{name}={value}"))
                .collect::<Vec<_>>()
        };
        assert_eq!(fields(Method::Auto), ["name=\"auto\""]);
        assert_eq!(fields(Method::Lsd), ["name=\"lsd\"", "published=false", "template=\"7\""]);
        assert_eq!(fields(Method::PcaTail), ["dims=3", "name=\"pca-tail\""]);
        assert_eq!(
            fields(Method::Mvu),
            ["dims=3", "name=\"mvu\"", "published=false", "residual=\"absolute\""]
        );
    }

    #[test]
    fn actions_are_renamed() {
        let text = r#"{"format": "plantigrade-segments", "version": 1, "source": {"name": "a.bvh"},
            "frames": 3, "rate": 30, "method": {"name": "auto"}, "segments": [
            {"start": 0, "end": 1, "start_s": 0, "end_s": 0.1, "kind": "action", "action": "A", "source": "auto"},
            {"start": 1, "end": 3, "start_s": 0.1, "end_s": 0.2, "kind": "action", "action": "B",
             "period_s": 0.5, "cycles": 2.5, "source": "auto"}]}"#;
        let mut document: SegmentsDocument = serde_json::from_str(text).unwrap();
        document.rename_actions(&[("A".into(), "B".into()), ("B".into(), "F".into())].into());
        assert_eq!([0, 1].map(|segment| document.segments[segment].action.as_str()), ["B", "F"]);
        let read = document.segments.remove(1).segment();
        assert_eq!((read.action.as_str(), read.cycles), ("F", Some(Cycles { period_s: 0.5, count: 2.5 })));
    }

    #[test]
    fn changed_labels_are_edited() {
        let text = r#"{"format": "plantigrade-segments", "version": 1, "source": {"name": "a.bvh"},
            "frames": 3, "rate": 30, "method": {"name": "auto"}, "segments": [
            {"start": 0, "end": 1, "start_s": 0, "end_s": 0.1, "kind": "action", "source": "auto"},
            {"start": 1, "end": 3, "start_s": 0.1, "end_s": 0.2, "kind": "periodic", "label": "1 2",
             "source": "auto"}]}"#;
        let mut document: SegmentsDocument = serde_json::from_str(text).unwrap();
        document.set_labels(&["walk".into(), "1 2".into(), "one too many".into()]);
        let labels: Vec<_> =
            document.segments.iter().map(|span| (span.label.as_str(), span.source)).collect();
        assert_eq!(labels, [("walk", Origin::Edited), ("1 2", Origin::Auto)]);
    }
}
