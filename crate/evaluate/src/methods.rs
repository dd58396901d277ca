//! Every method on the generated set, and what the noise does.

use plantigrade::labels::Part;
use plantigrade::plants::{Family, Method, detect_along};
use plantigrade::score::Events;
use plantigrade_synth::{full_set, generate, hard_cases};

use crate::parallel;
use crate::report::{Report, percent};
use crate::trial::{Accuracies, SEEDS, Trial, accuracies, labels, of, trials};

const FUZZY: [f64; 4] = [0.0, 0.1, 0.2, 0.3];

/// Adds the section.
pub fn write(report: &mut Report) -> anyhow::Result<()> {
    let all = trials(&full_set(1.0), SEEDS);
    report.text("## All methods on the generated set");
    report.text(
        "Accuracy in %. Methods of toes are scored on toe plants, methods of contact on contact, the default on \
         both. Thresholds are in metres with the program's defaults; tuned ones stand in table 3.",
    );
    let mut rows = Vec::new();
    for method in Method::ALL {
        for part in method.parts().iter().filter(|part| **part != Part::Heel) {
            rows.push(row(
                &format!("{} ({})", method.title(), part.name()),
                family(method),
                &all,
                |trial| trial.detect(of(method)),
                *part,
            ));
        }
    }
    rows.push(beside_standing(&all));
    report.table(
        &["method", "kind", "p = 0", "0.1", "0.2", "0.3", "0.3 strict", "lowest clip at 0.3", "F1 of plants"],
        &rows,
    );
    worst(report, &all);
    noise(report);
    Ok(())
}

fn family(method: Method) -> &'static str {
    match method.family() {
        Family::Spectral => "spectral",
        Family::Mixture => "mixture",
        Family::Threshold => "threshold",
    }
}

fn row(
    name: &str,
    kind: &str,
    all: &[Trial],
    detect: impl Fn(&Trial) -> plantigrade::plants::Detection + Sync,
    part: Part,
) -> Vec<String> {
    let found = parallel::map(all, |trial| {
        let detection = detect(trial);
        let labels = labels(&detection, part);
        (
            FUZZY.map(|fuzzy| trial.tally(part, labels, fuzzy)),
            trial.strict(part, labels, 0.3),
            trial.events(part, labels),
        )
    });
    let at = |place: usize| Accuracies::of(found.iter().map(|(tallies, ..)| tallies[place]));
    let strict = Accuracies::of(found.iter().map(|(_, strict, _)| *strict));
    let mut events = Events::default();
    found.iter().for_each(|(.., own)| events += own.clone());
    let mut row = vec![name.to_owned(), kind.to_owned()];
    row.extend((0..4).map(|place| percent(at(place).pooled())));
    row.push(percent(strict.pooled()));
    row.push(percent(at(3).lowest()));
    row.push(format!("{:.3}", events.score().f1));
    row
}

/// The paper's remedy for small movements: a clip of someone standing still, clustered along.
fn beside_standing(all: &[Trial]) -> Vec<String> {
    let still = hard_cases(1.0).into_iter().find(|recipe| recipe.name == "standing-still");
    let still = still.map(|recipe| Trial::generated("still", &generate(&recipe, 0)));
    row(
        "Paper 2014 with a standing clip (toe)",
        "spectral",
        all,
        |trial| {
            let params = of(Method::Paper).check().expect("defaults");
            match &still {
                Some(still) => detect_along(&trial.feet, &still.feet, params),
                None => trial.detect(of(Method::Paper)),
            }
        },
        Part::Toe,
    )
}

fn worst(report: &mut Report, all: &[Trial]) {
    report.text("### Where the default does worst");
    report.text("The motions in which robust contact has its lowest accuracy at p = 0.1, over all seeds.");
    let mut names: Vec<&str> = all.iter().map(|trial| trial.name.as_str()).collect();
    names.sort_unstable();
    names.dedup();
    let found = parallel::map(all, |trial| {
        let detection = trial.detect(of(Method::Robust));
        FUZZY.map(|fuzzy| trial.tally(Part::Contact, labels(&detection, Part::Contact), fuzzy))
    });
    let mut rows: Vec<(f64, Vec<String>)> = names
        .into_iter()
        .map(|name| {
            let own = |place: usize| {
                let tallies = all.iter().zip(&found).filter(|(trial, _)| trial.name == name);
                Accuracies::of(tallies.map(|(_, tallies)| tallies[place])).pooled()
            };
            let mut row = vec![name.to_owned()];
            row.extend((0..4).map(|place| percent(own(place))));
            (own(1), row)
        })
        .collect();
    rows.sort_by(|a, b| a.0.total_cmp(&b.0));
    let rows: Vec<Vec<String>> = rows.into_iter().take(6).map(|(_, row)| row).collect();
    report.table(&["motion", "p = 0", "0.1", "0.2", "0.3"], &rows);
}

fn noise(report: &mut Report) {
    report.text("### Noise");
    report.text(
        "Foot noise of the generated clips (jitter, slow slide, plants that float) from half to twice the level \
         of recorded motion; three seeds; accuracy in % at p = 0.1 and 0.3.",
    );
    let mut rows = Vec::new();
    for level in [0.5, 1.0, 1.5, 2.0] {
        let all = trials(&full_set(level), SEEDS.take(3));
        let mut row = vec![format!("{level}×")];
        for (method, part) in
            [(Method::Robust, Part::Contact), (Method::Robust, Part::Toe), (Method::Paper, Part::Toe)]
        {
            let [tenth, third] = accuracies(&all, of(method), part, [0.1, 0.3]);
            row.push(format!("{:.2} / {:.2}", tenth.pooled(), third.pooled()));
            row.push(percent(third.lowest()));
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
    fn the_default_holds_its_figures_on_the_generated_set() {
        let all = trials(&full_set(1.0), 10..11);
        for part in [Part::Contact, Part::Toe] {
            let [tenth, third] = accuracies(&all, of(Method::Robust), part, [0.1, 0.3]);
            let found = format!("{}: {} {} {}", part.name(), tenth.pooled(), third.pooled(), third.lowest());
            assert!(tenth.pooled() >= 96.0 && third.pooled() >= 99.3 && third.lowest() >= 95.0, "{found}");
        }
    }

    #[test]
    fn one_scale_for_all_clips_spreads_wider() {
        let all = trials(&full_set(1.0), 10..12);
        let [own] = accuracies(&all, of(Method::Paper), Part::Toe, [0.3]);
        let [fixed] = accuracies(&all, of(Method::FixedScale), Part::Toe, [0.3]);
        assert!(fixed.deviation() > own.deviation(), "{} {}", fixed.deviation(), own.deviation());
    }
}
