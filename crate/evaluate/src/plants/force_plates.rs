//! Contact measured by force plates.

use std::collections::BTreeMap;
use std::path::Path;

use plantigrade::foot::Part;
use plantigrade::plants::Method;
use plantigrade::score::{Events, Tally};

use super::threshold_search::{Kind, Signals, signals};
use super::trial::{Accuracies, Trial, default_params, labels};
use crate::report::{Report, percent};

/// Mark of the section in the page.
pub const MARK: &str = "force plates";

const FUZZY: [f64; 4] = [0.0, 0.1, 0.2, 0.3];

/// Adds the section.
pub fn write(report: &mut Report, corpus: &Path) -> anyhow::Result<()> {
    let mut paths: Vec<_> = std::fs::read_dir(corpus.join("contact"))?
        .filter_map(|entry| Some(entry.ok()?.path()))
        .filter(|path| path.extension().is_some_and(|extension| extension == "bvh"))
        .collect();
    paths.sort();
    let trials: Vec<Trial> = paths.iter().map(|path| Trial::recorded(path)).collect::<anyhow::Result<_>>()?;
    let frames: usize =
        trials.iter().map(|trial| tally(trial, Method::Robust, Part::Contact, 0.0).total).sum();
    report.begin_section(MARK);
    report.text("## Contact measured by force plates");
    report.text(&format!(
        "{} recorded trials (walking, running, drop jumps, squats, sitting down and standing up; {frames} \
         foot-frames with known truth) from public OpenSim and OpenCap data. The design of the edge refinement \
         took their onsets and offsets into account, the limits of speed at foot off were chosen such that \
         these trials do not become worse, and the speed above which noise is a step was chosen on squats and \
         sitting down with noise. They are therefore not an unseen test of boundaries. Accuracy in %, lenient. Thresholds are tuned at each p, either on the other four of \
         the five sources (\"other sources\") or on the same trials (\"same trials\"). The latter is an upper \
         bound that requires truth.",
        trials.len()
    ));
    let mut rows = Vec::new();
    for (method, part) in [
        (Method::Robust, Part::Contact),
        (Method::Robust, Part::Toe),
        (Method::Paper, Part::Toe),
        (Method::Njw, Part::Toe),
        (Method::Gmm, Part::Toe),
        (Method::Hmm, Part::Toe),
        (Method::MedianSpeed, Part::Toe),
        (Method::Displacement, Part::Toe),
        (Method::HeightSpeed, Part::Toe),
    ] {
        rows.push(method_row(&format!("{} ({})", method.title(), part.name()), &trials, method, part));
    }
    for (name, kind, method) in [
        ("toe height", Kind::Height, Method::Paper),
        ("toe speed", Kind::Speed, Method::Paper),
        ("toe height and speed", Kind::Dual, Method::Paper),
        ("slower of toe and ankle", Kind::Speed, Method::MinSpeed),
    ] {
        rows.push(tuned_row(&format!("{name} < t, other sources"), &trials, kind, method, true));
        rows.push(tuned_row(&format!("{name} < t, same trials"), &trials, kind, method, false));
    }
    report.table(
        &["method", "p = 0", "0.1", "0.2", "0.3", "lowest trial at 0.3", "onset ms", "offset ms"],
        &rows,
    );
    by_trial(report, &trials);
    report.text(
        "The data used in this section comes from the public repositories of OpenCap, AddBiomechanics and \
         OpenSim examples. No recorded motion is part of this project.",
    );
    report.end_section(MARK);
    Ok(())
}

/// Scores the labels of any part against contact.
fn tally(trial: &Trial, method: Method, part: Part, fuzzy: f64) -> Tally {
    trial.tally(Part::Contact, labels(&trial.detect(default_params(method)), part), fuzzy)
}

fn method_row(name: &str, trials: &[Trial], method: Method, part: Part) -> Vec<String> {
    let mut events = Events::default();
    for trial in trials {
        events += trial.events(Part::Contact, labels(&trial.detect(default_params(method)), part));
    }
    let accuracies =
        |fuzzy: f64| Accuracies::from_tallies(trials.iter().map(|trial| tally(trial, method, part, fuzzy)));
    cells(name, FUZZY.map(accuracies), &events)
}

fn cells(name: &str, accuracies: [Accuracies; 4], events: &Events) -> Vec<String> {
    let score = events.score();
    let mut row = vec![name.to_owned()];
    row.extend(accuracies.iter().map(|accuracies| percent(accuracies.pooled())));
    row.push(percent(accuracies[3].lowest()));
    row.push(format!("{:+.0}", 1e3 * score.onset));
    row.push(format!("{:+.0}", 1e3 * score.offset));
    row
}

/// Returns the source of a trial: the letters at the start of its name.
fn source(trial: &Trial) -> String {
    let name = trial.name.split('_').next().unwrap_or_default();
    name.trim_end_matches(char::is_numeric).to_owned()
}

fn tuned_row(name: &str, trials: &[Trial], kind: Kind, method: Method, leave_out: bool) -> Vec<String> {
    let all_signals: Vec<Signals> =
        trials.iter().map(|trial| signals(trial, method, trial.feet.metres_per_unit)).collect();
    let pairs: Vec<(&Trial, &Signals)> = trials.iter().zip(&all_signals).collect();
    let mut tallies: [Vec<Tally>; 4] = Default::default();
    let mut events = Events::default();
    for (index, fuzzy) in FUZZY.into_iter().enumerate() {
        let mut by_source: BTreeMap<String, (f64, f64)> = BTreeMap::new();
        for (trial, signals) in &pairs {
            let source = source(trial);
            let thresholds = *by_source.entry(source.clone()).or_insert_with(|| {
                let others = pairs.iter().filter(|(other, _)| !leave_out || self::source(other) != source);
                kind.best(&others.copied().collect::<Vec<_>>(), Part::Contact, fuzzy)
            });
            tallies[index].push(kind.tally(trial, Part::Contact, signals, thresholds, fuzzy));
            if index == 0 {
                let labels = kind.labels(signals, thresholds);
                events += trial.events(Part::Contact, [&labels[0], &labels[1]]);
            }
        }
    }
    cells(name, tallies.map(Accuracies::from_tallies), &events)
}

fn by_trial(report: &mut Report, trials: &[Trial]) {
    report.text("Robust contact by trial:");
    let row = |trial: &Trial| {
        let mut row = vec![trial.name.clone()];
        row.extend(
            FUZZY.map(|fuzzy| percent(100.0 * tally(trial, Method::Robust, Part::Contact, fuzzy).accuracy())),
        );
        let detection = trial.detect(default_params(Method::Robust));
        let events = trial.events(Part::Contact, labels(&detection, Part::Contact)).score();
        row.push(format!("{:+.0}", 1e3 * events.onset));
        row.push(format!("{:+.0}", 1e3 * events.offset));
        row
    };
    let rows: Vec<Vec<String>> = trials.iter().map(row).collect();
    report.table(&["trial", "p = 0", "0.1", "0.2", "0.3", "onset ms", "offset ms"], &rows);
}
