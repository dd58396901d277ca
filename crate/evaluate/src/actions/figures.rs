//! Figures of one recorded trial: what the methods look at, and where they cut.

use plantigrade::segments::{Curve, Kind, Method, Segment, Segmentation};

use super::recorded::Recorded;
use super::{Case, TEN, by, segmentation};
use crate::figure::{Panel, Series, draw};
use crate::report::Report;

/// A line is broken where nothing is known for longer, in seconds.
const GAP: f64 = 0.5;

/// The residuals that jumps are sought in.
pub fn residuals(report: &mut Report, recorded: &Recorded) -> anyhow::Result<()> {
    let case = &recorded.cases[0];
    let [tail, own, published] = [by(Method::PcaTail, false), by(Method::Mvu, false), TEN]
        .map(|params| segmentation(&case.clip, params));
    let path = report.figure(
        "actions-residuals",
        "Residuals of PCA and of unfolding over time in 86_01, with the cuts by hand and those found",
    );
    draw(
        &path,
        &[
            panel(case, "86_01: variance beyond two principal components (pca-tail)", "residual", &tail),
            panel(case, "Beyond one dimension of the unfolded window (mvu)", "residual", &own).unlabelled(),
            panel(case, "Beyond ten of them, as published (mvu)", "share", &published).unlabelled(),
        ],
    )
}

/// The patent's curve with its turning points, motifs and actions.
pub fn distances(report: &mut Report, recorded: &Recorded) -> anyhow::Result<()> {
    let case = &recorded.cases[0];
    let found = segmentation(&case.clip, by(Method::Lsd, false));
    let curve = &found.curve;
    let all = points(case, curve, &curve.values);
    let path = report.figure(
        "actions-lsd",
        "Distance to the template over time in 86_01 with its turning points, the cuts by hand and those found",
    );
    let title = "86_01: least-squares distance to the template (lsd)";
    let mut drawn = panel(case, title, "distance", &found);
    drawn.series[1] = Series::dots("turning points", curve.extrema.iter().map(|&place| all[place]).collect());
    draw(&path, &[drawn])?;
    let classes: Vec<String> = found.motifs.iter().map(|motif| motif.class.to_string()).collect();
    report.text(&format!(
        "The motifs between the turning points, by class: `{}`. The actions that come of them:",
        classes.join(" ")
    ));
    let rows: Vec<Vec<String>> =
        found.segments.iter().map(|segment| segment_row(case, segment, &recorded.actions)).collect();
    report.table(&["by hand, most of it", "from s", "to s", "kind", "motifs"], &rows);
    Ok(())
}

/// What a cut at each place is worth to the default.
pub fn gain(report: &mut Report, recorded: &Recorded) -> anyhow::Result<()> {
    let case = &recorded.cases[0];
    let found = segmentation(&case.clip, by(Method::Auto, false));
    let path = report.figure(
        "actions-gain",
        "Likelihood gained by a cut at each place of 86_01, with the price of a cut, the cuts by hand and those found",
    );
    let title = "86_01: likelihood gained by a cut, and its price (auto)";
    let mut drawn = panel(case, title, "gain", &found);
    drawn.series[1] = Series::line("price of a cut", points(case, &found.curve, &found.curve.threshold));
    // Room for the legend.
    drawn.y.1.end *= 1.4;
    draw(&path, &[drawn])
}

/// A curve with its threshold, the cuts that were found and those made by hand.
fn panel<'a>(case: &Case, title: &'a str, unit: &'a str, found: &Segmentation) -> Panel<'a> {
    let seconds = |frame: f64| frame * case.clip.frame_time();
    let curve = &found.curve;
    let most = curve.values.iter().chain(&curve.threshold).copied().fold(0.0, f64::max);
    let cuts = found.cuts().into_iter().map(|cut| seconds(cut as f64));
    let ranges = case.truth.iter().map(|cut| (seconds(cut.earliest), seconds(cut.latest)));
    Panel {
        title,
        x: ("seconds", 0.0..seconds(case.clip.frame_count() as f64)),
        y: (unit, 0.0..1.05 * most),
        series: vec![
            Series::line(unit, points(case, curve, &curve.values)),
            Series::line("limit", points(case, curve, &curve.threshold)),
            Series::uprights("cuts found", cuts),
            Series::bands("cuts by hand", ranges.collect()),
        ],
    }
}

/// Values of a curve over time, with breaks where it starts anew.
fn points(case: &Case, curve: &Curve, values: &[f64]) -> Vec<(f64, f64)> {
    let times = curve.frames.iter().map(|frame| frame * case.clip.frame_time());
    let mut points: Vec<(f64, f64)> = Vec::new();
    for (time, &value) in times.zip(values) {
        if let Some(&(last, _)) = points.last()
            && time - last > GAP
        {
            points.push((time, f64::NAN));
        }
        points.push((time, value));
    }
    points
}

/// A segment that was found beside the action by hand that most of it is.
fn segment_row(case: &Case, segment: &Segment, actions: &[Segment]) -> Vec<String> {
    let shared = |action: &&Segment| {
        let (a, b) = (&action.frames, &segment.frames);
        a.end.min(b.end).saturating_sub(a.start.max(b.start))
    };
    let seconds = |frame: usize| format!("{:.1}", frame as f64 * case.clip.frame_time());
    let by_hand = actions.iter().max_by_key(shared).map_or("", |action| &action.label);
    let kind = if segment.kind == Kind::Periodic { "repeats" } else { "does not repeat" };
    vec![
        by_hand.to_owned(),
        seconds(segment.frames.start),
        seconds(segment.frames.end),
        kind.to_owned(),
        segment.label.clone(),
    ]
}
