//! Errors of the command line and of single inputs.

use std::io;
use std::path::PathBuf;

use plantigrade::bvh;
use plantigrade::formats::ReadError;
use plantigrade::plants::DetectError;
use plantigrade::segments::SegmentError;
use plantigrade::skate::SkateError;

use crate::text::display_name;

/// Invalid command line; the program exits with code 2.
#[derive(Debug, thiserror::Error)]
pub enum UsageError {
    /// A parameter of a method is invalid.
    #[error("{0}")]
    InvalidParameter(String),
    /// `score --method` names an unknown method.
    #[error("{0}")]
    UnknownMethod(String),
    /// A folder has no BVH files.
    #[error("no .bvh files in {folder}", folder = display_name(.0))]
    EmptyFolder(PathBuf),
    /// Constraints without their clip are given for several inputs.
    #[error("--constraints belong to one clip: name it with --constraints-clip to label {0} clips")]
    ConstraintsClip(usize),
    /// `clean` was given more than one clip.
    #[error("found {0} inputs: clean takes exactly one clip")]
    NotOneClip(usize),
    /// Standard input was given for several files.
    #[error("standard input (-) can be read only once: use it for one file and name the others")]
    StdinTwice,
    /// Several inputs without an output folder.
    #[error("found {0} inputs: name a folder for the results with --out")]
    MissingOut(usize),
    /// `gait --labels` or `gait --segments` with several inputs.
    #[error("found {0} inputs: --labels and --segments apply to exactly one clip")]
    LabelsOfSeveral(usize),
    /// `gait --out` with a format that is printed.
    #[error("--out applies to --report, --format steps and --format angles; redirect the other formats")]
    OutOfPrinted,
    /// `--out` names a file that is read and differs from the result.
    #[error("--out would replace {path}, which is read: name another file", path = display_name(.0))]
    OutIsInput(PathBuf),
    /// The folder of `score` does not exist.
    #[error("{folder} does not exist: name a folder of clips with truth files", folder = display_name(.0))]
    NoFolder(PathBuf),
    /// No clip of a folder has truth.
    #[error("no clip in {folder} has a truth file ({expected})", folder = display_name(.folder))]
    NoTruth {
        /// The folder.
        folder: PathBuf,
        /// Names of the expected truth files.
        expected: &'static str,
    },
}

/// Failure of one input, reported in one line; the program exits with code 1.
#[derive(Debug, thiserror::Error)]
pub enum InputError {
    /// The file cannot be opened or read.
    #[error("{name}: error: {error}", name = display_name(.path))]
    Read {
        /// The file.
        path: PathBuf,
        /// Error of the operating system.
        error: io::Error,
    },
    /// The file is not valid BVH.
    #[error("{name}:{location} error: {kind}. {hint}", name = display_name(.path),
        location = .error.location.map_or_else(String::new, |location| format!("{location}:")),
        kind = .error.kind, hint = .error.kind.hint())]
    Parse {
        /// The file.
        path: PathBuf,
        /// Location and cause.
        error: Box<bvh::Error>,
    },
    /// The clip has no joint with a name given on the command line.
    #[error("{name}: error: unknown joint {joint:?}: use a joint name of the file's HIERARCHY section",
        name = display_name(.path))]
    UnknownJoint {
        /// The file.
        path: PathBuf,
        /// The joint name.
        joint: String,
    },
    /// Several joints of the clip have a name given on the command line.
    #[error("{name}: error: several joints are named {joint:?}: use {choices}", name = display_name(.path))]
    AmbiguousJoint {
        /// The file.
        path: PathBuf,
        /// The joint name.
        joint: String,
        /// Names of the joints that are unambiguous.
        choices: String,
    },
    /// Labels or truth cannot be used.
    #[error("{name}: error: {error}", name = display_name(.path))]
    Labels {
        /// The labels file.
        path: PathBuf,
        /// Cause.
        error: ReadError,
    },
    /// Corrections are of a part of the foot that the method does not label.
    #[error("{name}: error: it has corrections of the part {part}, which the method {method} does not \
        label: use --method robust", name = display_name(.path))]
    UnlabelledPart {
        /// The corrected labels.
        path: PathBuf,
        /// Name of the part.
        part: &'static str,
        /// Name of the method.
        method: &'static str,
    },
    /// Plants cannot be detected.
    #[error("{name}: error: {error}", name = display_name(.path))]
    Detect {
        /// The file.
        path: PathBuf,
        /// Cause.
        error: DetectError,
    },
    /// Foot skate cannot be removed.
    #[error("{name}: error: {error}", name = display_name(.path))]
    Clean {
        /// The file.
        path: PathBuf,
        /// Cause.
        error: SkateError,
    },
    /// The clip cannot be segmented.
    #[error("{name}: error: {error}", name = display_name(.path))]
    Segment {
        /// The file.
        path: PathBuf,
        /// Cause.
        error: SegmentError,
    },
    /// The input cannot be processed for a reason that was found before reading it.
    #[error("{name}: error: {problem}", name = display_name(.path))]
    Problem {
        /// The file.
        path: PathBuf,
        /// The reason.
        problem: String,
    },
    /// The program panicked.
    #[error("{name}: error: internal error: {message}. Please report it together with the clip",
        name = display_name(.path))]
    Panic {
        /// The file.
        path: PathBuf,
        /// Message and location of the panic.
        message: String,
    },
    /// The output folder cannot be used.
    #[error("{name}: error: cannot write results to the folder: {error}", name = display_name(.folder))]
    OutputFolder {
        /// The folder.
        folder: PathBuf,
        /// Error of the operating system.
        error: io::Error,
    },
    /// The result cannot be written.
    #[error("{name}: error: cannot write the result: {error}", name = display_name(.path))]
    Write {
        /// The output file.
        path: PathBuf,
        /// Error of the operating system.
        error: io::Error,
    },
}
