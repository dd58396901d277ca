//! Plots of the report as SVG.

use std::fmt::Write;
use std::ops::Range;

use crate::foot::Side;
use crate::formats::gait::report::html::escape;
use crate::gait::{ActionGait, CYCLE_POINTS, Curve, Gait, SideCurves};
use crate::intervals::intervals;
use crate::plants::Detection;

/// Size of a plot of angles, in pixels.
#[derive(Clone, Copy)]
pub(super) struct PlotSize {
    pub width: f64,
    pub height: f64,
}

/// Space at the left, top, right and bottom of the axes, in pixels.
const MARGINS: [f64; 4] = [24.0, 18.0, 4.0, 14.0];
/// Steps between ticks, in degrees; the smallest that needs at most [`MAX_TICKS`] of them is used.
const TICK_STEPS: [f64; 4] = [10.0, 20.0, 30.0, 60.0];
const MAX_TICKS: f64 = 5.0;

/// Returns one joint's curves with their deviations: left solid, right dashed. Dotted lines mark foot off.
pub(super) fn angle_plot(title: &str, curves: &SideCurves, gait: &Gait, size: PlotSize) -> String {
    let drawn = [("left", &curves.left), ("right", &curves.right)];
    let values = drawn.iter().filter_map(|(_, curve)| curve.as_ref()).flat_map(|curve| {
        let sd = move |point: usize| curve.sd.as_ref().map_or(0.0, |sd| sd[point]);
        (0..CYCLE_POINTS).flat_map(move |point| [-1.0, 1.0].map(|sign| curve.mean[point] + sign * sd(point)))
    });
    let (low, high) = values.fold((0.0_f64, 0.0_f64), |(low, high), value| (low.min(value), high.max(value)));
    let count = |step: f64| (high / step).ceil() - (low / step).floor();
    let step = TICK_STEPS.into_iter().find(|&step| count(step) <= MAX_TICKS).unwrap_or(90.0);
    let (low, high) = ((low / step).floor() * step, ((high / step).ceil() * step).max(low + step));
    let [left, top, right, bottom] = MARGINS;
    let x = |percent: f64| left + (size.width - left - right) * percent / 100.0;
    let y = |angle: f64| top + (size.height - top - bottom) * (high - angle) / (high.max(low + 1.0) - low);
    let mut svg = open(size.width, size.height, &format!("{title} over the gait cycle"));
    text(&mut svg, (0.0, 8.0), "name", "start", title);
    let ticks = ((high - low) / step).round() as usize;
    for tick in 0..=ticks {
        let angle = low + step * tick as f64;
        let class = if angle == 0.0 { "axis zero" } else { "axis" };
        line(&mut svg, class, [x(0.0), y(angle), x(100.0), y(angle)]);
        text(
            &mut svg,
            (left - 4.0, y(angle) + 3.0),
            "tick",
            "end",
            &format!("{angle:.0}°").replace('-', "−"),
        );
    }
    for percent in [0.0, 20.0, 40.0, 60.0, 80.0, 100.0] {
        line(&mut svg, "axis", [x(percent), y(low), x(percent), y(low) + 3.0]);
        let label = if percent == 100.0 { "100 %".into() } else { format!("{percent}") };
        let anchor = if percent == 100.0 { "end" } else { "middle" };
        text(&mut svg, (x(percent), size.height - 2.0), "tick", anchor, &label);
    }
    for (name, off) in [("left", gait.stance_percent.left), ("right", gait.stance_percent.right)] {
        if let Some(off) = off.filter(|off| off.mean < 100.0) {
            line(&mut svg, &format!("off {name}"), [x(off.mean), y(high), x(off.mean), y(low)]);
        }
    }
    for (name, curve) in drawn {
        let Some(Curve { mean, sd, .. }) = curve else { continue };
        let point = |index: usize, angle: f64| format!("{:.1},{:.1}", x(index as f64), y(angle));
        if let Some(sd) = sd {
            let upper = (0..CYCLE_POINTS).map(|index| point(index, mean[index] + sd[index]));
            let lower = (0..CYCLE_POINTS).rev().map(|index| point(index, mean[index] - sd[index]));
            let points = upper.chain(lower).collect::<Vec<_>>().join(" ");
            let _ = write!(svg, r#"<polygon class="band {name}" points="{points}"/>"#);
        }
        let points = (0..CYCLE_POINTS).map(|index| point(index, mean[index])).collect::<Vec<_>>().join(" ");
        let _ = write!(svg, r#"<polyline class="mean {name}" points="{points}"/>"#);
    }
    svg + "</svg>"
}

/// Returns the contacts of both feet over the clip, with the bounds of actions.
pub(super) fn contact_plot(detection: &Detection, parts: &[ActionGait], frame_time: f64) -> String {
    let labels = detection.principal();
    let frames = labels.foot(Side::Left).planted.len();
    let duration = frames as f64 * frame_time;
    let names = parts.iter().filter(|part| !part.action.name.is_empty()).count();
    let top = if names > 0 { 14.0 } else { 2.0 };
    let (width, left, height) = (690.0, 24.0, 46.0 + top);
    let x = |time: f64| left + (width - left) * (time / duration).clamp(0.0, 1.0);
    let mut svg = open(width, height, "Contacts of both feet");
    let step = [0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 60.0, 120.0, 300.0, 600.0, 1800.0]
        .into_iter()
        .find(|step| duration / step <= 14.0)
        .unwrap_or(3600.0);
    for tick in 0..=(duration / step).floor() as usize {
        let time = step * tick as f64;
        line(&mut svg, "axis", [x(time), top, x(time), height - 12.0]);
        let unit = if tick == 0 { " s" } else { "" };
        text(&mut svg, (x(time), height - 3.0), "tick", "middle", &format!("{time}{unit}"));
    }
    for side in Side::BOTH {
        let foot = labels.foot(side);
        let bar_top = top + 2.0 + 15.0 * side as usize as f64;
        text(
            &mut svg,
            (8.0, bar_top + 9.0),
            side.name(),
            "middle",
            if side == Side::Left { "L" } else { "R" },
        );
        for Range { start, end } in intervals(&foot.planted) {
            let [from, to] = [start, end].map(|frame| x(foot.boundary_time(frame, frame_time)));
            let _ = write!(
                svg,
                r#"<rect class="bar {}" x="{from:.1}" y="{bar_top}" width="{:.1}" height="11" rx="1.5"/>"#,
                side.name(),
                (to - from).max(0.4)
            );
        }
    }
    for part in parts.iter().filter(|part| !part.action.name.is_empty()) {
        for frames in &part.action.frames {
            let from = x(frames.start as f64 * frame_time);
            line(&mut svg, "cut", [from, 0.0, from, height - 12.0]);
            text(&mut svg, (from + 3.0, 9.0), "name", "start", &part.action.name);
        }
    }
    svg + "</svg>"
}

fn open(width: f64, height: f64, label: &str) -> String {
    format!(r#"<svg viewBox="0 0 {width} {height}" role="img" aria-label="{}">"#, escape(label))
}

fn line(svg: &mut String, class: &str, [x1, y1, x2, y2]: [f64; 4]) {
    let _ = write!(svg, r#"<line class="{class}" x1="{x1:.1}" y1="{y1:.1}" x2="{x2:.1}" y2="{y2:.1}"/>"#);
}

fn text(svg: &mut String, (x, y): (f64, f64), class: &str, anchor: &str, content: &str) {
    let content = escape(content);
    let _ =
        write!(svg, r#"<text class="{class}" x="{x:.1}" y="{y:.1}" text-anchor="{anchor}">{content}</text>"#);
}
