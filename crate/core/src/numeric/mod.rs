//! Numerical helpers that know nothing about motion.

pub(crate) mod interpolate;
pub(crate) mod sort;
pub(crate) mod stats;
