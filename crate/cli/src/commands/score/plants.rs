//! Scores of foot plants.

use std::fs;

use plantigrade::foot::{Part, Side};
use plantigrade::formats;
use plantigrade::plants::Annotation;
use plantigrade::plants::{self, Detection, Feet, ValidParams};
use plantigrade::score::{self, Events, FUZZY_PERIODS, Tally};
use plantigrade::skeleton::{Overrides, Skeleton};

use super::trials;
use crate::args::{ReadArgs, ScoreArgs};
use crate::error::{InputError, UsageError};
use crate::input::{self, Input};
use crate::output;
use crate::text::{decode, escape};

/// One clip with its labels and its truth.
struct Trial {
    name: String,
    frame_time: f64,
    detection: Detection,
    truth: Annotation,
}

/// Scores all clips of a folder that have truth. Returns the number of inputs that failed.
pub fn run(args: &ScoreArgs) -> Result<usize, UsageError> {
    let params = args.plants.check(trials::method(args)?)?;
    args.plants.warn_of_unused(params.method());
    let (trials, failures) = trials::trials(args, "NAME.json", |input, read| trial(input, params, read))?;
    let is_requested = |part: &Part| args.part.as_deref().is_none_or(|name| name == part.name());
    for part in Part::ALL.into_iter().filter(is_requested) {
        if trials.iter().any(|trial| pairs(trial, part).is_some()) {
            print(part, &trials);
        }
    }
    Ok(failures)
}

/// Returns labels and truth of a clip; `None` if it has no truth.
fn trial(input: &Input, params: ValidParams, read: &ReadArgs) -> Result<Option<Trial>, InputError> {
    let path = input.path.with_extension("json");
    if !path.is_file() {
        return Ok(None);
    }
    let clip = input::load(input, read)?.parsed.clip;
    let bytes = fs::read(&path).map_err(|error| InputError::Read { path: path.clone(), error })?;
    let truth = formats::read_plants(&bytes, clip.frame_count())
        .map_err(|error| InputError::Labels { path, error })?;
    let feet = Feet::new(&clip, &Skeleton::main(&clip, &Overrides::default()))
        .map_err(|error| InputError::Detect { path: input.path.clone(), error })?;
    Ok(Some(Trial {
        name: escape(&decode(input.stem.as_os_str())),
        frame_time: clip.frame_time(),
        detection: plants::detect(&feet, params),
        truth: masked(truth, clip.frame_time()),
    }))
}

/// Masks "no contact" next to unknown frames, where the foot may be off the force plate.
fn masked(truth: Annotation, frame_time: f64) -> Annotation {
    let mask = |(part, feet): (Part, [Vec<Option<bool>>; 2])| {
        (part, feet.map(|labels| score::mask_near_unknown(&labels, frame_time)))
    };
    Annotation { parts: truth.parts.into_iter().map(mask).collect() }
}

/// Labels of one foot with their truth.
type Pair<'a> = (&'a [bool], &'a [Option<bool>]);

/// Returns labels and truth of both feet, if both have the part.
fn pairs(trial: &Trial, part: Part) -> Option<[Pair<'_>; 2]> {
    let (labels, truth) = (trial.detection.part(part)?, trial.truth.part(part)?);
    Some(Side::BOTH.map(|side| (labels.foot(side).planted.as_slice(), truth[side as usize].as_slice())))
}

/// Writes the scores of one part: lenient and strict accuracy, by clip and pooled, and precision,
/// recall and timing of the plants.
fn print(part: Part, trials: &[Trial]) {
    let periods: Vec<String> = FUZZY_PERIODS.iter().map(|fuzzy| format!("p = {fuzzy}")).collect();
    output::print(format_args!("{}, accuracy in %\n\n", part.name()));
    output::print(format_args!("{:<32}{}\n", "lenient", columns(&periods)));
    let mut pooled = [[Tally::default(); FUZZY_PERIODS.len()]; 2];
    let mut accuracies: Vec<[f64; FUZZY_PERIODS.len()]> = Vec::new();
    let mut events = Events::default();
    for trial in trials {
        let Some(feet) = pairs(trial, part) else { continue };
        let mut tallies = [[Tally::default(); FUZZY_PERIODS.len()]; 2];
        for (labels, truth) in feet {
            for (index, fuzzy) in FUZZY_PERIODS.into_iter().enumerate() {
                tallies[0][index] += score::lenient(labels, truth, trial.frame_time, fuzzy);
                tallies[1][index] += score::strict(labels, truth, trial.frame_time, fuzzy);
            }
            events += score::events(labels, truth, trial.frame_time);
        }
        for (pooled, tallies) in pooled.iter_mut().flatten().zip(tallies.iter().flatten()) {
            *pooled += *tallies;
        }
        let accuracy = tallies[0].map(|tally| 100.0 * tally.accuracy());
        output::print(format_args!("{:<32}{}\n", trial.name, percents(&accuracy)));
        accuracies.push(accuracy);
    }
    let over_clips = |statistic: fn(&[f64]) -> f64| -> Vec<f64> {
        let at = |index: usize| accuracies.iter().map(|accuracy| accuracy[index]).collect::<Vec<_>>();
        (0..FUZZY_PERIODS.len()).map(|index| statistic(&at(index))).collect()
    };
    let lowest = over_clips(|values| values.iter().copied().fold(100.0, f64::min));
    let highest = over_clips(|values| values.iter().copied().fold(0.0, f64::max));
    output::print(format_args!(
        "{:<32}{}\n",
        "all frames",
        percents(&pooled[0].map(|tally| 100.0 * tally.accuracy()))
    ));
    output::print(format_args!(
        "{:<32}{}\n",
        "all frames, strict",
        percents(&pooled[1].map(|tally| 100.0 * tally.accuracy()))
    ));
    output::print(format_args!("{:<32}{}\n", "lowest clip", percents(&lowest)));
    output::print(format_args!("{:<32}{}\n", "highest clip", percents(&highest)));
    output::print(format_args!(
        "{:<32}{}\n",
        "standard deviation of clips",
        percents(&over_clips(standard_deviation))
    ));
    let score = events.score();
    output::print(format_args!(
        "\nplants: precision {:.3}, recall {:.3}, F1 {:.3}; onset {:+.0} ms (95 % within {:.0}), \
         offset {:+.0} ms (95 % within {:.0})\n\n",
        score.precision,
        score.recall,
        score.f1,
        1e3 * score.onset,
        1e3 * score.onset_95,
        1e3 * score.offset,
        1e3 * score.offset_95
    ));
}

fn columns(headers: &[String]) -> String {
    headers.iter().map(|header| format!("{header:>9}")).collect()
}

fn percents(values: &[f64]) -> String {
    values.iter().map(|value| format!("{value:>9.2}")).collect()
}

/// Returns the sample standard deviation (n − 1).
fn standard_deviation(values: &[f64]) -> f64 {
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
    (squares / (values.len().max(2) - 1) as f64).sqrt()
}
