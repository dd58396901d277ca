//! Clips and their reader.

use std::collections::BTreeMap;
use std::sync::Arc;

use js_sys::Float32Array;
use plantigrade::bvh::{Clip, Layout, Options, Parsed, Reader, Rewriter};
use plantigrade::formats::{PlantExport, PlantFormat, Source};
use plantigrade::notice::Notice;
use plantigrade::plants::{self, Corrections, Detection, Detector, Feet, Method, Params, ValidParams};
use plantigrade::skeleton::{self, Role, Skeleton};
use tsify::Ts;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::detection::{WasmDetection, edits_from_js};
use crate::names;
use crate::positions;
use crate::second::second_module;
use crate::types::{
    ClipInfo, DetectOptions, EditInfo, Failure, Overrides, SimilarInfo, from_js, parse_name, to_js,
};

/// Longest clip whose foot tracks are cached between detections, in frames; they occupy 24 MB.
const MAX_CACHED_FRAMES: usize = 100_000;

/// Reads a file chunk by chunk.
#[wasm_bindgen]
pub struct WasmReader(Reader);

#[wasm_bindgen]
impl WasmReader {
    /// Creates a reader for a file of `bytes` bytes. If `lenient`, a value that is not a number is
    /// replaced by that of the previous frame.
    #[wasm_bindgen(constructor)]
    pub fn new(lenient: bool, bytes: f64) -> WasmReader {
        WasmReader(Reader::new(Options {
            lenient,
            expected_bytes: bytes as u64,
            decode_names: names::decode,
            ..Options::default()
        }))
    }

    /// Reads the next chunk.
    ///
    /// # Errors
    /// If the file cannot be read; free the reader in that case.
    pub fn push(&mut self, chunk: &[u8]) -> Result<(), Failure> {
        Ok(self.0.push(chunk)?)
    }

    /// Finishes the file and consumes the reader.
    ///
    /// # Errors
    /// If the file as a whole cannot be read.
    pub fn finish(self) -> Result<WasmClip, Failure> {
        let Parsed { clip, notices, layout } = self.0.finish()?;
        let skeleton = Skeleton::main(&clip, &skeleton::Overrides::default());
        let (original_frame_time, clip) = (clip.frame_time(), Arc::new(clip));
        Ok(WasmClip { original_frame_time, clip, layout, notices, skeleton, detector: None })
    }
}

impl WasmClip {
    pub(crate) fn core(&self) -> &Arc<Clip> {
        &self.clip
    }

    /// Detects with the cached detector or, in a long clip, once.
    fn detect_with(
        &mut self,
        repeatedly: impl FnOnce(&mut Detector) -> Detection,
        once: impl FnOnce(&Feet) -> Detection,
    ) -> Result<WasmDetection, Failure> {
        let detection = match &mut self.detector {
            Some(detector) => repeatedly(detector),
            None => {
                let feet = Feet::new(&self.clip, &self.skeleton)?;
                if feet.frame_count() > MAX_CACHED_FRAMES {
                    once(&feet)
                } else {
                    repeatedly(self.detector.insert(Detector::new(feet)))
                }
            }
        };
        Ok(WasmDetection::new(detection, &self.skeleton, self.clip.frame_time()))
    }

    pub(crate) fn skeleton(&self) -> &Skeleton {
        &self.skeleton
    }

    pub(crate) fn notices(&self) -> &[Notice] {
        &self.notices
    }

    pub(crate) fn layout(&self) -> &Arc<Layout> {
        &self.layout
    }

    /// Returns the source entry of documents about the clip.
    pub(crate) fn source(&self, name: String, sha256: Option<String>) -> Source {
        Source { name, sha256, name_encoding: self.layout.name_encoding().map(Into::into) }
    }
}

/// Writes a changed clip, or a part of a clip: copies its file and replaces the numbers that differ.
#[wasm_bindgen]
pub struct WasmRewriter(Rewriter);

#[wasm_bindgen]
impl WasmRewriter {
    /// Reads the next chunk of the file and returns the next bytes of the result.
    pub fn push(&mut self, chunk: &[u8]) -> Vec<u8> {
        rewrite(self, chunk)
    }

    /// Ends the file, consumes the writer and returns the last bytes of the result.
    ///
    /// # Errors
    /// If the file is shorter than the one that the clip was read from.
    pub fn finish(self) -> Result<Vec<u8>, Failure> {
        finish_rewriting(self)
    }
}

impl From<Rewriter> for WasmRewriter {
    fn from(rewriter: Rewriter) -> WasmRewriter {
        WasmRewriter(rewriter)
    }
}

/// A clip with its skeleton.
#[wasm_bindgen]
pub struct WasmClip {
    clip: Arc<Clip>,
    layout: Arc<Layout>,
    original_frame_time: f64,
    notices: Vec<Notice>,
    skeleton: Skeleton,
    /// Foot tracks and intermediate results, valid for the current skeleton.
    detector: Option<Detector>,
}

#[wasm_bindgen]
impl WasmClip {
    /// Frames, rate, joints, roles, units and notices.
    ///
    /// # Errors
    /// Only if the conversion to JavaScript fails.
    pub fn info(&self) -> Result<Ts<ClipInfo>, Failure> {
        let Skeleton { roles, up, leg, metres_per_unit, .. } = &self.skeleton;
        to_js(&ClipInfo {
            frames: self.clip.frame_count(),
            rate: self.clip.rate(),
            joints: self.clip.joints().iter().map(Into::into).collect(),
            up: up.to_string(),
            metres_per_unit: *metres_per_unit,
            unit: skeleton::unit_name(*metres_per_unit).map(Into::into),
            leg: leg.map(|leg| leg * metres_per_unit),
            roles: map_of(roles.iter().map(|(role, joint)| (role.name().into(), joint))),
            role_evidence: map_of(
                Role::ALL
                    .into_iter()
                    .filter_map(|role| Some((role.name().into(), roles.assignment(role)?.into()))),
            ),
            role_names: Role::ALL.map(|role| role.name().into()).into(),
            notices: self.notices.iter().chain(&self.skeleton.notices).map(Into::into).collect(),
        })
    }

