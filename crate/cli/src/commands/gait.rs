//! `plantigrade gait`: measures walking and running.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use plantigrade::formats::{self, GaitExport, SkeletonGait};
use plantigrade::gait::{self, ActionGait, ActionRanges, Gait, GaitAnalysis, LeftOut, PerSide, Spread};
use plantigrade::plants::{self, Feet};
use plantigrade::segments;
use plantigrade::skeleton::Skeleton;
use serde::Serialize;

use super::detect::{self, DetectedSkeleton};
use crate::args::{GaitArgs, GaitFormat, ReportFormat, WriteArgs};
use crate::batch::Batch;
use crate::error::{InputError, UsageError};
use crate::file;
use crate::input::{self, Input, LoadedClip};
use crate::output::{self, print_json};
use crate::output_folder::hex_digest;
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
    /// Gait of the whole clip.
    #[serde(flatten)]
    analysis: GaitAnalysis,
    /// Gait of each action, if requested.
    #[serde(skip_serializing_if = "Option::is_none")]
    actions: Option<Vec<ActionGait>>,
}

/// Contents of the files that belong to the clip.
struct ClipFiles {
    labels: Option<Vec<u8>>,
    segments: Option<Vec<u8>>,
}

impl ClipFiles {
    fn read(args: &GaitArgs) -> Result<ClipFiles, InputError> {
        let read = |path: &Option<PathBuf>| path.as_deref().map(input::read_file).transpose();
        Ok(ClipFiles { labels: read(&args.labels)?, segments: read(&args.segments)? })
    }
}

/// Measures the gait of all inputs. Returns the number of inputs that failed.
pub fn run(args: &GaitArgs) -> Result<usize, UsageError> {
    args.detection.params()?;
    args.detection.warn_of_unused();
    let inputs = input::collect(&args.read)?;
    input::check_stdin(&args.read, &[&args.labels, &args.segments])?;
    if (args.labels.is_some() || args.segments.is_some()) && inputs.len() > 1 {
        return Err(UsageError::LabelsOfSeveral(inputs.len()));
    }
    let file_format = match (args.report, args.format) {
        (Some(ReportFormat::Html), _) => Some(formats::GaitFormat::Report),
        (None, GaitFormat::Steps) => Some(formats::GaitFormat::Steps),
        (None, GaitFormat::Angles) => Some(formats::GaitFormat::Angles),
        (None, GaitFormat::Text | GaitFormat::Csv | GaitFormat::Json) => None,
    };
    if file_format.is_none() && args.out.as_ref().is_some_and(|out| !file::is_stream(out)) {
        return Err(UsageError::OutOfPrinted);
    }
    let files = match ClipFiles::read(args) {
        Ok(files) => files,
        Err(error) => {
            output::report(format_args!("{error}"));
            return Ok(inputs.len());
        }
    };
    match file_format {
        Some(format) => write_files(args, &inputs, &files, format),
        None => Ok(print_records(args, &inputs, &files)),
    }
}

/// Writes the measures of all inputs. Returns the number of inputs that failed.
fn print_records(args: &GaitArgs, inputs: &[Input], files: &ClipFiles) -> usize {
    let (records, failures) = parallel::map(inputs, args.jobs, |input| records(input, args, files));
    let records: Vec<Record> = records.into_iter().flatten().collect();
    match args.format {
        GaitFormat::Csv => output::print(format_args!("{}", csv(&records))),
        GaitFormat::Json => match &records[..] {
            [] if inputs.len() == 1 => {}
            [record] if inputs.len() == 1 => print_json(record),
            records => print_json(&records),
        },
        GaitFormat::Text | GaitFormat::Steps | GaitFormat::Angles => {
            records.iter().for_each(|record| output::print(format_args!("{}", text(record))));
        }
    }
    failures
}

