//! Smooth curves of time: eases, tracks through keys, filters on an even grid.

mod ease;
mod smooth;
mod track;

pub use ease::{bump, hermite, ramped, rise, smooth_step};
pub use smooth::{blur, drift};
pub use track::{Key, Track};
