//! Fuzzing with cargo-fuzz. `crate/core/tests/fuzz.rs` runs the same targets on the stable toolchain.

pub mod targets;

use std::time::Duration;

use cpu_time::ProcessTime;

/// Measures the memory that a target uses.
#[global_allocator]
pub static ALLOCATOR: peak_alloc::PeakAlloc = peak_alloc::PeakAlloc;

/// Processor time that a target may take. Unlike elapsed time, it does not depend on other programs.
const TIME_LIMIT: Duration = Duration::from_secs(1);

/// Runs a target and checks the memory and the processor time that it uses.
///
/// # Panics
/// If the target panics, uses too much memory or takes too long.
pub fn run(target: fn(&[u8]), data: &[u8]) {
    // The creation of the clips does not count.
    targets::clips();
    let start = ProcessTime::now();
    targets::run(&ALLOCATOR, target, data);
    let elapsed = start.elapsed();
    assert!(elapsed <= TIME_LIMIT, "{elapsed:?} for an input of {} bytes", data.len());
}