    /// Joint positions of all poses: frames (or one rest pose) × joints × 3, in metres, Y up.
    pub fn positions(&self) -> Float32Array {
        positions::all(&self.skeleton, &self.clip)
    }

    /// Replaces all overrides.
    ///
    /// # Errors
    /// If an override names something that does not exist; the clip is then unchanged.
    #[wasm_bindgen(js_name = override)]
    pub fn apply(&mut self, overrides: Ts<Overrides>) -> Result<(), Failure> {
        override_clip(self, overrides)
    }

    /// Detects the plants.
    ///
    /// # Errors
    /// If the clip has no motion or no feet, or an option is invalid.
    pub fn detect(&mut self, options: Ts<DetectOptions>) -> Result<WasmDetection, Failure> {
        let params = Params::try_from(&from_js(&options)?)?.check()?;
        if params.method() == Method::default() {
            self.detect_with(
                |detector| detector.detect_by_default(params),
                |feet| plants::detect_by_default(feet, params),
            )
        } else {
            detect_by_any(self, params)
        }
    }

    /// Returns the changes of a detection by which edits apply to similar motion.
    ///
    /// # Errors
    /// If the clip has no motion or no feet, or an entry is not a valid edit.
    pub fn similar(
        &self,
        detection: &WasmDetection,
        edits: Vec<Ts<EditInfo>>,
    ) -> Result<Ts<SimilarInfo>, Failure> {
        similar(self, detection, edits)
    }

    /// Returns the plants of a detection as a file in a format that `plantFormats` lists.
    ///
    /// # Errors
    /// If the format does not exist.
    pub fn save(
        &self,
        detection: &WasmDetection,
        format: &str,
        name: String,
        sha256: Option<String>,
    ) -> Result<Vec<u8>, Failure> {
        save(self, detection, format, name, sha256)
    }
}

/// Returns a map of the entries. Collecting would sort, which is compiled for each type of entries.
fn map_of<T>(entries: impl Iterator<Item = (String, T)>) -> BTreeMap<String, T> {
    let mut map = BTreeMap::new();
    map.extend(entries);
    map
}

second_module! {
    "19" fn override_clip(clip: &mut WasmClip, overrides: Ts<Overrides>) -> Result<(), Failure> {
        let overrides = from_js(&overrides)?;
        let checked = overrides.check(clip.clip.joints().len())?;
        let frame_time = overrides.rate.map_or(clip.original_frame_time, |rate| 1.0 / rate);
        Arc::make_mut(&mut clip.clip).set_frame_time(frame_time);
        clip.skeleton = Skeleton::main(&clip.clip, &checked);
        clip.detector = None;
        Ok(())
    }

    "00" fn detect_by_any(clip: &mut WasmClip, params: ValidParams) -> Result<WasmDetection, Failure> {
        clip.detect_with(|detector| detector.detect(params), |feet| plants::detect(feet, params))
    }

    "01" fn similar(
        clip: &WasmClip,
        detection: &WasmDetection,
        edits: Vec<Ts<EditInfo>>,
    ) -> Result<Ts<SimilarInfo>, Failure> {
        let (edits, _) = edits_from_js(&edits)?;
        let new_feet;
        let feet = match &clip.detector {
            Some(detector) => detector.feet(),
            None => {
                new_feet = Feet::new(&clip.clip, &clip.skeleton)?;
                &new_feet
            }
        };
        let corrections = Corrections::learn(feet, detection.detected(), &edits);
        let corrected = corrections.apply(feet, detection.detected(), &edits);
        let mut changes: Vec<EditInfo> = corrected.changes.into_iter().map(Into::into).collect();
        for instant in corrected.instants {
            // That of a boundary that stays in its frame is part of any change.
            let (side, part, frame) = (instant.side, instant.part, instant.edge.frame);
            let is_own = |change: &EditInfo| {
                (change.side, change.part) == (side, part) && [change.start, change.end].contains(&frame)
            };
            let index = changes.iter().position(is_own).unwrap_or(0);
            changes.get_mut(index).into_iter().for_each(|change| change.instants.push(instant.into()));
        }
        to_js(&SimilarInfo { changes, plants: corrected.plants })
    }

    "02" fn save(
        clip: &WasmClip,
        detection: &WasmDetection,
        format: &str,
        name: String,
        sha256: Option<String>,
    ) -> Result<Vec<u8>, Failure> {
        let format: PlantFormat = parse_name(format)?;
        Ok(format.write(&PlantExport {
            source: clip.source(name, sha256),
            clip: &clip.clip,
            notices: &clip.notices,
            skeletons: vec![(&clip.skeleton, detection.core())],
            as_array: false,
        }))
    }

    "03" fn rewrite(rewriter: &mut WasmRewriter, chunk: &[u8]) -> Vec<u8> {
        rewriter.0.push(chunk)
    }

    "04" fn finish_rewriting(rewriter: WasmRewriter) -> Result<Vec<u8>, Failure> {
        Ok(rewriter.0.finish()?)
    }
}
