//! Fuzzing with cargo-fuzz. `crate/core/tests/fuzz.rs` runs the same targets on the stable toolchain.

pub mod targets;

pub use targets::run;

/// Measures the memory that a target uses.
#[global_allocator]
pub static ALLOCATOR: peak_alloc::PeakAlloc = peak_alloc::PeakAlloc;
