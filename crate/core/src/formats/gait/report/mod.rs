//! The printable report: one self-contained page per skeleton, on at most two sheets of A4 or Letter.

mod definitions;
mod html;
mod plots;

use std::fmt::Write;

use crate::foot::Side;
use crate::formats::format_info::FormatInfo;
use crate::formats::gait::export::{GaitExport, Reader, SkeletonGait, Writer};
use crate::gait::{ActionGait, Gait, LeftOut, PerSide, Spread, Step};
use crate::intervals::intervals;
use crate::numeric::sort;
use crate::skeleton::unit_name;
use definitions::{DEFINITIONS, SOURCES};
use html::escape;
use plots::{PlotSize, angle_plot, contact_plot};

pub(super) const FORMAT_INFO: FormatInfo<Writer, Reader> = FormatInfo {
    name: "report",
    title: "Report",
    description: "Printable page with figures, plots, steps and definitions.",
    extension: "gait.html",
    media_type: "text/html",
    write: report,
    read: None,
};

/// Style of the report. The app allows it by its hash.
const STYLE: &str = include_str!("report.css");

/// Maximum number of actions that fit; those with the most strides are shown.
const MAX_PARTS: usize = 3;
/// Maximum number of steps that fit on the second sheet.
const MAX_STEPS: usize = 24;

/// Returns the report as HTML.
fn report(export: &GaitExport) -> String {
    let title = escape(&format!("Gait report: {}", export.source.name));
    let mut page = format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'\">\n\
         <meta name=\"viewport\" content=\"width=device-width\">\n\
         <title>{title}</title>\n<style>{STYLE}</style>\n</head>\n<body>\n"
    );
    for gait in &export.skeletons {
        sheet(&mut page, export, gait);
    }
    page + "</body>\n</html>\n"
}

/// Appends the report of one skeleton.
fn sheet(page: &mut String, export: &GaitExport, gait: &SkeletonGait) {
    let shown = shown_parts(gait);
    page.push_str("<main class=\"sheet\">\n");
    head(page, export, gait);
    if let [part] = &shown[..] {
        key_figures(page, &part.analysis.gait);
    }
    let _ = write!(
        page,
        "<h2>Contacts</h2>\n<figure>{}</figure>\n",
        contact_plot(gait.detection, &gait.parts, export.clip.frame_time())
    );
    if shown.is_empty() {
        page.push_str(
            "<p class=\"note\">The clip contains no complete stride: there is nothing to measure.</p>\n",
        );
    } else if let [part] = &shown[..] {
        let size = PlotSize { width: 365.0, height: 178.0 };
        let _ = write!(page, "<div class=\"one\">\n<div>\n");
        measures(page, &shown);
        left_out(page, gait, &shown);
        let _ = write!(page, "</div>\n<div>\n");
        angles_heading(page);
        for plot in angle_plots(part, size) {
            let _ = writeln!(page, "<figure>{plot}</figure>");
        }
        page.push_str("</div>\n</div>\n");
    } else {
        measures(page, &shown);
        left_out(page, gait, &shown);
        angles_heading(page);
        page.push_str("<div class=\"plots\">\n");
        let size = PlotSize { width: 218.0, height: if shown.len() == 2 { 92.0 } else { 68.0 } };
        for part in &shown {
            let _ = writeln!(page, "<h3>{}</h3>", escape(&action_title(part)));
            for plot in angle_plots(part, size) {
                let _ = writeln!(page, "<figure>{plot}</figure>");
            }
        }
        page.push_str("</div>\n");
    }
    page.push_str("<section class=\"second\">\n");
    steps(page, gait);
    page.push_str("<h2>Definitions</h2>\n<dl class=\"definitions\">\n");
    for (term, definition) in DEFINITIONS {
        let _ = writeln!(page, "<div><dt>{term}</dt><dd>{}</dd></div>", escape(definition));
    }
    page.push_str("</dl>\n<h2>Sources</h2>\n<ol class=\"sources\">\n");
    for source in SOURCES {
        let _ = writeln!(page, "<li>{}</li>", escape(source));
    }
    page.push_str("</ol>\n</section>\n</main>\n");
}

/// Returns the parts with strides, at most [`MAX_PARTS`], in their order.
fn shown_parts<'a>(gait: &'a SkeletonGait) -> Vec<&'a ActionGait> {
    let strides = |part: &ActionGait| part.analysis.gait.strides;
    let mut counts: Vec<usize> = gait.parts.iter().map(strides).collect();
    counts.sort_unstable();
    let least = counts.iter().nth_back(MAX_PARTS - 1).copied().unwrap_or(0).max(1);
    gait.parts.iter().filter(|part| strides(part) >= least).take(MAX_PARTS).collect()
}

