//! The plain objects that cross the border, and what they are made of.

use std::collections::BTreeMap;

use plantigrade::bvh::{Error, JointKind};
use plantigrade::labels::{Edit, LabelsError, Part, Side};
use plantigrade::notice::Notice;
use plantigrade::plants::{DetectError, Family, Method, ParamError, Params};
use plantigrade::segments::{self, MethodOption, Segment, SegmentError};
use plantigrade::skate::SkateError;
use plantigrade::skeleton::{self, Role};
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use tsify::{Ts, Tsify};
use wasm_bindgen::JsValue;

/// Why something cannot be done, in the words a person needs.
#[derive(Debug, Default, Serialize, Deserialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct Failure {
    /// What is wrong.
    pub message: String,
    /// Line of the file, from 1.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line: Option<usize>,
    /// Column of the line, from 1.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub column: Option<usize>,
    /// The offending line, shortened.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub excerpt: Option<String>,
    /// Where in the excerpt the trouble begins, from 0.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub caret: Option<usize>,
    /// What to do about it.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hint: Option<String>,
}

/// What JavaScript catches.
impl From<Failure> for JsValue {
    fn from(failure: Failure) -> JsValue {
        failure.into_ts().map_or_else(|_| JsValue::from_str(&failure.message), JsValue::from)
    }
}

/// A record as the plain object it crosses the border as.
pub(crate) fn to_js<T: Tsify + Serialize>(record: &T) -> Result<Ts<T>, Failure> {
    record.into_ts().map_err(|error| Failure::from(error.to_string()))
}

/// The record that a plain object of JavaScript holds.
pub(crate) fn from_js<T: Tsify + DeserializeOwned>(object: &Ts<T>) -> Result<T, Failure> {
    T::from_js(object.js_value()).map_err(|error| Failure::from(error.to_string()))
}

impl From<Error> for Failure {
    fn from(error: Error) -> Failure {
        Failure {
            message: error.problem.to_string(),
            line: error.place.map(|place| place.line),
            column: error.place.map(|place| place.column),
            caret: error.excerpt.as_ref().map(|excerpt| excerpt.caret),
            excerpt: error.excerpt.map(|excerpt| excerpt.text),
            hint: Some(error.problem.hint().into()),
        }
    }
}

/// Errors that say everything in their text.
macro_rules! told_by_their_text {
    ($($error:ty),+) => {$(
        impl From<$error> for Failure {
            fn from(error: $error) -> Failure {
                error.to_string().into()
            }
        }
    )+};
}

told_by_their_text!(DetectError, SkateError, ParamError, SegmentError, segments::ParamError, LabelsError);

impl From<String> for Failure {
    fn from(message: String) -> Failure {
        Failure { message, ..Failure::default() }
    }
}

/// Something that was repaired, assumed or doubted.
#[derive(Debug, PartialEq, Serialize, Deserialize, Tsify)]
pub struct NoticeText {
    /// What it is about, in kebab case.
    pub code: String,
    /// The notice in a sentence.
    pub text: String,
    /// Line of the file, from 1.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line: Option<usize>,
    /// Column of the line, from 1.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub column: Option<usize>,
}

impl From<&Notice> for NoticeText {
    fn from(notice: &Notice) -> NoticeText {
        NoticeText {
            code: notice.code.name(),
            text: notice.text.clone(),
            line: notice.place.map(|place| place.line),
            column: notice.place.map(|place| place.column),
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

/// One joint of a clip.
#[derive(Debug, Serialize, Deserialize, Tsify)]
pub struct JointFacts {
    /// Its name as the file writes it.
    pub name: String,
    /// What it is in the hierarchy.
    #[tsify(type = "\"root\" | \"joint\" | \"end-site\"")]
    pub kind: String,
    /// Index of its parent.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub parent: Option<usize>,
}

impl From<&plantigrade::bvh::Joint> for JointFacts {
    fn from(joint: &plantigrade::bvh::Joint) -> JointFacts {
        let kind = match joint.kind {
            JointKind::Root => "root",
            JointKind::Joint => "joint",
            JointKind::EndSite => "end-site",
        };
        JointFacts { name: joint.name.clone(), kind: kind.into(), parent: joint.parent }
    }
}

/// What is known of a clip.
#[derive(Debug, Serialize, Deserialize, Tsify)]
#[tsify(hashmap_as_object)]
#[serde(rename_all = "camelCase")]
pub struct ClipFacts {
    /// Number of frames; 0 where there is only a rest pose.
    pub frames: usize,
    /// Frames per second in force.
    pub rate: f64,
    /// All joints and end sites, parents first.
    pub joints: Vec<JointFacts>,
    /// The axis that points up.
    #[tsify(type = "\"x\" | \"-x\" | \"y\" | \"-y\" | \"z\" | \"-z\"")]
    pub up: String,
    /// Metres per file unit in force.
    pub metres_per_unit: f64,
    /// Name of the unit, if it is a known one.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unit: Option<String>,
    /// Thigh plus shank, in metres.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub leg: Option<f64>,
    /// Role to joint index; roles that nobody plays are absent.
    pub roles: BTreeMap<String, usize>,
    /// All roles there are, in order.
    pub role_names: Vec<String>,
    /// What the reader had to say.
    pub notices: Vec<NoticeText>,
}

/// What a person knows better; what is absent stays as found.
#[derive(Debug, Default, Serialize, Deserialize, Tsify)]
#[tsify(hashmap_as_object)]
#[serde(rename_all = "camelCase", default)]
pub struct Overrides {
    /// Frames per second.
    #[tsify(optional)]
    pub rate: Option<f64>,
    /// The axis that points up.
    #[tsify(optional, type = "\"x\" | \"-x\" | \"y\" | \"-y\" | \"z\" | \"-z\"")]
    pub up: Option<String>,
    /// Metres per file unit.
    #[tsify(optional)]
    pub metres_per_unit: Option<f64>,
    /// Role to joint index; −1 empties a role.
    #[tsify(optional)]
    pub roles: Option<BTreeMap<String, i32>>,
}

impl Overrides {
    /// The core's overrides, for a clip of so many joints.
    ///
    /// # Errors
    /// If a role, joint or axis does not exist or a number is not positive.
    pub fn check(&self, joints: usize) -> Result<skeleton::Overrides, Failure> {
        let positive = |what: &str, value: Option<f64>| match value {
            Some(value) if !(value > 0.0 && value.is_finite()) => {
                Err(Failure::from(format!("the {what} must be greater than 0, not {value}")))
            }
            value => Ok(value),
        };
        positive("rate", self.rate)?;
        let role = |(name, &joint): (&String, &i32)| {
            let role = Role::named(name).ok_or_else(|| format!("there is no role {name:?}"))?;
            match usize::try_from(joint) {
                Err(_) => Ok((role, None)),
                Ok(joint) if joint < joints => Ok((role, Some(joint))),
                Ok(joint) => Err(Failure::from(format!("there is no joint {joint}"))),
            }
        };
        Ok(skeleton::Overrides {
            roles: self.roles.iter().flatten().map(role).collect::<Result<_, Failure>>()?,
            up: self.up.as_deref().map(str::parse).transpose()?,
            metres_per_unit: positive("scale", self.metres_per_unit)?,
        })
    }
}

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

/// The side of that name.
pub(crate) fn side(name: &str) -> Result<Side, Failure> {
    let side = Side::BOTH.into_iter().find(|side| side.name() == name);
    side.ok_or_else(|| Failure::from(format!("the side must be left or right, not {name:?}")))
}
