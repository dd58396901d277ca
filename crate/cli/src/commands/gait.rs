//! `plantigrade gait`: measures walking and running.

use std::fmt::Write;

use plantigrade::gait::{Gait, PerSide, Spread};
use serde::Serialize;

use super::detect::{self, DetectedSkeleton};
use crate::args::{GaitArgs, GaitFormat};
use crate::error::{InputError, UsageError};
use crate::input::{self, Input};
use crate::output::{self, print_json};
use crate::parallel;
use crate::text::{display_name, escape};

/// Gait of one skeleton of a clip.
#[derive(Serialize)]
struct Record {
    /// Path of the input.
    path: String,
    /// Name of the root joint, if the clip has several skeletons.
    #[serde(skip_serializing_if = "Option::is_none")]
    root: Option<String>,
    frames: usize,
    /// Frame rate, in Hz.
    rate: f64,
    /// Method of plant detection.
    method: &'static str,
    gait: Gait,
}

/// Measures the gait of all inputs. Returns the number of inputs that failed.
pub fn run(args: &GaitArgs) -> Result<usize, UsageError> {
    args.detection.params()?;
    let inputs = input::collect(&args.read)?;
    let (records, failures) = parallel::map(&inputs, args.jobs, |input| measure(input, args));
    let records: Vec<Record> = records.into_iter().flatten().collect();
    match args.format {
        GaitFormat::Text => records.iter().for_each(|record| output::print(format_args!("{}", text(record)))),
        GaitFormat::Csv => output::print(format_args!("{}", csv(&records))),
        GaitFormat::Json => match &records[..] {
            [] if inputs.len() == 1 => {}
            [record] if inputs.len() == 1 => print_json(record),
            records => print_json(&records),
        },
    }
    Ok(failures)
}

/// Measures each skeleton of a clip that has feet.
fn measure(input: &Input, args: &GaitArgs) -> Result<Vec<Record>, InputError> {
    let params = args.detection.params().expect("parameters were checked before");
    let loaded = input::load(input, &args.read)?;
    let clip = &loaded.parsed.clip;
    let has_several_roots = clip.roots().count() > 1;
    let record = |(skeleton, feet, detection): &DetectedSkeleton| Record {
        path: display_name(&input.path),
        root: has_several_roots.then(|| clip.joints()[skeleton.root].name.clone()),
        frames: clip.frame_count(),
        rate: clip.rate(),
        method: args.detection.method.name(),
        gait: Gait::from_detection(feet, detection),
    };
    Ok(detect::detect_all(input, &loaded, params, None)?.iter().map(record).collect())
}

/// Returns a table with one row per skeleton; unknown values are empty.
fn csv(records: &[Record]) -> String {
    let mut table = csv::Writer::from_writer(Vec::new());
    let columns = Gait::default().columns().into_iter().map(|(name, _)| name);
    let clip_columns = ["clip", "root", "frames", "rate_hz", "method"].map(String::from);
    let rows =
        std::iter::once(clip_columns.into_iter().chain(columns).collect()).chain(records.iter().map(row));
    rows.for_each(|row: Vec<String>| table.write_record(row).expect("rows of equal length"));
    String::from_utf8(table.into_inner().expect("a table in memory")).expect("a table of text")
}

fn row(record: &Record) -> Vec<String> {
    let clip_values = [
        escape(&record.path),
        record.root.as_deref().map_or_else(String::new, escape),
        record.frames.to_string(),
        rounded(record.rate).to_string(),
        record.method.to_owned(),
    ];
    let values = record.gait.columns().into_iter();
    let values = values.map(|(_, value)| value.map_or_else(String::new, |value| rounded(value).to_string()));
    clip_values.into_iter().chain(values).collect()
}

/// Rounds to six decimals, which is beyond the accuracy of any clip.
fn rounded(value: f64) -> f64 {
    (value * 1e6).round() / 1e6
}

fn text(record: &Record) -> String {
    let gait = &record.gait;
    let mut text = escape(&record.path);
    // Writing to a String cannot fail.
    let _ = match &record.root {
        Some(root) => writeln!(text, ", {}", escape(root)),
        None => writeln!(text),
    };
    if gait.strides == 0 {
        text.push_str("  no complete strides\n");
        return text;
    }
    let mut line = |label: &str, value: String| {
        let _ = writeln!(text, "  {label:<16} {value}");
    };
    line("strides", gait.strides.to_string());
    line("cadence", or_dash(gait.cadence_steps_per_min, |cadence| format!("{cadence:.1} steps/min")));
    line("speed", or_dash(gait.speed_m_per_s, |speed| format!("{speed:.3} m/s")));
    let mean_sd = |spread: Option<Spread>, unit: &str| {
        or_dash(spread, |Spread { mean, sd, .. }| match sd {
            Some(sd) => format!("{mean:.3} ± {sd:.3}{unit}"),
            None => format!("{mean:.3}{unit}"),
        })
    };
    for (name, PerSide { left, right }) in gait.by_side() {
        let (label, unit) = name.rsplit_once('_').unwrap_or((name, ""));
        let unit = format!(" {unit}");
        let sides = format!("left {}, right {}", mean_sd(left, &unit), mean_sd(right, &unit));
        line(&label.replace('_', " "), sides);
    }
    for (label, fraction, time) in [
        ("double support", gait.double_support_share, gait.double_support_s),
        ("flight", gait.flight_share, gait.flight_s),
    ] {
        let fraction = or_dash(fraction, |fraction| format!("{:.1} % of the stride", 100.0 * fraction.mean));
        line(label, format!("{fraction}, {}", mean_sd(time, " s")));
    }
    let symmetry = gait.symmetry;
    let percent = |value: Option<f64>| or_dash(value, |value| format!("{value:+.1} %"));
    line(
        "right over left",
        format!(
            "stance {}, swing {}, step time {}, step length {}",
            percent(symmetry.stance_percent),
            percent(symmetry.swing_percent),
            percent(symmetry.step_time_percent),
            percent(symmetry.step_length_percent)
        ),
    );
    text
}

/// Formats a value, or returns a dash if it is unknown.
fn or_dash<T>(value: Option<T>, format: impl Fn(T) -> String) -> String {
    value.map_or_else(|| "-".into(), format)
}