/// Appends name and settings.
fn head(page: &mut String, export: &GaitExport, gait: &SkeletonGait) {
    let clip = export.clip;
    let duration = clip.frame_count() as f64 * clip.frame_time();
    let _ = write!(
        page,
        "<header>\n<div>\n<p class=\"kind\">Gait report</p>\n<h1>{}</h1>\n",
        escape(&export.source.name)
    );
    if let Some(root) = export.root(gait.skeleton) {
        let _ = writeln!(page, "<p>Skeleton {}</p>", escape(root));
    }
    if let Some(sha256) = &export.source.sha256 {
        let _ = writeln!(page, "<p>SHA-256 {}…</p>", escape(&sha256.chars().take(16).collect::<String>()));
    }
    let params = gait.detection.params;
    let metres = gait.skeleton.metres_per_unit;
    let unit = unit_name(metres).map_or_else(|| format!("{metres} m"), |name| format!("1 {name}"));
    let leg =
        gait.skeleton.leg.map_or_else(String::new, |leg| format!(", leg {:.0} cm", 100.0 * leg * metres));
    let edits = match gait.detection.edits.len() {
        0 => "not edited".into(),
        1 => "with 1 edit".into(),
        count => format!("with {count} edits"),
    };
    let _ = write!(
        page,
        "</div>\n<ul>\n<li>{} frames, {duration:.2} s at {} Hz</li>\n\
         <li>Contacts: {} (r {}, w {}), {edits}</li>\n<li>Unit: {unit}{leg}</li>\n\
         <li>Plantigrade {}</li>\n</ul>\n</header>\n",
        clip.frame_count(),
        (clip.rate() * 100.0).round() / 100.0,
        escape(params.method().title()),
        params.tolerance(),
        params.window(),
        env!("CARGO_PKG_VERSION"),
    );
}

/// Appends the most important figures of one part.
fn key_figures(page: &mut String, gait: &Gait) {
    let strides = match gait.left_out.total() {
        0 => format!("{}", gait.strides),
        count => format!("{} <small>and {count} left out</small>", gait.strides),
    };
    let surface = gait
        .belt_m_per_s
        .map_or_else(|| "Overground".into(), |belt| format!("Treadmill <small>{belt:.2} m/s</small>"));
    let with_unit = |value: Option<f64>, decimals: usize, unit: &str| {
        or_dash(value.map(|value| format!("{value:.decimals$} <small>{unit}</small>")))
    };
    page.push_str("<dl class=\"key\">\n");
    for (term, value) in [
        ("Cadence", with_unit(gait.cadence_steps_per_min, 1, "steps/min")),
        ("Speed", with_unit(gait.speed_m_per_s, 2, "m/s")),
        ("Strides", strides),
        ("Surface", surface),
    ] {
        let _ = writeln!(page, "<div><dt>{term}</dt><dd>{value}</dd></div>");
    }
    page.push_str("</dl>\n");
}

/// A row of the table of measures: title, unit, factor to that unit, decimals, values.
type MeasureRow = (&'static str, &'static str, f64, usize, fn(&Gait) -> PerSide);

const MEASURES: [MeasureRow; 11] = [
    ("Stance", "% of cycle", 1.0, 1, |gait| gait.stance_percent),
    ("Swing", "% of cycle", 1.0, 1, |gait| gait.swing_percent),
    ("Single support", "% of cycle", 1.0, 1, |gait| gait.single_support_percent),
    ("Double support", "% of cycle", 1.0, 1, |gait| gait.double_support_percent),
    ("Stance time", "s", 1.0, 3, |gait| gait.stance_s),
    ("Swing time", "s", 1.0, 3, |gait| gait.swing_s),
    ("Stride time", "s", 1.0, 3, |gait| gait.stride_time_s),
    ("Step time", "s", 1.0, 3, |gait| gait.step_time_s),
    ("Stride length", "cm", 100.0, 1, |gait| gait.stride_length_m),
    ("Step length", "cm", 100.0, 1, |gait| gait.step_length_m),
    ("Step width", "cm", 100.0, 1, |gait| gait.step_width_m),
];

/// A row about both feet: title, unit, value.
type BothRow = (&'static str, &'static str, fn(&Gait) -> Option<String>);

const FIGURES: [BothRow; 4] = [
    ("Cadence", "steps/min", |gait| gait.cadence_steps_per_min.map(|cadence| format!("{cadence:.1}"))),
    ("Speed", "m/s", |gait| gait.speed_m_per_s.map(|speed| format!("{speed:.2}"))),
    ("Strides", "", |gait| Some(gait.strides.to_string())),
    ("Flight", "% of cycle", |gait| gait.flight_share.map(|flight| mean_sd(flight, 100.0, 1))),
];

