//! Figures 3 to 5 of the paper: effect of the window, and selection of the bandwidth.

use plantigrade::plants::{Method, Params};

use super::trial::{Trial, default_params};
use crate::figure::{Panel, Series, draw};
use crate::report::Report;

/// Adds the figures.
pub fn write(report: &mut Report, trials: &[Trial]) -> anyhow::Result<()> {
    report.text("### Figure 3: effect of the window");
    let Some(trial) = trials.iter().find(|trial| trial.name == "foot-drag-walk") else { return Ok(()) };
    figure_3(report, trial)?;
    report.text("### Figures 4 and 5: selection of the bandwidth");
    let Some(trial) = trials.iter().find(|trial| trial.name == "curved-walk") else { return Ok(()) };
    figures_4_and_5(report, trial)
}

/// Labels and heights of one toe, without and with the window.
fn figure_3(report: &mut Report, trial: &Trial) -> anyhow::Result<()> {
    let metres = trial.feet.metres_per_unit;
    let frames = trial.feet.frame_count().min((5.0 / trial.frame_time()) as usize);
    let mut plant_counts = Vec::new();
    let mut panel = |window: usize, title: &'static str| {
        let detection = trial.detect(Params { window, ..default_params(Method::Paper) });
        let toe = &detection.principal().feet[0];
        let plants =
            |foot: usize| plantigrade::intervals::intervals(&detection.principal().feet[foot].planted).len();
        plant_counts.push(plants(0) + plants(1));
        let points = |planted: bool| {
            (0..frames)
                .filter(|&frame| toe.planted[frame] == planted)
                .map(|frame| (frame as f64 * trial.frame_time(), f64::from(toe.height[frame]) * metres))
                .collect::<Vec<_>>()
        };
        Panel {
            title,
            x: ("time in s", 0.0..frames as f64 * trial.frame_time()),
            y: ("height in m", 0.0..0.2),
            series: vec![Series::dots("planted", points(true)), Series::dots("not planted", points(false))],
        }
    };
    let panels = [panel(0, "Left toe, w = 0"), panel(1, "Left toe, w = 1")];
    report.text(&format!(
        "Labels of the published method flicker where noise is strong. A window of three frames reduces \
         this. The whole clip (walk dragging a foot) has {} plants at w = 0 and {} at w = 1.",
        plant_counts[0], plant_counts[1]
    ));
    let path = report.figure("figure-3", "Heights of a toe and its labels, without and with the window");
    draw(&path, &panels)
}

/// Norms by frame and sorted, and their running variance.
fn figures_4_and_5(report: &mut Report, trial: &Trial) -> anyhow::Result<()> {
    let detection = trial.detect(default_params(Method::Paper));
    let Some(evidence) = &detection.principal().evidence else { return Ok(()) };
    let numbered = |values: &mut dyn Iterator<Item = f64>| {
        values.enumerate().map(|(index, value)| (index as f64, value)).collect::<Vec<_>>()
    };
    let knee = evidence.knee as f64;
    let count = evidence.sorted_norms.len() as f64;
    let variance = numbered(&mut evidence.running_variance().take_while(|variance| *variance <= 0.01));
    let path = report.figure(
        "figure-4-5",
        "Norms of the samples of a walk, unsorted and sorted, and their running variance with its knee",
    );
    draw(
        &path,
        &[
            Panel {
                title: "Norms of the samples of a walk (figure 4a)",
                x: ("sample: left foot, then right", 0.0..count),
                y: ("norm", 0.0..2.0),
                series: vec![Series::dots(
                    "",
                    numbered(&mut evidence.norms.iter().map(|&norm| f64::from(norm))),
                )],
            },
            Panel {
                title: "Sorted norms (figure 4b)",
                x: ("sample", 0.0..count),
                y: ("norm", 0.0..2.0),
                series: vec![
                    Series::line("norms", numbered(&mut evidence.sorted_norms.iter().copied())),
                    Series::line(format!("σ = {:.3}", evidence.sigma), vec![(knee, 0.0), (knee, 2.0)]),
                ],
            },
            Panel {
                title: "Running variance of the sorted norms (figure 5)",
                x: ("sample", 0.0..count),
                y: ("variance", 0.0..0.01),
                series: vec![
                    Series::line("variance", variance),
                    Series::line("r = 0.001", vec![(0.0, 0.001), (count, 0.001)]),
                ],
            },
        ],
    )
}
