//! Independence of the frame rate.

use plantigrade::labels::Part;
use plantigrade::plants::Method;
use plantigrade_synth::{decimated, full_set, generate};

use crate::parallel;
use crate::report::{Report, percent};
use crate::trial::{Accuracies, SEEDS, Trial, labels, of};

/// Adds the section.
pub fn write(report: &mut Report) -> anyhow::Result<()> {
    report.text("## Frame rate");
    report.text(
        "Clips of 120 Hz with frames left out: how many labels are those of the full rate at the same instants, \
         and the accuracy at p = 0.2, in %; robust contact.",
    );
    let mut rows = Vec::new();
    for factor in [1, 2, 4, 5] {
        let (same, right) = thinned(factor, SEEDS);
        rows.push(vec![format!("{}", 120 / factor), percent(same.pooled()), percent(right.pooled())]);
    }
    report.table(&["Hz", "labels as at 120 Hz", "accuracy"], &rows);
    Ok(())
}

/// Clips of 120 Hz with every `factor`-th frame alone: labels that are the same, and accuracy.
fn thinned(factor: usize, seeds: std::ops::Range<u64>) -> (Accuracies, Accuracies) {
    let recipes: Vec<_> = full_set(1.0).into_iter().filter(|recipe| recipe.rate == 120).collect();
    let jobs: Vec<_> = seeds.flat_map(|seed| recipes.iter().map(move |recipe| (recipe, seed))).collect();
    let found = parallel::map(&jobs, |(recipe, seed)| {
        let full = generate(recipe, *seed);
        let whole = Trial::generated("", &full);
        let fewer = Trial::generated("", &decimated(&full, factor));
        let [all, some] = [&whole, &fewer].map(|trial| trial.detect(of(Method::Robust)));
        let mut same = plantigrade::score::Tally::default();
        for (all, some) in labels(&all, Part::Contact).into_iter().zip(labels(&some, Part::Contact)) {
            same.total += some.len();
            same.right +=
                some.iter().zip(all.iter().step_by(factor)).filter(|(some, all)| some == all).count();
        }
        (same, fewer.tally(Part::Contact, labels(&some, Part::Contact), 0.2))
    });
    let same = Accuracies::of(found.iter().map(|(same, _)| *same));
    let right = Accuracies::of(found.iter().map(|(_, right)| *right));
    (same, right)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_do_not_depend_on_the_rate() {
        let (_, full) = thinned(1, 10..12);
        for factor in [2, 4, 5] {
            let (same, right) = thinned(factor, 10..12);
            assert!(same.pooled() >= 98.0, "{factor}: {}", same.pooled());
            assert!((right.pooled() - full.pooled()).abs() <= 0.5, "{factor}: {}", right.pooled());
        }
    }
}
