//! Tables of the timing of foot strikes and foot offs.

use std::path::{Path, PathBuf};

use anyhow::Context;
use plantigrade::bvh;
use plantigrade::foot::{Part, Side};
use plantigrade::formats;
use plantigrade::plants::Method;
use plantigrade_synth::{ClipSpec, full_set, generate};
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

use super::edge_uncertainty;
use super::gaitkit::{self, GaitkitEvents, LegTracks};
use super::timing::{Event, Kind, Timing, TrueEvents, detected_events};
use super::trial::{SEEDS, Trial, default_params};
use crate::report::Report;

/// Mark of the section about raw capture.
const RAW_MARK: &str = "timing in raw capture";

/// Mark of the section about solved motion.
const SOLVED_MARK: &str = "timing in solved motion";

/// A clip with its true events.
pub(super) struct TimedTrial {
    pub trial: Trial,
    pub truth: TrueEvents,
    /// Tracks for gaitkit; `None` for generated clips.
    tracks: Option<LegTracks>,
}

/// Adds the sections. `corpus` is the folder of recorded motion; the folder of raw capture,
/// `plates`, is next to it. Sections whose recordings are missing are copied from `previous`.
pub fn write(report: &mut Report, corpus: Option<&Path>, previous: &str) -> anyhow::Result<()> {
    report.text("## Timing of foot strikes and foot offs");
    report.text(
        "Errors of the event times, detected minus true: negative is early. A detected event belongs to \
         the nearest true one of the same foot within 150 ms. *MAE* is the mean absolute error, *SD* the \
         standard deviation of the errors. *Within* 10 and 20 ms counts all true events, missed ones too. \
         *False* are detected events without a true one within 150 ms, where the truth is known. Methods \
         that label contact are scored by it, the others by toe plants.",
    );
    let plates = corpus.and_then(|corpus| Some(corpus.parent()?.join("plates")));
    match plates.filter(|plates| plates.is_dir()) {
        Some(plates) => raw_capture(report, &plates)?,
        None => report.copy_section(previous, RAW_MARK),
    }
    match corpus {
        Some(corpus) => solved_motion(report, corpus)?,
        None => report.copy_section(previous, SOLVED_MARK),
    }
    generated(report);
    Ok(())
}

/// Reads the trials of raw capture.
pub(super) fn raw_trials(plates: &Path) -> anyhow::Result<Vec<TimedTrial>> {
    let trial = |path: &PathBuf| {
        let text = std::fs::read(path.with_extension("json"))?;
        let measured: Measured = serde_json::from_slice(&text).context("events of a trial")?;
        let events = measured.events.into_iter().map(Event::from).collect();
        timed(path, |truth| TrueEvents { events, ..truth })
    };
    recorded_paths(plates)?.iter().map(trial).collect()
}

/// Reads the trials of solved motion; frames near unknown ones are unknown.
pub(super) fn solved_trials(corpus: &Path) -> anyhow::Result<Vec<TimedTrial>> {
    let mask = |truth: TrueEvents| {
        let masked = truth
            .contact
            .each_ref()
            .map(|labels| plantigrade::score::mask_near_unknown(labels, truth.frame_time));
        TrueEvents::from_labels(masked, truth.frame_time)
    };
    recorded_paths(&corpus.join("contact"))?.iter().map(|path| timed(path, mask)).collect()
}

fn raw_capture(report: &mut Report, plates: &Path) -> anyhow::Result<()> {
    let trials = raw_trials(plates)?;
    report.begin_section(RAW_MARK);
    report.text("### Raw capture");
    report.text(&format!(
        "{} barefoot walks of 18 people, optical capture at 150 to 300 Hz whose marker trajectories no \
         solver has filtered, over force plates at 1,500 Hz (contact: more than 20 N).",
        trials.len()
    ));
    tables(report, &trials)?;
    report.text(
        "The recordings are those of the public repository GaitEventsAlgorithms by F. Moissenet. No \
         recorded motion is part of this project.",
    );
    report.end_section(RAW_MARK);
    Ok(())
}

fn solved_motion(report: &mut Report, corpus: &Path) -> anyhow::Result<()> {
    let trials = solved_trials(corpus)?;
    report.begin_section(SOLVED_MARK);
    report.text("### Solved motion");
    report.text(&format!(
        "The {} trials of the previous section: walking, running, drop jumps, squats, sitting down and \
         standing up, solved to a model by filtered inverse kinematics, which blurs impacts. True events \
         are the edges of labels at 100 and 200 Hz, so their own error is up to half a frame time. Edges \
         next to frames of unknown truth do not count.",
        trials.len()
    ));
    tables(report, &trials)?;
    report.end_section(SOLVED_MARK);
    Ok(())
}

