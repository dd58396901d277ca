//! The command line.

use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::str::FromStr;

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args as ClapArgs, Parser, Subcommand, ValueEnum};
use plantigrade::foot::Part;
use plantigrade::plants;
use plantigrade::segments::{self, Residual, Template};
use plantigrade::skeleton::{Role, Up};

/// Foot plants and actions in motion capture, found with nothing to tune.
///
/// Reads BVH files, folders of them (with all folders below) and - for
/// standard input. Exits with 0 when all is done, 1 when some inputs failed
/// (one line each on standard error; the others are done), 2 when the command
/// line is wrong.
#[derive(Parser)]
#[command(name = "plantigrade", version)]
pub struct Args {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// What to do.
#[derive(Subcommand)]
pub enum Command {
    /// Find the frames in which each foot is planted
    Detect(DetectArgs),
    /// Cut clips into actions
    Segment(SegmentArgs),
    /// Measure how people walk and run: cadence, stance and swing, step length and width, symmetry
    Gait(GaitArgs),
    /// Compare the labels of clips with their truth
    Score(ScoreArgs),
    /// Hold planted feet still: remove foot skate
    Clean(CleanArgs),
    /// Say what a file holds: joints, feet, axes, scale, and what had to be repaired
    Info(InfoArgs),
}

/// Which clips to read, and how.
#[derive(ClapArgs, Default)]
pub struct ReadArgs {
    /// BVH files, folders, or - for standard input
    #[arg(required = true, value_name = "PATH")]
    pub paths: Vec<PathBuf>,
    /// Frames per second, whatever the file states
    #[arg(long, value_name = "HZ", value_parser = positive)]
    pub fps: Option<f64>,
    /// The axis that points up: x, y or z, with - before it for down [default: found from the motion]
    #[arg(long, value_name = "AXIS", allow_hyphen_values = true)]
    pub up: Option<Up>,
    /// The joint that plays a role, such as left_ankle=LFoot, or none after the = sign; may be
    /// given several times [default: found from names and shape; info --format json lists the roles]
    #[arg(long = "joint", value_name = "ROLE=NAME", value_parser = joint)]
    pub joints: Vec<(Role, String)>,
    /// Metres per file unit, for thresholds and figures in metres [default: found from the legs]
    #[arg(long, value_name = "METRES", value_parser = positive)]
    pub unit: Option<f64>,
    /// Hold the previous frame's value where one is no number
    #[arg(long)]
    pub lenient: bool,
}

/// Where to write.
#[derive(ClapArgs)]
pub struct WriteArgs {
    /// Folder to write one result per input into [default: standard output, for one input]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Make again what is there already, made from the same input in the same way
    #[arg(long, requires = "out")]
    pub force: bool,
    /// Clips to work on at a time [default: one per processor]
    #[arg(long, value_name = "N")]
    pub jobs: Option<NonZeroUsize>,
}

/// How to detect and where to write.
#[derive(ClapArgs)]
pub struct DetectArgs {
    /// The clips.
    #[command(flatten)]
    pub read: ReadArgs,
    /// How to find plants.
    #[command(flatten)]
    pub find: FindArgs,
    /// A clip of the same character standing still, to be clustered along (spectral methods of toes)
    #[arg(long, value_name = "CLIP")]
    pub still: Option<PathBuf>,
    /// What to write
    #[arg(long, value_enum, default_value_t = Format::Json)]
    pub format: Format,
    /// Where to.
    #[command(flatten)]
    pub write: WriteArgs,
}

/// How to find the plants that gait is measured by, and how to write it.
#[derive(ClapArgs)]
pub struct GaitArgs {
    /// The clips.
    #[command(flatten)]
    pub read: ReadArgs,
    /// How to find plants.
    #[command(flatten)]
    pub find: FindArgs,
    /// How to write it
    #[arg(long, value_enum, default_value_t = GaitFormat::Text)]
    pub format: GaitFormat,
    /// Clips to work on at a time [default: one per processor]
    #[arg(long, value_name = "N")]
    pub jobs: Option<NonZeroUsize>,
}

/// How to cut into actions and where to write.
#[derive(ClapArgs)]
pub struct SegmentArgs {
    /// The clips.
    #[command(flatten)]
    pub read: ReadArgs,
    /// The method; auto is the one to use
    #[arg(long, default_value = "auto", value_parser = one_of(segments::Method::ALL, segments::Method::name))]
    pub method: segments::Method,
    /// Its parameters.
    #[command(flatten)]
    pub segments: SegmentsArgs,
    /// What to write
    #[arg(long, value_enum, default_value_t = SegmentFormat::Json)]
    pub format: SegmentFormat,
    /// Where to.
    #[command(flatten)]
    pub write: WriteArgs,
}

/// How to find plants.
#[derive(ClapArgs)]
#[group(id = "find")]
pub struct FindArgs {
    /// The method; robust labels contact, toe and heel
    #[arg(long, default_value = "robust", value_parser = one_of(plants::Method::ALL, plants::Method::name))]
    pub method: plants::Method,
    /// Its parameters.
    #[command(flatten)]
    pub plants: PlantArgs,
}

impl FindArgs {
    /// The parameters, or what is wrong with them.
    pub fn params(&self) -> Result<plants::ValidParams, String> {
        self.plants.params(self.method)
    }
}

/// Parameters of the methods that find plants.
#[derive(ClapArgs)]
#[group(id = "plants")]
pub struct PlantArgs {
    /// Threshold on the running variance of the sorted norms
    #[arg(long, value_name = "R", default_value_t = 0.001)]
    pub r: f64,
    /// Window half-width in frames
    #[arg(long, value_name = "W", default_value_t = 1)]
    pub w: usize,
    /// Scale of the kernel, set by hand [default: found at the knee of the norms]
    #[arg(long, value_name = "S")]
    pub sigma: Option<f64>,
    /// Height in metres for the methods height and dual
    #[arg(long, value_name = "M", default_value_t = plants::Params::default().height)]
    pub height: f64,
    /// Speed in metres per second for the methods speed, dual and min-speed
    #[arg(long, value_name = "M/S", default_value_t = plants::Params::default().speed)]
    pub speed: f64,
    /// Compare all pairs of frames, however long the clip: slow, and hardly ever another label
    #[arg(long)]
    pub exact: bool,
}

impl PlantArgs {
    /// The parameters of a method, or what is wrong with them.
    pub fn params(&self, method: plants::Method) -> Result<plants::ValidParams, String> {
        let params = plants::Params {
            method,
            tolerance: self.r,
            window: self.w,
            scale: self.sigma,
            height: self.height,
            speed: self.speed,
            exact: self.exact,
        };
        params.check().map_err(|error| error.to_string())
    }
}

/// Parameters of the methods that cut clips into actions.
#[derive(ClapArgs)]
#[group(id = "segments")]
pub struct SegmentsArgs {
    /// Dimensions kept before the rest is called residual [default: 1 for mvu, 2 for pca-tail]
    #[arg(long, value_name = "D")]
    pub dims: Option<usize>,
    /// What mvu calls residual: the absolute sum of what is left over, or its ratio to all
    #[arg(long, value_name = "absolute|ratio", default_value_t)]
    pub residual: Residual,
    /// The pose that lsd compares others with: their mean, the T-pose, or a frame from 0
    #[arg(long, value_name = "mean|tpose|FRAME", default_value_t)]
    pub template: Template,
    /// Keep to the letter of what was published (lsd, mvu and ppca)
    #[arg(long)]
    pub published: bool,
}

impl SegmentsArgs {
    /// The parameters of a method, or what is wrong with them.
    pub fn params(&self, method: segments::Method) -> Result<segments::ValidParams, String> {
        let params = segments::Params {
            method,
            dims: self.dims,
            residual: self.residual,
            template: self.template,
            published: self.published,
        };
        params.check().map_err(|error| error.to_string())
    }
}

/// One of the methods that there are, by its name.
fn one_of<M: FromStr<Err = String> + Clone + Send + Sync + 'static, const N: usize>(
    all: [M; N],
    name: fn(M) -> &'static str,
) -> impl TypedValueParser<Value = M> {
    PossibleValuesParser::new(all.map(name)).try_map(|name| name.parse::<M>())
}

