//! The evidence behind the labels: the clustered samples and the parameters of the clustering.

use plantigrade::plants::{Evidence, Thresholds};
use serde::{Deserialize, Serialize};
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::detection::WasmDetection;
use crate::second::second_module;
use crate::types::{ArgumentError, Failure, parse_side, to_js};

/// The clustering of the samples of a part.
#[derive(Debug, Serialize, Deserialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct EvidenceInfo {
    /// Index of the knee in the sorted norms.
    pub knee: usize,
    /// Bandwidth σ of the kernel.
    pub sigma: f64,
    /// True if σ is a limit of the method rather than the norm at the knee.
    pub sigma_is_limited: bool,
    /// Sensitivity r, as requested.
    pub r: f64,
    /// Threshold on the running variance: r, scaled for wider windows.
    pub tolerance: f64,
    /// Decision value that separates planted samples from the others; −∞ if all are planted.
    pub threshold: f64,
    /// True if planted samples lie above the threshold.
    pub planted_is_high: bool,
    /// Median decision value of the planted class.
    pub planted_median: f64,
    /// True if `decisionField` is available.
    pub has_field: bool,
}

/// Thresholds below which a method labels a foot as planted.
#[derive(Debug, Serialize, Deserialize, Tsify)]
pub struct ThresholdInfo {
    /// Height, in metres.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub height: Option<f64>,
    /// Speed, in metres per second.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub speed: Option<f64>,
}

impl WasmDetection {
    fn evidence_of(&self, part: &str) -> Result<&Evidence, Failure> {
        let evidence = self.unedited_part(part)?.evidence.as_ref();
        evidence.ok_or_else(|| ArgumentError::NoEvidence.into())
    }

    /// Values of the samples of one foot, per frame of the clip; NaN where a frame was not clustered.
    fn by_frame(&self, part: &str, side: &str, values: fn(&Evidence) -> &[f32]) -> Result<Vec<f32>, Failure> {
        let evidence = self.evidence_of(part)?;
        let mut series = vec![f32::NAN; self.foot(part, side)?.planted.len()];
        let count = evidence.frames.len();
        let foot_values = &values(evidence)[parse_side(side)? as usize * count..][..count];
        for (&frame, &value) in evidence.frames.iter().zip(foot_values) {
            series[frame] = value;
        }
        Ok(series)
    }
}

#[wasm_bindgen]
impl WasmDetection {
    /// True if the method clustered the samples of the part.
    #[wasm_bindgen(js_name = hasEvidence)]
    pub fn has_evidence(&self, part: &str) -> Result<bool, Failure> {
        Ok(self.unedited_part(part)?.evidence.is_some())
    }

    /// The clustering of the samples.
    ///
    /// # Errors
    /// If the part does not exist or was not clustered; the same holds for all evidence.
    pub fn evidence(&self, part: &str) -> Result<Ts<EvidenceInfo>, Failure> {
        evidence(self, part)
    }

    /// Norms of the samples of both feet, ascending.
    #[wasm_bindgen(js_name = sortedNorms)]
    pub fn sorted_norms(&self, part: &str) -> Result<Vec<f32>, Failure> {
        Ok(to_f32(&self.evidence_of(part)?.sorted_norms))
    }

    /// Variance of the sorted norms up to each one.
    #[wasm_bindgen(js_name = runningVariance)]
    pub fn running_variance(&self, part: &str) -> Result<Vec<f32>, Failure> {
        Ok(self.evidence_of(part)?.running_variance().map(|variance| variance as f32).collect())
    }

    /// Norm of each frame's sample; NaN where a frame was not clustered.
    pub fn norms(&self, part: &str, side: &str) -> Result<Vec<f32>, Failure> {
        self.by_frame(part, side, |evidence| &evidence.norms)
    }

    /// Decision value of each frame's sample: the square root of its degree, or the value that the
    /// method thresholds instead; NaN where a frame was not clustered.
    #[wasm_bindgen(js_name = decisionValues)]
    pub fn decision_values(&self, part: &str, side: &str) -> Result<Vec<f32>, Failure> {
        self.by_frame(part, side, |evidence| &evidence.values)
    }

    /// Decision values of a foot at constant height (metres) and speed (metres per second):
    /// heights × speeds, row by row.
    #[wasm_bindgen(js_name = decisionField)]
    pub fn decision_field(&self, part: &str, heights: &[f64], speeds: &[f64]) -> Result<Vec<f32>, Failure> {
        decision_field(self, part, heights, speeds)
    }

    /// The height and speed thresholds of the method; absent if it has none.
    ///
    /// # Errors
    /// Only if the conversion to JavaScript fails.
    pub fn thresholds(&self) -> Result<Ts<ThresholdInfo>, Failure> {
        thresholds(self)
    }
}

fn to_f32(values: &[f64]) -> Vec<f32> {
    values.iter().map(|&value| value as f32).collect()
}

second_module! {
    "08" fn evidence(detection: &WasmDetection, part: &str) -> Result<Ts<EvidenceInfo>, Failure> {
        let evidence = detection.evidence_of(part)?;
        to_js(&EvidenceInfo {
            knee: evidence.knee,
            sigma: evidence.sigma,
            sigma_is_limited: evidence.sigma_is_limited,
            r: detection.core().params.tolerance(),
            tolerance: evidence.tolerance,
            threshold: evidence.threshold,
            planted_is_high: evidence.planted_is_high,
            planted_median: evidence.planted_median,
            has_field: evidence.field.is_some(),
        })
    }

    "09" fn decision_field(
        detection: &WasmDetection,
        part: &str,
        heights: &[f64],
        speeds: &[f64],
    ) -> Result<Vec<f32>, Failure> {
        let field = detection.evidence_of(part)?.field.as_ref();
        let field = field.ok_or(ArgumentError::NoField)?;
        let units = |metres: &[f64]| -> Vec<f64> {
            metres.iter().map(|metres| metres / detection.metres_per_unit()).collect()
        };
        Ok(to_f32(&field.sqrt_degrees(&units(heights), &units(speeds))))
    }

    "0a" fn thresholds(detection: &WasmDetection) -> Result<Ts<ThresholdInfo>, Failure> {
        let Thresholds { height, speed } = detection.core().params.thresholds();
        to_js(&ThresholdInfo { height, speed })
    }
}
