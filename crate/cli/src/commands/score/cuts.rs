//! Scores of cuts between actions, and of the classes of the actions.

use std::fs;
use std::path::{Path, PathBuf};

use plantigrade::formats;
use plantigrade::score::{self, ClassScore, CutTally, Tally, Tolerance};
use plantigrade::segments::{self, Segment, ValidParams};
use plantigrade::skeleton::{Overrides, Skeleton};

use super::trials;
use crate::args::{ReadArgs, ScoreArgs};
use crate::error::{InputError, UsageError};
use crate::input::{self, Input};
use crate::output;
use crate::text::{decode, escape};

/// Tallies of correct cuts by tolerance; `None` if the truth has no ranges.
type Tallies = [Option<CutTally>; Tolerance::REPORTED.len()];

/// Scores of a clip.
struct Trial {
    /// Name of the clip.
    name: String,
    cuts: Tallies,
    /// `None` if the truth has no classes.
    classes: Option<ClassScore>,
}

/// Scores all clips of a folder that have truth. Returns the number of inputs that failed.
pub fn run(args: &ScoreArgs) -> Result<usize, UsageError> {
    let params = args.segments.check(trials::method(args)?)?;
    args.segments.warn_of_unused(params.method());
    let expected = "NAME.segments.json, NAME.json or segmentation*.json";
    let (trials, failures) = trials::trials(args, expected, |input, read| trial(input, params, read))?;
    if !trials.is_empty() {
        print(&trials);
        if args.classes {
            print_classes(&trials);
        }
    }
    Ok(failures)
}

/// Returns the scores of a clip; `None` if it has no truth.
fn trial(input: &Input, params: ValidParams, read: &ReadArgs) -> Result<Option<Trial>, InputError> {
    let name = input.path.file_stem().unwrap_or_default().to_string_lossy();
    let Some((path, text)) = read_truth(&input.path, &name)? else { return Ok(None) };
    let clip = input::load(input, read)?.parsed.clip;
    let read = |error| InputError::Labels { path: path.clone(), error };
    let truth = formats::read_cuts(&text, &name, clip.frame_count(), clip.rate()).map_err(read)?;
    let actions = formats::read_segments(&text, &name, clip.frame_count(), clip.rate()).map_err(read)?;
    let skeleton = Skeleton::main(&clip, &Overrides::default());
    let segmentation = segments::segment(&clip, &skeleton, params, &mut |_| Ok(()))
        .map_err(|error| InputError::Segment { path: input.path.clone(), error })?;
    let cuts = segmentation.cuts();
    let has_ranges = truth.iter().any(|cut| cut.earliest < cut.latest);
    let tally = |tolerance| {
        let is_known = tolerance != Tolerance::Inside || has_ranges;
        is_known.then(|| score::cuts(&cuts, &truth, clip.frame_time(), tolerance))
    };
    let detected: Vec<_> = segmentation.segments.iter().map(|s| (s.frames.clone(), &*s.action)).collect();
    let true_classes: Vec<_> = actions.iter().map(|s| (s.frames.clone(), class(s))).collect();
    let has_classes = true_classes.iter().any(|(_, class)| !class.is_empty());
    Ok(Some(Trial {
        name: escape(&decode(input.stem.as_os_str())),
        cuts: Tolerance::REPORTED.map(tally),
        classes: has_classes.then(|| score::classes(&detected, &true_classes)),
    }))
}

/// Returns the class of an annotated segment: its label, or else the name of its action.
fn class(segment: &Segment) -> &str {
    if segment.label.is_empty() { &segment.action } else { &segment.label }
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
        let bytes = fs::read(&path).map_err(|error| read_error(&path, error))?;
        let text = input::text(&path, &bytes)?;
        if formats::has_segments(text, name) {
            return Ok(Some((path.clone(), text.into())));
        }
    }
    Ok(None)
}

/// Writes precision, recall and F1 at each tolerance, by clip and pooled.
fn print(trials: &[Trial]) {
    let headers = Tolerance::REPORTED.map(|tolerance| match tolerance {
        Tolerance::Seconds(seconds) => format!("±{seconds} s"),
        Tolerance::Inside => "inside".into(),
    });
    output::print(format_args!("cuts: precision, recall and F1\n\n"));
    let headers = headers.map(|header| format!("{header:>24}")).concat();
    output::print(format_args!("{:<24}{:>9}{:>6}{headers}\n", "", "detected", "true"));
    let mut pooled = Tallies::default();
    for Trial { name, cuts, .. } in trials {
        output::print(format_args!("{}\n", row(name, cuts)));
        for (pooled, tally) in pooled.iter_mut().zip(cuts) {
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

/// Writes frame accuracy and adjusted Rand index, by clip and for all clips: pooled frames and the mean
/// index.
fn print_classes(trials: &[Trial]) {
    output::print(format_args!(
        "\nclasses: frame accuracy after the best assignment, adjusted Rand index\n\n"
    ));
    output::print(format_args!("{:<24}{:>10}{:>8}\n", "", "accuracy", "index"));
    let (mut pooled, mut indices) = (Tally::default(), Vec::new());
    for Trial { name, classes, .. } in trials {
        let Some(ClassScore { frames, adjusted_rand }) = classes else {
            output::print(format_args!("{name:<24}{:>10}{:>8}\n", "-", "-"));
            continue;
        };
        output::print(format_args!("{name:<24}{:>10.3}{adjusted_rand:>8.3}\n", frames.accuracy()));
        pooled += *frames;
        indices.push(adjusted_rand);
    }
    if !indices.is_empty() {
        let mean = indices.iter().copied().sum::<f64>() / indices.len() as f64;
        output::print(format_args!("{:<24}{:>10.3}{mean:>8.3}\n", "all frames", pooled.accuracy()));
    }
}