/// Writes a file per input, to the output or to standard output. Returns the number of inputs that failed.
fn write_files(
    args: &GaitArgs,
    inputs: &[Input],
    files: &ClipFiles,
    format: formats::GaitFormat,
) -> Result<usize, UsageError> {
    let write = |input: &Input, loaded: &LoadedClip| {
        let detected = detect_all(input, loaded, args, files)?;
        let clip = &loaded.parsed.clip;
        let gait = |(skeleton, feet, detection): &'_ DetectedSkeleton| {
            let actions = actions(input, loaded, skeleton, args, files)?;
            Ok((skeleton.clone(), feet.clone(), detection.clone(), actions))
        };
        let detected = detected.iter().map(gait).collect::<Result<Vec<_>, InputError>>()?;
        let skeletons = detected.iter().map(|(skeleton, feet, detection, actions)| {
            SkeletonGait::new(clip, skeleton, feet, detection, actions.clone())
        });
        let skeletons = skeletons.collect();
        Ok(format.write(&GaitExport { source: loaded.source(input), clip, skeletons }))
    };
    let is_folder = |out: &Path| {
        let has_separator = out.as_os_str().as_encoded_bytes().ends_with(b"/");
        let reads_folder = args.read.paths.iter().any(|path| path.is_dir());
        out.is_dir() || has_separator || reads_folder || inputs.len() > 1
    };
    let write_args = WriteArgs { out: args.out.clone(), force: args.force, jobs: args.jobs };
    if let (Some(out), [input]) = (write_args.folder().filter(|out| !is_folder(out)), inputs) {
        let mut read =
            [Some(&input.path), args.labels.as_ref(), args.segments.as_ref()].into_iter().flatten();
        if read.any(|path| file::is_same(path, out)) {
            return Err(UsageError::OutIsInput(out.into()));
        }
        let (_, failures) = parallel::map(std::slice::from_ref(input), args.jobs, |input| {
            let text = write(input, &input::load(input, &args.read)?)?;
            output::write(out, text.as_bytes())
        });
        return Ok(failures);
    }
    let contents = [&files.labels, &files.segments].map(|bytes| bytes.as_deref().map(hex_digest));
    let batch = Batch {
        read: &args.read,
        write: &write_args,
        extension: format.extension(),
        options: format!("{:?} {} {contents:?}", args.detection.params()?, args.per_action),
    };
    batch.run(write)
}

/// Detects the plants of each skeleton that has feet, or applies the given labels to the main skeleton.
fn detect_all(
    input: &Input,
    loaded: &LoadedClip,
    args: &GaitArgs,
    files: &ClipFiles,
) -> Result<Vec<DetectedSkeleton>, InputError> {
    let params = args.detection.params().expect("parameters were checked before");
    let (Some(path), Some(bytes)) = (&args.labels, &files.labels) else {
        return detect::detect_all(input, loaded, params, None);
    };
    let clip = &loaded.parsed.clip;
    let skeleton = loaded.main_skeleton();
    let detect_error = |error| InputError::Detect { path: input.path.clone(), error };
    let feet = Feet::new(clip, &skeleton).map_err(detect_error)?;
    let labels = formats::read_plants(bytes, clip.frame_count());
    let labels = labels.map_err(|error| InputError::Labels { path: path.clone(), error })?;
    let detection = plants::detect(&feet, params);
    let edited = plants::apply_edits(&detection, &labels.edits(), clip.frame_time());
    Ok(vec![(skeleton, feet, edited)])
}

/// Returns the actions of the segments file or of the segmentation; `None` if they are not requested.
fn actions(
    input: &Input,
    loaded: &LoadedClip,
    skeleton: &Skeleton,
    args: &GaitArgs,
    files: &ClipFiles,
) -> Result<Option<Vec<ActionRanges>>, InputError> {
    let clip = &loaded.parsed.clip;
    let segments = if let (Some(path), Some(bytes)) = (&args.segments, &files.segments) {
        let text = input::text(path, bytes)?;
        let name = input.path.file_stem().unwrap_or_default().to_string_lossy();
        let segments = formats::read_segments(text, &name, clip.frame_count(), clip.rate());
        segments.map_err(|error| InputError::Labels { path: path.clone(), error })?
    } else if args.per_action {
        let params = segments::Params::default().check().expect("defaults are valid");
        let segmentation = segments::segment(clip, skeleton, params, &mut |_| Ok(()));
        segmentation.map_err(|error| InputError::Segment { path: input.path.clone(), error })?.segments
    } else {
        return Ok(None);
    };
    Ok(Some(gait::action_ranges(&segments)))
}

/// Measures each skeleton of a clip that has feet.
fn records(input: &Input, args: &GaitArgs, files: &ClipFiles) -> Result<Vec<Record>, InputError> {
    let loaded = input::load(input, &args.read)?;
    let clip = &loaded.parsed.clip;
    let has_several_roots = clip.roots().count() > 1;
    let record = |(skeleton, feet, detection): &DetectedSkeleton| {
        let part = |actions| SkeletonGait::new(clip, skeleton, feet, detection, actions).parts;
        let actions = actions(input, &loaded, skeleton, args, files)?;
        Ok(Record {
            path: display_name(&input.path),
            root: has_several_roots.then(|| clip.joints()[skeleton.root].name.clone()),
            frames: clip.frame_count(),
            rate: clip.rate(),
            method: args.detection.method.name(),
            analysis: part(None).pop().expect("the whole clip").analysis,
            actions: actions.map(|actions| part(Some(actions))),
        })
    };
    detect_all(input, &loaded, args, files)?.iter().map(record).collect()
}

