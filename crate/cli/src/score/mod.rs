//! `plantigrade score`

mod cuts;
mod plants;

use crate::args::{ReadArgs, ScoreArgs};
use crate::failure::Failure;
use crate::inputs::{self, Input};

/// Scores all clips of a folder that have truth, and counts those that failed.
pub fn run(args: &ScoreArgs) -> Result<usize, String> {
    if args.cuts { cuts::run(args) } else { plants::run(args) }
}

/// A trial for each clip of the folder that has truth, and how many of them failed.
fn trials<T>(
    args: &ScoreArgs,
    truth: &str,
    trial: impl Fn(&Input, &ReadArgs) -> Result<Option<T>, Failure>,
) -> Result<(Vec<T>, usize), String> {
    let read = ReadArgs { paths: vec![args.folder.clone()], ..ReadArgs::default() };
    let mut trials = Vec::new();
    let mut failed = 0;
    for input in inputs::collect(&read)? {
        match trial(&input, &read) {
            Ok(trial) => trials.extend(trial),
            Err(failure) => {
                eprintln!("{failure}");
                failed += 1;
            }
        }
    }
    if trials.is_empty() && failed == 0 {
        return Err(format!("no clip in {} has truth beside it ({truth})", args.folder.display()));
    }
    Ok((trials, failed))
}

/// The method of a name, or the default one.
fn method<M: Default + std::str::FromStr<Err = String>>(args: &ScoreArgs) -> Result<M, String> {
    args.method.as_deref().map_or_else(|| Ok(M::default()), str::parse)
}
