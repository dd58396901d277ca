//! Detection options, methods and edits.

use plantigrade::foot::{Part, Side};
use plantigrade::plants::{Edge, Edit, Instant, Method, Params};
use serde::{Deserialize, Serialize};
use tsify::Tsify;

use super::{Failure, parse_name};

/// Options of a detection; absent ones have the defaults of the core.
#[derive(Debug, Serialize, Deserialize, Tsify)]
#[serde(default)]
pub struct DetectOptions {
    /// Name of the method, as listed by `methods`.
    pub method: String,
    /// Threshold on the running variance of the sorted norms.
    pub r: f64,
    /// Window half-width, in frames.
    pub w: usize,
    /// Height threshold of a planted toe, in metres, for threshold methods.
    #[tsify(optional)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub height: Option<f64>,
    /// Speed threshold of a planted toe, in metres per second, for threshold methods.
    #[tsify(optional)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub speed: Option<f64>,
    /// True to compare all pairs of frames of clips of any length; slow. Default false.
    #[tsify(optional)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub exact: Option<bool>,
}

impl Default for DetectOptions {
    fn default() -> DetectOptions {
        let Params { method, tolerance, window, .. } = Params::default();
        let method = method.name().into();
        DetectOptions { method, r: tolerance, w: window, height: None, speed: None, exact: None }
    }
}

impl TryFrom<&DetectOptions> for Params {
    type Error = Failure;

    fn try_from(options: &DetectOptions) -> Result<Params, Failure> {
        let method = parse_name(&options.method)?;
        let default = Params::default();
        Ok(Params {
            method,
            tolerance: options.r,
            window: options.w,
            sigma: None,
            height: options.height.unwrap_or(default.height),
            speed: options.speed.unwrap_or(default.speed),
            exact: options.exact.unwrap_or_default(),
        })
    }
}

/// Ground on which the feet stand, with Y up.
#[derive(Debug, PartialEq, Serialize, Deserialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct GroundInfo {
    /// Unit normal of the plane.
    pub normal: [f64; 3],
    /// Point of the plane, in metres.
    pub origin: [f64; 3],
    /// Tilt of the plane, in degrees.
    pub tilt: f64,
    /// Heights of the levels above the plane, in metres, ascending; one of them is 0.
    pub levels: Vec<f64>,
    /// Velocity of a treadmill belt, in metres per second; absent if the ground is at rest.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub belt: Option<[f64; 3]>,
}

/// Noise of planted feet: of the capture, and of feet that roll.
#[derive(Debug, PartialEq, Serialize, Deserialize, Tsify)]
pub struct NoiseInfo {
    /// Standard deviation of each coordinate of planted toes, in metres.
    pub position: f64,
    /// Median speed, in metres per second.
    pub speed: f64,
}

/// A detection method, for menus.
#[derive(Debug, Serialize, Deserialize, Tsify)]
pub struct MethodInfo {
    /// Name in the options.
    pub name: String,
    /// Display name.
    pub title: String,
    /// Description in a sentence.
    pub description: String,
    /// Family of the method.
    #[tsify(type = "\"spectral\" | \"mixture\" | \"threshold\"")]
    pub family: String,
    /// Parts that the method labels.
    #[tsify(type = "(\"contact\" | \"toe\" | \"heel\")[]")]
    pub parts: Vec<String>,
}

impl From<Method> for MethodInfo {
    fn from(method: Method) -> MethodInfo {
        MethodInfo {
            name: method.name().into(),
            title: method.title().into(),
            description: method.description().into(),
            family: method.family().name().into(),
            parts: method.parts().iter().map(|part| part.name().into()).collect(),
        }
    }
}

/// A correction: the label of a part of a foot in a range of frames.
#[derive(Debug, PartialEq, Serialize, Deserialize, Tsify)]
pub struct EditInfo {
    /// Foot.
    #[tsify(type = r#""left" | "right""#)]
    pub side: Side,
    /// Part of the foot.
    #[tsify(type = r#""contact" | "toe" | "heel""#)]
    pub part: Part,
    /// First frame.
    pub start: usize,
    /// First frame after the range.
    pub end: usize,
    /// True if planted.
    pub planted: bool,
    /// Instants of boundaries that result from a correction of similar motion.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[tsify(type = "InstantInfo[] | undefined", optional)]
    pub instants: Vec<InstantInfo>,
}

/// Instant of a boundary of one part of one foot. It has no effect if the boundary has moved.
#[derive(Debug, PartialEq, Serialize, Deserialize, Tsify)]
pub struct InstantInfo {
    /// Foot.
    #[tsify(type = r#""left" | "right""#)]
    pub side: Side,
    /// Part of the foot.
    #[tsify(type = r#""contact" | "toe" | "heel""#)]
    pub part: Part,
    /// Frame at which the label changes.
    pub frame: usize,
    /// Time from the first frame of the clip, in seconds.
    pub time: f64,
    /// Standard deviation of the error of `time`, in seconds.
    pub uncertainty: f64,
}

/// Changes of labels by which corrections apply to similar motion.
#[derive(Debug, Serialize, Deserialize, Tsify)]
pub struct SimilarInfo {
    /// The changes, as edits.
    pub changes: Vec<EditInfo>,
    /// Number of plants that they change, add or remove.
    pub plants: usize,
}

impl From<Edit> for EditInfo {
    fn from(Edit { side, part, start, end, planted }: Edit) -> EditInfo {
        EditInfo { side, part, start, end, planted, instants: Vec::new() }
    }
}

impl From<Instant> for InstantInfo {
    fn from(Instant { side, part, edge: Edge { frame, time, uncertainty } }: Instant) -> InstantInfo {
        InstantInfo { side, part, frame, time, uncertainty }
    }
}

impl From<&InstantInfo> for Instant {
    fn from(&InstantInfo { side, part, frame, time, uncertainty }: &InstantInfo) -> Instant {
        Instant { side, part, edge: Edge { frame, time, uncertainty } }
    }
}

impl From<EditInfo> for Edit {
    fn from(EditInfo { side, part, start, end, planted, .. }: EditInfo) -> Edit {
        Edit { side, part, start, end, planted }
    }
}
