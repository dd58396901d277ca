//! Many inputs at a time, with a bar that shows how far they are.

use std::io::IsTerminal;
use std::num::NonZeroUsize;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::failure::Failure;
use crate::inputs::Input;

/// Does `work` for each input and its index, `jobs` at a time, reports failures as they come and
/// counts them; a panic is the failure of its input alone.
pub fn for_each(
    inputs: &[Input],
    jobs: Option<NonZeroUsize>,
    work: impl Fn(usize, &Input) -> Result<(), Failure> + Sync,
) -> usize {
    let jobs = jobs.or_else(|| thread::available_parallelism().ok()).map_or(1, NonZeroUsize::get);
    let bar = bar(inputs.len());
    let next = AtomicUsize::new(0);
    let failed = Mutex::new(0);
    thread::scope(|scope| {
        for _ in 0..jobs.min(inputs.len()) {
            scope.spawn(|| {
                loop {
                    let index = next.fetch_add(1, Ordering::Relaxed);
                    let Some(input) = inputs.get(index) else { break };
                    let done = catch_unwind(AssertUnwindSafe(|| work(index, input)));
                    let fault = |_| Err(Failure::Fault { path: input.path.clone() });
                    if let Err(failure) = done.unwrap_or_else(fault) {
                        *failed.lock().unwrap_or_else(PoisonError::into_inner) += 1;
                        bar.suspend(|| eprintln!("{failure}"));
                    }
                    bar.inc(1);
                }
            });
        }
    });
    bar.finish_and_clear();
    failed.into_inner().unwrap_or_else(PoisonError::into_inner)
}

fn bar(count: usize) -> ProgressBar {
    let hidden = count < 2 || !std::io::stderr().is_terminal();
    let target = if hidden { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
    let bar = ProgressBar::with_draw_target(Some(count as u64), target);
    let style = ProgressStyle::with_template("{bar:30} {pos}/{len} clips, {eta} left");
    bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_is_the_failure_of_one_input() {
        let inputs = ["a", "b", "c"].map(|name| Input { path: name.into(), stem: name.into() });
        let done = Mutex::new(Vec::new());
        let failed = for_each(&inputs, NonZeroUsize::new(1), |index, input| {
            assert!(index != 1, "on purpose");
            done.lock().unwrap().push(input.path.clone());
            Ok(())
        });
        assert_eq!((failed, done.into_inner().unwrap()), (1, vec!["a".into(), "c".into()]));
    }
}