const SYMMETRY: [BothRow; 4] = [
    ("stance time", "%", |gait| gait.symmetry.stance_percent.map(signed)),
    ("swing time", "%", |gait| gait.symmetry.swing_percent.map(signed)),
    ("step time", "%", |gait| gait.symmetry.step_time_percent.map(signed)),
    ("step length", "%", |gait| gait.symmetry.step_length_percent.map(signed)),
];

/// Appends the table of measures, with two columns per part.
fn measures(page: &mut String, parts: &[&ActionGait]) {
    let is_single = parts.len() == 1;
    let class = if is_single { "" } else { " class=\"compact\"" };
    let _ = write!(
        page,
        "<h2>Measures <small>mean ± standard deviation</small></h2>
<div class=\"scroll\"><table{class}>
<thead>
"
    );
    if !is_single {
        page.push_str("<tr><td></td>");
        for part in parts {
            let _ = write!(page, "<th colspan=\"2\" scope=\"colgroup\">{}</th>", escape(&action_title(part)));
        }
        page.push_str("</tr>\n");
    }
    page.push_str("<tr><td></td>");
    for _ in parts {
        page.push_str(
            "<th class=\"left\" scope=\"col\">Left</th><th class=\"right\" scope=\"col\">Right</th>",
        );
    }
    page.push_str("</tr>\n</thead>\n<tbody>\n");
    let both = |page: &mut String, rows: &[BothRow], prefix: &str| {
        for (index, (title, unit, value)) in rows.iter().enumerate() {
            let class = if index == 0 { " class=\"section\"" } else { "" };
            let _ = write!(page, "<tr{class}><th scope=\"row\">{prefix}{title} <small>{unit}</small></th>");
            for part in parts {
                let _ = write!(
                    page,
                    "<td class=\"both\" colspan=\"2\">{}</td>",
                    or_dash(value(&part.analysis.gait))
                );
            }
            page.push_str("</tr>\n");
        }
    };
    if !is_single {
        both(page, &FIGURES, "");
    }
    for (index, (title, unit, factor, decimals, value)) in MEASURES.iter().enumerate() {
        let class = if [0, 4, 8].contains(&index) { " class=\"section\"" } else { "" };
        let _ = write!(page, "<tr{class}><th scope=\"row\">{title} <small>{unit}</small></th>");
        for part in parts {
            let PerSide { left, right } = value(&part.analysis.gait);
            for spread in [left, right] {
                let _ = write!(
                    page,
                    "<td>{}</td>",
                    or_dash(spread.map(|spread| mean_sd(spread, *factor, *decimals)))
                );
            }
        }
        page.push_str("</tr>\n");
    }
    if is_single {
        both(page, &FIGURES[3..], "");
    }
    both(page, &SYMMETRY, "Symmetry, ");
    page.push_str("</tbody>\n</table></div>\n");
}

/// Appends the numbers of strides that were left out.
fn left_out(page: &mut String, gait: &SkeletonGait, shown: &[&ActionGait]) {
    let mut notes = Vec::new();
    for part in shown {
        let LeftOut { cut_off, missing_event, pause, on_the_spot } = part.analysis.gait.left_out;
        let reasons = [
            (cut_off, "cut off"),
            (missing_event, "with a missing event"),
            (pause, "with a pause"),
            (on_the_spot, "on the spot"),
        ];
        let reasons: Vec<String> = reasons
            .iter()
            .filter(|(count, _)| *count > 0)
            .map(|(count, reason)| format!("{count} {reason}"))
            .collect();
        let name =
            if part.action.name.is_empty() { String::new() } else { format!(" in {}", action_title(part)) };
        if !reasons.is_empty() {
            notes.push(format!("Strides left out{name}: {}.", reasons.join(", ")));
        }
    }
    let hidden = gait.parts.iter().filter(|part| part.analysis.gait.strides > 0).count() - shown.len();
    if hidden > 0 {
        notes.push(format!("{hidden} further actions with fewer strides are not shown."));
    }
    if !notes.is_empty() {
        let _ = writeln!(page, "<p class=\"note\">{}</p>", escape(&notes.join(" ")));
    }
}

fn angles_heading(page: &mut String) {
    page.push_str(
        "<h2>Joint angles <small>mean and standard deviation over the gait cycle; left solid, right dashed, \
         dotted at foot off</small></h2>\n",
    );
}

/// Returns the plots of hip, knee and ankle.
fn angle_plots(part: &ActionGait, size: PlotSize) -> Vec<String> {
    let Some(curves) = &part.analysis.curves else { return Vec::new() };
    let titles = ["Hip flexion", "Knee flexion", "Ankle dorsiflexion"];
    let joints = titles.into_iter().zip(curves.by_joint());
    joints.map(|(title, (_, sides))| angle_plot(title, sides, &part.analysis.gait, size)).collect()
}

