//! `plantigrade detect`

use std::collections::BTreeMap;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use plantigrade::bvh::Parsed;
use plantigrade::labels::{self, Document, Labelled, Source};
use plantigrade::plants::{self, DetectError, Detection, Feet, ValidParams};
use plantigrade::skeleton::Skeleton;

use crate::args::{DetectArgs, Format};
use crate::failure::Failure;
use crate::inputs::{self, Input, Loaded};
use crate::output::{OutputFolder, Recipe};
use crate::parallel;

/// Detects in all inputs and counts those that failed; an error is one of the command line.
pub fn run(args: &DetectArgs) -> Result<usize, String> {
    let params = args.method.params()?;
    let still = args.still.as_deref().map(|path| standing(path, args)).transpose()?;
    let still = still.as_ref();
    let inputs = inputs::collect(&args.read)?;
    match &args.out {
        None if inputs.len() > 1 => {
            Err(format!("there are {} inputs: name a folder for their results with --out", inputs.len()))
        }
        None => Ok(parallel::for_each(&inputs, args.jobs, |input| {
            let loaded = inputs::load(input, &args.read)?;
            let text = detect(input, &loaded, params, still, args)?;
            let written = io::stdout().write_all(text.as_bytes());
            written.map_err(|error| Failure::Write { path: "<stdout>".into(), error })
        })),
        Some(folder) => into_folder(&inputs, params, still, args, folder),
    }
}

/// The feet of the clip to be clustered along.
fn standing(path: &Path, args: &DetectArgs) -> Result<Feet, String> {
    let input = Input { path: path.into(), stem: PathBuf::new() };
    let loaded = inputs::load(&input, &args.read).map_err(|failure| failure.to_string())?;
    let clip = &loaded.parsed.clip;
    let feet = Feet::of(clip, &Skeleton::main(clip, &inputs::overrides(&args.read)));
    feet.map_err(|error| format!("{}: {error}", path.display()))
}

fn into_folder(
    inputs: &[Input],
    params: ValidParams,
    still: Option<&Feet>,
    args: &DetectArgs,
    folder: &Path,
) -> Result<usize, String> {
    let result_name = |input: &Input| {
        let mut name = input.stem.clone().into_os_string();
        name.push(".");
        name.push(args.format.ending());
        PathBuf::from(name)
    };
    let mut owners: BTreeMap<PathBuf, &Input> = BTreeMap::new();
    for input in inputs {
        let name = result_name(input);
        if let Some(other) = owners.insert(name.clone(), input) {
            return Err(format!(
                "{} and {} would both be written to {}",
                other.path.display(),
                input.path.display(),
                name.display()
            ));
        }
    }
    let cannot_write = |error| format!("cannot write to {}: {error}", folder.display());
    let output = OutputFolder::open(folder).map_err(cannot_write)?;
    let settings = format!(
        "{params:?} {:?} {} {:?} {:?} {}",
        args.still,
        args.format.ending(),
        args.read.fps,
        args.read.up,
        args.read.lenient
    );
    let failed = parallel::for_each(inputs, args.jobs, |input| {
        let name = result_name(input);
        let loaded = inputs::load(input, &args.read)?;
        let recipe = Recipe { sha256: &loaded.sha256, settings: settings.clone() };
        if !args.force && output.is_made(&name, &recipe) {
            return Ok(());
        }
        let text = detect(input, &loaded, params, still, args)?;
        let written = output.write(&name, &text, &recipe);
        written.map_err(|error| Failure::Write { path: output.path(&name), error })
    });
    output.close().map_err(cannot_write)?;
    Ok(failed)
}

/// The result for one clip, in the format asked for.
fn detect(
    input: &Input,
    loaded: &Loaded,
    params: ValidParams,
    still: Option<&Feet>,
    args: &DetectArgs,
) -> Result<String, Failure> {
    let Parsed { clip, notices } = &loaded.parsed;
    let all = Skeleton::all(clip, &inputs::overrides(&args.read));
    let mut found: Vec<(Skeleton, Detection)> = Vec::new();
    let mut refused = DetectError::NoFeet;
    for skeleton in all {
        match Feet::of(clip, &skeleton) {
            Ok(feet) => {
                let detection = match still {
                    Some(still) => plants::detect_along(&feet, still, params),
                    None => plants::detect(&feet, params),
                };
                found.push((skeleton, detection));
            }
            Err(error) => refused = error,
        }
    }
    if found.is_empty() {
        return Err(Failure::Detect { path: input.path.clone(), error: refused });
    }
    let several = clip.roots().count() > 1;
    let labelled: Vec<Labelled> = found
        .iter()
        .map(|(skeleton, detection)| Labelled {
            root: several.then(|| clip.joints()[skeleton.root].name.as_str()),
            detection,
        })
        .collect();
    Ok(match args.format {
        Format::Csv => labels::frames_csv(&labelled, clip.frame_time()),
        Format::Intervals => labels::intervals_csv(&labelled, clip.frame_time()),
        Format::Events => labels::events_csv(&labelled, clip.frame_time()),
        Format::Json => {
            let name = input.path.file_name().unwrap_or(input.path.as_os_str()).to_string_lossy();
            let document = |(skeleton, detection): &(Skeleton, Detection)| {
                let source = Source { name: name.clone().into_owned(), sha256: Some(loaded.sha256.clone()) };
                Document::of(source, clip, skeleton, detection, notices)
            };
            let documents: Vec<Document> = found.iter().map(document).collect();
            if several { Document::all_to_json(&documents) } else { documents[0].to_json() }
        }
    })
}
