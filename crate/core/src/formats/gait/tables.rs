//! Gait as CSV tables with named columns.
//!
//! With several skeletons, every table begins with a column `root`; per action, a column `action` follows.

use std::fmt::Write;

use crate::formats::csv::{field, root_field, table_header};
use crate::formats::format_info::FormatInfo;
use crate::formats::gait::export::{GaitExport, Reader, SkeletonGait, Writer};
use crate::gait::{ActionGait, CYCLE_POINTS, Curve, Step};

pub(super) const STEPS: FormatInfo<Writer, Reader> = FormatInfo {
    name: "steps",
    title: "Steps",
    description: "One row per step, with its times, its length and its stride.",
    extension: "steps.csv",
    media_type: "text/csv",
    write: steps_csv,
    read: None,
};

pub(super) const ANGLES: FormatInfo<Writer, Reader> = FormatInfo {
    name: "angles",
    title: "Joint angles",
    description: "One row per percent of the gait cycle: flexion of hip, knee and ankle, mean and deviation.",
    extension: "angles.csv",
    media_type: "text/csv",
    write: angles_csv,
    read: None,
};

/// Returns one row per step with [`Step::COLUMNS`].
fn steps_csv(export: &GaitExport) -> String {
    let mut text = header(export, &Step::COLUMNS.join(","));
    for_parts(export, |prefix, part| {
        for step in &part.analysis.steps {
            let _ = writeln!(text, "{prefix}{}", step.columns().join(","));
        }
    });
    text
}

/// Returns one row per percent of the gait cycle: `percent,left_hip_flexion_deg,left_hip_flexion_deg_sd,…`.
/// Angles without strides are empty.
fn angles_csv(export: &GaitExport) -> String {
    let joints = ["hip_flexion", "knee_flexion", "ankle_dorsiflexion"];
    let columns = joints
        .iter()
        .flat_map(|joint| ["left", "right"].map(|side| format!(",{side}_{joint}_deg,{side}_{joint}_deg_sd")));
    let mut text = header(export, &format!("percent{}", columns.collect::<String>()));
    for_parts(export, |prefix, part| {
        let Some(curves) = &part.analysis.curves else { return };
        for percent in 0..CYCLE_POINTS {
            let _ = write!(text, "{prefix}{percent}");
            for (_, sides) in curves.by_joint() {
                for curve in [&sides.left, &sides.right] {
                    let value = |values: Option<&Vec<f64>>| {
                        values.map_or_else(String::new, |values| values[percent].to_string())
                    };
                    let mean = value(curve.as_ref().map(|curve| &curve.mean));
                    let sd = value(curve.as_ref().and_then(|curve: &Curve| curve.sd.as_ref()));
                    let _ = write!(text, ",{mean},{sd}");
                }
            }
            text.push('\n');
        }
    });
    text
}

/// Returns the header of a table, with the columns `root` and `action` if there are any.
fn header(export: &GaitExport, columns: &str) -> String {
    let roots = export.skeletons.iter().map(|gait| export.root(gait.skeleton));
    let is_per_action = export.skeletons.iter().any(SkeletonGait::is_per_action);
    table_header(roots, &format!("{}{columns}\n", if is_per_action { "action," } else { "" }))
}

/// Calls a function for each part, with the fields of its root and action.
fn for_parts(export: &GaitExport, mut write: impl FnMut(&str, &ActionGait)) {
    for gait in &export.skeletons {
        let root = root_field(export.root(gait.skeleton));
        for part in &gait.parts {
            let action = match gait.is_per_action() {
                true => format!("{},", field(&part.action.name)),
                false => String::new(),
            };
            write(&format!("{root}{action}"), part);
        }
    }
}
