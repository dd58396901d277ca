//! Whether labels are as sure as they say.

use plantigrade::labels::{Part, Side};
use plantigrade::plants::Method;
use plantigrade_synth::full_set;

use crate::figure::{Panel, Series, draw};
use crate::parallel;
use crate::report::{Report, percent};
use crate::trial::{SEEDS, of, trials};

const BINS: usize = 10;

/// Adds the section.
pub fn write(report: &mut Report) -> anyhow::Result<()> {
    report.text("## Confidence");
    let all = trials(&full_set(1.0), SEEDS);
    let found = parallel::map(&all, |trial| {
        let detection = trial.detect(of(Method::Robust));
        let mut bins = [(0_usize, 0_usize, 0.0_f64); BINS];
        for side in Side::BOTH {
            let labels = detection.principal().foot(side);
            let truth = &trial.truth(Part::Contact)[side as usize];
            for ((label, truth), p) in labels.planted.iter().zip(truth).zip(&labels.confidence) {
                let p = f64::from(*p);
                let place = (((p - 0.5) * 2.0 * BINS as f64) as usize).min(BINS - 1);
                bins[place].0 += 1;
                bins[place].1 += usize::from(Some(*label) == *truth);
                bins[place].2 += p;
            }
        }
        bins
    });
    let mut bins = [(0_usize, 0_usize, 0.0_f64); BINS];
    for own in found {
        for (bin, own) in bins.iter_mut().zip(own) {
            bin.0 += own.0;
            bin.1 += own.1;
            bin.2 += own.2;
        }
    }
    let total: usize = bins.iter().map(|bin| bin.0).sum();
    let filled = || bins.iter().filter(|bin| bin.0 > 0);
    let gap: f64 = filled().map(|bin| (bin.1 as f64 - bin.2).abs()).sum::<f64>() / total as f64;
    report.text(&format!(
        "How often contact labels are right at p = 0, by the confidence they come with. The mean gap between \
         the two, weighted by frames, is {gap:.3}. Doubt gathers at the edges of plants."
    ));
    let rows: Vec<Vec<String>> = filled()
        .map(|bin| {
            vec![
                format!("{:.3}", bin.2 / bin.0 as f64),
                percent(100.0 * bin.1 as f64 / bin.0 as f64),
                percent(100.0 * bin.0 as f64 / total as f64),
            ]
        })
        .collect();
    report.table(&["mean confidence", "right in %", "share of frames in %"], &rows);
    let path = report.figure("confidence", "Reliability diagram: share of right labels over confidence");
    draw(
        &path,
        &[Panel {
            title: "Reliability of contact labels",
            x: ("confidence", 0.5..1.0),
            y: ("share of right labels", 0.5..1.0),
            series: vec![
                Series::line(
                    "found",
                    filled().map(|bin| (bin.2 / bin.0 as f64, bin.1 as f64 / bin.0 as f64)).collect(),
                ),
                Series::line("ideal", vec![(0.5, 0.5), (1.0, 1.0)]),
            ],
        }],
    )
}
