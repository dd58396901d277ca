//! Failures and notices.

use plantigrade::bvh::{Error, OtherFile};
use plantigrade::formats::ReadError;
use plantigrade::notice::Notice;
use plantigrade::plants::{DetectError, ParamError};
use plantigrade::segments::{self, SegmentError};
use plantigrade::skate::SkateError;
use serde::{Deserialize, Serialize};
use tsify::Tsify;
use wasm_bindgen::JsValue;

use super::ArgumentError;

/// The reason why an operation failed, for display.
#[derive(Debug, Default, Serialize, Deserialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct Failure {
    /// Description of the problem.
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
    /// Position of the problem in the excerpt, from 0.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub caret: Option<usize>,
    /// Suggested remedy.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hint: Option<String>,
}

impl From<Failure> for JsValue {
    fn from(failure: Failure) -> JsValue {
        failure.into_ts().map_or_else(|_| JsValue::from_str(&failure.message), JsValue::from)
    }
}

impl From<Error> for Failure {
    fn from(error: Error) -> Failure {
        Failure {
            message: error.kind.to_string(),
            line: error.location.map(|location| location.line),
            column: error.location.map(|location| location.column),
            caret: error.excerpt.as_ref().map(|excerpt| excerpt.caret),
            excerpt: error.excerpt.map(|excerpt| excerpt.text),
            hint: Some(error.kind.hint().into()),
        }
    }
}

/// Implements conversions from errors whose text is the whole message.
macro_rules! impl_from_display {
    ($($error:ty),+) => {$(
        impl From<$error> for Failure {
            // Called in many places: inlined, it would enlarge the module.
            #[inline(never)]
            fn from(error: $error) -> Failure {
                Failure { message: error.to_string(), ..Failure::default() }
            }
        }
    )+};
}

impl_from_display!(
    ArgumentError,
    DetectError,
    SkateError,
    ParamError,
    SegmentError,
    segments::ParamError,
    ReadError,
    OtherFile
);

/// A repair, an assumption or a warning.
#[derive(Debug, PartialEq, Serialize, Deserialize, Tsify)]
pub struct NoticeInfo {
    /// Code of the notice, in kebab case.
    pub code: String,
    /// The notice as a sentence.
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

impl From<&Notice> for NoticeInfo {
    fn from(notice: &Notice) -> NoticeInfo {
        NoticeInfo {
            code: notice.code.name(),
            text: notice.text.clone(),
            line: notice.location.map(|location| location.line),
            column: notice.location.map(|location| location.column),
        }
    }
}
