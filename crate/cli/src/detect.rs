//! `plantigrade detect`

use std::path::{Path, PathBuf};

use plantigrade::bvh::Parsed;
use plantigrade::formats::{self, Document, Labelled};
use plantigrade::plants::{self, DetectError, Detection, Feet, ValidParams};
use plantigrade::skeleton::Skeleton;

use crate::args::{DetectArgs, Format};
use crate::failure::Failure;
use crate::inputs::{self, Input, Loaded};
use crate::results::Results;

/// Detects in all inputs and counts those that failed; an error is one of the command line.
pub fn run(args: &DetectArgs) -> Result<usize, String> {
    let params = args.find.params()?;
    let still = args.still.as_deref().map(|path| standing(path, args)).transpose()?;
    let results = Results {
        read: &args.read,
        write: &args.write,
        ending: args.format.ending(),
        settings: format!("{params:?} {:?}", args.still),
    };
    results.make(|input, loaded| detect(input, loaded, params, still.as_ref(), args))
}

/// The feet of the clip to be clustered along.
fn standing(path: &Path, args: &DetectArgs) -> Result<Feet, String> {
    let input = Input { path: path.into(), stem: PathBuf::new() };
    let loaded = inputs::load(&input, &args.read).map_err(|failure| failure.to_string())?;
    let clip = &loaded.parsed.clip;
    let feet = Feet::new(clip, &Skeleton::main(clip, &loaded.overrides));
    feet.map_err(|error| format!("{}: {error}", path.display()))
}

/// One skeleton with its feet and what was detected.
pub type Found = (Skeleton, Feet, Detection);

/// What is detected in each skeleton of a clip that has feet: one at least.
pub fn all(
    input: &Input,
    loaded: &Loaded,
    params: ValidParams,
    still: Option<&Feet>,
) -> Result<Vec<Found>, Failure> {
    let clip = &loaded.parsed.clip;
    let mut found: Vec<Found> = Vec::new();
    let mut refused = DetectError::NoFeet;
    for skeleton in Skeleton::all(clip, &loaded.overrides) {
        match Feet::new(clip, &skeleton) {
            Ok(feet) => {
                let detection = match still {
                    Some(still) => plants::detect_along(&feet, still, params),
                    None => plants::detect(&feet, params),
                };
                found.push((skeleton, feet, detection));
            }
            Err(error) => refused = error,
        }
    }
    if found.is_empty() {
        return Err(Failure::Detect { path: input.path.clone(), error: refused });
    }
    Ok(found)
}

/// The result for one clip, in the format asked for.
fn detect(
    input: &Input,
    loaded: &Loaded,
    params: ValidParams,
    still: Option<&Feet>,
    args: &DetectArgs,
) -> Result<Vec<u8>, Failure> {
    let Parsed { clip, notices } = &loaded.parsed;
    let found = all(input, loaded, params, still)?;
    let several = clip.roots().count() > 1;
    let labelled: Vec<Labelled> = found
        .iter()
        .map(|(skeleton, _, detection)| Labelled {
            root: several.then(|| clip.joints()[skeleton.root].name.as_str()),
            detection,
        })
        .collect();
    let source = loaded.source(input);
    let text = match args.format {
        Format::Npz => return Ok(formats::npz(&labelled, &source.name, clip.frame_time())),
        Format::Blender => formats::blender_script(&labelled, &source.name, clip.frame_time()),
        Format::Csv => formats::frames_csv(&labelled, clip.frame_time()),
        Format::Intervals => formats::intervals_csv(&labelled, clip.frame_time()),
        Format::Events => formats::events_csv(&labelled, clip.frame_time()),
        Format::Json => {
            let document = |(skeleton, _, detection): &Found| {
                Document::of(source.clone(), clip, skeleton, detection, notices)
            };
            let documents: Vec<Document> = found.iter().map(document).collect();
            if several { Document::all_to_json(&documents) } else { documents[0].to_json() }
        }
    };
    Ok(text.into_bytes())
}
