//! `plantigrade clean`

use std::fs;
use std::path::{Path, PathBuf};

use plantigrade::bvh;
use plantigrade::formats;
use plantigrade::plants::{self, Feet};
use plantigrade::skate::{self, Cleaned, Contacts, Options};
use plantigrade::skeleton::Skeleton;

use crate::args::CleanArgs;
use crate::failure::{self, Failure};
use crate::inputs::{self, Input, Loaded};
use crate::output;

/// Cleans up one clip and counts it if it failed; an error is one of the command line.
pub fn run(args: &CleanArgs) -> Result<usize, String> {
    let params = args.find.params()?;
    let [input] = <[Input; 1]>::try_from(inputs::collect(&args.read)?)
        .map_err(|inputs| format!("there are {} inputs: name one clip to clean up", inputs.len()))?;
    if args.labels.as_deref() == Some(Path::new("-")) && input.path == Path::new("-") {
        return Err("standard input cannot be both the clip and its labels".into());
    }
    let done = inputs::load(&input, &args.read).and_then(|loaded| clean(&input, &loaded, params, args));
    Ok(match done {
        Ok(()) => 0,
        Err(failure) => {
            eprintln!("{failure}");
            1
        }
    })
}

/// Cleans up, writes the result and says what came of it.
fn clean(
    input: &Input,
    loaded: &Loaded,
    params: plants::ValidParams,
    args: &CleanArgs,
) -> Result<(), Failure> {
    let clip = &loaded.parsed.clip;
    let skeleton = Skeleton::main(clip, &loaded.overrides);
    let contacts = match &args.labels {
        Some(path) => {
            let text = read(path)?;
            let labelling = formats::read(&text, clip.frame_count());
            let truth = |error| Failure::Truth { path: path.clone(), error };
            Contacts::from(&labelling.map_err(truth)?)
        }
        None => {
            let detect = |error| Failure::Detect { path: input.path.clone(), error };
            Contacts::from(&plants::detect(&Feet::new(clip, &skeleton).map_err(detect)?, params))
        }
    };
    let cleaned = skate::clean(clip, &skeleton, &contacts, &Options::default());
    let cleaned = cleaned.map_err(|error| Failure::Clean { path: input.path.clone(), error })?;
    let written = output::replace(&args.out, bvh::write(&cleaned.clip).as_bytes());
    written.map_err(|error| Failure::Write { path: args.out.clone(), error })?;
    let name = failure::name(&input.path);
    eprintln!("{name}: {}", summary(&cleaned));
    for notice in skeleton.notices.iter().chain(&cleaned.notices) {
        eprintln!("{name}: {notice}");
    }
    Ok(())
}

/// The text of a file or of standard input.
fn read(path: &PathBuf) -> Result<String, Failure> {
    let text = if path == Path::new("-") {
        std::io::read_to_string(std::io::stdin())
    } else {
        fs::read_to_string(path)
    };
    text.map_err(|error| Failure::Read { path: path.clone(), error })
}

/// One line: plants, and their slide before and after.
fn summary(cleaned: &Cleaned) -> String {
    let of = |slide: fn(&skate::CleanedPlant) -> f64| {
        let slides = || cleaned.plants.iter().map(slide);
        let mean = slides().sum::<f64>() / cleaned.plants.len().max(1) as f64;
        [mean, slides().fold(0.0, f64::max)].map(|metres| 1e3 * metres)
    };
    let ([mean, worst], [mean_after, worst_after]) = (of(|plant| plant.before), of(|plant| plant.after));
    format!(
        "{} plants, {} held; slide {mean:.1} → {mean_after:.1} mm in the mean, {worst:.1} → {worst_after:.1} mm at worst",
        cleaned.plants.len(),
        cleaned.constrained(),
    )
}