/// Which clips to compare with their truth.
#[derive(ClapArgs)]
#[command(mut_group("segments", |group| group.requires("cuts")))]
pub struct ScoreArgs {
    /// Folder of clips with their truth beside them: NAME.bvh with NAME.json
    #[arg(value_name = "FOLDER")]
    pub folder: PathBuf,
    /// Compare where actions are cut: NAME.bvh with NAME.segments.json, or named in segmentation*.json
    #[arg(long, conflicts_with_all = ["plants", "part"])]
    pub cuts: bool,
    /// The method, one of detect, or with --cuts of segment [default: robust, or auto]
    #[arg(long)]
    pub method: Option<String>,
    /// Parameters that plants are found by.
    #[command(flatten)]
    pub plants: PlantArgs,
    /// Compare this part only [default: every part that truth and method have]
    #[arg(long, value_parser = PossibleValuesParser::new(Part::ALL.map(Part::name)))]
    pub part: Option<String>,
    /// Parameters that actions are found by.
    #[command(flatten, next_help_heading = "Options with --cuts")]
    pub segments: SegmentsArgs,
}

/// Which clip to clean up, by which plants, and where to write it.
#[derive(ClapArgs)]
#[command(mut_arg("paths", |arg| arg.value_name("FILE").num_args(1).help("A BVH file, or - for standard input")))]
pub struct CleanArgs {
    /// The clip.
    #[command(flatten)]
    pub read: ReadArgs,
    /// The file to write: BVH with the same hierarchy
    #[arg(short, long, value_name = "OUT.bvh")]
    pub out: PathBuf,
    /// Labels to go by: a document of detect, a table per frame, or a truth file [default: detected]
    #[arg(long, value_name = "LABELS", conflicts_with_all = ["plants", "method"])]
    pub labels: Option<PathBuf>,
    /// How to find plants.
    #[command(flatten)]
    pub find: FindArgs,
}

