//! Definition of the command line.

use std::error::Error;
use std::num::NonZeroUsize;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
use std::str::FromStr;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Args as ClapArgs, Parser, Subcommand, ValueEnum};
use plantigrade::bvh::FRAME_RATES;
use plantigrade::foot::Part;
use plantigrade::formats::{PlantFormat, SegmentFormat};
use plantigrade::plants::{self, Family};
use plantigrade::segments::{self, MethodOption, Residual, Template};
use plantigrade::skeleton::{Role, UNITS, Up};

use crate::error::UsageError;
use crate::file::is_stream;
use crate::output;

/// Detects foot plants and actions in motion capture, without tuning.
///
/// Reads BVH files, folders (recursively) and - for standard input.
/// Exit codes: 0 if all inputs succeeded, 1 if some failed (one line each on
/// standard error; the results of the others are written), 2 if the command
/// line is invalid, 141 if the reader of the output closes the pipe.
#[derive(Parser)]
#[command(name = "plantigrade", version)]
pub struct Args {
    /// Command to run.
    #[command(subcommand)]
    pub command: Command,
}

/// Commands.
#[derive(Subcommand)]
pub enum Command {
    /// Label the frames in which each foot is planted
    Detect(DetectArgs),
    /// Segment clips into actions
    Segment(SegmentArgs),
    /// Measure gait: cadence, stance and swing, step length and width, symmetry
    Gait(GaitArgs),
    /// Compare detected labels with ground truth
    Score(ScoreArgs),
    /// Remove foot skate
    Clean(CleanArgs),
    /// Describe files: joints, feet, axes, scale, and what was assumed or repaired
    Info(InfoArgs),
}

/// Inputs and reader options.
#[derive(ClapArgs, Default)]
pub struct ReadArgs {
    /// BVH files, folders, or - for standard input
    #[arg(required = true, value_name = "PATH")]
    pub paths: Vec<PathBuf>,
    /// Frame rate, from 1 to 1000 Hz; overrides the frame time of the file
    #[arg(long, value_name = "HZ", value_parser = parse_rate, allow_negative_numbers = true)]
    pub fps: Option<f64>,
    /// Up axis: x, y or z; a leading - reverses it [default: detected from the motion]
    #[arg(long, value_name = "AXIS", allow_hyphen_values = true)]
    pub up: Option<Up>,
    /// Joint of a role, such as left_ankle=LFoot; an empty name means no joint. May be repeated.
    /// If several joints have the name: left_ankle=2/LFoot for that of the second skeleton of the
    /// file, or left_ankle=LShin/LFoot for that below LShin
    /// [default: detected from names and structure; info --format json lists the roles]
    #[arg(long = "joint", value_name = "ROLE=NAME", value_parser = parse_joint)]
    pub joints: Vec<(Role, String)>,
    /// Metres per file unit, from 0.000001 to 1000000 [default: detected from the length of the legs]
    #[arg(long, value_name = "METRES", value_parser = parse_unit, allow_negative_numbers = true)]
    pub unit: Option<f64>,
    /// Replace invalid numbers by the value of the previous frame
    #[arg(long)]
    pub lenient: bool,
}

/// Output options.
#[derive(ClapArgs)]
pub struct WriteArgs {
    /// Folder for the results, one file per input [default: -, standard output, for a single input]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Recompute results that are up to date, and replace results that a person changed
    #[arg(long, requires = "out")]
    pub force: bool,
    /// Number of clips processed in parallel [default: one per processor]
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub jobs: Option<NonZeroUsize>,
}

impl WriteArgs {
    /// Returns the folder for the results; `None` for standard output.
    pub fn folder(&self) -> Option<&Path> {
        self.out.as_deref().filter(|out| !is_stream(out))
    }
}

/// Arguments of `detect`.
#[derive(ClapArgs)]
pub struct DetectArgs {
    /// Inputs.
    #[command(flatten)]
    pub read: ReadArgs,
    /// Detection method and parameters.
    #[command(flatten)]
    pub detection: DetectionArgs,
    /// Clip of the same character standing still, clustered together with each input (spectral
    /// toe methods)
    #[arg(long, value_name = "CLIP")]
    pub still: Option<PathBuf>,
    /// Corrected labels, applied to similar motion as well: a labels document with edits, or
    /// annotated contact with -1 for unknown frames
    #[arg(long, value_name = "LABELS")]
    pub constraints: Option<PathBuf>,
    /// Clip that the corrected labels belong to, of the same character [default: the input]
    #[arg(long, value_name = "CLIP", requires = "constraints")]
    pub constraints_clip: Option<PathBuf>,
    /// Output format
    #[arg(long, default_value_t, value_parser = one_of(PlantFormat::ALL, PlantFormat::name, PlantFormat::description))]
    pub format: PlantFormat,
    /// Output options.
    #[command(flatten)]
    pub write: WriteArgs,
}

