//! `plantigrade detect`: labels foot plants.

use std::path::{Path, PathBuf};

use plantigrade::bvh::Parsed;
use plantigrade::formats::PlantExport;
use plantigrade::plants::{self, DetectError, Detection, Feet, ValidParams};
use plantigrade::skeleton::Skeleton;

use crate::args::DetectArgs;
use crate::batch::Batch;
use crate::error::{InputError, UsageError};
use crate::input::{self, Input, LoadedClip};

/// Detects plants in all inputs. Returns the number of inputs that failed.
pub fn run(args: &DetectArgs) -> Result<usize, UsageError> {
    let params = args.detection.params()?;
    let standing = args.still.as_deref().map(|path| load_standing(path, args)).transpose();
    let (standing, standing_sha256) = standing.map_err(UsageError::Still)?.unzip();
    let batch = Batch {
        read: &args.read,
        write: &args.write,
        extension: args.format.extension(),
        options: format!("{params:?} {standing_sha256:?}"),
    };
    batch.run(|input, loaded| detect(input, loaded, params, standing.as_ref(), args))
}

/// Loads the feet of the standing clip that is clustered together with the inputs. Returns them with the
/// SHA-256 of the file.
fn load_standing(path: &Path, args: &DetectArgs) -> Result<(Feet, String), InputError> {
    let input = Input { path: path.into(), stem: PathBuf::new(), problem: None };
    let loaded = input::load(&input, &args.read)?;
    let clip = &loaded.parsed.clip;
    let feet = Feet::new(clip, &loaded.main_skeleton());
    let feet = feet.map_err(|error| InputError::Detect { path: path.into(), error })?;
    Ok((feet, loaded.sha256))
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
    args: &DetectArgs,
) -> Result<Vec<u8>, InputError> {
    let Parsed { clip, notices, .. } = &loaded.parsed;
    let detected = detect_all(input, loaded, params, standing)?;
    Ok(args.format.write(&PlantExport {
        source: loaded.source(input),
        clip,
        notices,
        skeletons: detected.iter().map(|(skeleton, _, detection)| (skeleton, detection)).collect(),
        as_array: clip.roots().count() > 1,
    }))
}
