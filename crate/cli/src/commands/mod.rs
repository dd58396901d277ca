//! The commands.
//!
//! Each `run` function returns the number of inputs that failed, or a [`UsageError`] if the
//! command line is invalid.
//!
//! [`UsageError`]: crate::error::UsageError

pub mod clean;
pub mod detect;
pub mod gait;
pub mod info;
pub mod score;
pub mod segment;

use serde::Serialize;

/// Prints a value as indented JSON.
fn print_json(value: &impl Serialize) {
    println!("{}", serde_json::to_string_pretty(value).expect("text, numbers and lists"));
}