/// Arguments of `gait`.
#[derive(ClapArgs)]
pub struct GaitArgs {
    /// Inputs.
    #[command(flatten)]
    pub read: ReadArgs,
    /// Detection method and parameters.
    #[command(flatten)]
    pub detection: DetectionArgs,
    /// Labels to use, for a single clip: a truth file, or json, csv, intervals or npz of detect [default:
    /// detected]
    #[arg(long, value_name = "LABELS", conflicts_with_all = ["plants", "method"])]
    pub labels: Option<PathBuf>,
    /// Measure each action separately; actions are segmented and named clip by clip
    #[arg(long)]
    pub per_action: bool,
    /// Measure each action of a segments file separately, for a single clip
    #[arg(long, value_name = "SEGMENTS")]
    pub segments: Option<PathBuf>,
    /// Output format
    #[arg(long, value_enum, default_value_t = GaitFormat::Text)]
    pub format: GaitFormat,
    /// Write a printable report with figures, plots, steps and definitions
    #[arg(long, value_enum, value_name = "FORMAT", conflicts_with = "format")]
    pub report: Option<ReportFormat>,
    /// File, or folder with one file per input, for reports, steps and angles [default: -, standard
    /// output, for a single input]
    #[arg(short, long, value_name = "FILE|DIR")]
    pub out: Option<PathBuf>,
    /// Recompute results that are up to date, and replace results that a person changed
    #[arg(long, requires = "out")]
    pub force: bool,
    /// Number of clips processed in parallel [default: one per processor]
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub jobs: Option<NonZeroUsize>,
}

/// Arguments of `segment`.
#[derive(ClapArgs)]
pub struct SegmentArgs {
    /// Inputs.
    #[command(flatten)]
    pub read: ReadArgs,
    /// Segmentation method; auto is recommended
    #[arg(long, default_value_t, value_parser = one_of(segments::Method::ALL, segments::Method::name, segments::Method::description))]
    pub method: segments::Method,
    /// Parameters of the method.
    #[command(flatten)]
    pub params: SegmentationParamArgs,
    /// Output format
    #[arg(long, default_value_t, value_parser = one_of(SegmentFormat::ALL, SegmentFormat::name, SegmentFormat::description))]
    pub format: SegmentFormat,
    /// Output options.
    #[command(flatten)]
    pub write: WriteArgs,
}

/// Detection method with its parameters.
#[derive(ClapArgs)]
#[group(id = "detection")]
pub struct DetectionArgs {
    /// Detection method; robust labels contact, toe and heel
    #[arg(long, default_value_t, value_parser = one_of(plants::Method::ALL, plants::Method::name, plants::Method::description))]
    pub method: plants::Method,
    /// Parameters of the method.
    #[command(flatten)]
    pub params: DetectionParamArgs,
}

impl DetectionArgs {
    /// Warns of the parameters that are not those of the method.
    pub fn warn_of_unused(&self) {
        self.params.warn_of_unused(self.method);
    }

    /// Checks and returns the parameters.
    pub fn params(&self) -> Result<plants::ValidParams, UsageError> {
        self.params.check(self.method)
    }
}

/// Parameters of detection methods.
#[derive(ClapArgs)]
#[group(id = "plants")]
pub struct DetectionParamArgs {
    /// Threshold on the running variance of the sorted norms
    #[arg(long, value_name = "R", default_value_t = plants::Params::default().tolerance, allow_negative_numbers = true)]
    pub r: f64,
    /// Half-width of the smoothing window, in frames
    #[arg(long, value_name = "W", default_value_t = plants::Params::default().window, allow_negative_numbers = true)]
    pub w: usize,
    /// Kernel bandwidth [default: at the knee of the norms]
    #[arg(long, value_name = "S", allow_negative_numbers = true)]
    pub sigma: Option<f64>,
    /// Height threshold of the methods height and dual, in metres
    #[arg(long, value_name = "M", default_value_t = plants::Params::default().height, allow_negative_numbers = true)]
    pub height: f64,
    /// Speed threshold of the methods speed, dual and min-speed, in metres per second
    #[arg(long, value_name = "M/S", default_value_t = plants::Params::default().speed, allow_negative_numbers = true)]
    pub speed: f64,
    /// Compare all pairs of frames in long clips too; slow, and labels rarely change
    #[arg(long)]
    pub exact: bool,
}

