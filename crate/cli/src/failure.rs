//! What can go wrong with one input, in one line.

use std::io;
use std::path::{Path, PathBuf};

use plantigrade::bvh;
use plantigrade::formats::LabelsError;
use plantigrade::plants::DetectError;
use plantigrade::segments::SegmentError;
use plantigrade::skate::SkateError;

/// Why an input gave no result.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    /// The file cannot be opened or read.
    #[error("{name}: error: {error}", name = name(.path))]
    Read {
        /// The input.
        path: PathBuf,
        /// What the system says.
        error: io::Error,
    },
    /// The file is not BVH that can be read.
    #[error("{name}:{place} error: {problem}. {hint}", name = name(.path),
        place = .error.place.map_or_else(String::new, |place| format!("{place}:")),
        problem = .error.problem, hint = .error.problem.hint())]
    Parse {
        /// The input.
        path: PathBuf,
        /// Where and why.
        error: Box<bvh::Error>,
    },
    /// The clip has no joint of a name that the command line gives.
    #[error("{name}: error: there is no joint {joint:?}: compare the names with those in the file's hierarchy",
        name = name(.path))]
    Joint {
        /// The input.
        path: PathBuf,
        /// The name.
        joint: String,
    },
    /// The truth beside the clip cannot be used.
    #[error("{name}: error: {error}", name = name(.path))]
    Truth {
        /// The truth.
        path: PathBuf,
        /// Why not.
        error: LabelsError,
    },
    /// The clip has nothing to detect in.
    #[error("{name}: error: {error}", name = name(.path))]
    Detect {
        /// The input.
        path: PathBuf,
        /// Why not.
        error: DetectError,
    },
    /// The clip cannot be cleaned up.
    #[error("{name}: error: {error}", name = name(.path))]
    Clean {
        /// The input.
        path: PathBuf,
        /// Why not.
        error: SkateError,
    },
    /// The clip has nothing to cut.
    #[error("{name}: error: {error}", name = name(.path))]
    Segment {
        /// The input.
        path: PathBuf,
        /// Why not.
        error: SegmentError,
    },
    /// The program panicked, and said why.
    #[error("{name}: error: this is a fault of plantigrade: please report what it says above, with the clip",
        name = name(.path))]
    Fault {
        /// The input.
        path: PathBuf,
    },
    /// The result cannot be written.
    #[error("{name}: error: cannot write the result: {error}", name = name(.path))]
    Write {
        /// The output.
        path: PathBuf,
        /// What the system says.
        error: io::Error,
    },
}

/// The name an input goes by.
pub fn name(path: &Path) -> String {
    if path == Path::new("-") { "<stdin>".into() } else { path.display().to_string() }
}
