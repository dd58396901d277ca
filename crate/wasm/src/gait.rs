//! Gait measures.

use std::ops::Range;

use plantigrade::foot::Side;
use plantigrade::formats::{GaitExport, GaitFormat, SkeletonGait};
use plantigrade::gait::{ActionRanges, Curve, GaitAnalysis, LeftOut, Legs, SideCurves, Spread, Step};
use plantigrade::plants::Feet;
use serde::{Deserialize, Serialize};
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::second::second_module;
use crate::types::{ArgumentError, Failure, FormatInfo, from_js, parse_name, to_js};
use crate::{WasmClip, WasmDetection};

/// Gait measures; measures that the clip does not allow are absent.
#[derive(Debug, Serialize, Deserialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct GaitInfo {
    /// Number of complete strides of both feet.
    pub strides: usize,
    /// Number of strides that were left out, by reason.
    pub left_out: LeftOutInfo,
    /// Speed of the belt of a treadmill in m/s; absent over ground.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub belt_speed: Option<f64>,
    /// Steps in order of foot strike.
    pub steps: Vec<StepInfo>,
    /// Joint angles over the gait cycle; empty without strides or without joints of the legs.
    pub curves: Vec<CurveInfo>,
    /// Steps per minute.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cadence: Option<f64>,
    /// Speed over ground, or relative to the belt of a treadmill, in m/s.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub speed: Option<f64>,
    /// Measures per side: `stance_s`, `swing_s`, `stride_time_s`, `stride_length_m`, `step_time_s`,
    /// `step_length_m`, `step_width_m`, and in percent of the gait cycle `stance_percent`,
    /// `swing_percent`, `single_support_percent` and `double_support_percent`, with the unit after the last
    /// underscore.
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

/// Number of strides that were left out, by reason.
#[derive(Debug, Serialize, Deserialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct LeftOutInfo {
    /// Strides that the ends of the clip or of the action cut off.
    pub cut_off: usize,
    /// Strides in which the other foot does not strike exactly once.
    pub missing_event: usize,
    /// Strides in which the person stands.
    pub pause: usize,
    /// Strides on the spot.
    pub on_the_spot: usize,
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

/// One foot strike: the step that it ends and the stride that it begins. Measures whose events are missing
/// are absent.
#[derive(Debug, Serialize, Deserialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct StepInfo {
    /// The foot that strikes.
    #[tsify(type = "\"left\" | \"right\"")]
    pub side: Side,
    /// First frame of contact.
    pub strike_frame: usize,
    /// Time of the foot strike, in seconds.
    pub strike: f64,
    /// First frame after contact; absent if the clip ends before.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub off_frame: Option<usize>,
    /// Time of the foot off, in seconds.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub off: Option<f64>,
    /// Time from the other foot's strike, in seconds.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub step_time: Option<f64>,
    /// Distance ahead of the other heel, in metres.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub step_length: Option<f64>,
    /// Distance to the own side of the other heel, in metres.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub step_width: Option<f64>,
    /// The stride that the strike begins, if it counts.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stride: Option<StrideInfo>,
    /// Reason why the stride does not count, as in `cut off`.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub left_out: Option<String>,
}

/// One stride, from foot strike to the next foot strike of the same foot.
#[derive(Debug, Serialize, Deserialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct StrideInfo {
    /// Stride time, in seconds.
    pub time: f64,
    /// Stride length, in metres.
    pub length: f64,
    /// Stance, in percent of the gait cycle.
    pub stance_percent: f64,
    /// Swing, in percent of the gait cycle.
    pub swing_percent: f64,
    /// Single support, in percent of the gait cycle.
    pub single_support_percent: f64,
    /// Double support, in percent of the gait cycle.
    pub double_support_percent: f64,
}

/// One joint's angle over the gait cycle. It is the angle of lines between joint centres in the sagittal
/// plane of travel, not a clinical angle.
#[derive(Debug, Serialize, Deserialize, Tsify)]
pub struct CurveInfo {
    /// Name of the angle: `hip_flexion`, `knee_flexion` or `ankle_dorsiflexion`.
    pub name: String,
    /// Left leg.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub left: Option<SideCurveInfo>,
    /// Right leg.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub right: Option<SideCurveInfo>,
}

/// Mean and deviation of an angle at 0, 1, …, 100 percent of the gait cycle, in degrees.
#[derive(Debug, Serialize, Deserialize, Tsify)]
pub struct SideCurveInfo {
    /// Mean over the strides.
    pub mean: Vec<f64>,
    /// Standard deviation; absent for a single stride.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sd: Option<Vec<f64>>,
    /// Number of strides.
    pub strides: usize,
}

/// An action: the frame ranges in which it is done.
#[derive(Clone, Debug, Serialize, Deserialize, Tsify)]
pub struct ActionInfo {
    /// Name.
    pub name: String,
    /// Frame ranges: start, end, start, end, …, half-open.
    pub frames: Vec<usize>,
}

/// All file formats of gait, the default first.
///
/// # Errors
/// Only if the conversion to JavaScript fails.
#[wasm_bindgen(js_name = gaitFormats)]
pub fn gait_formats() -> Result<Vec<Ts<FormatInfo>>, Failure> {
    GaitFormat::ALL.iter().map(|&format| to_js(&FormatInfo::from(format))).collect()
}

