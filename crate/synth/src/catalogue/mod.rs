//! The clips there are recipes for.

mod everyday;
mod hard;
mod long;
mod samples;

pub use everyday::full_set;
pub use hard::hard_cases;
pub use long::long;
pub use samples::catalogue;
