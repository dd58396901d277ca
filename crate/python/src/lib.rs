//! Bindings of Plantigrade to Python: the module `_plantigrade`, on which the package `plantigrade` is
//! built.
//!
//! The classes hold data of the core; checks of arguments that need Python's types, and documentation for
//! users, are in the package. Computations release the global interpreter lock.
// Not `forbid`: the macros of PyO3 generate code that Python's C interface requires.
#![deny(unsafe_op_in_unsafe_fn)]

mod clip;
mod clip_data;
mod detection;
mod failure;
mod params;
mod registry;
mod segmentation;

use pyo3::prelude::*;

/// The module.
#[pymodule(gil_used = false)]
mod _plantigrade {
    #[pymodule_export]
    use super::clip::RawClip;
    #[pymodule_export]
    use super::detection::RawDetection;
    #[pymodule_export]
    use super::registry::{
        defaults, detection_methods, plant_formats, role_names, segment_formats, segmentation_methods,
    };
    #[pymodule_export]
    use super::segmentation::RawSegmentation;

    /// Version of the package.
    #[pymodule_export]
    const VERSION: &str = env!("CARGO_PKG_VERSION");
}