#[wasm_bindgen]
impl WasmClip {
    /// Gait measures from the labels of a detection, with edits applied.
    ///
    /// `frames` are ranges of frames to which the measures are limited, as start, end, start, end, …; none
    /// for the whole clip.
    ///
    /// # Errors
    /// If the clip has no motion or no feet, or a range is not in the clip.
    pub fn gait(
        &self,
        detection: &WasmDetection,
        frames: Option<Vec<usize>>,
    ) -> Result<Ts<GaitInfo>, Failure> {
        gait(self, detection, frames)
    }

    /// Returns the gait of a detection as a file in a format that `gaitFormats` lists: of the whole clip or,
    /// if `actions` is not empty, of each action.
    ///
    /// # Errors
    /// If the format does not exist, the clip has no motion or no feet, or an action is not in the clip.
    #[wasm_bindgen(js_name = saveGait)]
    pub fn save_gait(
        &self,
        detection: &WasmDetection,
        actions: Vec<Ts<ActionInfo>>,
        format: &str,
        name: String,
        sha256: Option<String>,
    ) -> Result<String, Failure> {
        save_gait(self, detection, actions, format, name, sha256)
    }
}

impl WasmClip {
    /// Returns pairs of frames as ranges.
    fn ranges(&self, frames: &[usize]) -> Result<Vec<Range<usize>>, Failure> {
        let count = self.core().frame_count();
        let range = |pair: &[usize]| {
            let (start, end) = (pair[0], pair.get(1).copied().unwrap_or(0));
            if start < end && end <= count {
                Ok(start..end)
            } else {
                Err(ArgumentError::FrameRange { start, end, frames: count }.into())
            }
        };
        frames.chunks(2).map(range).collect()
    }
}

impl From<GaitAnalysis> for GaitInfo {
    fn from(GaitAnalysis { gait, steps, curves }: GaitAnalysis) -> GaitInfo {
        let mean_sd = |spread: Option<Spread>| spread.map(MeanSd::from);
        let sides = gait.by_side().into_iter().chain(gait.percent_by_side());
        let sides = sides.map(|(name, measure)| BilateralMeasure {
            name: name.into(),
            left: mean_sd(measure.left),
            right: mean_sd(measure.right),
        });
        let curve = |(name, sides): (&str, &SideCurves)| CurveInfo {
            name: name.into(),
            left: sides.left.clone().map(SideCurveInfo::from),
            right: sides.right.clone().map(SideCurveInfo::from),
        };
        let curves = curves.iter().flat_map(|curves| curves.by_joint()).map(curve).collect();
        GaitInfo {
            strides: gait.strides,
            left_out: gait.left_out.into(),
            belt_speed: gait.belt_m_per_s,
            steps: steps.into_iter().map(StepInfo::from).collect(),
            curves,
            cadence: gait.cadence_steps_per_min,
            speed: gait.speed_m_per_s,
            sides: sides.collect(),
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

impl From<LeftOut> for LeftOutInfo {
    fn from(LeftOut { cut_off, missing_event, pause, on_the_spot }: LeftOut) -> LeftOutInfo {
        LeftOutInfo { cut_off, missing_event, pause, on_the_spot }
    }
}

impl From<Curve> for SideCurveInfo {
    fn from(Curve { mean, sd, strides }: Curve) -> SideCurveInfo {
        SideCurveInfo { mean, sd, strides }
    }
}

impl From<Step> for StepInfo {
    fn from(step: Step) -> StepInfo {
        StepInfo {
            side: step.side,
            strike_frame: step.strike_frame,
            strike: step.strike_s,
            off_frame: step.off_frame,
            off: step.off_s,
            step_time: step.step_time_s,
            step_length: step.step_length_m,
            step_width: step.step_width_m,
            stride: step.stride.map(|stride| StrideInfo {
                time: stride.time_s,
                length: stride.length_m,
                stance_percent: stride.stance_percent,
                swing_percent: stride.swing_percent,
                single_support_percent: stride.single_support_percent,
                double_support_percent: stride.double_support_percent,
            }),
            left_out: step.left_out.map(|omission| omission.description().into()),
        }
    }
}

impl From<Spread> for MeanSd {
    fn from(Spread { mean, sd, count }: Spread) -> MeanSd {
        MeanSd { mean, sd, count }
    }
}

second_module! {
    "0b" fn gait(
        clip: &WasmClip,
        detection: &WasmDetection,
        frames: Option<Vec<usize>>,
    ) -> Result<Ts<GaitInfo>, Failure> {
        let feet = Feet::new(clip.core(), clip.skeleton())?;
        let legs = Legs::new(clip.core(), clip.skeleton());
        let ranges = frames.map(|frames| clip.ranges(&frames)).transpose()?;
        let analysis =
            GaitAnalysis::from_detection(&feet, legs.as_ref(), detection.core(), ranges.as_deref());
        to_js(&GaitInfo::from(analysis))
    }

    "0c" fn save_gait(
        clip: &WasmClip,
        detection: &WasmDetection,
        actions: Vec<Ts<ActionInfo>>,
        format: &str,
        name: String,
        sha256: Option<String>,
    ) -> Result<String, Failure> {
        let format: GaitFormat = parse_name(format)?;
        let feet = Feet::new(clip.core(), clip.skeleton())?;
        let actions = actions.iter().map(|action| {
            let ActionInfo { name, frames } = from_js(action)?;
            Ok(ActionRanges { name, frames: clip.ranges(&frames)? })
        });
        let actions = actions.collect::<Result<Vec<_>, Failure>>()?;
        let actions = (!actions.is_empty()).then_some(actions);
        let gait = SkeletonGait::new(clip.core(), clip.skeleton(), &feet, detection.core(), actions);
        let source = clip.source(name, sha256);
        Ok(format.write(&GaitExport { source, clip: clip.core(), skeletons: vec![gait] }))
    }
}
