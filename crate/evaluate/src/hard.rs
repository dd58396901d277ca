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
         foot stands on. *one-foot-dragged* creeps along the ground at 0.1 to 0.4 m/s for the whole clip: frame by \
         frame it is a planted foot with noise, and the clustering takes it for one. The default sees where it \
         gets to: two planted feet do not part, whatever the ground does that they stand on, so a foot that moves \
         steadily away from the other one, both labelled planted, 0.4 leg lengths without a step, is dragged. \
         *afloat* is beyond what motion alone can tell. It has no plant at all: the slow turning points of swimming \
         feet are labelled, and the notice says that the share of time in the air is beyond any gait.",
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

/// What a foot that is dragged throughout has in common with a planted one, and what not.
fn dragged(report: &mut Report) -> anyhow::Result<()> {
    let Some(recipe) = hard_cases(1.0).into_iter().find(|recipe| recipe.name == "one-foot-dragged") else {
        return Ok(());
    };
    let trial = &trials(&[recipe], [SEEDS.start])[0];
    let detection = trial.detect(of(Method::Robust));
    let toe = detection.part(Part::Toe).expect("the default labels toes");
    let frames = trial.feet.frame_count().min((6.0 / trial.frame_time()) as usize);
    let metres = trial.feet.metres_per_unit;
    let over_time = |value: &dyn Fn(usize) -> f64| {
        (0..frames)
            .map(|frame| (frame as f64 * trial.frame_time(), metres * value(frame)))
            .collect::<Vec<_>>()
    };
    let series = |name: &str, foot: usize| {
        let track = &trial.feet.tracks[foot].toe;
        [
            Series::line(name, over_time(&|frame| f64::from(toe.feet[foot].speed[frame]))),
            Series::line(name, over_time(&|frame| (track[frame] - track[0]).norm())),
        ]
    };
    let ([left_speed, left_way], [right_speed, right_way]) = (series("left", 0), series("right", 1));
    let path = report.figure(
        "one-foot-dragged",
        "Speeds and ways of both toes: the dragged one is slow like a plant, but goes on while the other stands",
    );
    let x = ("seconds", 0.0..frames as f64 * trial.frame_time());
    draw(
        &path,
        &[
            Panel {
                title: "Toe speeds of one-foot-dragged: one steps, the other creeps",
                x: x.clone(),
                y: ("m/s", 0.0..1.5),
                series: vec![left_speed, right_speed],
            },
            Panel {
                title: "How far the toes have come: while one stands, the other parts from it",
                x,
                y: ("m", 0.0..3.0),
                series: vec![left_way, right_way],
            },
        ],
    )
}

#[cfg(test)]
mod tests {
    use plantigrade_synth::setting::Setting;
    use plantigrade_synth::{Recipe, decimated, generate};

    use super::*;
    use crate::trial::Trial;

    #[test]
    fn hard_cases_are_labelled_but_for_the_one_that_cannot_be() {
        for recipe in hard_cases(1.0) {
            let trial = &trials(std::slice::from_ref(&recipe), 10..11)[0];
            let detection = trial.detect(of(Method::Robust));
            let share = 100.0 * trial.tally(Part::Contact, labels(&detection, Part::Contact), 0.2).accuracy();
            if recipe.name == "afloat" {
                let codes: Vec<_> = detection.notices.iter().map(|notice| notice.code.name()).collect();
                assert!(codes.contains(&"implausible-airborne".to_owned()), "{codes:?}");
            } else {
                assert!(share >= 95.0, "{}: {share}", recipe.name);
            }
        }
    }

    #[test]
    fn a_dragged_foot_is_no_plant_at_any_rate() {
        let recipe = case("one-foot-dragged");
        for (seed, factor) in (10..14).flat_map(|seed| [(seed, 1), (seed, 2)]) {
            let trial = Trial::generated("", &decimated(&generate(&recipe, seed), factor));
            let detection = trial.detect(of(Method::Robust));
            for part in Part::ALL {
                let share = 100.0 * trial.tally(part, labels(&detection, part), 0.2).accuracy();
                assert!(share >= 95.0, "seed {seed}, every {factor}. frame, {}: {share}", part.name());
            }
        }
    }

    #[test]
    fn ground_that_moves_drags_no_foot() {
        let belts = [0.3, 0.6, 0.9, 1.2].map(|speed| ("treadmill", Setting::Belt(speed)));
        let platforms = [0.15, 0.6, 1.2].map(|speed| ("moving-platform", Setting::Platform(speed)));
        for (name, setting) in belts.into_iter().chain(platforms) {
            let recipe = Recipe { setting, ..case(name) };
            for trial in trials(&[recipe], 10..12) {
                let detection = trial.detect(of(Method::Robust));
                let share =
                    100.0 * trial.tally(Part::Contact, labels(&detection, Part::Contact), 0.2).accuracy();
                assert!(share >= 95.0, "{setting:?}: {share}");
            }
        }
    }

    fn case(name: &str) -> Recipe {
        hard_cases(1.0).into_iter().find(|recipe| recipe.name == name).expect("a hard case")
    }
}
