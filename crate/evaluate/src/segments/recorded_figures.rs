//! Figures of the recorded trial 86_01: curves of the methods and their cuts.

use plantigrade::segments::{Curve, Kind, Method, Segment, Segmentation};

use super::recorded_trials::Recorded;
use super::{Case, MVU_PUBLISHED, params_of, segmentation};
use crate::figure::{Panel, Series, draw};
use crate::report::Report;

/// Maximum time between the points of an unbroken line, in seconds.
const MAX_GAP: f64 = 0.5;

/// Adds the residuals of `pca-tail` and `mvu`.
pub fn residuals(report: &mut Report, recorded: &Recorded) -> anyhow::Result<()> {
    let case = &recorded.cases[0];
    let [tail, mvu, published] =
        [params_of(Method::PcaTail, false), params_of(Method::Mvu, false), MVU_PUBLISHED]
            .map(|params| segmentation(&case.clip, params));
    let path = report.figure(
        "actions-residuals",
        "Residuals of PCA and of unfolding over time in 86_01, with annotated and detected cuts",
    );
    let title = "86_01: variance beyond two principal components (pca-tail)";
    let mvu_title = "Residual beyond one dimension of the unfolded window (mvu)";
    let published_title = "Residual beyond ten dimensions, as published (mvu)";
    draw(
        &path,
        &[
            panel(case, title, "residual", &tail),
            panel(case, mvu_title, "residual", &mvu).without_legend(),
            panel(case, published_title, "ratio", &published).without_legend(),
        ],
    )
}

/// Adds the distance curve of `lsd` with its turning points, motifs and actions.
pub fn distances(report: &mut Report, recorded: &Recorded) -> anyhow::Result<()> {
    let case = &recorded.cases[0];
    let segmentation = segmentation(&case.clip, params_of(Method::Lsd, false));
    let curve = &segmentation.curve;
    let points = points(case, curve, &curve.values);
    let path = report.figure(
        "actions-lsd",
        "Distance to the template over time in 86_01, with turning points and annotated and detected cuts",
    );
    let title = "86_01: least-squares distance to the template (lsd)";
    let mut plot = panel(case, title, "distance", &segmentation);
    let turning_points = curve.extrema.iter().map(|&index| points[index]).collect();
    plot.series[1] = Series::dots("turning points", turning_points);
    draw(&path, &[plot])?;
    let classes: Vec<String> = segmentation.motifs.iter().map(|motif| motif.class.to_string()).collect();
    report.text(&format!(
        "Classes of the motifs between turning points: `{}`. The resulting actions:",
        classes.join(" ")
    ));
    let rows: Vec<Vec<String>> = segmentation
        .segments
        .iter()
        .map(|segment| segment_row(case, segment, &recorded.actions[0]))
        .collect();
    report.table(&["main annotated action", "start in s", "end in s", "kind", "motifs"], &rows);
    Ok(())
}

/// Adds the likelihood gain of `auto`.
pub fn likelihood_gain(report: &mut Report, recorded: &Recorded) -> anyhow::Result<()> {
    let case = &recorded.cases[0];
    let segmentation = segmentation(&case.clip, params_of(Method::Auto, false));
    let path = report.figure(
        "actions-gain",
        "Likelihood gain of a cut over time in 86_01, with the penalty and annotated and detected cuts",
    );
    let title = "86_01: likelihood gain of a cut, and the penalty of a cut (auto)";
    let mut plot = panel(case, title, "gain", &segmentation);
    let curve = &segmentation.curve;
    plot.series[1] = Series::line("penalty of a cut", points(case, curve, &curve.threshold));
    // Space for the legend.
    plot.y.1.end *= 1.4;
    draw(&path, &[plot])
}

/// Returns a plot of a curve with its threshold, and the detected and annotated cuts.
fn panel<'a>(case: &Case, title: &'a str, unit: &'a str, segmentation: &Segmentation) -> Panel<'a> {
    let seconds = |frame: f64| frame * case.clip.frame_time();
    let curve = &segmentation.curve;
    let highest = curve.values.iter().chain(&curve.threshold).copied().fold(0.0, f64::max);
    let cuts = segmentation.cuts().into_iter().map(|cut| seconds(cut as f64));
    let ranges = case.truth.iter().map(|cut| (seconds(cut.earliest), seconds(cut.latest)));
    Panel {
        title,
        x: ("time in s", 0.0..seconds(case.clip.frame_count() as f64)),
        y: (unit, 0.0..1.05 * highest),
        series: vec![
            Series::line(unit, points(case, curve, &curve.values)),
            Series::line("threshold", points(case, curve, &curve.threshold)),
            Series::vertical_lines("detected cuts", cuts),
            Series::bands("annotated cuts", ranges.collect()),
        ],
    }
}

/// Returns the values of a curve over time, with NaN in gaps.
fn points(case: &Case, curve: &Curve, values: &[f64]) -> Vec<(f64, f64)> {
    let times = curve.frames.iter().map(|frame| frame * case.clip.frame_time());
    let mut points: Vec<(f64, f64)> = Vec::new();
    for (time, &value) in times.zip(values) {
        if let Some(&(last, _)) = points.last()
            && time - last > MAX_GAP
        {
            points.push((time, f64::NAN));
        }
        points.push((time, value));
    }
    points
}

/// Returns the table row of a segment, with the annotated action that it overlaps most.
fn segment_row(case: &Case, segment: &Segment, actions: &[Segment]) -> Vec<String> {
    let overlap = |action: &&Segment| {
        let (a, b) = (&action.frames, &segment.frames);
        a.end.min(b.end).saturating_sub(a.start.max(b.start))
    };
    let seconds = |frame: usize| format!("{:.1}", frame as f64 * case.clip.frame_time());
    let annotated = actions.iter().max_by_key(overlap).map_or("", |action| &action.label);
    let kind = if segment.kind == Kind::Periodic { "periodic" } else { "not periodic" };
    vec![
        annotated.to_owned(),
        seconds(segment.frames.start),
        seconds(segment.frames.end),
        kind.to_owned(),
        segment.label.clone(),
    ]
}
