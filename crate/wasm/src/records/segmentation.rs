//! What a clip is cut by, and what comes of it.

use plantigrade::segments::{self, MethodOption, Segment};
use serde::{Deserialize, Serialize};
use tsify::Tsify;

use super::Failure;

/// How a clip is to be cut.
#[derive(Debug, Default, Serialize, Deserialize, Tsify)]
pub struct SegmentOptions {
    /// The method's name: one that `segmentMethods` lists.
    pub method: String,
    /// Dimensions kept before the rest is called residual.
    #[tsify(optional)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub dims: Option<usize>,
    /// What of the eigenvalues is called residual.
    #[tsify(optional, type = "\"absolute\" | \"ratio\"")]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub residual: Option<String>,
    /// The pose that others are compared with: the mean, the rest pose or that of a frame.
    #[tsify(optional, type = "\"mean\" | \"tpose\" | `${number}`")]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub template: Option<String>,
    /// Keeps to the letter of what was published.
    #[tsify(optional)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub published: Option<bool>,
}

impl TryFrom<&SegmentOptions> for segments::Params {
    type Error = Failure;

    fn try_from(options: &SegmentOptions) -> Result<segments::Params, Failure> {
        let SegmentOptions { method, dims, residual, template, published } = options;
        Ok(segments::Params {
            method: method.parse()?,
            dims: *dims,
            residual: residual.as_deref().map(str::parse).transpose()?.unwrap_or_default(),
            template: template.as_deref().map(str::parse).transpose()?.unwrap_or_default(),
            published: published.unwrap_or_default(),
        })
    }
}

/// A method of segmentation, for a menu.
#[derive(Debug, Serialize, Deserialize, Tsify)]
pub struct SegmentMethodFacts {
    /// What the options call it.
    pub name: String,
    /// What people call it.
    pub title: String,
    /// What it does, in a sentence.
    pub about: String,
    /// The dimensions that it keeps unless told otherwise, if that can be told.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub dims: Option<usize>,
    /// The other options that matter to it.
    #[tsify(type = "(\"residual\" | \"template\" | \"published\")[]")]
    pub options: Vec<String>,
}

impl From<segments::Method> for SegmentMethodFacts {
    fn from(method: segments::Method) -> SegmentMethodFacts {
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
        SegmentMethodFacts {
            name: method.name().into(),
            title: method.title().into(),
            about: method.about().into(),
            dims,
            options,
        }
    }
}

/// One action: frames half-open.
#[derive(Debug, PartialEq, Serialize, Deserialize, Tsify)]
pub struct SegmentFacts {
    /// First frame.
    pub start: usize,
    /// First frame after.
    pub end: usize,
    /// What kind of action it is.
    #[tsify(type = "\"action\" | \"periodic\" | \"aperiodic\"")]
    pub kind: String,
    /// The method's name for it; empty where there is none.
    pub label: String,
}

impl From<&Segment> for SegmentFacts {
    fn from(segment: &Segment) -> SegmentFacts {
        SegmentFacts {
            start: segment.frames.start,
            end: segment.frames.end,
            kind: segment.kind.name().into(),
            label: segment.label.clone(),
        }
    }
}
