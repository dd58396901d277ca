//! Spectral clustering of samples: affinity → bandwidth → degree → two-means → threshold.

pub(crate) mod affinity;
pub(crate) mod bandwidth;
pub(crate) mod cells;
pub(crate) mod degree;
pub(crate) mod expansion;
pub(crate) mod field;
pub(crate) mod lanczos;
mod source_cells;
pub(crate) mod threshold;
pub(crate) mod two_means;