/// Returns a table with one row per skeleton or, per action, one row per action; unknown values are empty.
fn csv(records: &[Record]) -> String {
    let mut table = csv::Writer::from_writer(Vec::new());
    let is_per_action = records.iter().any(|record| record.actions.is_some());
    let columns = Gait::default().columns().into_iter().map(|(name, _)| name);
    let action_column = is_per_action.then_some("action");
    let clip_columns =
        ["clip", "root"].into_iter().chain(action_column).chain(["frames", "rate_hz", "method"]);
    let header = clip_columns.map(String::from).chain(columns).collect();
    let rows = records.iter().flat_map(|record| match &record.actions {
        Some(actions) => {
            actions.iter().map(|part| row(record, Some(&part.action.name), &part.analysis.gait)).collect()
        }
        None => vec![row(record, None, &record.analysis.gait)],
    });
    let rows = std::iter::once(header).chain(rows);
    rows.for_each(|row: Vec<String>| table.write_record(row).expect("rows of equal length"));
    String::from_utf8(table.into_inner().expect("a table in memory")).expect("a table of text")
}

fn row(record: &Record, action: Option<&str>, gait: &Gait) -> Vec<String> {
    let mut fields = vec![escape(&record.path), record.root.as_deref().map_or_else(String::new, escape)];
    fields.extend(action.map(escape));
    fields.extend([record.frames.to_string(), rounded(record.rate).to_string(), record.method.to_owned()]);
    let values = gait.columns().into_iter();
    fields
        .extend(values.map(|(_, value)| value.map_or_else(String::new, |value| rounded(value).to_string())));
    fields
}

/// Rounds to six decimals, which is beyond the accuracy of any clip.
fn rounded(value: f64) -> f64 {
    (value * 1e6).round() / 1e6
}

fn text(record: &Record) -> String {
    let root = record.root.as_ref().map_or_else(String::new, |root| format!(", {}", escape(root)));
    let title = format!("{}{root}", escape(&record.path));
    let Some(actions) = &record.actions else {
        return format!("{title}\n{}", gait_text(&record.analysis.gait));
    };
    let part = |ActionGait { action, analysis }: &ActionGait| {
        let frames = action.frames.iter().map(|frames| format!("{}-{}", frames.start, frames.end - 1));
        let frames = frames.collect::<Vec<_>>().join(", ");
        let name = escape(&action.name);
        format!("{title}, action {name}, frames {frames}\n{}", gait_text(&analysis.gait))
    };
    actions.iter().map(part).collect()
}

/// Returns the measures in lines of text.
fn gait_text(gait: &Gait) -> String {
    let mut text = String::new();
    // Writing to a String cannot fail.
    let mut line = |label: &str, value: String| {
        let _ = writeln!(text, "  {label:<16} {value}");
    };
    let left_out = left_out_text(&gait.left_out);
    if gait.strides == 0 {
        let _ = writeln!(text, "  no complete strides{left_out}");
        return text;
    }
    line("strides", format!("{}{left_out}", gait.strides));
    let surface = gait.belt_m_per_s.map(|belt| format!("treadmill, belt {belt:.3} m/s"));
    line("surface", surface.unwrap_or_else(|| "overground".into()));
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
    let percent_sd = |spread: Option<Spread>| {
        or_dash(spread, |Spread { mean, sd, .. }| match sd {
            Some(sd) => format!("{mean:.1} ± {sd:.1} %"),
            None => format!("{mean:.1} %"),
        })
    };
    for (name, PerSide { left, right }) in gait.percent_by_side() {
        let label = name.trim_end_matches("_percent").replace('_', " ");
        line(&label, format!("left {}, right {} of the stride", percent_sd(left), percent_sd(right)));
    }
    for (label, fraction, time) in [
        ("both feet down", gait.double_support_share, gait.double_support_s),
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

/// Returns the numbers of strides that were left out, as in `, 3 left out (2 cut off, 1 pause)`.
fn left_out_text(left_out: &LeftOut) -> String {
    let LeftOut { cut_off, missing_event, pause, on_the_spot } = *left_out;
    let reasons = [
        (cut_off, "cut off"),
        (missing_event, "missing event"),
        (pause, "pause"),
        (on_the_spot, "on the spot"),
    ];
    let reasons = reasons.iter().filter(|(count, _)| *count > 0);
    let reasons = reasons.map(|(count, reason)| format!("{count} {reason}")).collect::<Vec<_>>().join(", ");
    match left_out.total() {
        0 => String::new(),
        total => format!(", {total} left out ({reasons})"),
    }
}

/// Formats a value, or returns a dash if it is unknown.
fn or_dash<T>(value: Option<T>, format: impl Fn(T) -> String) -> String {
    value.map_or_else(|| "-".into(), format)
}
