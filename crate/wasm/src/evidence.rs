//! Why a foot is taken for planted: what was clustered, and what with.

use plantigrade::plants::{Evidence, Limits};
use serde::{Deserialize, Serialize};
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::detection::RawDetection;
use crate::records::{Failure, side, to_js};

/// How the samples of a part were parted.
#[derive(Debug, Serialize, Deserialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct EvidenceFacts {
    /// Index into the sorted norms of the knee.
    pub knee: usize,
    /// Scale of the kernel.
    pub sigma: f64,
    /// r, as it was asked for.
    pub r: f64,
    /// What the variance was compared with: r, or more of it for a wider window.
    pub tolerance: f64,
    /// The value of u that parts planted from not; no number is less where all are planted.
    pub threshold: f64,
    /// Whether the planted ones are those above.
    pub planted_is_high: bool,
    /// Median u of the planted class.
    pub planted_middle: f64,
    /// Whether `field` can be asked.
    pub has_field: bool,
}

/// What a method takes a foot for planted under.
#[derive(Debug, Serialize, Deserialize, Tsify)]
pub struct LimitFacts {
    /// In metres.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub height: Option<f64>,
    /// In metres per second.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub speed: Option<f64>,
}

impl RawDetection {
    fn evidence_of(&self, part: &str) -> Result<&Evidence, Failure> {
        let evidence = self.part_found(part)?.evidence.as_ref();
        evidence.ok_or_else(|| Failure::from("nothing was clustered".to_owned()))
    }

    /// Values of the samples of one foot, per frame of the clip; no number where a frame was not clustered.
    fn by_frame(&self, part: &str, of: &str, values: fn(&Evidence) -> &[f32]) -> Result<Vec<f32>, Failure> {
        let evidence = self.evidence_of(part)?;
        let mut series = vec![f32::NAN; self.foot(part, of)?.planted.len()];
        let count = evidence.frames.len();
        let own = &values(evidence)[side(of)? as usize * count..][..count];
        for (&frame, &value) in evidence.frames.iter().zip(own) {
            series[frame] = value;
        }
        Ok(series)
    }
}

#[wasm_bindgen]
impl RawDetection {
    /// Whether there was anything to cluster; without, there is no evidence.
    #[wasm_bindgen(js_name = hasEvidence)]
    pub fn has_evidence(&self, part: &str) -> Result<bool, Failure> {
        Ok(self.part_found(part)?.evidence.is_some())
    }

    /// How the samples were parted.
    ///
    /// # Errors
    /// If there is no such part or no evidence; so for all of it.
    pub fn evidence(&self, part: &str) -> Result<Ts<EvidenceFacts>, Failure> {
        let evidence = self.evidence_of(part)?;
        to_js(&EvidenceFacts {
            knee: evidence.knee,
            sigma: evidence.sigma,
            r: self.core().params.tolerance(),
            tolerance: evidence.tolerance,
            threshold: evidence.threshold,
            planted_is_high: evidence.planted_is_high,
            planted_middle: evidence.planted_middle,
            has_field: evidence.field.is_some(),
        })
    }

    /// Norms of the samples of both feet, ascending.
    #[wasm_bindgen(js_name = sortedNorms)]
    pub fn sorted_norms(&self, part: &str) -> Result<Vec<f32>, Failure> {
        Ok(single(&self.evidence_of(part)?.sorted_norms))
    }

    /// Variance of the first norms up to each one.
    #[wasm_bindgen(js_name = runningVariance)]
    pub fn running_variance(&self, part: &str) -> Result<Vec<f32>, Failure> {
        Ok(self.evidence_of(part)?.running_variance().map(|variance| variance as f32).collect())
    }

    /// Norm of each frame's sample; no number where a frame was not clustered.
    pub fn norms(&self, part: &str, side: &str) -> Result<Vec<f32>, Failure> {
        self.by_frame(part, side, |evidence| &evidence.norms)
    }

    /// u of each frame's sample; no number where a frame was not clustered.
    pub fn roots(&self, part: &str, side: &str) -> Result<Vec<f32>, Failure> {
        self.by_frame(part, side, |evidence| &evidence.roots)
    }

    /// u of a foot that holds a height in metres and a speed in metres per second over the window,
    /// for each height all speeds.
    pub fn field(&self, part: &str, heights: &[f64], speeds: &[f64]) -> Result<Vec<f32>, Failure> {
        let field = self.evidence_of(part)?.field.as_ref();
        let field = field.ok_or_else(|| Failure::from("this method has no field".to_owned()))?;
        let units = |metres: &[f64]| -> Vec<f64> {
            metres.iter().map(|metres| metres / self.metres_per_unit()).collect()
        };
        Ok(single(&field.roots(&units(heights), &units(speeds))))
    }

    /// The height and the speed that the method compares with, where it does.
    ///
    /// # Errors
    /// None.
    pub fn limits(&self) -> Result<Ts<LimitFacts>, Failure> {
        let Limits { height, speed } = self.core().params.limits();
        to_js(&LimitFacts { height, speed })
    }
}

fn single(values: &[f64]) -> Vec<f32> {
    values.iter().map(|&value| value as f32).collect()
}
