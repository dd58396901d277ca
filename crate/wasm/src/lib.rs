//! Plantigrade for the browser: thin bindings to the core.
//!
//! Each `Wasm…` class owns memory of the module: call its `free()` when done.
//! Small structs are passed as plain objects, long series as typed arrays.

mod clip;
mod compare;
mod detection;
mod evidence;
mod gait;
mod names;
mod positions;
mod second;
mod segmentation;
mod skate;
mod types;

pub use clip::{WasmClip, WasmReader, WasmRewriter};
pub use compare::{DisagreementInfo, EventScoreInfo, ScoreInfo, ScoreRow, WasmAnnotation};
pub use detection::WasmDetection;
pub use evidence::{EvidenceInfo, ThresholdInfo};
pub use gait::{
    ActionInfo, BilateralMeasure, CurveInfo, GaitInfo, LeftOutInfo, MeanSd, SideCurveInfo, StepInfo,
    StrideInfo, SymmetryInfo, gait_formats,
};
pub use segmentation::{
    CutScore, WasmSegmentAnnotation, WasmSegmentation, common_actions, has_segments, segment_formats,
    segment_methods,
};
pub use skate::{CleanedPlantInfo, SlideInfo, WasmCleanedClip};
pub use types::{
    ArgumentError, ClipInfo, DetectOptions, EditInfo, Failure, FormatInfo, InstantInfo, JointInfo,
    MethodInfo, NoticeInfo, Overrides, SegmentInfo, SegmentMethodInfo, SegmentOptions,
};

use plantigrade::formats::PlantFormat;
use plantigrade::plants::Method;
use tsify::Ts;
use wasm_bindgen::prelude::wasm_bindgen;

/// All detection methods, the default first.
///
/// # Errors
/// Only if the conversion to JavaScript fails.
#[wasm_bindgen]
pub fn methods() -> Result<Vec<Ts<MethodInfo>>, Failure> {
    Method::ALL.iter().map(|&method| types::to_js(&MethodInfo::from(method))).collect()
}

/// All file formats of plants, the default first.
///
/// # Errors
/// Only if the conversion to JavaScript fails.
#[wasm_bindgen(js_name = plantFormats)]
pub fn plant_formats() -> Result<Vec<Ts<FormatInfo>>, Failure> {
    PlantFormat::ALL.iter().map(|&format| types::to_js(&FormatInfo::from(format))).collect()
}

/// Reports panics in the console before the module traps.
#[wasm_bindgen(start)]
pub fn start() {
    console_error_panic_hook::set_once();
}
