//! Parallel processing of inputs with a progress bar.

use std::cell::Cell;
use std::io::IsTerminal;
use std::num::NonZeroUsize;
use std::panic::{self, AssertUnwindSafe, catch_unwind};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use rayon::ThreadPoolBuilder;
use rayon::iter::{ParallelBridge, ParallelIterator};

use crate::error::InputError;
use crate::input::Input;
use crate::output;

thread_local! {
    /// Message and location of the last panic of the thread.
    static PANIC: Cell<Option<String>> = const { Cell::new(None) };
}

/// Stores the messages of panics for [`catch_panic`]; otherwise they are printed in several lines.
pub fn keep_panic_messages() {
    panic::set_hook(Box::new(|panic| PANIC.set(Some(panic.to_string().replacen(":\n", ": ", 1)))));
}

/// Returns the result of `work`, or the message of its panic.
pub fn catch_panic<R>(work: impl FnOnce() -> R) -> Result<R, String> {
    catch_unwind(AssertUnwindSafe(work)).map_err(|_| PANIC.take().unwrap_or_else(|| "panicked".into()))
}

/// Applies `work` to each input, `jobs` at a time (default: one per processor).
///
/// Inputs are started in order. A failure is printed when it occurs; a panic is a failure of its
/// input only. Returns the results of the inputs that succeeded, in input order, and the number
/// of failures.
pub fn map<R: Send>(
    inputs: &[Input],
    jobs: Option<NonZeroUsize>,
    work: impl Fn(&Input) -> Result<R, InputError> + Sync,
) -> (Vec<R>, usize) {
    // Zero selects one thread per processor. Further threads than inputs would be idle.
    let threads = jobs.map_or(0, |jobs| jobs.get().min(inputs.len().max(1)));
    let pool = ThreadPoolBuilder::new().num_threads(threads).build().expect("threads can be started");
    let bar = progress_bar(inputs.len());
    let run = |input: &Input| {
        let result = match &input.problem {
            Some(problem) => Err(InputError::Problem { path: input.path.clone(), problem: problem.clone() }),
            None => catch_panic(|| work(input))
                .unwrap_or_else(|message| Err(InputError::Panic { path: input.path.clone(), message })),
        };
        let result = result.map_err(|error| bar.suspend(|| output::report(format_args!("{error}")))).ok();
        bar.inc(1);
        result
    };
    let mut results: Vec<(usize, R)> = pool.install(|| {
        // A bridge hands out inputs one by one; splitting the slice would start in the middle.
        let numbered = inputs.iter().enumerate().par_bridge();
        numbered.filter_map(|(index, input)| Some((index, run(input)?))).collect()
    });
    bar.finish_and_clear();
    results.sort_by_key(|(index, _)| *index);
    let failures = inputs.len() - results.len();
    (results.into_iter().map(|(_, result)| result).collect(), failures)
}

fn progress_bar(count: usize) -> ProgressBar {
    let hidden = count < 2 || !std::io::stderr().is_terminal();
    let target = if hidden { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
    let bar = ProgressBar::with_draw_target(Some(count as u64), target);
    let style = ProgressStyle::with_template("{bar:30} {pos}/{len} clips, {eta} left");
    bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn inputs<const N: usize>(names: [&str; N]) -> [Input; N] {
        names.map(|name| Input { path: name.into(), stem: name.into(), problem: None })
    }

    #[test]
    fn panic_fails_only_its_input() {
        let inputs = inputs(["a", "b", "c"]);
        let (results, failures) = map(&inputs, NonZeroUsize::new(1), |input| {
            assert!(input.path.as_os_str() != "b", "on purpose");
            Ok(input.path.clone())
        });
        assert_eq!((results, failures), (vec!["a".into(), "c".into()], 1));
    }

    /// The test runs itself in a second process, whose standard error it reads.
    #[test]
    fn panic_is_reported_in_one_line() {
        const CHILD: &str = "PLANTIGRADE_TEST_CHILD";
        if std::env::var_os(CHILD).is_some() {
            keep_panic_messages();
            map(&inputs(["walk.bvh"]), NonZeroUsize::new(1), |_| -> Result<(), _> { panic!("on\npurpose") });
            return;
        }
        let mut command = std::process::Command::new(std::env::current_exe().expect("the test"));
        let name = "parallel::tests::panic_is_reported_in_one_line";
        let child = command.args(["--exact", name, "--nocapture"]).env(CHILD, "1").output().expect("a run");
        let message = String::from_utf8(child.stderr).expect("text");
        assert_eq!(message.lines().count(), 1, "{message}");
        assert!(message.starts_with("walk.bvh: error: internal error: panicked at "), "{message}");
        assert!(message.contains("parallel.rs:") && message.contains(r": on\npurpose. Please report it"));
    }

    #[test]
    fn no_more_threads_than_inputs_are_started() {
        let (threads, _) =
            map(&inputs(["a", "b"]), NonZeroUsize::new(1000), |_| Ok(rayon::current_num_threads()));
        assert_eq!(threads, [2, 2]);
    }

    #[test]
    fn results_are_in_input_order() {
        let inputs = inputs(["a", "b", "c", "d", "e", "f"]);
        let (results, failures) = map(&inputs, NonZeroUsize::new(3), |input| {
            let delay = if input.path.as_os_str() == "a" { 30 } else { 1 };
            std::thread::sleep(std::time::Duration::from_millis(delay));
            Ok(input.path.clone())
        });
        assert_eq!(failures, 0);
        assert!(results.iter().eq(inputs.iter().map(|input| &input.path)));
    }
}
