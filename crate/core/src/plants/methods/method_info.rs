//! Interface of detection methods.

use crate::foot::Part;
use crate::notice::Notice;
use crate::plants::methods::robust::cache::DetectionCache;
use crate::plants::spectral::degree::Summation;
use crate::plants::{Feet, PartLabels};

/// Family of methods.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Family {
    /// Clusters an affinity graph.
    Spectral,
    /// Fits distributions to each clip.
    Mixture,
    /// Compares heights or speeds in metres with thresholds.
    Threshold,
}

impl Family {
    /// Returns the name: `spectral`, `mixture` or `threshold`.
    pub fn name(self) -> &'static str {
        match self {
            Family::Spectral => "spectral",
            Family::Mixture => "mixture",
            Family::Threshold => "threshold",
        }
    }
}

/// Thresholds of a method; `None` for a quantity that it does not compare.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Thresholds {
    /// Height, in metres.
    pub height: Option<f64>,
    /// Speed, in metres per second.
    pub speed: Option<f64>,
}

impl Thresholds {
    pub(crate) const NONE: Thresholds = Thresholds { height: None, speed: None };
}

/// Parameters as a method receives them; see [`Params`](crate::plants::Params).
#[derive(Clone, Copy)]
pub(crate) struct Settings {
    pub tolerance: f64,
    /// Half-width, in frames.
    pub window: usize,
    pub sigma: Option<f64>,
    /// Height threshold, in metres.
    pub height: f64,
    /// Speed threshold, in metres per second.
    pub speed: f64,
    pub summation: Summation,
}

/// Input of a method.
pub(crate) struct Input<'a> {
    pub feet: &'a Feet,
    /// Feet of the same character standing still, whose samples are clustered together with the clip.
    pub standing: Option<&'a Feet>,
    pub settings: Settings,
    /// Results cached between detections on these feet.
    pub cache: Option<&'a mut DetectionCache>,
}

/// Output of a method.
pub(crate) struct Output {
    pub parts: Vec<PartLabels>,
    pub notices: Vec<Notice>,
}

/// Registry entry of a method.
pub(crate) struct MethodInfo {
    pub name: &'static str,
    pub title: &'static str,
    pub description: &'static str,
    pub family: Family,
    /// Labelled parts; the first one defines the plants.
    pub parts: &'static [Part],
    /// Returns the thresholds that the method compares with, given those of the parameters: a height
    /// in metres and a speed in metres per second.
    pub thresholds: fn(f64, f64) -> Thresholds,
    pub detect: fn(&mut Input) -> Output,
}
