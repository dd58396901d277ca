//! Plantigrade for the browser: thin bindings to the core.
//!
//! Each `Raw…` class owns memory of the module: call its `free()` when done.
//! Small records cross as plain objects, long series as typed arrays.

mod clip;
mod detection;
mod records;

pub use clip::{RawClip, RawReader};
pub use detection::RawDetection;
pub use records::{ClipFacts, DetectOptions, Failure, JointFacts, NoticeText, Overrides};

use wasm_bindgen::prelude::wasm_bindgen;

/// Lets a panic say what happened in the console before the module traps.
#[wasm_bindgen(start)]
pub fn start() {
    console_error_panic_hook::set_once();
}
