//! The paper's figures 3 to 5: what the window does, and why a scale can be found.

use plantigrade::plants::{Method, Params};

use crate::figure::{Panel, Series, draw};
use crate::report::Report;
use crate::trial::{Trial, of};

/// Adds the figures.
pub fn write(report: &mut Report, all: &[Trial]) -> anyhow::Result<()> {
    report.text("### Figure 3: what the window is for");
    let Some(trial) = all.iter().find(|trial| trial.name == "foot-drag-walk") else { return Ok(()) };
    jitter(report, trial)?;
    report.text("### Figures 4 and 5: why a scale can be found");
    let Some(trial) = all.iter().find(|trial| trial.name == "curved-walk") else { return Ok(()) };
    knee(report, trial)
}

/// Labels of one foot without and with the window, on the height of the toe.
fn jitter(report: &mut Report, trial: &Trial) -> anyhow::Result<()> {
    let metres = trial.feet.metres_per_unit;
    let frames = trial.feet.frame_count().min((5.0 / trial.frame_time()) as usize);
    let mut runs = Vec::new();
    let mut panel = |window: usize, title: &'static str| {
        let detection = trial.detect(Params { window, ..of(Method::Paper) });
        let toe = &detection.principal().feet[0];
        let count =
            |foot: usize| plantigrade::labels::intervals(&detection.principal().feet[foot].planted).len();
        runs.push(count(0) + count(1));
        let points = |planted: bool| {
            (0..frames)
                .filter(|&frame| toe.planted[frame] == planted)
                .map(|frame| (frame as f64 * trial.frame_time(), f64::from(toe.height[frame]) * metres))
                .collect::<Vec<_>>()
        };
        Panel {
            title,
            x: ("seconds", 0.0..frames as f64 * trial.frame_time()),
            y: ("height in m", 0.0..0.2),
            series: vec![Series::dots("planted", points(true)), Series::dots("not", points(false))],
        }
    };
    let panels = [panel(0, "Left toe, w = 0"), panel(1, "Left toe, w = 1")];
    report.text(&format!(
        "Labels of the published method flicker where noise is strong; a window of three frames calms them. Over \
         the whole clip (walk dragging a foot) there are {} plants at w = 0 and {} at w = 1.",
        runs[0], runs[1]
    ));
    let path = report.figure("figure-3", "Heights of a toe with its labels, without and with the window");
    draw(&path, &panels)
}

/// Norms by frame and sorted, and their running variance.
fn knee(report: &mut Report, trial: &Trial) -> anyhow::Result<()> {
    let detection = trial.detect(of(Method::Paper));
    let Some(evidence) = &detection.principal().evidence else { return Ok(()) };
    let numbered = |values: &mut dyn Iterator<Item = f64>| {
        values.enumerate().map(|(j, value)| (j as f64, value)).collect::<Vec<_>>()
    };
    let knee = evidence.knee as f64;
    let count = evidence.sorted_norms.len() as f64;
    let variance = numbered(&mut evidence.running_variance().take_while(|variance| *variance <= 0.01));
    let path = report
        .figure("figure-4-5", "Norms of a walk's samples, sorted, and their running variance, with the knee");
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
                title: "The same, sorted (figure 4b)",
                x: ("sample", 0.0..count),
                y: ("norm", 0.0..2.0),
                series: vec![
                    Series::line("norms", numbered(&mut evidence.sorted_norms.iter().copied())),
                    Series::line(format!("σ = {:.3}", evidence.sigma), vec![(knee, 0.0), (knee, 2.0)]),
                ],
            },
            Panel {
                title: "Sample variance of the first norms (figure 5)",
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