/// Returns the paths of the BVH files in a folder, sorted.
pub fn recorded_paths(folder: &Path) -> anyhow::Result<Vec<PathBuf>> {
    let mut paths: Vec<_> = std::fs::read_dir(folder)?
        .filter_map(|entry| Some(entry.ok()?.path()))
        .filter(|path| path.extension().is_some_and(|extension| extension == "bvh"))
        .collect();
    paths.sort();
    Ok(paths)
}

/// Events in the JSON file of a trial.
#[derive(serde::Deserialize)]
struct Measured {
    /// Side, kind, and time in seconds.
    events: Vec<(char, String, f64)>,
}

impl From<(char, String, f64)> for Event {
    fn from((side, kind, time): (char, String, f64)) -> Event {
        let side = if side == 'L' { Side::Left } else { Side::Right };
        Event { side, kind: if kind == "strike" { Kind::Strike } else { Kind::Off }, time }
    }
}

/// Reads a trial with labels of contact; `truth` returns its events.
fn timed(path: &Path, truth: impl FnOnce(TrueEvents) -> TrueEvents) -> anyhow::Result<TimedTrial> {
    let clip = bvh::parse(&std::fs::read(path)?, bvh::Options::default())?.clip;
    let labels = formats::read_plants(&std::fs::read(path.with_extension("json"))?, clip.frame_count())?;
    let contact = labels.part(Part::Contact).context("labels of contact")?.clone();
    Ok(TimedTrial {
        trial: Trial::new(path.display().to_string(), &clip, labels.parts),
        truth: truth(TrueEvents::from_labels(contact, clip.frame_time())),
        tracks: Some(LegTracks::new(&clip)),
    })
}

/// Adds a table of all methods for each kind of event.
fn tables(report: &mut Report, trials: &[TimedTrial]) -> anyhow::Result<()> {
    let tracks: Vec<LegTracks> = trials.iter().filter_map(|trial| trial.tracks.clone()).collect();
    let gaitkit = gaitkit::detect(&tracks)?;
    let mut rows: Vec<(String, Vec<Vec<Event>>)> = Vec::new();
    for &method in Method::ALL {
        let part = principal(method);
        let events = trials.par_iter().map(|trial| events(trial, method)).collect();
        rows.push((format!("{} ({})", method.title(), part.name()), events));
    }
    let version = gaitkit.as_ref().map(|gaitkit| gaitkit.version.clone());
    rows.extend(
        gaitkit
            .into_iter()
            .flat_map(|GaitkitEvents { detectors, .. }| detectors)
            .map(|(title, events)| (format!("gaitkit: {title}"), events)),
    );
    for kind in Kind::BOTH {
        let timing = |events: &[Vec<Event>]| {
            let pairs = trials.iter().zip(events);
            Timing::pool(pairs.map(|(trial, events)| Timing::compare(kind, events, &trial.truth)))
        };
        let total = timing(&rows[0].1).total();
        report.text(&format!("{total} {}s:", kind.name()));
        let row = |(name, events): &(String, Vec<Vec<Event>>)| table_row(name.clone(), &timing(events));
        report.table(&head("method"), &rows.iter().map(row).collect::<Vec<_>>());
    }
    uncertainty(report, trials);
    report.text(&match version {
        Some(version) => format!(
            "The last rows are detectors of gait events from the Python package gaitkit {version}, given \
             the positions of hips, knees, ankles and toes; the ankle stands for the heel, since the files \
             have no heel marker. They are made for straight walking."
        ),
        None => "The detectors of the Python package gaitkit were not available.".to_owned(),
    });
    Ok(())
}

/// Adds a table of the calibration of the edges of the default method.
fn uncertainty(report: &mut Report, trials: &[TimedTrial]) {
    let errors = trials.par_iter().map(|trial| {
        let detection = trial.trial.detect(default_params(Method::Robust));
        edge_uncertainty::edge_errors(&detection, &trial.truth)
    });
    edge_uncertainty::write(report, &errors.flatten().collect::<Vec<_>>());
}

/// Returns the part by which a method is scored.
fn principal(method: Method) -> Part {
    if method.parts().contains(&Part::Contact) { Part::Contact } else { Part::Toe }
}

fn events(trial: &TimedTrial, method: Method) -> Vec<Event> {
    let detection = trial.trial.detect(default_params(method));
    detected_events(&detection, principal(method), trial.truth.frame_time)
}

