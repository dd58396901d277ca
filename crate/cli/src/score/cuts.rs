//! Cuts between actions against truth.

use std::fs;
use std::path::{Path, PathBuf};

use plantigrade::formats;
use plantigrade::score::{self, CutTally, Tolerance};
use plantigrade::segments::{self, ValidParams};
use plantigrade::skeleton::{Overrides, Skeleton};

use crate::args::{ReadArgs, ScoreArgs};
use crate::failure::Failure;
use crate::inputs::{self, Input};

/// How many cuts were right, by tolerance; `None` where the truth has no ranges to lie inside of.
type Tallies = [Option<CutTally>; Tolerance::USUAL.len()];

/// Scores all clips of a folder that have truth, and counts those that failed.
pub fn run(args: &ScoreArgs) -> Result<usize, String> {
    let params = args.segments.params(super::method(args)?)?;
    let truth = "NAME.segments.json, NAME.json or segmentation*.json";
    let (trials, failed) = super::trials(args, truth, |input, read| trial(input, params, read))?;
    if !trials.is_empty() {
        print(&trials);
    }
    Ok(failed)
}

/// The clip's name with its tallies; `None` where it has no truth.
fn trial(input: &Input, params: ValidParams, read: &ReadArgs) -> Result<Option<(String, Tallies)>, Failure> {
    let name = input.path.file_stem().unwrap_or_default().to_string_lossy();
    let Some((path, text)) = truth(&input.path, &name)? else { return Ok(None) };
    let clip = inputs::load(input, read)?.parsed.clip;
    let truth = formats::read_cuts(&text, &name, clip.frame_count(), clip.rate())
        .map_err(|error| Failure::Truth { path, error })?;
    let skeleton = Skeleton::main(&clip, &Overrides::default());
    let found = segments::segment(&clip, &skeleton, params, &mut |_| Ok(()))
        .map_err(|error| Failure::Segment { path: input.path.clone(), error })?
        .cuts();
    let has_ranges = truth.iter().any(|cut| cut.earliest < cut.latest);
    let tally = |tolerance| {
        let is_known = tolerance != Tolerance::Inside || has_ranges;
        is_known.then(|| score::cuts(&found, &truth, clip.frame_time(), tolerance))
    };
    Ok(Some((input.stem.display().to_string(), Tolerance::USUAL.map(tally))))
}

/// The first file beside a clip that has its segments: its own, or one of many clips.
fn truth(clip: &Path, name: &str) -> Result<Option<(PathBuf, String)>, Failure> {
    let folder = clip.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let read_error = |path: &Path, error| Failure::Read { path: path.into(), error };
    let mut shared = Vec::new();
    for entry in fs::read_dir(folder).map_err(|error| read_error(folder, error))? {
        let path = entry.map_err(|error| read_error(folder, error))?.path();
        let file = path.file_name().unwrap_or_default().to_string_lossy();
        if file.starts_with("segmentation") && file.ends_with(".json") {
            shared.push(path);
        }
    }
    shared.sort();
    let own = ["segments.json", "json"].map(|ending| clip.with_extension(ending));
    for path in own.into_iter().chain(shared).filter(|path| path.is_file()) {
        let text = fs::read_to_string(&path).map_err(|error| read_error(&path, error))?;
        if formats::has_segments(&text, name) {
            return Ok(Some((path, text)));
        }
    }
    Ok(None)
}

/// Prints precision, recall and F1 by clip and pooled, at each tolerance.
fn print(trials: &[(String, Tallies)]) {
    let heads = Tolerance::USUAL.map(|tolerance| match tolerance {
        Tolerance::Seconds(seconds) => format!("±{seconds} s"),
        Tolerance::Inside => "inside".into(),
    });
    println!("cuts: precision, recall and F1\n");
    println!("{:<24}{:>6}{:>6}{}", "", "found", "true", heads.map(|head| format!("{head:>24}")).concat());
    let mut pooled = Tallies::default();
    for (name, tallies) in trials {
        println!("{}", row(name, tallies));
        for (pooled, tally) in pooled.iter_mut().zip(tallies) {
            if let Some(tally) = tally {
                *pooled.get_or_insert_default() += *tally;
            }
        }
    }
    println!("{}", row("all cuts", &pooled));
}

fn row(name: &str, tallies: &Tallies) -> String {
    let CutTally { found, wanted, .. } = tallies[0].unwrap_or_default();
    let shares = |tally: Option<CutTally>| match tally {
        Some(tally) => {
            [tally.precision(), tally.recall(), tally.f1()].map(|share| format!("{share:>8.3}")).concat()
        }
        None => format!("{:>8}", "-").repeat(3),
    };
    format!("{name:<24}{found:>6}{wanted:>6}{}", tallies.map(shares).concat())
}
