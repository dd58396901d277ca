//! The detected plants of a clip.

use plantigrade::intervals::intervals;
use plantigrade::plants::{self, CaptureNoise, Detection, Edit, FootLabels, Instant, PartLabels};
use plantigrade::skeleton::{Skeleton, Up};
use tsify::Ts;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::second::second_module;
use crate::types::{
    ArgumentError, EditInfo, Failure, GroundInfo, NoiseInfo, NoticeInfo, from_js, parse_side, to_js,
};

/// The detected plants of a clip; series are addressed by part and side.
#[wasm_bindgen]
pub struct WasmDetection {
    detected: Detection,
    /// The detection with edits applied, if there are any.
    edited: Option<Detection>,
    metres_per_unit: f64,
    up: Up,
    frame_time: f64,
}

impl WasmDetection {
    pub(crate) fn new(detected: Detection, skeleton: &Skeleton, frame_time: f64) -> WasmDetection {
        let Skeleton { metres_per_unit, up, .. } = *skeleton;
        WasmDetection { detected, edited: None, metres_per_unit, up, frame_time }
    }

    pub(crate) fn core(&self) -> &Detection {
        self.edited.as_ref().unwrap_or(&self.detected)
    }

    /// The labels of the method, without edits.
    pub(crate) fn detected(&self) -> &Detection {
        &self.detected
    }

    pub(crate) fn metres_per_unit(&self) -> f64 {
        self.metres_per_unit
    }

    pub(crate) fn part(&self, part: &str) -> Result<&PartLabels, Failure> {
        part_labels(self.core(), part)
    }

    /// The labels of a part without edits.
    pub(crate) fn unedited_part(&self, part: &str) -> Result<&PartLabels, Failure> {
        part_labels(&self.detected, part)
    }

    pub(crate) fn foot(&self, part: &str, side: &str) -> Result<&FootLabels, Failure> {
        Ok(self.part(part)?.foot(parse_side(side)?))
    }

    fn metres(&self, values: &[f32]) -> Vec<f32> {
        values.iter().map(|&value| (f64::from(value) * self.metres_per_unit) as f32).collect()
    }
}

second_module! {
    "1a" fn apply_edits(detection: &mut WasmDetection, edits: Vec<Ts<EditInfo>>) -> Result<(), Failure> {
        let (edits, instants) = edits_from_js(&edits)?;
        let mut edited = plants::apply_edits(&detection.detected, &edits, detection.frame_time);
        edited.set_instants(&instants);
        detection.edited = Some(edited);
        Ok(())
    }
}

#[wasm_bindgen]
impl WasmDetection {
    /// Applies edits to the detected labels, replacing earlier edits; later entries take precedence.
    ///
    /// # Errors
    /// If an entry is not a valid edit.
    pub fn edit(&mut self, edits: Vec<Ts<EditInfo>>) -> Result<(), Failure> {
        if edits.is_empty() {
            self.edited = None;
            return Ok(());
        }
        apply_edits(self, edits)
    }

    /// Names of the labelled parts, the principal part first.
    pub fn parts(&self) -> Vec<String> {
        self.core().parts.iter().map(|labels| labels.part.name().into()).collect()
    }

    /// Height of the ground in the clip's positions, in metres.
    #[wasm_bindgen(getter)]
    pub fn floor(&self) -> f64 {
        self.core().ground_height * self.metres_per_unit
    }

    /// Ground on which the feet stand.
    ///
    /// # Errors
    /// Only if the conversion to JavaScript fails.
    pub fn ground(&self) -> Result<Ts<GroundInfo>, Failure> {
        let ground = &self.core().ground;
        let metres = |vector| (self.up.to_y_up(vector) * self.metres_per_unit).into();
        to_js(&GroundInfo {
            normal: self.up.to_y_up(ground.normal).into(),
            origin: metres(ground.origin),
            tilt: ground.tilt_degrees(self.up),
            levels: ground.levels.iter().map(|level| level * self.metres_per_unit).collect(),
            belt: ground.belt.map(metres),
        })
    }

