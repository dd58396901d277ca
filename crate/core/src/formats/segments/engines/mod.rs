//! Segments as scripts of game engines.

mod names;
mod unity;
mod unreal;

pub(super) use unity::FORMAT_INFO as UNITY;
pub(super) use unreal::FORMAT_INFO as UNREAL;
