//! Gait measures.

use plantigrade::gait::{Gait, Spread};
use plantigrade::plants::Feet;
use serde::{Deserialize, Serialize};
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::records::{Failure, to_js};
use crate::{RawClip, RawDetection};

/// How a person walks or runs; what the clip has nothing to take from is absent.
#[derive(Debug, Serialize, Deserialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct GaitFacts {
    /// Whole strides of both feet that the measures are taken from.
    pub strides: usize,
    /// Steps per minute.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cadence: Option<f64>,
    /// Speed over ground in m/s.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub speed: Option<f64>,
    /// What each foot has: `stance_s`, `swing_s`, `stride_time_s`, `stride_length_m`, `step_time_s`,
    /// `step_length_m` and `step_width_m`, the unit behind the last underscore.
    pub sides: Vec<SidesFacts>,
    /// Time of a stride in which both feet are down, in seconds.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub double_support: Option<SpreadFacts>,
    /// The same as a share of the stride, 0 … 1.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub double_support_share: Option<SpreadFacts>,
    /// Share of a stride in which neither foot is down, 0 … 1.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub flight_share: Option<SpreadFacts>,
    /// Right against left in percent, positive where the right side has more.
    pub symmetry: SymmetryFacts,
}

/// A measure of each foot.
#[derive(Debug, Serialize, Deserialize, Tsify)]
pub struct SidesFacts {
    /// Its name with its unit.
    pub name: String,
    /// The left foot's.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub left: Option<SpreadFacts>,
    /// The right foot's.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub right: Option<SpreadFacts>,
}

/// Mean and spread of a measure.
#[derive(Debug, Serialize, Deserialize, Tsify)]
pub struct SpreadFacts {
    /// Arithmetic mean.
    pub mean: f64,
    /// Standard deviation; absent of a single value.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sd: Option<f64>,
    /// Number of values.
    pub count: usize,
}

/// Robinson's symmetry indices in percent.
#[derive(Debug, Serialize, Deserialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct SymmetryFacts {
    /// Of stance times.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stance: Option<f64>,
    /// Of swing times.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub swing: Option<f64>,
    /// Of step times.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub step_time: Option<f64>,
    /// Of step lengths.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub step_length: Option<f64>,
}

#[wasm_bindgen]
impl RawClip {
    /// The gait measures by the labels of a detection, as a person has edited them.
    ///
    /// # Errors
    /// If the clip has no motion or no feet.
    pub fn gait(&self, detection: &RawDetection) -> Result<Ts<GaitFacts>, Failure> {
        let feet = Feet::of(self.core(), self.skeleton())?;
        to_js(&GaitFacts::from(Gait::of(&feet, detection.core())))
    }
}

impl From<Gait> for GaitFacts {
    fn from(gait: Gait) -> GaitFacts {
        let spread = |spread: Option<Spread>| spread.map(SpreadFacts::from);
        let sides = gait.by_side().map(|(name, measure)| SidesFacts {
            name: name.into(),
            left: spread(measure.left),
            right: spread(measure.right),
        });
        GaitFacts {
            strides: gait.strides,
            cadence: gait.cadence_steps_per_min,
            speed: gait.speed_m_per_s,
            sides: sides.into(),
            double_support: spread(gait.double_support_s),
            double_support_share: spread(gait.double_support_share),
            flight_share: spread(gait.flight_share),
            symmetry: SymmetryFacts {
                stance: gait.symmetry.stance_percent,
                swing: gait.symmetry.swing_percent,
                step_time: gait.symmetry.step_time_percent,
                step_length: gait.symmetry.step_length_percent,
            },
        }
    }
}

impl From<Spread> for SpreadFacts {
    fn from(Spread { mean, sd, count }: Spread) -> SpreadFacts {
        SpreadFacts { mean, sd, count }
    }
}
