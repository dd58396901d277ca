//! The labels document: foot plants as the JSON that is saved, shared and read back.

use std::ops::Range;

use serde::{Deserialize, Serialize};

use crate::bvh::Clip;
use crate::foot::{Part, Side};
use crate::intervals::intervals;
use crate::notice::Notice;
use crate::plants::Detection;
use crate::skeleton::Skeleton;

/// What [`Document::format`] says.
pub const FORMAT: &str = "plantigrade-labels";

/// The version of the documents' shapes that this library writes.
pub const VERSION: u32 = 1;

/// Foot plants of one clip with where they come from.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Document {
    /// Always [`FORMAT`].
    pub format: String,
    /// Always [`VERSION`] in what is written.
    pub version: u32,
    /// The clip that the labels belong to.
    pub source: Source,
    /// Name of the root joint, where the clip has several skeletons.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub root: Option<String>,
    /// Number of frames in the clip.
    pub frames: usize,
    /// Frames per second, after any override.
    pub rate: f64,
    /// The joints taken for heels and toes; absent where labels come from elsewhere.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub joints: Option<Joints>,
    /// Height of the ground along the up axis, in file units.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub floor: Option<f64>,
    /// How the labels were made.
    pub method: MethodUsed,
    /// The left foot's labels.
    pub left: Foot,
    /// The right foot's labels.
    pub right: Foot,
    /// What the reader and the detector had to say.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub notices: Vec<Notice>,
}

/// The clip that labels belong to.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Source {
    /// File name without folders.
    pub name: String,
    /// SHA-256 of the file's bytes in lower-case hexadecimal, where known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sha256: Option<String>,
}

/// The joints that stand for the feet.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Joints {
    /// Those of the left foot.
    pub left: FootJoints,
    /// Those of the right foot.
    pub right: FootJoints,
}

/// The joints that stand for one foot, by name.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FootJoints {
    /// The ankle, whose track is the heel's.
    pub heel: String,
    /// The toe base, or what stands in for it.
    pub toe: String,
}

/// The method that made the labels, with its parameters.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct MethodUsed {
    /// `robust`, `paper`, ...; `truth` where the labels are known from elsewhere.
    pub name: String,
    /// Threshold on the running variance of the sorted norms.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub r: Option<f64>,
    /// Window half-width, in frames.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub w: Option<usize>,
    /// Scale of the kernel, where it was set by hand.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sigma: Option<f64>,
}

/// The labels of one foot: a list of spans for each part that was labelled.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Foot {
    /// Any part of the sole carries weight.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub contact: Option<Vec<Span>>,
    /// The toe is down and still.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub toe: Option<Vec<Span>>,
    /// The heel is down and still.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub heel: Option<Vec<Span>>,
}

/// A run of planted frames: `[start, end)`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Span {
    /// First planted frame.
    pub start: usize,
    /// First frame after the plant.
    pub end: usize,
    /// `start` in seconds from the clip's start.
    pub start_s: f64,
    /// `end` in seconds from the clip's start.
    pub end_s: f64,
    /// Who says so.
    pub source: SpanSource,
}

/// Where a span comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum SpanSource {
    /// A detector.
    Auto,
    /// A person.
    Edited,
    /// Measured or generated with the motion.
    Truth,
}

