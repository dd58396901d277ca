//! What plants are found by, and what a person says of them.

use plantigrade::labels::{Edit, Part, Side};
use plantigrade::plants::{Family, Method, Params};
use serde::{Deserialize, Serialize};
use tsify::Tsify;

use super::Failure;

/// How plants are to be found.
#[derive(Debug, Serialize, Deserialize, Tsify)]
pub struct DetectOptions {
    /// The method's name: one that `methods` lists.
    pub method: String,
    /// Threshold on the running variance of the sorted norms; 0.001 serves any clip.
    pub r: f64,
    /// Window half-width, in frames; 1 serves any clip.
    pub w: usize,
    /// Height under which thresholds take a toe for planted, in metres.
    #[tsify(optional)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub height: Option<f64>,
    /// Speed under which thresholds take a toe for planted, in metres per second.
    #[tsify(optional)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub speed: Option<f64>,
    /// Whether all pairs of frames are compared, however long the clip; slow. Default false.
    #[tsify(optional)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub exact: Option<bool>,
}

impl TryFrom<&DetectOptions> for Params {
    type Error = Failure;

    fn try_from(options: &DetectOptions) -> Result<Params, Failure> {
        let method = options.method.parse()?;
        let default = Params::default();
        Ok(Params {
            method,
            tolerance: options.r,
            window: options.w,
            scale: None,
            height: options.height.unwrap_or(default.height),
            speed: options.speed.unwrap_or(default.speed),
            exact: options.exact.unwrap_or_default(),
        })
    }
}

/// A method of detection, for a menu.
#[derive(Debug, Serialize, Deserialize, Tsify)]
pub struct MethodFacts {
    /// What the options call it.
    pub name: String,
    /// What people call it.
    pub title: String,
    /// What it does, in a sentence.
    pub about: String,
    /// What kind of method it is.
    #[tsify(type = "\"spectral\" | \"mixture\" | \"threshold\"")]
    pub family: String,
    /// The parts that it labels.
    #[tsify(type = "(\"contact\" | \"toe\" | \"heel\")[]")]
    pub parts: Vec<String>,
}

impl From<Method> for MethodFacts {
    fn from(method: Method) -> MethodFacts {
        let family = match method.family() {
            Family::Spectral => "spectral",
            Family::Mixture => "mixture",
            Family::Threshold => "threshold",
        };
        MethodFacts {
            name: method.name().into(),
            title: method.title().into(),
            about: method.about().into(),
            family: family.into(),
            parts: method.parts().iter().map(|part| part.name().into()).collect(),
        }
    }
}

/// A stretch of frames of which a person says whether a part of a foot is planted.
#[derive(Debug, PartialEq, Serialize, Deserialize, Tsify)]
pub struct EditFacts {
    /// The foot.
    #[tsify(type = r#""left" | "right""#)]
    pub side: Side,
    /// What of it.
    #[tsify(type = r#""contact" | "toe" | "heel""#)]
    pub part: Part,
    /// The first frame.
    pub start: usize,
    /// The first frame after.
    pub end: usize,
    /// Planted, or not.
    pub planted: bool,
}

impl From<Edit> for EditFacts {
    fn from(Edit { side, part, start, end, planted }: Edit) -> EditFacts {
        EditFacts { side, part, start, end, planted }
    }
}

impl From<EditFacts> for Edit {
    fn from(EditFacts { side, part, start, end, planted }: EditFacts) -> Edit {
        Edit { side, part, start, end, planted }
    }
}
