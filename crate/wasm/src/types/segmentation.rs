//! Segmentation options, methods and segments.

use plantigrade::segments::{self, MethodOption, Segment};
use serde::{Deserialize, Serialize};
use tsify::Tsify;

use super::{Failure, parse_name};

/// Options of a segmentation; absent ones have the defaults of the core.
#[derive(Debug, Serialize, Deserialize, Tsify)]
#[serde(default)]
pub struct SegmentOptions {
    /// Name of the method, as listed by `segmentMethods`.
    pub method: String,
    /// Number of principal dimensions; the remaining ones form the residual.
    #[tsify(optional)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub dims: Option<usize>,
    /// Measure of the residual of the eigenvalues.
    #[tsify(optional, type = "\"absolute\" | \"ratio\"")]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub residual: Option<String>,
    /// Pose with which others are compared: the mean, the rest pose or that of a frame.
    #[tsify(optional, type = "\"mean\" | \"tpose\" | `${number}`")]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub template: Option<String>,
    /// True to follow the published method exactly.
    #[tsify(optional)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub published: Option<bool>,
}

impl Default for SegmentOptions {
    fn default() -> SegmentOptions {
        let method = segments::Params::default().method.name().into();
        SegmentOptions { method, dims: None, residual: None, template: None, published: None }
    }
}

impl TryFrom<&SegmentOptions> for segments::Params {
    type Error = Failure;

    fn try_from(options: &SegmentOptions) -> Result<segments::Params, Failure> {
        let SegmentOptions { method, dims, residual, template, published } = options;
        Ok(segments::Params {
            method: parse_name(method)?,
            dims: *dims,
            residual: residual.as_deref().map(parse_name).transpose()?.unwrap_or_default(),
            template: template.as_deref().map(parse_name).transpose()?.unwrap_or_default(),
            published: published.unwrap_or_default(),
        })
    }
}

/// A segmentation method, for menus.
#[derive(Debug, Serialize, Deserialize, Tsify)]
pub struct SegmentMethodInfo {
    /// Name in the options.
    pub name: String,
    /// Display name.
    pub title: String,
    /// Description in a sentence.
    pub description: String,
    /// Default number of dimensions, if the method has that option.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub dims: Option<usize>,
    /// Other options of the method.
    #[tsify(type = "(\"residual\" | \"template\" | \"published\")[]")]
    pub options: Vec<String>,
}

impl From<segments::Method> for SegmentMethodInfo {
    fn from(method: segments::Method) -> SegmentMethodInfo {
        let mut dims = None;
        let mut options = Vec::new();
        for option in method.options() {
            match option {
                MethodOption::Dims(default) => dims = Some(*default),
                MethodOption::Residual => options.push("residual".into()),
                MethodOption::Template => options.push("template".into()),
                MethodOption::Published => options.push("published".into()),
            }
        }
        SegmentMethodInfo {
            name: method.name().into(),
            title: method.title().into(),
            description: method.description().into(),
            dims,
            options,
        }
    }
}

/// A correction of a cut between segments by a person.
#[derive(Debug, PartialEq, Serialize, Deserialize, Tsify)]
pub struct CutEditInfo {
    /// First frame of the segment that begins at the cut.
    pub cut: usize,
    /// True if there is a cut.
    pub present: bool,
}

/// One segment, over half-open frames.
#[derive(Debug, PartialEq, Serialize, Deserialize, Tsify)]
pub struct SegmentInfo {
    /// First frame.
    pub start: usize,
    /// First frame after the segment.
    pub end: usize,
    /// Kind of action.
    #[tsify(type = "\"action\" | \"periodic\" | \"aperiodic\"")]
    pub kind: String,
    /// The method's label; empty if it has none.
    pub label: String,
    /// Name of the action, which all segments share in which the same is done: A, B, ….
    #[tsify(optional)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub action: Option<String>,
    /// Period of the action's cycles, in seconds, if it repeats.
    #[tsify(optional)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub period: Option<f64>,
    /// Number of cycles, if the action repeats.
    #[tsify(optional)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cycles: Option<f64>,
}

impl From<&Segment> for SegmentInfo {
    fn from(segment: &Segment) -> SegmentInfo {
        SegmentInfo {
            start: segment.frames.start,
            end: segment.frames.end,
            kind: segment.kind.name().into(),
            label: segment.label.clone(),
            action: (!segment.action.is_empty()).then(|| segment.action.clone()),
            period: segment.cycles.map(|cycles| cycles.period_s),
            cycles: segment.cycles.map(|cycles| cycles.count),
        }
    }
}
