//! All methods on the generated set, the motions with the lowest accuracy, and the effect of noise.

use plantigrade::foot::Part;
use plantigrade::plants::{Detection, Method, detect_with_standing};
use plantigrade::score::{Events, Tally};
use plantigrade_synth::{full_set, generate, hard_cases};
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

use super::trial::{Accuracies, SEEDS, Trial, accuracies, default_params, generate_trials, labels};
use crate::report::{Report, percent};

const FUZZY: [f64; 4] = [0.0, 0.1, 0.2, 0.3];

/// Number of motions in the table of the lowest accuracies.
const LOWEST_COUNT: usize = 6;

/// Adds the section.
pub fn write(report: &mut Report) -> anyhow::Result<()> {
    let trials = generate_trials(&full_set(1.0), SEEDS);
    report.text("## All methods on the generated set");
    report.text(
        "Accuracy in %. Methods that label toes are scored on toe plants, methods that label contact on \
         contact, and the default on both. Thresholds are the defaults of the program, in metres; table 3 \
         has tuned thresholds.",
    );
    let mut rows = Vec::new();
    for &method in Method::ALL {
        for part in method.parts().iter().filter(|part| **part != Part::Heel) {
            let name = format!("{} ({})", method.title(), part.name());
            let detect = |trial: &Trial| trial.detect(default_params(method));
            rows.push(row(&name, method.family().name(), &trials, detect, *part));
        }
    }
    rows.push(row_with_standing_clip(&trials));
    report.table(
        &["method", "kind", "p = 0", "0.1", "0.2", "0.3", "0.3 strict", "lowest clip at 0.3", "F1 of plants"],
        &rows,
    );
    lowest(report, &trials);
    noise(report);
    Ok(())
}

/// Scores of one clip: lenient tallies by fuzzy period, strict tally at p = 0.3, and events.
type Scores = ([Tally; 4], Tally, Events);

fn row(
    name: &str,
    family: &str,
    trials: &[Trial],
    detect: impl Fn(&Trial) -> Detection + Sync,
    part: Part,
) -> Vec<String> {
    let score = |trial: &Trial| {
        let detection = detect(trial);
        let labels = labels(&detection, part);
        let lenient = FUZZY.map(|fuzzy| trial.tally(part, labels, fuzzy));
        (lenient, trial.strict(part, labels, 0.3), trial.events(part, labels))
    };
    let scores: Vec<Scores> = trials.par_iter().map(score).collect();
    let at = |index: usize| Accuracies::from_tallies(scores.iter().map(|(lenient, ..)| lenient[index]));
    let strict = Accuracies::from_tallies(scores.iter().map(|(_, strict, _)| *strict));
    let mut events = Events::default();
    scores.iter().for_each(|(.., clip_events)| events += clip_events.clone());
    let mut row = vec![name.to_owned(), family.to_owned()];
    row.extend((0..4).map(|index| percent(at(index).pooled())));
    row.push(percent(strict.pooled()));
    row.push(percent(at(3).lowest()));
    row.push(format!("{:.3}", events.score().f1));
    row
}

/// Returns the row of the paper's method for clips with little motion: clustering together with a
/// standing clip.
fn row_with_standing_clip(trials: &[Trial]) -> Vec<String> {
    let standing = hard_cases(1.0).into_iter().find(|spec| spec.name == "standing-still");
    let standing = standing.map(|spec| Trial::generated("still", &generate(&spec, 0)));
    let detect = |trial: &Trial| {
        let params = default_params(Method::Paper).check().expect("valid defaults");
        match &standing {
            Some(standing) => detect_with_standing(&trial.feet, &standing.feet, params),
            None => trial.detect(default_params(Method::Paper)),
        }
    };
    row("Paper 2014 with a standing clip (toe)", "spectral", trials, detect, Part::Toe)
}

fn lowest(report: &mut Report, trials: &[Trial]) {
    report.text("### Lowest accuracies of the default method");
    report.text("Motions with the lowest accuracy of robust contact at p = 0.1, over all seeds.");
    let mut names: Vec<&str> = trials.iter().map(|trial| trial.name.as_str()).collect();
    names.sort_unstable();
    names.dedup();
    let tallies = |trial: &Trial| {
        let detection = trial.detect(default_params(Method::Robust));
        FUZZY.map(|fuzzy| trial.tally(Part::Contact, labels(&detection, Part::Contact), fuzzy))
    };
    let tallies: Vec<[Tally; 4]> = trials.par_iter().map(tallies).collect();
    let mut rows: Vec<(f64, Vec<String>)> = names
        .into_iter()
        .map(|name| {
            let accuracy = |index: usize| {
                let named = trials.iter().zip(&tallies).filter(|(trial, _)| trial.name == name);
                Accuracies::from_tallies(named.map(|(_, tallies)| tallies[index])).pooled()
            };
            let mut row = vec![name.to_owned()];
            row.extend((0..4).map(|index| percent(accuracy(index))));
            (accuracy(1), row)
        })
        .collect();
    rows.sort_by(|a, b| a.0.total_cmp(&b.0));
    let rows: Vec<Vec<String>> = rows.into_iter().take(LOWEST_COUNT).map(|(_, row)| row).collect();
    report.table(&["motion", "p = 0", "0.1", "0.2", "0.3"], &rows);
}

fn noise(report: &mut Report) {
    report.text("### Noise");
    report.text(
        "Accuracy in % at p = 0.1 / 0.3 for foot noise (jitter, slow sliding, vertical offset of plants) \
         between half and twice the level of recorded motion; three seeds. *Lowest* is the lowest clip at \
         p = 0.3.",
    );
    let mut rows = Vec::new();
    for level in [0.5, 1.0, 1.5, 2.0] {
        let trials = generate_trials(&full_set(level), SEEDS.take(3));
        let mut row = vec![format!("{level}×")];
        for (method, part) in
            [(Method::Robust, Part::Contact), (Method::Robust, Part::Toe), (Method::Paper, Part::Toe)]
        {
            let [at_01, at_03] = accuracies(&trials, default_params(method), part, [0.1, 0.3]);
            row.push(format!("{:.2} / {:.2}", at_01.pooled(), at_03.pooled()));
            row.push(percent(at_03.lowest()));
        }
        rows.push(row);
    }
    report
        .table(&["noise", "robust contact", "lowest", "robust toe", "lowest", "paper toe", "lowest"], &rows);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn default_reaches_its_accuracy_on_the_generated_set() {
        let trials = generate_trials(&full_set(1.0), 10..11);
        // Toe plants end when the ball rises, 50 ms before contact.
        for (part, least) in [(Part::Contact, 98.5), (Part::Toe, 98.0)] {
            let [at_01, at_03] = accuracies(&trials, default_params(Method::Robust), part, [0.1, 0.3]);
            let measured =
                format!("{}: {} {} {}", part.name(), at_01.pooled(), at_03.pooled(), at_03.lowest());
            assert!(
                at_01.pooled() >= least && at_03.pooled() >= 99.8 && at_03.lowest() >= 97.0,
                "{measured}"
            );
        }
    }

    #[test]
    fn common_bandwidth_varies_more_between_clips() {
        let trials = generate_trials(&full_set(1.0), 10..12);
        let [adaptive] = accuracies(&trials, default_params(Method::Paper), Part::Toe, [0.3]);
        let [common] = accuracies(&trials, default_params(Method::FixedSigma), Part::Toe, [0.3]);
        let deviations = [adaptive, common].map(|accuracies| accuracies.standard_deviation());
        assert!(deviations[1] > deviations[0], "{deviations:?}");
    }
}
