//! Corrections of a person that are applied to similar motion.

mod nearest_neighbours;
mod person;

use std::path::Path;

use plantigrade::foot::{Part, Side};
use plantigrade::plants::{Corrections, Detection, Edit, Method, apply_edits};
use plantigrade::score::Truth;
use plantigrade_synth::hard_cases;
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

use super::timing::{Event, Kind, Timing, TrueEvents, detected_events};
use super::timing_tables::{TimedTrial, raw_trials, solved_trials};
use super::trial::{SEEDS, Trial, default_params, generate_trials, labels};
use super::video_noise;
use crate::report::{Report, percent};

/// Mark of the part about recorded motion.
const MARK: &str = "corrections of recorded motion";

/// Number of corrections of each clip.
const CORRECTIONS: usize = 3;

/// Minimum share of wrong frames of a case in the table, in percent.
const MIN_WRONG: f64 = 0.5;

/// Adds the section; the part about recorded motion is copied from `previous` without a corpus.
pub fn write(report: &mut Report, corpus: Option<&Path>, previous: &str) -> anyhow::Result<()> {
    report.text("## Corrections applied to similar motion");
    report.text(&format!(
        "A person is simulated with the truth: {CORRECTIONS} times, the longest run of wrong frames is \
         corrected together with the frames around it, up to the middles of the neighbouring plants and \
         swings and at most 0.6 s away. *Edits only* leaves the rest of the clip as it is, *similar* applies \
         the corrections to similar motion, and *k-NN* labels all other frames by the nearest five corrected \
         frames. Wrong frames in %, of all frames at p = 0; cases with at least {MIN_WRONG} %. Affinities and \
         limits were chosen on seeds 0 to 9.",
    ));
    let head = ["case", "detected", "edits only", "similar", "k-NN"];
    let mut rows = Vec::new();
    for spec in hard_cases(1.0) {
        let trials = generate_trials(std::slice::from_ref(&spec), SEEDS);
        rows.extend(Errors::of(&trials).row(&spec.name));
    }
    report.table(&head, &rows);
    let Some(corpus) = corpus else {
        report.copy_section(previous, MARK);
        return Ok(());
    };
    report.begin_section(MARK);
    report.text(
        "The same for the trials over force plates, reduced to 30 Hz, with the noise of video capture, one draw each:",
    );
    let noisy = video_noise::noisy_trials(corpus, 1.0)?;
    let rows: Vec<Vec<String>> =
        noisy.iter().filter_map(|(activity, trials)| Errors::of(trials).row(activity)).collect();
    report.table(&head, &rows);
    report.text(
        "One corrected stance per foot of each trial over force plates, the first one that is measured; the \
         table is about the rest of each trial. *Better* and *worse* are numbers of trials whose number of wrong \
         frames changes, and *less exact* of those in which the mean absolute error of an event grows.",
    );
    let plates = corpus.parent().map(|parent| parent.join("plates")).filter(|plates| plates.is_dir());
    let mut rows = Vec::new();
    if let Some(plates) = plates {
        rows.push(rest_row("raw capture", &raw_trials(&plates)?));
    }
    rows.push(rest_row("solved motion", &solved_trials(corpus)?));
    report.table(
        &[
            "trials",
            "number",
            "changed",
            "better",
            "worse",
            "less exact",
            "wrong frames",
            "after",
            "foot strike MAE ms",
            "after",
            "foot off MAE ms",
            "after",
        ],
        &rows,
    );
    report.end_section(MARK);
    Ok(())
}

/// Numbers of wrong frames.
#[derive(Clone, Copy, Default)]
struct Errors {
    total: usize,
    detected: usize,
    edits_only: usize,
    similar: usize,
    nearest_neighbours: usize,
}

impl Errors {
    /// Corrects each trial three times and sums up the wrong frames.
    fn of(trials: &[Trial]) -> Errors {
        let all: Vec<Errors> = trials.par_iter().map(Errors::of_trial).collect();
        all.into_iter().fold(Errors::default(), |sum, errors| Errors {
            total: sum.total + errors.total,
            detected: sum.detected + errors.detected,
            edits_only: sum.edits_only + errors.edits_only,
            similar: sum.similar + errors.similar,
            nearest_neighbours: sum.nearest_neighbours + errors.nearest_neighbours,
        })
    }

    fn of_trial(trial: &Trial) -> Errors {
        let detection = trial.detect(default_params(Method::Robust));
        let (edits, corrected) = correct(trial, &detection, CORRECTIONS);
        let edited = apply_edits(&detection, &edits, trial.frame_time());
        let wrong = |labels: [&[bool]; 2]| {
            let tally = trial.tally(Part::Contact, labels, 0.0);
            tally.total - tally.correct
        };
        let nearest = nearest_neighbours::labels(&trial.feet, &detection, &edits);
        Errors {
            total: trial.tally(Part::Contact, labels(&detection, Part::Contact), 0.0).total,
            detected: wrong(labels(&detection, Part::Contact)),
            edits_only: wrong(labels(&edited, Part::Contact)),
            similar: wrong(labels(&corrected, Part::Contact)),
            nearest_neighbours: wrong([&nearest[0], &nearest[1]]),
        }
    }

    /// Returns a row of the table, if enough frames are wrong.
    fn row(&self, name: &str) -> Option<Vec<String>> {
        let share = |wrong: usize| 100.0 * wrong as f64 / self.total.max(1) as f64;
        let shares = [self.detected, self.edits_only, self.similar, self.nearest_neighbours].map(share);
        let cells = std::iter::once(name.to_owned()).chain(shares.map(percent));
        (shares[0] >= MIN_WRONG).then(|| cells.collect())
    }
}

