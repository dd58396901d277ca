//! `plantigrade detect`: labels foot plants.

use std::path::{Path, PathBuf};

use plantigrade::bvh::Parsed;
use plantigrade::formats::{self, PlantExport};
use plantigrade::plants::{
    self, Corrections, DetectError, Detection, Edit, Family, Feet, Method, ValidParams,
};
use plantigrade::skeleton::Skeleton;

use crate::args::{DetectArgs, warn_of_unused};
use crate::batch::Batch;
use crate::error::{InputError, UsageError};
use crate::input::{self, Input, LoadedClip};
use crate::output;
use crate::output_folder::hex_digest;

/// Detects plants in all inputs. Returns the number of inputs that failed.
pub fn run(args: &DetectArgs) -> Result<usize, UsageError> {
    let params = args.detection.params()?;
    input::check_stdin(&args.read, &[&args.still, &args.constraints, &args.constraints_clip])?;
    let loaded = load_standing(args).and_then(|standing| Ok((standing, Constraints::load(args)?)));
    let (standing, constraints) = match loaded {
        Ok(loaded) => loaded,
        Err(error) => {
            output::report(format_args!("{error}"));
            return Ok(1);
        }
    };
    args.detection.warn_of_unused();
    let uses_still = params.method() != Method::Robust && params.method().family() == Family::Spectral;
    warn_of_unused(&[("--still", args.still.is_some() && !uses_still)], params.method().name());
    let (standing, standing_sha256) = standing.unzip();
    if let Some(Constraints { clip: None, .. }) = constraints {
        let inputs = input::collect(&args.read)?.len();
        if inputs > 1 {
            return Err(UsageError::ConstraintsClip(inputs));
        }
    }
    let batch = Batch {
        read: &args.read,
        write: &args.write,
        extension: args.format.extension(),
        options: format!(
            "{params:?} {standing_sha256:?} {:?}",
            constraints.as_ref().map(|constraints| &constraints.sha256)
        ),
    };
    batch.run(|input, loaded| detect(input, loaded, params, standing.as_ref(), constraints.as_ref(), args))
}

/// Corrections of a person.
struct Constraints {
    path: PathBuf,
    bytes: Vec<u8>,
    /// The clip that the corrections belong to, if it is not the input: hash of its file, corrections that were
    /// learnt from it, and its edits.
    clip: Option<(String, Corrections, Vec<Edit>)>,
    /// Hashes of the files.
    sha256: [String; 2],
}

impl Constraints {
    /// Loads the corrections named on the command line, if any.
    fn load(args: &DetectArgs) -> Result<Option<Constraints>, InputError> {
        let Some(path) = args.constraints.as_deref() else { return Ok(None) };
        let params = args.detection.params().expect("parameters were checked before");
        let bytes = input::read_file(path)?;
        let hash = hex_digest(&bytes);
        let Some(clip_path) = &args.constraints_clip else {
            let sha256 = [hash, String::new()];
            return Ok(Some(Constraints { path: path.into(), bytes, clip: None, sha256 }));
        };
        let input = Input { path: clip_path.clone(), stem: PathBuf::new(), problem: None };
        let loaded = input::load(&input, &args.read)?;
        let detected = detect_all(&input, &loaded, params, None)?;
        let (_, feet, detection) = &detected[0];
        let edits = read_edits(path, &bytes, &loaded, detection)?;
        let corrections = Corrections::learn(feet, detection, &edits);
        let sha256 = [hash, loaded.sha256.clone()];
        let clip = Some((loaded.sha256, corrections, edits));
        Ok(Some(Constraints { path: path.into(), bytes, clip, sha256 }))
    }

    /// Applies the corrections to a clip.
    fn apply(
        &self,
        loaded: &LoadedClip,
        feet: &Feet,
        detection: &Detection,
    ) -> Result<Detection, InputError> {
        let mut corrected = match &self.clip {
            Some((sha256, corrections, edits)) => {
                let own: &[Edit] = if *sha256 == loaded.sha256 { edits } else { &[] };
                corrections.apply(feet, detection, own)
            }
            None => {
                let edits = read_edits(&self.path, &self.bytes, loaded, detection)?;
                Corrections::learn(feet, detection, &edits).apply(feet, detection, &edits)
            }
        };
        corrected.detection.notices.push(corrected.notice());
        Ok(corrected.detection)
    }
}

/// Reads corrections of a detection.
fn read_edits(
    path: &Path,
    bytes: &[u8],
    loaded: &LoadedClip,
    detection: &Detection,
) -> Result<Vec<Edit>, InputError> {
    let edits = formats::read_edits(bytes, loaded.parsed.clip.frame_count())
        .map_err(|error| InputError::Labels { path: path.into(), error })?;
    match edits.iter().find(|edit| detection.part(edit.part).is_none()) {
        Some(Edit { part, .. }) => Err(InputError::UnlabelledPart {
            path: path.into(),
            part: part.name(),
            method: detection.params.method().name(),
        }),
        None => Ok(edits),
    }
}

/// Loads the feet of the standing clip that is clustered together with the inputs, if any. Returns them with
/// the SHA-256 of the file.
fn load_standing(args: &DetectArgs) -> Result<Option<(Feet, String)>, InputError> {
    let Some(path) = args.still.as_deref() else { return Ok(None) };
    let input = Input { path: path.into(), stem: PathBuf::new(), problem: None };
    let loaded = input::load(&input, &args.read)?;
    let clip = &loaded.parsed.clip;
    let feet = Feet::new(clip, &loaded.main_skeleton());
    let feet = feet.map_err(|error| InputError::Detect { path: path.into(), error })?;
    Ok(Some((feet, loaded.sha256)))
}

/// A skeleton with its feet and its detection.
pub type DetectedSkeleton = (Skeleton, Feet, Detection);

/// Detects plants in each skeleton of a clip that has feet. Returns at least one detection.
pub fn detect_all(
    input: &Input,
    loaded: &LoadedClip,
    params: ValidParams,
    standing: Option<&Feet>,
) -> Result<Vec<DetectedSkeleton>, InputError> {
    let clip = &loaded.parsed.clip;
    let mut detected: Vec<DetectedSkeleton> = Vec::new();
    let mut last_error = DetectError::NoFeet;
    for skeleton in loaded.skeletons() {
        match Feet::new(clip, &skeleton) {
            Ok(feet) => {
                let detection = match standing {
                    Some(standing) => plants::detect_with_standing(&feet, standing, params),
                    None => plants::detect(&feet, params),
                };
                detected.push((skeleton, feet, detection));
            }
            Err(error) => last_error = error,
        }
    }
    if detected.is_empty() {
        return Err(InputError::Detect { path: input.path.clone(), error: last_error });
    }
    Ok(detected)
}

/// Returns the result for one clip in the requested format.
fn detect(
    input: &Input,
    loaded: &LoadedClip,
    params: ValidParams,
    standing: Option<&Feet>,
    constraints: Option<&Constraints>,
    args: &DetectArgs,
) -> Result<Vec<u8>, InputError> {
    let Parsed { clip, notices, .. } = &loaded.parsed;
    let mut detected = detect_all(input, loaded, params, standing)?;
    if let (Some(constraints), [(_, feet, detection), ..]) = (constraints, &mut detected[..]) {
        *detection = constraints.apply(loaded, feet, detection)?;
    }
    Ok(args.format.write(&PlantExport {
        source: loaded.source(input),
        clip,
        notices,
        skeletons: detected.iter().map(|(skeleton, _, detection)| (skeleton, detection)).collect(),
        as_array: clip.roots().count() > 1,
    }))
}