fn head(first: &'static str) -> Vec<&'static str> {
    std::iter::once(first).chain(Timing::HEAD).collect()
}

fn table_row(name: String, timing: &Timing) -> Vec<String> {
    std::iter::once(name).chain(timing.cells()).collect()
}

/// Families of the motions of the generated set; all others are *other*.
const FAMILIES: [(&str, &[&str]); 4] = [
    ("walking", &["curved-walk", "straight-walk", "brisk-walk", "walk-stop-walk"]),
    ("running", &["straight-jog", "jog-with-turns", "sprint-start"]),
    ("jumps", &["frog-jumps", "run-and-jump", "jumping-jacks", "one-leg-hop", "hopscotch", "skipping"]),
    ("other", &[]),
];

fn family(name: &str) -> &'static str {
    FAMILIES.iter().find(|(_, names)| names.contains(&name)).map_or("other", |(family, _)| family)
}

fn generated(report: &mut Report) {
    report.text("### Generated set");
    report.text(
        "By family of motions. True events are the exact times of the plan. *Other* are clips of several \
         kinds of motion, dance, fighting, sneaking and steps on the spot. The speeds of the generated \
         feet around these events are means of the raw capture above and of the solved motion.",
    );
    let specs = full_set(1.0);
    let jobs: Vec<(&ClipSpec, u64)> =
        SEEDS.flat_map(|seed| specs.iter().map(move |spec| (spec, seed))).collect();
    let trials: Vec<TimedTrial> = jobs.par_iter().map(|(spec, seed)| generated_trial(spec, *seed)).collect();
    let methods = [Method::Robust, Method::MinSpeed, Method::HeightSpeed];
    let by_method: Vec<Vec<Vec<Event>>> =
        methods.map(|method| trials.par_iter().map(|trial| events(trial, method)).collect()).into();
    for kind in Kind::BOTH {
        let mut rows = Vec::new();
        for (method, events) in methods.iter().zip(&by_method) {
            for (family, _) in FAMILIES {
                let pairs = trials.iter().zip(events);
                let named = pairs.filter(|(trial, _)| self::family(&trial.trial.name) == family);
                let timing =
                    Timing::pool(named.map(|(trial, events)| Timing::compare(kind, events, &trial.truth)));
                let name = format!("{} ({}), {family}", method.title(), principal(*method).name());
                rows.push(table_row(name, &timing));
            }
        }
        let name = kind.name();
        report.text(&format!("{}{}s:", name[..1].to_uppercase(), &name[1..]));
        report.table(&head("method and motion"), &rows);
    }
    uncertainty(report, &trials);
}

/// Generates a clip with the exact times of its events.
fn generated_trial(spec: &ClipSpec, seed: u64) -> TimedTrial {
    let generated = generate(spec, seed);
    let trial = Trial::generated(spec.name.clone(), &generated);
    let truth = TrueEvents {
        events: planned_events(spec, seed),
        contact: trial.truth(Part::Contact).clone(),
        frame_time: trial.frame_time(),
    };
    TimedTrial { trial, truth, tracks: None }
}

/// Returns the strikes and offs of a plan within the clip, except for feet that slide.
fn planned_events(spec: &ClipSpec, seed: u64) -> Vec<Event> {
    let plan = spec.plan(seed);
    let lead = if spec.leading_t_pose { 1.0 / spec.rate as f64 } else { 0.0 };
    let end = (spec.frames - 1) as f64 / spec.rate as f64;
    let events = Side::BOTH.into_iter().flat_map(|side| {
        let stances = plantigrade_synth::plan::stances(&plan.feet[side as usize]);
        stances.into_iter().filter(|stance| stance.toe_off - stance.strike > 1e-6).flat_map(move |stance| {
            [(Kind::Strike, stance.strike), (Kind::Off, stance.toe_off)].map(|(kind, time)| Event {
                side,
                kind,
                time: time + lead,
            })
        })
    });
    events.filter(|event| event.time > lead && event.time < end).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn planned_events_are_the_edges_of_the_labels() {
        for spec in full_set(1.0).iter().filter(|spec| family(&spec.name) != "other") {
            let trial = generated_trial(spec, 10);
            let truth = &trial.truth;
            let edges = TrueEvents::from_labels(truth.contact.clone(), truth.frame_time);
            for kind in Kind::BOTH {
                let timing = Timing::compare(kind, &edges.events, truth);
                assert_eq!((timing.missed, timing.false_events), (0, 0), "{}", spec.name);
                let largest = timing.errors.iter().fold(0.0, |max: f64, error| max.max(error.abs()));
                assert!(largest <= 510.0 * truth.frame_time, "{}: {largest}", spec.name);
            }
        }
    }
}
