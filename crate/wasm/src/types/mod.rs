//! Plain objects exchanged with JavaScript.

mod clip;
mod detection;
mod error;
mod failure;
mod format;
mod segmentation;

pub use clip::{ClipInfo, JointInfo, Overrides};
pub use detection::{DetectOptions, EditInfo, GroundInfo, InstantInfo, MethodInfo, NoiseInfo, SimilarInfo};
pub use error::ArgumentError;
pub use failure::{Failure, NoticeInfo};
pub use format::FormatInfo;
pub use segmentation::{CutEditInfo, SegmentInfo, SegmentMethodInfo, SegmentOptions};

use std::fmt::Display;
use std::str::FromStr;

use plantigrade::foot::Side;
use serde::Serialize;
use serde::de::DeserializeOwned;
use tsify::{Ts, Tsify};

/// Converts a struct to a plain JavaScript object.
pub(crate) fn to_js<T: Tsify + Serialize>(value: &T) -> Result<Ts<T>, Failure> {
    value.into_ts().map_err(conversion_failure)
}

/// Converts a plain JavaScript object to a struct.
pub(crate) fn from_js<T: Tsify + DeserializeOwned>(object: &Ts<T>) -> Result<T, Failure> {
    T::from_js(object.js_value()).map_err(conversion_failure)
}

#[inline(never)]
fn conversion_failure(error: impl Display) -> Failure {
    ArgumentError::Conversion(error.to_string()).into()
}

/// Parses the name of a method, an axis or an option.
pub(crate) fn parse_name<T: FromStr<Err: Display>>(name: &str) -> Result<T, ArgumentError> {
    name.parse().map_err(name_error)
}

#[inline(never)]
fn name_error(error: impl Display) -> ArgumentError {
    ArgumentError::Name(error.to_string())
}

/// Parses `left` or `right`.
#[inline(never)]
pub(crate) fn parse_side(name: &str) -> Result<Side, Failure> {
    let side = Side::BOTH.into_iter().find(|side| side.name() == name);
    side.ok_or_else(|| ArgumentError::Side(name.into()).into())
}