/// Appends the table of steps.
fn steps(page: &mut String, gait: &SkeletonGait) {
    let rows: Vec<(&ActionGait, &Step)> =
        gait.parts.iter().flat_map(|part| part.analysis.steps.iter().map(move |step| (part, step))).collect();
    let rows = sort::sort_by_number(rows, |(_, step)| step.strike_s);
    page.push_str(
        "<h2>Steps and events</h2>\n<div class=\"scroll\"><table class=\"steps\">\n<thead>\n<tr><th scope=\"col\">Foot</th>",
    );
    let is_per_action = gait.is_per_action();
    if is_per_action {
        page.push_str("<th scope=\"col\">Action</th>");
    }
    for title in [
        "Foot<br>strike s",
        "Foot<br>off s",
        "Step<br>time s",
        "Step<br>length cm",
        "Step<br>width cm",
        "Stride<br>time s",
        "Stride<br>length cm",
        "Stance<br>%",
        "Swing<br>%",
        "Single<br>support %",
        "Double<br>support %",
    ] {
        let _ = write!(page, "<th scope=\"col\">{title}</th>");
    }
    page.push_str("</tr>\n</thead>\n<tbody>\n");
    for (part, step) in rows.iter().take(MAX_STEPS) {
        let side = step.side.name();
        let number = |value: Option<f64>, factor: f64, decimals: usize| {
            or_dash(value.map(|value| minus(format!("{:.decimals$}", factor * value))))
        };
        let mut cells = vec![
            number(Some(step.strike_s), 1.0, 3),
            number(step.off_s, 1.0, 3),
            number(step.step_time_s, 1.0, 3),
            number(step.step_length_m, 100.0, 1),
            number(step.step_width_m, 100.0, 1),
        ];
        match (&step.stride, step.left_out) {
            (Some(stride), _) => cells.extend([
                number(Some(stride.time_s), 1.0, 3),
                number(Some(stride.length_m), 100.0, 1),
                number(Some(stride.stance_percent), 1.0, 1),
                number(Some(stride.swing_percent), 1.0, 1),
                number(Some(stride.single_support_percent), 1.0, 1),
                number(Some(stride.double_support_percent), 1.0, 1),
            ]),
            (None, omission) => {
                let reason = omission.map_or("", |omission| omission.description());
                cells.push(format!("</td><td colspan=\"5\"><small>{reason}</small>"));
            }
        }
        let _ = write!(
            page,
            "<tr><td class=\"{side}\">{}</td>",
            if step.side == Side::Left { "Left" } else { "Right" }
        );
        if is_per_action {
            let _ = write!(page, "<td>{}</td>", escape(&part.action.name));
        }
        for cell in cells {
            let _ = write!(page, "<td>{cell}</td>");
        }
        page.push_str("</tr>\n");
    }
    page.push_str("</tbody>\n</table></div>\n");
    let contacts: usize =
        Side::BOTH.iter().map(|&side| intervals(&gait.detection.principal().foot(side).planted).len()).sum();
    let more = match rows.len() {
        count if count > MAX_STEPS => format!(
            "The first {MAX_STEPS} of {count} foot strikes; the table of steps contains all of them. "
        ),
        _ => String::new(),
    };
    let _ = writeln!(
        page,
        "<p class=\"note\">{more}The clip has {contacts} contacts. A row is a foot strike: the step that it ends \
         and the stride that it begins.</p>"
    );
}

/// Returns the title of an action: `Action A`.
fn action_title(part: &ActionGait) -> String {
    let name = &part.action.name;
    let is_letters = name.chars().all(|c| c.is_ascii_uppercase() || c.is_ascii_digit());
    if is_letters { format!("Action {name}") } else { name.clone() }
}

fn mean_sd(spread: Spread, factor: f64, decimals: usize) -> String {
    let mean = minus(format!("{:.decimals$}", factor * spread.mean));
    match spread.sd {
        Some(sd) => format!("{mean} <small>± {:.decimals$}</small>", factor * sd),
        None => mean,
    }
}

/// Formats a percentage with its sign.
fn signed(percent: f64) -> String {
    let rounded = (percent * 10.0).round() / 10.0;
    if rounded == 0.0 { "0.0".into() } else { minus(format!("{rounded:+.1}")) }
}

/// Replaces the hyphen of a negative number by a minus sign.
fn minus(number: String) -> String {
    number.replace('-', "−")
}

fn or_dash(text: Option<String>) -> String {
    text.unwrap_or_else(|| "–".into())
}
