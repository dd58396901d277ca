//! Calibration of the confidence of labels.

use plantigrade::foot::{Part, Side};
use plantigrade::plants::Method;
use plantigrade_synth::full_set;
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

use super::trial::{SEEDS, Trial, default_params, generate_trials};
use crate::figure::{Panel, Series, draw};
use crate::report::{Report, percent};

const BIN_COUNT: usize = 10;

/// Labels whose confidence is in one bin.
#[derive(Clone, Copy, Default)]
struct Bin {
    labels: usize,
    correct: usize,
    confidence_sum: f64,
}

impl Bin {
    fn mean_confidence(&self) -> f64 {
        self.confidence_sum / self.labels as f64
    }

    fn accuracy(&self) -> f64 {
        self.correct as f64 / self.labels as f64
    }
}

/// Adds the section.
pub fn write(report: &mut Report) -> anyhow::Result<()> {
    report.text("## Confidence");
    let trials = generate_trials(&full_set(1.0), SEEDS);
    let by_trial: Vec<[Bin; BIN_COUNT]> = trials.par_iter().map(bins).collect();
    let mut bins = [Bin::default(); BIN_COUNT];
    for (bin, counts) in by_trial.iter().flat_map(|bins| bins.iter().enumerate()) {
        bins[bin].labels += counts.labels;
        bins[bin].correct += counts.correct;
        bins[bin].confidence_sum += counts.confidence_sum;
    }
    let total: usize = bins.iter().map(|bin| bin.labels).sum();
    let filled = || bins.iter().filter(|bin| bin.labels > 0);
    let gap = filled().map(|bin| (bin.correct as f64 - bin.confidence_sum).abs()).sum::<f64>() / total as f64;
    report.text(&format!(
        "Accuracy of contact labels at p = 0 by their confidence. The mean difference between confidence \
         and accuracy, weighted by frames, is {gap:.3}. Low confidence occurs mainly at the edges of \
         plants."
    ));
    let rows: Vec<Vec<String>> = filled()
        .map(|bin| {
            vec![
                format!("{:.3}", bin.mean_confidence()),
                percent(100.0 * bin.correct as f64 / bin.labels as f64),
                percent(100.0 * bin.labels as f64 / total as f64),
            ]
        })
        .collect();
    report.table(&["mean confidence", "correct in %", "frames in %"], &rows);
    let path = report.figure("confidence", "Reliability diagram: fraction of correct labels over confidence");
    draw(
        &path,
        &[Panel {
            title: "Reliability of contact labels",
            x: ("confidence", 0.5..1.0),
            y: ("fraction of correct labels", 0.5..1.0),
            series: vec![
                Series::line(
                    "measured",
                    filled().map(|bin| (bin.mean_confidence(), bin.accuracy())).collect(),
                ),
                Series::line("ideal", vec![(0.5, 0.5), (1.0, 1.0)]),
            ],
        }],
    )
}

/// Bins the contact labels of a trial by confidence.
fn bins(trial: &Trial) -> [Bin; BIN_COUNT] {
    let detection = trial.detect(default_params(Method::Robust));
    let mut bins = [Bin::default(); BIN_COUNT];
    for side in Side::BOTH {
        let labels = detection.principal().foot(side);
        let truth = &trial.truth(Part::Contact)[side as usize];
        for ((label, truth), confidence) in labels.planted.iter().zip(truth).zip(&labels.confidence) {
            let confidence = f64::from(*confidence);
            let bin = (((confidence - 0.5) * 2.0 * BIN_COUNT as f64) as usize).min(BIN_COUNT - 1);
            bins[bin].labels += 1;
            bins[bin].correct += usize::from(Some(*label) == *truth);
            bins[bin].confidence_sum += confidence;
        }
    }
    bins
}
