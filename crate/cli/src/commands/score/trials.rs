//! Clips with truth, and the method to score.

use std::num::NonZeroUsize;
use std::str::FromStr;

use crate::args::{ReadArgs, ScoreArgs};
use crate::error::{InputError, UsageError};
use crate::input::{self, Input};
use crate::parallel;

/// Runs `trial` on each clip of the folder; it returns `None` for clips without truth. Returns the
/// trials and the number of inputs that failed. `expected` lists the names of truth files.
pub fn trials<T: Send>(
    args: &ScoreArgs,
    expected: &'static str,
    trial: impl Fn(&Input, &ReadArgs) -> Result<Option<T>, InputError> + Sync,
) -> Result<(Vec<T>, usize), UsageError> {
    if !args.folder.exists() {
        return Err(UsageError::NoFolder(args.folder.clone()));
    }
    let read = ReadArgs { paths: vec![args.folder.clone()], ..ReadArgs::default() };
    let one_by_one = NonZeroUsize::new(1);
    let (trials, failures) = parallel::map(&input::collect(&read)?, one_by_one, |input| trial(input, &read));
    let trials: Vec<T> = trials.into_iter().flatten().collect();
    if trials.is_empty() && failures == 0 {
        return Err(UsageError::NoTruth { folder: args.folder.clone(), expected });
    }
    Ok((trials, failures))
}

/// Returns the method named on the command line, or the default.
pub fn method<M: Default + FromStr>(args: &ScoreArgs) -> Result<M, UsageError>
where
    M::Err: ToString,
{
    let method = args.method.as_deref().map_or_else(|| Ok(M::default()), str::parse);
    method.map_err(|error| UsageError::UnknownMethod(error.to_string()))
}
