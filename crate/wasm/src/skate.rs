//! Measurement and clean-up of foot skate.

use std::sync::Arc;

use js_sys::Float32Array;
use plantigrade::bvh::{Clip, Layout, Rewriter};
use plantigrade::notice::Notice;
use plantigrade::skate::{self, Cleaned, CleanedPlant, Contacts, Options, Slide};
use plantigrade::skeleton::Skeleton;
use serde::{Deserialize, Serialize};
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::positions;
use crate::second::second_module;
use crate::types::{Failure, NoticeInfo, from_js, parse_side, to_js};
use crate::{WasmClip, WasmDetection, WasmRewriter};

/// The slide of one plant, over half-open frames.
#[derive(Debug, Serialize, Deserialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct SlideInfo {
    /// The foot.
    #[tsify(type = r#""left" | "right""#)]
    pub side: String,
    /// First frame in which heel or toe is in contact.
    pub start: usize,
    /// First frame after the plant.
    pub end: usize,
    /// Largest horizontal distance of the contact point from its mean position, in metres.
    pub max_distance: f64,
    /// Frame of the largest distance.
    pub frame: usize,
}

/// Frames of one foot, half-open.
#[derive(Debug, Serialize, Deserialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct FootFrames {
    /// The foot.
    #[tsify(type = r#""left" | "right""#)]
    pub side: String,
    /// First frame.
    pub start: usize,
    /// First frame after the range.
    pub end: usize,
}

/// Result of the clean-up for one plant, over half-open frames.
#[derive(Debug, Serialize, Deserialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct CleanedPlantInfo {
    /// The foot.
    #[tsify(type = r#""left" | "right""#)]
    pub side: String,
    /// First frame in which heel or toe is in contact.
    pub start: usize,
    /// First frame after the plant.
    pub end: usize,
    /// Slide before the clean-up, in metres.
    pub before: f64,
    /// Slide after the clean-up, in metres.
    pub after: f64,
    /// Reason why the foot was not constrained, if it was not.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub skip_reason: Option<String>,
}

/// A clip with its foot skate removed.
#[wasm_bindgen]
pub struct WasmCleanedClip {
    clip: Arc<Clip>,
    plants: Vec<CleanedPlant>,
    notices: Vec<Notice>,
    layout: Arc<Layout>,
    skeleton: Skeleton,
}

#[wasm_bindgen]
impl WasmClip {
    /// Slide of every plant of a detection: those of the left foot, then those of the right.
    ///
    /// # Errors
    /// If the clip has no motion or no feet.
    pub fn skate(&self, detection: &WasmDetection) -> Result<Vec<Ts<SlideInfo>>, Failure> {
        skate(self, detection)
    }

    /// Removes foot skate: constrains every planted foot to one position. Spikes of the hips, short jumps
    /// away and back, are interpolated unless `keep_spikes`. If `only` is not empty, only plants that overlap
    /// one of its ranges are corrected.
    ///
    /// # Errors
    /// If the clip has no motion or no feet, or `only` has an unknown side.
    pub fn clean(
        &self,
        detection: &WasmDetection,
        keep_spikes: bool,
        only: Vec<Ts<FootFrames>>,
    ) -> Result<WasmCleanedClip, Failure> {
        clean(self, detection, keep_spikes, only)
    }
}

#[wasm_bindgen]
impl WasmCleanedClip {
    /// Result for every plant: those of the left foot, then those of the right.
    ///
    /// # Errors
    /// Only if the conversion to JavaScript fails; the same holds for the notices.
    pub fn plants(&self) -> Result<Vec<Ts<CleanedPlantInfo>>, Failure> {
        plants(self)
    }

    /// Omissions and assumptions of the clean-up.
    pub fn notices(&self) -> Result<Vec<Ts<NoticeInfo>>, Failure> {
        self.notices.iter().map(|notice| to_js(&NoticeInfo::from(notice))).collect()
    }

    /// Joint positions of all poses: frames × joints × 3, in metres, Y up.
    pub fn positions(&self) -> Float32Array {
        positions::all(&self.skeleton, &self.clip)
    }

    /// Returns a writer of the clip, to which the file of the original clip is given.
    pub fn rewriter(&self) -> WasmRewriter {
        rewriter(self)
    }
}

impl From<&Slide> for SlideInfo {
    fn from(slide: &Slide) -> SlideInfo {
        SlideInfo {
            side: slide.side.name().into(),
            start: slide.frames.start,
            end: slide.frames.end,
            max_distance: slide.distance,
            frame: slide.frame,
        }
    }
}

second_module! {
    "15" fn skate(clip: &WasmClip, detection: &WasmDetection) -> Result<Vec<Ts<SlideInfo>>, Failure> {
        let skate = skate::measure(clip.core(), clip.skeleton(), &Contacts::from(detection.core()))?;
        skate.plants.iter().map(|slide| to_js(&SlideInfo::from(slide))).collect()
    }

    "16" fn clean(
        clip: &WasmClip,
        detection: &WasmDetection,
        keep_spikes: bool,
        only: Vec<Ts<FootFrames>>,
    ) -> Result<WasmCleanedClip, Failure> {
        let contacts = Contacts::from(detection.core());
        let selected = only.iter().map(|range| {
            let FootFrames { side, start, end } = from_js(range)?;
            Ok((parse_side(&side)?, start..end))
        });
        let options = Options {
            repair_spikes: !keep_spikes,
            only: selected.collect::<Result<_, Failure>>()?,
            ..Options::default()
        };
        let cleaned = skate::clean(clip.core(), clip.skeleton(), &contacts, &options)?;
        let Cleaned { clip: cleaned, plants, notices } = cleaned;
        let (layout, skeleton) = (clip.layout().clone(), clip.skeleton().clone());
        Ok(WasmCleanedClip { clip: Arc::new(cleaned), plants, notices, layout, skeleton })
    }

    "17" fn plants(cleaned: &WasmCleanedClip) -> Result<Vec<Ts<CleanedPlantInfo>>, Failure> {
        let plants = cleaned.plants.iter().map(|plant| CleanedPlantInfo {
            side: plant.side.name().into(),
            start: plant.frames.start,
            end: plant.frames.end,
            before: plant.before,
            after: plant.after,
            skip_reason: plant.skip_reason.map(|reason| reason.to_string()),
        });
        plants.map(|plant| to_js(&plant)).collect()
    }

    "18" fn rewriter(cleaned: &WasmCleanedClip) -> WasmRewriter {
        Rewriter::new(cleaned.layout.clone(), cleaned.clip.clone(), 0..cleaned.clip.frame_count()).into()
    }
}
