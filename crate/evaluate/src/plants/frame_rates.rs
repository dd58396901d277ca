//! Independence of the frame rate.

use plantigrade::foot::Part;
use plantigrade::plants::Method;
use plantigrade::score::Tally;
use plantigrade_synth::{ClipSpec, decimate, full_set, generate};
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

use super::trial::{Accuracies, SEEDS, Trial, default_params, labels};
use crate::report::{Report, percent};

/// Adds the section.
pub fn write(report: &mut Report) -> anyhow::Result<()> {
    report.text("## Frame rate");
    report.text(
        "Clips of 120 Hz reduced to lower frame rates, robust contact, in %: labels that equal those of \
         the full rate at the same instants, and accuracy at p = 0.2.",
    );
    let mut rows = Vec::new();
    for factor in [1, 2, 4, 5] {
        let (agreement, accuracy) = evaluate(factor, SEEDS);
        rows.push(vec![format!("{}", 120 / factor), percent(agreement.pooled()), percent(accuracy.pooled())]);
    }
    report.table(&["Hz", "labels as at 120 Hz", "accuracy"], &rows);
    Ok(())
}

/// Reduces the clips of 120 Hz to every `factor`-th frame. Returns the agreement with the labels at
/// the full rate, and the accuracy.
fn evaluate(factor: usize, seeds: std::ops::Range<u64>) -> (Accuracies, Accuracies) {
    let specs: Vec<_> = full_set(1.0).into_iter().filter(|spec| spec.rate == 120).collect();
    let jobs: Vec<_> = seeds.flat_map(|seed| specs.iter().map(move |spec| (spec, seed))).collect();
    let tallies: Vec<(Tally, Tally)> =
        jobs.par_iter().map(|(spec, seed)| tallies(spec, *seed, factor)).collect();
    let agreement = Accuracies::from_tallies(tallies.iter().map(|(agreement, _)| *agreement));
    let accuracy = Accuracies::from_tallies(tallies.iter().map(|(_, accuracy)| *accuracy));
    (agreement, accuracy)
}

fn tallies(spec: &ClipSpec, seed: u64, factor: usize) -> (Tally, Tally) {
    let generated = generate(spec, seed);
    let full = Trial::generated("", &generated);
    let reduced = Trial::generated("", &decimate(&generated, factor));
    let detections = [&full, &reduced].map(|trial| trial.detect(default_params(Method::Robust)));
    let [at_full, at_reduced] = detections.each_ref().map(|detection| labels(detection, Part::Contact));
    let mut agreement = Tally::default();
    for (full, reduced) in at_full.into_iter().zip(at_reduced) {
        agreement.total += reduced.len();
        agreement.correct += reduced.iter().zip(full.iter().step_by(factor)).filter(|(a, b)| a == b).count();
    }
    (agreement, reduced.tally(Part::Contact, at_reduced, 0.2))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_do_not_depend_on_the_frame_rate() {
        let (_, full_rate) = evaluate(1, 10..12);
        for factor in [2, 4, 5] {
            let (agreement, accuracy) = evaluate(factor, 10..12);
            assert!(agreement.pooled() >= 98.0, "{factor}: {}", agreement.pooled());
            assert!((accuracy.pooled() - full_rate.pooled()).abs() <= 0.5, "{factor}: {}", accuracy.pooled());
        }
    }
}
