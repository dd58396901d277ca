//! `plantigrade gait`

use std::fmt::Write;
use std::sync::{Mutex, PoisonError};

use plantigrade::gait::{Gait, PerSide, Spread};
use serde::Serialize;

use crate::args::{GaitArgs, GaitFormat};
use crate::detect;
use crate::failure::{self, Failure};
use crate::inputs::{self, Input};
use crate::parallel;

/// How one skeleton of a clip walks or runs.
#[derive(Serialize)]
struct Record {
    /// The input's path.
    path: String,
    /// Name of the root joint, where the clip has several skeletons.
    #[serde(skip_serializing_if = "Option::is_none")]
    root: Option<String>,
    frames: usize,
    /// Frames per second.
    rate: f64,
    /// How the feet's plants were found.
    method: &'static str,
    gait: Gait,
}

/// Measures all inputs and counts those that failed; an error is one of the command line.
pub fn run(args: &GaitArgs) -> Result<usize, String> {
    args.find.params()?;
    let inputs = inputs::collect(&args.read)?;
    let found = Mutex::new(Vec::new());
    let failed = parallel::for_each(&inputs, args.jobs, |index, input| {
        let records = measure(input, args)?;
        found.lock().unwrap_or_else(PoisonError::into_inner).push((index, records));
        Ok(())
    });
    let mut found = found.into_inner().unwrap_or_else(PoisonError::into_inner);
    found.sort_by_key(|(index, _)| *index);
    let records: Vec<Record> = found.into_iter().flat_map(|(_, records)| records).collect();
    match args.format {
        GaitFormat::Text => records.iter().for_each(|record| print!("{}", text(record))),
        GaitFormat::Csv => print!("{}", csv(&records)),
        GaitFormat::Json => match &records[..] {
            [] if inputs.len() == 1 => {}
            [record] if inputs.len() == 1 => print_json(record),
            records => print_json(&records),
        },
    }
    Ok(failed)
}

fn print_json(value: &impl Serialize) {
    println!("{}", serde_json::to_string_pretty(value).expect("text, numbers and lists"));
}

/// The measures of each skeleton of a clip that has feet.
fn measure(input: &Input, args: &GaitArgs) -> Result<Vec<Record>, Failure> {
    let params = args.find.params().expect("they were checked before");
    let loaded = inputs::load(input, &args.read)?;
    let clip = &loaded.parsed.clip;
    let found = detect::all(input, &loaded, params, None)?;
    let several = clip.roots().count() > 1;
    let record = |(skeleton, feet, detection): &detect::Found| Record {
        path: failure::name(&input.path),
        root: several.then(|| clip.joints()[skeleton.root].name.clone()),
        frames: clip.frame_count(),
        rate: clip.rate(),
        method: args.find.method.name(),
        gait: Gait::from_detection(feet, detection),
    };
    Ok(found.iter().map(record).collect())
}

/// A row per clip, or per skeleton where a clip has several; what is not known is empty.
fn csv(records: &[Record]) -> String {
    let columns: Vec<String> = Gait::default().columns().into_iter().map(|(name, _)| name).collect();
    let mut text = format!("clip,root,frames,rate_hz,method,{}\n", columns.join(","));
    for record in records {
        let values: Vec<String> = record
            .gait
            .columns()
            .into_iter()
            .map(|(_, value)| value.map_or_else(String::new, |value| rounded(value).to_string()))
            .collect();
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "{},{},{},{},{},{}",
            field(&record.path),
            field(record.root.as_deref().unwrap_or_default()),
            record.frames,
            rounded(record.rate),
            record.method,
            values.join(",")
        );
    }
    text
}

/// A text as a field, in quotes where it must be.
fn field(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.into()
    }
}

/// To the millionth, which is finer than any clip tells.
fn rounded(value: f64) -> f64 {
    (value * 1e6).round() / 1e6
}

fn text(record: &Record) -> String {
    let gait = &record.gait;
    let mut text = record.path.clone();
    // Writing to a String cannot fail.
    let _ = match &record.root {
        Some(root) => writeln!(text, ", {root}"),
        None => writeln!(text),
    };
    if gait.strides == 0 {
        text.push_str("  no whole strides: nothing to measure\n");
        return text;
    }
    let mut line = |what: &str, value: String| {
        let _ = writeln!(text, "  {what:<16} {value}");
    };
    line("strides", gait.strides.to_string());
    line("cadence", known(gait.cadence_steps_per_min, |cadence| format!("{cadence:.1} steps/min")));
    line("speed", known(gait.speed_m_per_s, |speed| format!("{speed:.3} m/s")));
    let spread = |spread: Option<Spread>, unit: &str| {
        known(spread, |Spread { mean, sd, .. }| match sd {
            Some(sd) => format!("{mean:.3} ± {sd:.3}{unit}"),
            None => format!("{mean:.3}{unit}"),
        })
    };
    for (name, PerSide { left, right }) in gait.by_side() {
        let (what, unit) = name.rsplit_once('_').unwrap_or((name, ""));
        let unit = format!(" {unit}");
        let sides = format!("left {}, right {}", spread(left, &unit), spread(right, &unit));
        line(&what.replace('_', " "), sides);
    }
    for (what, share, time) in [
        ("double support", gait.double_support_share, gait.double_support_s),
        ("flight", gait.flight_share, gait.flight_s),
    ] {
        let share = known(share, |share| format!("{:.1} % of the stride", 100.0 * share.mean));
        line(what, format!("{share}, {}", spread(time, " s")));
    }
    let symmetry = gait.symmetry;
    let percent = |value: Option<f64>| known(value, |value| format!("{value:+.1} %"));
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

/// A value as a text, or a dash where there is none.
fn known<T>(value: Option<T>, text: impl Fn(T) -> String) -> String {
    value.map_or_else(|| "-".into(), text)
}
