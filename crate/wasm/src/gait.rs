//! Gait measures.

use plantigrade::gait::{Gait, Spread};
use plantigrade::plants::Feet;
use serde::{Deserialize, Serialize};
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::types::{Failure, to_js};
use crate::{WasmClip, WasmDetection};

/// Gait measures; measures that the clip does not allow are absent.
#[derive(Debug, Serialize, Deserialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct GaitInfo {
    /// Number of complete strides of both feet.
    pub strides: usize,
    /// Steps per minute.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cadence: Option<f64>,
    /// Speed over ground in m/s.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub speed: Option<f64>,
    /// Measures per side: `stance_s`, `swing_s`, `stride_time_s`, `stride_length_m`, `step_time_s`,
    /// `step_length_m` and `step_width_m`, with the unit after the last underscore.
    pub sides: Vec<BilateralMeasure>,
    /// Double support per stride, in seconds.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub double_support: Option<MeanSd>,
    /// Double support as a fraction of the stride, 0 to 1.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub double_support_share: Option<MeanSd>,
    /// Flight as a fraction of the stride, 0 to 1.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub flight_share: Option<MeanSd>,
    /// Right relative to left in percent; positive if the right side is larger.
    pub symmetry: SymmetryInfo,
}

/// A measure per side.
#[derive(Debug, Serialize, Deserialize, Tsify)]
pub struct BilateralMeasure {
    /// Name of the measure, with its unit.
    pub name: String,
    /// Left side.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub left: Option<MeanSd>,
    /// Right side.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub right: Option<MeanSd>,
}

/// Mean and standard deviation of a measure.
#[derive(Debug, Serialize, Deserialize, Tsify)]
pub struct MeanSd {
    /// Arithmetic mean.
    pub mean: f64,
    /// Standard deviation; absent for a single value.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sd: Option<f64>,
    /// Number of values.
    pub count: usize,
}

/// Symmetry indices after Robinson, in percent.
#[derive(Debug, Serialize, Deserialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct SymmetryInfo {
    /// Symmetry of stance times.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stance: Option<f64>,
    /// Symmetry of swing times.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub swing: Option<f64>,
    /// Symmetry of step times.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub step_time: Option<f64>,
    /// Symmetry of step lengths.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub step_length: Option<f64>,
}

#[wasm_bindgen]
impl WasmClip {
    /// Gait measures from the labels of a detection, with edits applied.
    ///
    /// # Errors
    /// If the clip has no motion or no feet.
    pub fn gait(&self, detection: &WasmDetection) -> Result<Ts<GaitInfo>, Failure> {
        let feet = Feet::new(self.core(), self.skeleton())?;
        to_js(&GaitInfo::from(Gait::from_detection(&feet, detection.core())))
    }
}

impl From<Gait> for GaitInfo {
    fn from(gait: Gait) -> GaitInfo {
        let mean_sd = |spread: Option<Spread>| spread.map(MeanSd::from);
        let sides = gait.by_side().map(|(name, measure)| BilateralMeasure {
            name: name.into(),
            left: mean_sd(measure.left),
            right: mean_sd(measure.right),
        });
        GaitInfo {
            strides: gait.strides,
            cadence: gait.cadence_steps_per_min,
            speed: gait.speed_m_per_s,
            sides: sides.into(),
            double_support: mean_sd(gait.double_support_s),
            double_support_share: mean_sd(gait.double_support_share),
            flight_share: mean_sd(gait.flight_share),
            symmetry: SymmetryInfo {
                stance: gait.symmetry.stance_percent,
                swing: gait.symmetry.swing_percent,
                step_time: gait.symmetry.step_time_percent,
                step_length: gait.symmetry.step_length_percent,
            },
        }
    }
}

impl From<Spread> for MeanSd {
    fn from(Spread { mean, sd, count }: Spread) -> MeanSd {
        MeanSd { mean, sd, count }
    }
}
