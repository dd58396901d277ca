//! Scores of cuts between actions.

use std::fs;
use std::path::{Path, PathBuf};

use plantigrade::formats;
use plantigrade::score::{self, CutTally, Tolerance};
use plantigrade::segments::{self, ValidParams};
use plantigrade::skeleton::{Overrides, Skeleton};

use super::trials;
use crate::args::{ReadArgs, ScoreArgs};
use crate::error::{InputError, UsageError};
use crate::input::{self, Input};
use crate::output;
use crate::text::{decode, escape};

/// Tallies of correct cuts by tolerance; `None` if the truth has no ranges.
type Tallies = [Option<CutTally>; Tolerance::REPORTED.len()];

/// Scores all clips of a folder that have truth. Returns the number of inputs that failed.
pub fn run(args: &ScoreArgs) -> Result<usize, UsageError> {
    let params = args.segments.check(trials::method(args)?)?;
    let expected = "NAME.segments.json, NAME.json or segmentation*.json";
    let (trials, failures) = trials::trials(args, expected, |input, read| trial(input, params, read))?;
    if !trials.is_empty() {
        print(&trials);
    }
    Ok(failures)
}

/// Returns the name of the clip and its tallies; `None` if it has no truth.
fn trial(
    input: &Input,
    params: ValidParams,
    read: &ReadArgs,
) -> Result<Option<(String, Tallies)>, InputError> {
    let name = input.path.file_stem().unwrap_or_default().to_string_lossy();
    let Some((path, text)) = read_truth(&input.path, &name)? else { return Ok(None) };
    let clip = input::load(input, read)?.parsed.clip;
    let truth = formats::read_cuts(&text, &name, clip.frame_count(), clip.rate())
        .map_err(|error| InputError::Labels { path, error })?;
    let skeleton = Skeleton::main(&clip, &Overrides::default());
    let cuts = segments::segment(&clip, &skeleton, params, &mut |_| Ok(()))
        .map_err(|error| InputError::Segment { path: input.path.clone(), error })?
        .cuts();
    let has_ranges = truth.iter().any(|cut| cut.earliest < cut.latest);
    let tally = |tolerance| {
        let is_known = tolerance != Tolerance::Inside || has_ranges;
        is_known.then(|| score::cuts(&cuts, &truth, clip.frame_time(), tolerance))
    };
    Ok(Some((escape(&decode(input.stem.as_os_str())), Tolerance::REPORTED.map(tally))))
}

/// Returns path and text of the truth file of a clip, if any. Files named after the clip take
/// precedence over files that cover several clips.
fn read_truth(clip: &Path, name: &str) -> Result<Option<(PathBuf, String)>, InputError> {
    let folder = clip.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let read_error = |path: &Path, error| InputError::Read { path: path.into(), error };
    let mut shared = Vec::new();
    for entry in fs::read_dir(folder).map_err(|error| read_error(folder, error))? {
        let path = entry.map_err(|error| read_error(folder, error))?.path();
        let file = path.file_name().unwrap_or_default().to_string_lossy();
        if file.starts_with("segmentation") && file.ends_with(".json") {
            shared.push(path);
        }
    }
    shared.sort();
    let own_files = ["segments.json", "json"].map(|extension| clip.with_extension(extension));
    for path in own_files.into_iter().chain(shared).filter(|path| path.is_file()) {
        let text = fs::read_to_string(&path).map_err(|error| read_error(&path, error))?;
        if formats::has_segments(&text, name) {
            return Ok(Some((path, text)));
        }
    }
    Ok(None)
}

/// Prints precision, recall and F1 at each tolerance, by clip and pooled.
fn print(trials: &[(String, Tallies)]) {
    let headers = Tolerance::REPORTED.map(|tolerance| match tolerance {
        Tolerance::Seconds(seconds) => format!("±{seconds} s"),
        Tolerance::Inside => "inside".into(),
    });
    output::print(format_args!("cuts: precision, recall and F1\n\n"));
    let headers = headers.map(|header| format!("{header:>24}")).concat();
    output::print(format_args!("{:<24}{:>9}{:>6}{headers}\n", "", "detected", "true"));
    let mut pooled = Tallies::default();
    for (name, tallies) in trials {
        output::print(format_args!("{}\n", row(name, tallies)));
        for (pooled, tally) in pooled.iter_mut().zip(tallies) {
            if let Some(tally) = tally {
                *pooled.get_or_insert_default() += *tally;
            }
        }
    }
    output::print(format_args!("{}\n", row("all cuts", &pooled)));
}

fn row(name: &str, tallies: &Tallies) -> String {
    let CutTally { detected, total, .. } = tallies[0].unwrap_or_default();
    let cells = |tally: Option<CutTally>| match tally {
        Some(tally) => {
            [tally.precision(), tally.recall(), tally.f1()].map(|value| format!("{value:>8.3}")).concat()
        }
        None => format!("{:>8}", "-").repeat(3),
    };
    format!("{name:<24}{detected:>9}{total:>6}{}", tallies.map(cells).concat())
}