impl Document {
    /// The document of what was detected in a clip, whose reader gave `notices`.
    pub fn of(
        source: Source,
        clip: &Clip,
        skeleton: &Skeleton,
        detection: &Detection,
        notices: &[Notice],
    ) -> Document {
        let name = |joint: usize| clip.joints()[joint].name.clone();
        let joints =
            |side| Some(FootJoints { heel: name(skeleton.heel(side)?), toe: name(skeleton.toe(side)?) });
        let foot = |side: Side| {
            let mut foot = Foot::default();
            for labels in &detection.parts {
                let part = labels.part;
                foot.set(part, &labels.foot(side).planted, clip.rate(), |run| {
                    if detection.is_edited(side, part, run) { SpanSource::Edited } else { SpanSource::Auto }
                });
            }
            foot
        };
        let params = detection.params;
        Document {
            format: FORMAT.into(),
            version: VERSION,
            source,
            root: (clip.roots().count() > 1).then(|| name(skeleton.root)),
            frames: clip.frame_count(),
            rate: clip.rate(),
            joints: joints(Side::Left).zip(joints(Side::Right)).map(|(left, right)| Joints { left, right }),
            floor: Some(detection.ground_height),
            method: MethodUsed {
                name: params.method().name().into(),
                r: Some(params.tolerance()),
                w: Some(params.window()),
                sigma: params.sigma(),
            },
            left: foot(Side::Left),
            right: foot(Side::Right),
            notices: [notices, &skeleton.notices, &detection.notices].concat(),
        }
    }

    /// The document as JSON, indented, with a line end.
    pub fn to_json(&self) -> String {
        pretty(self)
    }

    /// Several documents as a JSON array: one for each skeleton of a clip.
    pub fn all_to_json(documents: &[Document]) -> String {
        pretty(documents)
    }

    /// The labels of one foot.
    pub fn foot(&self, side: Side) -> &Foot {
        match side {
            Side::Left => &self.left,
            Side::Right => &self.right,
        }
    }

    /// Per-frame labels of one part of one foot; `None` where it was not labelled.
    ///
    /// Spans that reach past the clip's end are cut there.
    pub fn labels(&self, side: Side, part: Part) -> Option<Vec<bool>> {
        let spans = self.foot(side).part(part)?;
        let mut labels = vec![false; self.frames];
        for span in spans {
            let end = span.end.min(self.frames);
            labels[span.start.min(end)..end].fill(true);
        }
        Some(labels)
    }
}

/// JSON, indented, with a line end.
pub(crate) fn pretty(value: &(impl Serialize + ?Sized)) -> String {
    let mut text = serde_json::to_string_pretty(value).expect("a document has only text, numbers and lists");
    text.push('\n');
    text
}

impl Foot {
    /// The spans of one part.
    pub fn part(&self, part: Part) -> Option<&[Span]> {
        match part {
            Part::Contact => self.contact.as_deref(),
            Part::Toe => self.toe.as_deref(),
            Part::Heel => self.heel.as_deref(),
        }
    }

    /// Sets one part from per-frame labels at `rate` frames per second; `source` tells of each
    /// run of planted frames who says so.
    pub fn set(
        &mut self,
        part: Part,
        labels: &[bool],
        rate: f64,
        source: impl Fn(&Range<usize>) -> SpanSource,
    ) {
        let spans = intervals(labels)
            .into_iter()
            .map(|range| Span {
                start: range.start,
                end: range.end,
                start_s: range.start as f64 / rate,
                end_s: range.end as f64 / rate,
                source: source(&range),
            })
            .collect();
        match part {
            Part::Contact => self.contact = Some(spans),
            Part::Toe => self.toe = Some(spans),
            Part::Heel => self.heel = Some(spans),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_survive_the_document() {
        let labels = [true, false, true, true];
        let mut left = Foot::default();
        left.set(Part::Toe, &labels, 30.0, |_| SpanSource::Auto);
        let document = Document {
            format: FORMAT.into(),
            version: VERSION,
            source: Source { name: "walk.bvh".into(), sha256: None },
            root: None,
            frames: 4,
            rate: 30.0,
            joints: None,
            floor: None,
            method: MethodUsed { name: "paper".into(), r: Some(0.001), w: Some(1), sigma: None },
            left,
            right: Foot::default(),
            notices: vec![Notice::new(crate::notice::Code::NoToe, "No toes.")],
        };
        let text = serde_json::to_string(&document).unwrap();
        let back: Document = serde_json::from_str(&text).unwrap();
        assert_eq!(back, document);
        assert_eq!(back.labels(Side::Left, Part::Toe).unwrap(), labels);
        assert_eq!(back.labels(Side::Right, Part::Toe), None);
    }
}