impl DetectionParamArgs {
    /// Warns of the parameters that differ from their defaults but are not those of the method.
    pub fn warn_of_unused(&self, method: plants::Method) {
        let Ok(params) = self.check(method) else { return };
        let (default, thresholds) = (plants::Params::default(), params.thresholds());
        let is_spectral = method.family() == Family::Spectral;
        let unused = [
            ("--r", !is_spectral && self.r != default.tolerance),
            ("--sigma", !is_spectral && self.sigma.is_some()),
            ("--exact", !is_spectral && self.exact),
            ("--height", self.height != default.height && thresholds.height != Some(self.height)),
            ("--speed", self.speed != default.speed && thresholds.speed != Some(self.speed)),
        ];
        warn_of_unused(&unused, method.name());
    }

    /// Checks and returns the parameters of a method.
    pub fn check(&self, method: plants::Method) -> Result<plants::ValidParams, UsageError> {
        let params = plants::Params {
            method,
            tolerance: self.r,
            window: self.w,
            sigma: self.sigma,
            height: self.height,
            speed: self.speed,
            exact: self.exact,
        };
        params.check().map_err(|error| UsageError::InvalidParameter(error.to_string()))
    }
}

/// Parameters of segmentation methods.
#[derive(ClapArgs)]
#[group(id = "segments")]
pub struct SegmentationParamArgs {
    /// Number of dimensions excluded from the residual [default: 1 for mvu, 2 for pca-tail]
    #[arg(long, value_name = "D", allow_negative_numbers = true)]
    pub dims: Option<usize>,
    /// Residual of mvu: sum over the remaining dimensions (absolute), or its ratio to the total
    #[arg(long, value_name = "absolute|ratio", default_value_t)]
    pub residual: Residual,
    /// Template pose of lsd: the mean pose, the T-pose, or a frame number (from 0)
    #[arg(long, value_name = "mean|tpose|FRAME", default_value_t, allow_negative_numbers = true)]
    pub template: Template,
    /// Follow the publication exactly (lsd, mvu and ppca)
    #[arg(long)]
    pub published: bool,
}

impl SegmentationParamArgs {
    /// Warns of the parameters that differ from their defaults but are not those of the method.
    pub fn warn_of_unused(&self, method: segments::Method) {
        let (default, options) = (segments::Params::default(), method.options());
        let has_dims = options.iter().any(|option| matches!(option, MethodOption::Dims(_)));
        let is_unused = |option, is_given: bool| is_given && !options.contains(&option);
        let unused = [
            ("--dims", self.dims.is_some() && !has_dims),
            ("--residual", is_unused(MethodOption::Residual, self.residual != default.residual)),
            ("--template", is_unused(MethodOption::Template, self.template != default.template)),
            ("--published", is_unused(MethodOption::Published, self.published)),
        ];
        warn_of_unused(&unused, method.name());
    }

    /// Checks and returns the parameters of a method.
    pub fn check(&self, method: segments::Method) -> Result<segments::ValidParams, UsageError> {
        let params = segments::Params {
            method,
            dims: self.dims,
            residual: self.residual,
            template: self.template,
            published: self.published,
        };
        params.check().map_err(|error| UsageError::InvalidParameter(error.to_string()))
    }
}

/// Warns of options without effect, given the names of options and whether they are unused.
pub fn warn_of_unused(options: &[(&str, bool)], method: &str) {
    for (option, _) in options.iter().filter(|(_, is_unused)| *is_unused) {
        output::report(format_args!("warning: {option} has no effect with the method {method}"));
    }
}

/// Returns a parser of the names of a registry, with the descriptions as help texts.
fn one_of<T>(
    items: &'static [T],
    name: fn(T) -> &'static str,
    description: fn(T) -> &'static str,
) -> impl TypedValueParser<Value = T>
where
    T: FromStr + Copy + Send + Sync + 'static,
    T::Err: Error + Send + Sync,
{
    let value = move |&item| PossibleValue::new(name(item)).help(description(item));
    PossibleValuesParser::new(items.iter().map(value)).try_map(|name| name.parse::<T>())
}

/// Arguments of `score`.
#[derive(ClapArgs)]
#[command(mut_group("segments", |group| group.requires("cuts")))]
pub struct ScoreArgs {
    /// Folder of clips with truth files: NAME.bvh with NAME.json
    #[arg(value_name = "FOLDER")]
    pub folder: PathBuf,
    /// Score cuts between actions; truth is NAME.segments.json, NAME.json or segmentation*.json
    #[arg(long, conflicts_with_all = ["plants", "part"])]
    pub cuts: bool,
    /// Score the classes of the actions, too
    #[arg(long, requires = "cuts")]
    pub classes: bool,
    /// Method of detect, or of segment with --cuts [default: robust, or auto]
    #[arg(long)]
    pub method: Option<String>,
    /// Parameters of the detection.
    #[command(flatten)]
    pub plants: DetectionParamArgs,
    /// Score this part only [default: all parts labelled by both truth and method]
    #[arg(long, value_parser = PossibleValuesParser::new(Part::ALL.map(Part::name)))]
    pub part: Option<String>,
    /// Parameters of the segmentation.
    #[command(flatten, next_help_heading = "Options with --cuts")]
    pub segments: SegmentationParamArgs,
}

