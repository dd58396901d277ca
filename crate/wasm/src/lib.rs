//! Plantigrade for the browser: thin bindings to the core.
//!
//! Each `Raw…` class owns memory of the module: call its `free()` when done.
//! Small records cross as plain objects, long series as typed arrays.

mod clip;
mod compare;
mod detection;
mod evidence;
mod gait;
mod positions;
mod records;
mod segmentation;
mod skate;

pub use clip::{RawClip, RawReader};
pub use compare::{DisagreementFacts, EventFacts, RawLabelling, ScoreFacts, ScoreRow};
pub use detection::RawDetection;
pub use evidence::{EvidenceFacts, LimitFacts};
pub use gait::{GaitFacts, SidesFacts, SpreadFacts, SymmetryFacts};
pub use records::{
    ClipFacts, DetectOptions, EditFacts, Failure, JointFacts, MethodFacts, NoticeText, Overrides,
    SegmentFacts, SegmentMethodFacts, SegmentOptions,
};
pub use segmentation::{CutScore, RawSegmentation, RawSegments, has_segments, segment_methods};
pub use skate::{CleanedPlantFacts, RawCleaned, SlideFacts};

use plantigrade::plants::Method;
use tsify::Ts;
use wasm_bindgen::prelude::wasm_bindgen;

/// All methods of detection, the default first.
///
/// # Errors
/// None.
#[wasm_bindgen]
pub fn methods() -> Result<Vec<Ts<MethodFacts>>, Failure> {
    Method::ALL.into_iter().map(|method| records::to_js(&MethodFacts::from(method))).collect()
}

/// Lets a panic say what happened in the console before the module traps.
#[wasm_bindgen(start)]
pub fn start() {
    console_error_panic_hook::set_once();
}
