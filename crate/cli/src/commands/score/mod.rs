//! `plantigrade score`: compares labels with truth.

mod cuts;
mod plants;
mod trials;

use crate::args::ScoreArgs;
use crate::error::UsageError;

/// Scores all clips of a folder that have truth. Returns the number of inputs that failed.
pub fn run(args: &ScoreArgs) -> Result<usize, UsageError> {
    if args.cuts { cuts::run(args) } else { plants::run(args) }
}
