//! Post-processing: from classes of samples to labels.

pub(crate) mod capture_noise;
pub(crate) mod confidence;
pub(crate) mod dragging;
pub(crate) mod edges;
pub(crate) mod ground_height;
pub(crate) mod plausibility;
pub(crate) mod short_runs;
