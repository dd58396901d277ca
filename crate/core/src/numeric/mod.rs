//! Numerical helpers that know nothing of motion.

pub(crate) mod interpolate;
pub(crate) mod sort;
