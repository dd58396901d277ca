//! Foot skate, measured and removed.

use js_sys::Float32Array;
use plantigrade::bvh::{self, Clip};
use plantigrade::skate::{self, Cleaned, Contacts, Options, Slide};
use plantigrade::skeleton::Skeleton;
use serde::{Deserialize, Serialize};
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::positions;
use crate::records::{Failure, NoticeText, to_js};
use crate::{RawClip, RawDetection};

/// How far one plant slides; frames half-open.
#[derive(Debug, Serialize, Deserialize, Tsify)]
pub struct SlideFacts {
    /// The foot.
    #[tsify(type = r#""left" | "right""#)]
    pub side: String,
    /// First frame in which heel or toe stands.
    pub start: usize,
    /// First frame after.
    pub end: usize,
    /// Greatest distance of what stands from its mean position, level with the ground, in metres.
    pub farthest: f64,
}

/// What became of one plant in a clip without foot skate; frames half-open.
#[derive(Debug, Serialize, Deserialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct CleanedPlantFacts {
    /// The foot.
    #[tsify(type = r#""left" | "right""#)]
    pub side: String,
    /// First frame in which heel or toe stands.
    pub start: usize,
    /// First frame after.
    pub end: usize,
    /// How far it slid, in metres.
    pub before: f64,
    /// How far it still does, in metres.
    pub after: f64,
    /// Why the foot is not held, where it is not.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub why_not: Option<String>,
}

/// A clip whose planted feet stand still.
#[wasm_bindgen]
pub struct RawCleaned {
    cleaned: Cleaned,
    skeleton: Skeleton,
}

#[wasm_bindgen]
impl RawClip {
    /// How far every plant of a detection slides: the left foot's, then the right's.
    ///
    /// # Errors
    /// If the clip has no motion or no feet.
    pub fn skate(&self, detection: &RawDetection) -> Result<Vec<Ts<SlideFacts>>, Failure> {
        let skate = skate::measure(self.core(), self.skeleton(), &Contacts::from(detection.core()))?;
        skate.plants.iter().map(|slide| to_js(&SlideFacts::from(slide))).collect()
    }

    /// Holds every planted foot still where it stands.
    ///
    /// # Errors
    /// If the clip has no motion or no feet.
    pub fn clean(&self, detection: &RawDetection) -> Result<RawCleaned, Failure> {
        let contacts = Contacts::from(detection.core());
        let cleaned = skate::clean(self.core(), self.skeleton(), &contacts, &Options::default())?;
        Ok(RawCleaned { cleaned, skeleton: self.skeleton().clone() })
    }
}

#[wasm_bindgen]
impl RawCleaned {
    /// What became of every plant: the left foot's, then the right's.
    ///
    /// # Errors
    /// None that a clip can cause; so for the notices.
    pub fn plants(&self) -> Result<Vec<Ts<CleanedPlantFacts>>, Failure> {
        let facts = self.cleaned.plants.iter().map(|plant| CleanedPlantFacts {
            side: plant.side.name().into(),
            start: plant.frames.start,
            end: plant.frames.end,
            before: plant.before,
            after: plant.after,
            why_not: plant.why_not.map(|why| why.to_string()),
        });
        facts.map(|facts| to_js(&facts)).collect()
    }

    /// What was left out or assumed.
    pub fn notices(&self) -> Result<Vec<Ts<NoticeText>>, Failure> {
        self.cleaned.notices.iter().map(|notice| to_js(&NoticeText::from(notice))).collect()
    }

    /// All poses: frames × joints × 3 in metres, Y up.
    pub fn positions(&self) -> Float32Array {
        positions::all(&self.skeleton, self.clip())
    }

    /// The bytes of the clip as a BVH file: those of an hour take seconds to make a string of.
    pub fn bvh(&self) -> Vec<u8> {
        bvh::write(self.clip()).into_bytes()
    }

    fn clip(&self) -> &Clip {
        &self.cleaned.clip
    }
}

impl From<&Slide> for SlideFacts {
    fn from(slide: &Slide) -> SlideFacts {
        SlideFacts {
            side: slide.side.name().into(),
            start: slide.frames.start,
            end: slide.frames.end,
            farthest: slide.farthest,
        }
    }
}