/// Corrects a trial `count` times, each time with the result of the previous correction in view. Returns the
/// edits and the detection with the corrections applied to similar motion.
fn correct(trial: &Trial, detection: &Detection, count: usize) -> (Vec<Edit>, Detection) {
    let truth = trial.truth(Part::Contact);
    let mut edits: Vec<Edit> = Vec::new();
    let mut corrected = detection.clone();
    for _ in 0..count {
        let shown = labels(&corrected, Part::Contact);
        let Some((side, range)) = person::next_correction(shown, truth, trial.frame_time()) else { break };
        edits.extend(person::state_truth(side, Part::Contact, &truth[side as usize], &range));
        let corrections = Corrections::learn(&trial.feet, detection, &edits);
        corrected = corrections.apply(&trial.feet, detection, &edits).detection;
    }
    (edits, corrected)
}

/// The rest of a trial, without the corrected frames, before and after the corrections are applied.
struct Rest {
    wrong: [usize; 2],
    timing: [[Timing; 2]; 2],
    is_changed: bool,
}

impl Rest {
    fn new(timed: &TimedTrial) -> Rest {
        let TimedTrial { trial, truth, .. } = timed;
        let detection = trial.detect(default_params(Method::Robust));
        let contact = &truth.contact;
        let edits: Vec<Edit> = Side::BOTH
            .into_iter()
            .flat_map(|side| {
                let labels = &contact[side as usize];
                let range = person::first_stance(labels, trial.frame_time());
                range
                    .map(|range| person::state_truth(side, Part::Contact, labels, &range))
                    .unwrap_or_default()
            })
            .collect();
        let is_stated = |side: Side, frame: usize| {
            edits.iter().any(|edit| edit.side == side && (edit.start..edit.end).contains(&frame))
        };
        let masked: [Truth; 2] = Side::BOTH.map(|side| {
            let labels = contact[side as usize].iter().enumerate();
            labels.map(|(frame, label)| label.filter(|_| !is_stated(side, frame))).collect()
        });
        let is_rest =
            |event: &&Event| !is_stated(event.side, (event.time / trial.frame_time()).round() as usize);
        let rest = TrueEvents {
            events: truth.events.iter().filter(is_rest).copied().collect(),
            contact: masked.clone(),
            frame_time: truth.frame_time,
        };
        let edited = apply_edits(&detection, &edits, trial.frame_time());
        let corrections = Corrections::learn(&trial.feet, &detection, &edits);
        let corrected = corrections.apply(&trial.feet, &detection, &edits);
        let both = [&edited, &corrected.detection];
        let wrong = both.map(|detection| {
            let shown = labels(detection, Part::Contact);
            let wrong = |(labels, truth): (&[bool], &Truth)| {
                labels.iter().zip(truth).filter(|(label, truth)| **truth == Some(!**label)).count()
            };
            shown.into_iter().zip(&masked).map(wrong).sum()
        });
        let timing = both.map(|detection| {
            let events = detected_events(detection, Part::Contact, trial.frame_time());
            Kind::BOTH.map(|kind| Timing::compare(kind, &events, &rest))
        });
        Rest {
            wrong,
            timing,
            is_changed: !corrected.changes.is_empty() || timing_differs(&edited, &corrected.detection),
        }
    }
}

/// True if an instant differs.
fn timing_differs(a: &Detection, b: &Detection) -> bool {
    Side::BOTH.into_iter().any(|side| a.principal().foot(side).edges != b.principal().foot(side).edges)
}

fn rest_row(name: &str, trials: &[TimedTrial]) -> Vec<String> {
    let rests: Vec<Rest> = trials.par_iter().map(Rest::new).collect();
    let count = |is: &dyn Fn(&Rest) -> bool| rests.iter().filter(|rest| is(rest)).count().to_string();
    let sum = |index: usize| rests.iter().map(|rest| rest.wrong[index]).sum::<usize>().to_string();
    let mean = |index: usize, kind: usize| {
        let timing = Timing::pool(rests.iter().map(|rest| rest.timing[index][kind].clone()));
        format!("{:.2}", timing.mean_absolute())
    };
    vec![
        name.into(),
        rests.len().to_string(),
        count(&|rest| rest.is_changed),
        count(&|rest| rest.wrong[1] < rest.wrong[0]),
        count(&|rest| rest.wrong[1] > rest.wrong[0]),
        count(&|rest| {
            let [before, after] = &rest.timing;
            before
                .iter()
                .zip(after)
                .any(|(before, after)| after.mean_absolute() > before.mean_absolute() + 1e-9)
        }),
        sum(0),
        sum(1),
        mean(0, 0),
        mean(1, 0),
        mean(0, 1),
        mean(1, 1),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_corrections_halve_the_wrong_frames_of_hard_cases() {
        // Treadmill walks and swimming repeat exactly, which favours nearest neighbours.
        for (name, repeats) in
            [("one-foot-dragged", false), ("moving-platform", false), ("treadmill", true), ("afloat", true)]
        {
            let spec = hard_cases(1.0).into_iter().find(|spec| spec.name == name).expect("a hard case");
            let errors = Errors::of(&generate_trials(&[spec], 10..13));
            assert!(2 * errors.similar <= errors.detected, "{name}: {:?}", errors.row(name));
            assert!(errors.similar < errors.edits_only, "{name}: {:?}", errors.row(name));
            assert!(repeats || errors.similar < errors.nearest_neighbours, "{name}: {:?}", errors.row(name));
        }
    }
}
