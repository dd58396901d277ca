//! Reading a clip and holding it.

use std::cell::OnceCell;

use js_sys::Float32Array;
use plantigrade::bvh::{Clip, Options, Parsed, Reader};
use plantigrade::notice::Notice;
use plantigrade::plants::{self, Detector, Feet, Params};
use plantigrade::skeleton::{self, Role, Skeleton};
use tsify::Ts;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::detection::RawDetection;
use crate::positions;
use crate::records::{ClipFacts, DetectOptions, Failure, Overrides, from_js, to_js};

/// Feet of longer clips are not kept for another detection: those of so many frames take 24 MB.
const MOST_KEPT: usize = 100_000;

/// Reads a file chunk by chunk.
#[wasm_bindgen]
pub struct RawReader(Reader);

#[wasm_bindgen]
impl RawReader {
    /// A reader at the beginning of a file of so many bytes; a lenient one holds values over
    /// what is no number.
    #[wasm_bindgen(constructor)]
    pub fn new(lenient: bool, bytes: f64) -> RawReader {
        RawReader(Reader::new(Options { lenient, expected_bytes: bytes as u64, ..Options::default() }))
    }

    /// Takes the next chunk.
    ///
    /// # Errors
    /// If the file cannot be read; free the reader then.
    pub fn push(&mut self, chunk: &[u8]) -> Result<(), Failure> {
        Ok(self.0.push(chunk)?)
    }

    /// Ends the file and uses up the reader.
    ///
    /// # Errors
    /// If the file as a whole cannot be read.
    pub fn finish(self) -> Result<RawClip, Failure> {
        let Parsed { clip, notices } = self.0.finish()?;
        let skeleton = Skeleton::main(&clip, &skeleton::Overrides::default());
        Ok(RawClip {
            found_frame_time: clip.frame_time(),
            clip,
            notices,
            skeleton,
            detector: OnceCell::new(),
        })
    }
}

/// The largest file that is read, in bytes.
#[wasm_bindgen(js_name = mostBytes)]
pub fn most_bytes() -> f64 {
    plantigrade::bvh::Limits::default().bytes as f64
}

impl RawClip {
    pub(crate) fn core(&self) -> &Clip {
        &self.clip
    }

    pub(crate) fn skeleton(&self) -> &Skeleton {
        &self.skeleton
    }

    pub(crate) fn notices(&self) -> &[Notice] {
        &self.notices
    }
}

/// A clip with its skeleton.
#[wasm_bindgen]
pub struct RawClip {
    clip: Clip,
    found_frame_time: f64,
    notices: Vec<Notice>,
    skeleton: Skeleton,
    /// What detection keeps for the next time, as the skeleton stands.
    detector: OnceCell<Detector>,
}

#[wasm_bindgen]
impl RawClip {
    /// What is known of it.
    ///
    /// # Errors
    /// None that a clip can cause.
    pub fn facts(&self) -> Result<Ts<ClipFacts>, Failure> {
        let Skeleton { roles, up, leg, metres_per_unit, .. } = &self.skeleton;
        to_js(&ClipFacts {
            frames: self.clip.frame_count(),
            rate: self.clip.rate(),
            joints: self.clip.joints().iter().map(Into::into).collect(),
            up: up.to_string(),
            metres_per_unit: *metres_per_unit,
            unit: skeleton::unit_name(*metres_per_unit).map(Into::into),
            leg: leg.map(|leg| leg * metres_per_unit),
            roles: roles.iter().map(|(role, joint)| (role.name().into(), joint)).collect(),
            role_names: Role::ALL.map(|role| role.name().into()).into(),
            notices: self.notices.iter().chain(&self.skeleton.notices).map(Into::into).collect(),
        })
    }

    /// All poses: frames (or one rest pose) × joints × 3 in metres, Y up.
    pub fn positions(&self) -> Float32Array {
        positions::all(&self.skeleton, &self.clip)
    }

    /// Puts overrides in place of those before.
    ///
    /// # Errors
    /// If they name what does not exist; nothing has changed then.
    #[wasm_bindgen(js_name = override)]
    pub fn apply(&mut self, overrides: Ts<Overrides>) -> Result<(), Failure> {
        let overrides = from_js(&overrides)?;
        let checked = overrides.check(self.clip.joints().len())?;
        let frame_time = overrides.rate.map_or(self.found_frame_time, |rate| 1.0 / rate);
        self.clip.set_frame_time(frame_time);
        self.skeleton = Skeleton::main(&self.clip, &checked);
        self.detector = OnceCell::new();
        Ok(())
    }

    /// Finds the plants.
    ///
    /// # Errors
    /// If there is no motion, there are no feet, or an option breaks its rule.
    pub fn detect(&self, options: Ts<DetectOptions>) -> Result<RawDetection, Failure> {
        let params = Params::try_from(&from_js(&options)?)?.check()?;
        let found = match self.detector.get() {
            Some(detector) => detector.detect(params),
            None => {
                let feet = Feet::of(&self.clip, &self.skeleton)?;
                if feet.frame_count() > MOST_KEPT {
                    plants::detect_once(feet, params)
                } else {
                    self.detector.get_or_init(|| Detector::new(feet)).detect(params)
                }
            }
        };
        Ok(RawDetection::new(found, self.skeleton.metres_per_unit, self.clip.frame_time()))
    }

    /// The labels of a detection as a file: `json`, `csv`, `intervals`, `events`, `npz` or `blender`.
    ///
    /// # Errors
    /// If there is no such format.
    pub fn save(
        &self,
        detection: &RawDetection,
        format: &str,
        name: String,
        sha256: Option<String>,
    ) -> Result<Vec<u8>, Failure> {
        detection.save(format, name, sha256, &self.clip, &self.skeleton, &self.notices)
    }
}