/// What to say of which clips.
#[derive(ClapArgs)]
pub struct InfoArgs {
    /// The clips.
    #[command(flatten)]
    pub read: ReadArgs,
    /// How to write it
    #[arg(long, value_enum, default_value_t = InfoFormat::Text)]
    pub format: InfoFormat,
}

/// What `detect` writes.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// The labels document: plants per foot and part, with all that was used to find them
    Json,
    /// A row per frame with a column of 0 and 1 per foot and part
    Csv,
    /// A row per plant
    Intervals,
    /// A row per foot strike and foot off
    Events,
    /// Arrays for NumPy with named columns, and the confidence
    Npz,
    /// A Python script that sets markers and contact keys in Blender
    Blender,
}

impl Format {
    /// The ending of files in this format.
    pub fn ending(self) -> &'static str {
        match self {
            Format::Json => "json",
            Format::Csv => "csv",
            Format::Intervals => "intervals.csv",
            Format::Events => "events.csv",
            Format::Npz => "npz",
            Format::Blender => "blender.py",
        }
    }
}

/// What `segment` writes.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum SegmentFormat {
    /// The segments document: actions with all that was used to find them
    Json,
    /// A row per action
    Csv,
    /// Actions in the shape of BABEL's files
    Babel,
}

impl SegmentFormat {
    /// The ending of files in this format: another than that of labels in the same folder.
    pub fn ending(self) -> &'static str {
        match self {
            SegmentFormat::Json => "segments.json",
            SegmentFormat::Csv => "segments.csv",
            SegmentFormat::Babel => "babel.json",
        }
    }
}

/// How `info` writes.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum InfoFormat {
    /// For reading
    Text,
    /// For programs: an object for one path, an array for several
    Json,
}

/// How `gait` writes.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum GaitFormat {
    /// For reading
    Text,
    /// For programs: an object for one clip, an array for several
    Json,
    /// A row per clip, with units in the columns' names
    Csv,
}

/// A role and the name of its joint, which may be empty.
fn joint(text: &str) -> Result<(Role, String), String> {
    let (role, name) = text.split_once('=').ok_or("it must be a role, = and the name of a joint")?;
    let known = || Role::ALL.map(Role::name).join(", ");
    let role =
        Role::named(role).ok_or_else(|| format!("there is no role {role:?}; there are {}", known()))?;
    Ok((role, name.to_owned()))
}

fn positive(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(value) if value > 0.0 && f64::is_finite(value) => Ok(value),
        _ => Err("it must be a number greater than 0".into()),
    }
}
