//! The plain objects that cross the border, and what they are made of.

mod clip;
mod detection;
mod failure;
mod segmentation;

pub use clip::{ClipFacts, JointFacts, Overrides};
pub use detection::{DetectOptions, EditFacts, MethodFacts};
pub use failure::{Failure, NoticeText};
pub use segmentation::{SegmentFacts, SegmentMethodFacts, SegmentOptions};

use plantigrade::labels::Side;
use serde::Serialize;
use serde::de::DeserializeOwned;
use tsify::{Ts, Tsify};

/// A record as the plain object it crosses the border as.
pub(crate) fn to_js<T: Tsify + Serialize>(record: &T) -> Result<Ts<T>, Failure> {
    record.into_ts().map_err(|error| Failure::from(error.to_string()))
}

/// The record that a plain object of JavaScript holds.
pub(crate) fn from_js<T: Tsify + DeserializeOwned>(object: &Ts<T>) -> Result<T, Failure> {
    T::from_js(object.js_value()).map_err(|error| Failure::from(error.to_string()))
}

/// The side of that name.
pub(crate) fn side(name: &str) -> Result<Side, Failure> {
    let side = Side::BOTH.into_iter().find(|side| side.name() == name);
    side.ok_or_else(|| Failure::from(format!("the side must be left or right, not {name:?}")))
}