    /// Noise of planted feet; undefined if no foot is planted.
    ///
    /// # Errors
    /// Only if the conversion to JavaScript fails.
    pub fn noise(&self) -> Result<Option<Ts<NoiseInfo>>, Failure> {
        let info = |noise: CaptureNoise| NoiseInfo {
            position: noise.position * self.metres_per_unit,
            speed: noise.speed * self.metres_per_unit,
        };
        self.core().noise.map(|noise| to_js(&info(noise))).transpose()
    }

    /// Assumptions and warnings of the detector.
    ///
    /// # Errors
    /// Only if the conversion to JavaScript fails.
    pub fn notices(&self) -> Result<Vec<Ts<NoticeInfo>>, Failure> {
        self.core().notices.iter().map(|notice| to_js(&NoticeInfo::from(notice))).collect()
    }

    /// Labels per frame: 1 planted, 0 not planted.
    ///
    /// # Errors
    /// If the part or the side does not exist; the same holds for all series.
    pub fn planted(&self, part: &str, side: &str) -> Result<Vec<u8>, Failure> {
        Ok(self.foot(part, side)?.planted.iter().map(|&planted| u8::from(planted)).collect())
    }

    /// Probability that the label is correct, per frame.
    pub fn confidence(&self, part: &str, side: &str) -> Result<Vec<f32>, Failure> {
        Ok(self.foot(part, side)?.confidence.clone())
    }

    /// Height above the ground in metres, per frame.
    pub fn height(&self, part: &str, side: &str) -> Result<Vec<f32>, Failure> {
        Ok(self.metres(&self.foot(part, side)?.height))
    }

    /// Speed in metres per second, per frame.
    pub fn speed(&self, part: &str, side: &str) -> Result<Vec<f32>, Failure> {
        Ok(self.metres(&self.foot(part, side)?.speed))
    }

    /// Plants as half-open frame ranges: start, end, start, end, ….
    pub fn intervals(&self, part: &str, side: &str) -> Result<Vec<u32>, Failure> {
        let ranges = intervals(&self.foot(part, side)?.planted);
        Ok(ranges.into_iter().flat_map(|range| [range.start as u32, range.end as u32]).collect())
    }

    /// Instants of each of these plants: time of the foot strike, its uncertainty, time of the foot off,
    /// its uncertainty, in seconds; NaN where an instant is known to the frame only.
    pub fn instants(&self, part: &str, side: &str) -> Result<Vec<f64>, Failure> {
        let foot = self.foot(part, side)?;
        let instant =
            |frame: usize| foot.edge(frame).map_or([f64::NAN; 2], |edge| [edge.time, edge.uncertainty]);
        let ranges = intervals(&foot.planted);
        Ok(ranges
            .into_iter()
            .flat_map(|range| [instant(range.start), instant(range.end)])
            .flatten()
            .collect())
    }

    /// For each of these plants 1 if an edit determines it, else 0.
    pub fn edited(&self, part: &str, side: &str) -> Result<Vec<u8>, Failure> {
        let (detection, labels, side) = (self.core(), self.part(part)?, parse_side(side)?);
        let ranges = intervals(&labels.foot(side).planted);
        Ok(ranges.iter().map(|range| u8::from(detection.is_edited(side, labels.part, range))).collect())
    }
}

/// Converts edits from JavaScript. Returns the edits and their instants.
pub(crate) fn edits_from_js(edits: &[Ts<EditInfo>]) -> Result<(Vec<Edit>, Vec<Instant>), Failure> {
    let mut converted = (Vec::with_capacity(edits.len()), Vec::new());
    for edit in edits {
        let edit = from_js(edit)?;
        converted.1.extend(edit.instants.iter().map(Instant::from));
        converted.0.push(edit.into());
    }
    Ok(converted)
}

fn part_labels<'a>(detection: &'a Detection, part: &str) -> Result<&'a PartLabels, Failure> {
    let labels = detection.parts.iter().find(|labels| labels.part.name() == part);
    labels.ok_or_else(|| ArgumentError::UnlabelledPart(part.into()).into())
}
