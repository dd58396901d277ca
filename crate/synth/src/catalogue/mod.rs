//! Specifications of all generated clips.

mod full_set;
mod hard_cases;
mod long;
mod samples;

pub use full_set::full_set;
pub use hard_cases::hard_cases;
pub use long::long_mix;
pub use samples::samples;
