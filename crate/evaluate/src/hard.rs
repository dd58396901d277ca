//! The hard cases, one by one.

use plantigrade::labels::Part;
use plantigrade::plants::Method;
use plantigrade_synth::hard_cases;

use crate::figure::{Panel, Series, draw};
use crate::report::{Report, percent};
use crate::trial::{Accuracies, SEEDS, labels, of, trials};

/// Adds the section.
pub fn write(report: &mut Report) -> anyhow::Result<()> {
    report.text("## Hard cases");
    report.text(
        "Accuracy in % at p = 0.2, pooled over the seeds. Truth is to be still relative to the ground that the \
         foot stands on. Two cases are beyond what motion alone can tell. *one-foot-dragged* creeps along the \
         ground at about 0.2 m/s for the whole clip: to every method here its samples are those of a planted foot \
         with noise, unless a threshold in metres says otherwise. *afloat* has no plant at all: the slow turning \
         points of swimming feet are labelled, and the notice says that the share of time in the air is beyond any \
         gait.",
    );
    let mut rows = Vec::new();
    for recipe in hard_cases(1.0) {
        let own = trials(std::slice::from_ref(&recipe), SEEDS);
        let at = |method: Method, part: Part| {
            let tallies =
                own.iter().map(|trial| trial.tally(part, labels(&trial.detect(of(method)), part), 0.2));
            percent(Accuracies::of(tallies).pooled())
        };
        let mut codes: Vec<String> = own
            .iter()
            .flat_map(|trial| trial.detect(of(Method::Robust)).notices)
            .map(|notice| notice.code.name())
            .collect();
        codes.sort_unstable();
        codes.dedup();
        rows.push(vec![
            recipe.name.to_string(),
            at(Method::Robust, Part::Contact),
            at(Method::Robust, Part::Toe),
            at(Method::Paper, Part::Toe),
            codes.join(", "),
        ]);
    }
    report.table(&["case", "robust contact", "robust toe", "paper toe", "notices"], &rows);
    dragged(report)
}

/// Why a foot that is dragged throughout is taken for planted.
fn dragged(report: &mut Report) -> anyhow::Result<()> {
    let Some(recipe) = hard_cases(1.0).into_iter().find(|recipe| recipe.name == "one-foot-dragged") else {
        return Ok(());
    };
    let trial = &trials(&[recipe], [SEEDS.start])[0];
    let detection = trial.detect(of(Method::Robust));
    let toe = detection.part(Part::Toe).expect("the default labels toes");
    let frames = trial.feet.frame_count().min((6.0 / trial.frame_time()) as usize);
    let speeds = |foot: usize| {
        let speed = |frame: usize| toe.feet[foot].speed[frame] * trial.feet.metres_per_unit;
        (0..frames).map(|frame| (frame as f64 * trial.frame_time(), speed(frame))).collect::<Vec<_>>()
    };
    let path = report.figure(
        "one-foot-dragged",
        "Speeds of both toes: the dragged one is never faster than a noisy plant",
    );
    draw(
        &path,
        &[Panel {
            title: "Toe speeds of one-foot-dragged: one steps, the other creeps",
            x: ("seconds", 0.0..frames as f64 * trial.frame_time()),
            y: ("m/s", 0.0..1.5),
            series: vec![Series::line("left", speeds(0)), Series::line("right", speeds(1))],
        }],
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hard_cases_are_labelled_but_for_those_that_cannot_be() {
        for recipe in hard_cases(1.0) {
            let trial = &trials(std::slice::from_ref(&recipe), 10..11)[0];
            let detection = trial.detect(of(Method::Robust));
            let share = 100.0 * trial.tally(Part::Contact, labels(&detection, Part::Contact), 0.2).accuracy();
            match recipe.name.as_str() {
                "one-foot-dragged" => {}
                "afloat" => {
                    let codes: Vec<_> = detection.notices.iter().map(|notice| notice.code.name()).collect();
                    assert!(codes.contains(&"implausible-airborne".to_owned()), "{codes:?}");
                }
                name => assert!(share >= 95.0, "{name}: {share}"),
            }
        }
    }
}
