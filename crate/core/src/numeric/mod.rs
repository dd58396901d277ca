//! Numerical helpers, independent of motion data.

pub(crate) mod interpolate;
pub(crate) mod sort;
pub(crate) mod stats;
