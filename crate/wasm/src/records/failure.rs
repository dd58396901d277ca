//! What cannot be done, and what is doubtful.

use plantigrade::bvh::Error;
use plantigrade::labels::LabelsError;
use plantigrade::notice::Notice;
use plantigrade::plants::{DetectError, ParamError};
use plantigrade::segments::{self, SegmentError};
use plantigrade::skate::SkateError;
use serde::{Deserialize, Serialize};
use tsify::Tsify;
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