/// Arguments of `clean`.
#[derive(ClapArgs)]
#[command(mut_arg("paths", |arg| arg.value_name("FILE").num_args(1).help("BVH file, or - for standard input")))]
pub struct CleanArgs {
    /// Input.
    #[command(flatten)]
    pub read: ReadArgs,
    /// BVH file to write, or - for standard output; its hierarchy equals that of the input
    #[arg(short, long, value_name = "OUT.bvh")]
    pub out: PathBuf,
    /// Labels to use: a truth file, or json, csv, intervals or npz of detect [default: detected]
    #[arg(long, value_name = "LABELS", conflicts_with_all = ["plants", "method"])]
    pub labels: Option<PathBuf>,
    /// Leave spikes of the hips, short jumps away and back, which are otherwise interpolated
    #[arg(long)]
    pub keep_spikes: bool,
    /// Detection method and parameters.
    #[command(flatten)]
    pub detection: DetectionArgs,
}

/// Arguments of `info`.
#[derive(ClapArgs)]
pub struct InfoArgs {
    /// Inputs.
    #[command(flatten)]
    pub read: ReadArgs,
    /// Output format
    #[arg(long, value_enum, default_value_t = InfoFormat::Text)]
    pub format: InfoFormat,
}

/// Output formats of `info`.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum InfoFormat {
    /// Plain text
    Text,
    /// An object for one path, an array for several
    Json,
}

/// Output formats of `gait`.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum GaitFormat {
    /// Plain text
    Text,
    /// An object for one clip, an array for several
    Json,
    /// One row per clip, skeleton and action; column names include units
    Csv,
    /// Table with one row per step, of one clip
    Steps,
    /// Table of joint angles with one row per percent of the gait cycle, of one clip
    Angles,
}

/// Formats of the report of `gait`.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum ReportFormat {
    /// Self-contained page for the browser, on at most two sheets of A4 or Letter
    Html,
}

/// Parses a role and the name of its joint, which may be empty.
fn parse_joint(text: &str) -> Result<(Role, String), String> {
    let (role, name) = text.split_once('=').ok_or("expected ROLE=NAME")?;
    let roles = || Role::ALL.map(Role::name).join(", ");
    let role =
        Role::from_name(role).ok_or_else(|| format!("unknown role {role:?}: expected one of {}", roles()))?;
    Ok((role, name.to_owned()))
}

/// Parses a frame rate, in Hz.
fn parse_rate(text: &str) -> Result<f64, String> {
    parse_in(FRAME_RATES, text).map_err(|error| {
        let rate = text.parse().map_or(f64::NAN, |time: f64| (100.0 / time).round() / 100.0);
        if FRAME_RATES.contains(&rate) {
            format!("{error}; {text} looks like a frame time: did you mean --fps {rate}?")
        } else {
            error
        }
    })
}

/// Parses the size of a unit, in metres.
fn parse_unit(text: &str) -> Result<f64, String> {
    parse_in(UNITS, text)
}

/// Parses a number of a range.
fn parse_in(range: RangeInclusive<f64>, text: &str) -> Result<f64, String> {
    let number = text.parse().ok().filter(|number| range.contains(number));
    number.ok_or_else(|| format!("must be a number from {} to {}", range.start(), range.end()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rates_and_units_have_ranges() {
        for (text, rate) in [("1", 1.0), ("29.97", 29.97), ("1000", 1000.0), ("1e2", 100.0)] {
            assert_eq!(parse_rate(text), Ok(rate));
        }
        let range = "must be a number from 1 to 1000";
        for text in ["0", "-3", "-0.01", "1e-6", "1000.5", "1e300", "1e-320", "inf", "NaN", "", "fast"] {
            assert_eq!(parse_rate(text), Err(range.into()), "{text}");
        }
        for (time, rate) in [("0.0083333", "120"), ("0.0333667", "29.97"), (".04", "25"), ("0.001", "1000")] {
            let hint = format!("{range}; {time} looks like a frame time: did you mean --fps {rate}?");
            assert_eq!(parse_rate(time), Err(hint));
        }
        assert_eq!(
            (parse_unit("0.01"), parse_unit("1e-6"), parse_unit("1e6")),
            (Ok(0.01), Ok(1e-6), Ok(1e6))
        );
        for text in ["0", "-1", "1e-300", "1e300", "inf", "NaN"] {
            assert_eq!(parse_unit(text), Err("must be a number from 0.000001 to 1000000".into()), "{text}");
        }
    }
}
