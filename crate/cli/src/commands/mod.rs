//! The commands: one file or folder per command.

mod clean;
mod detect;
mod gait;
mod info;
mod score;
mod segment;

use crate::args::Command;
use crate::error::UsageError;

/// Runs a command. Returns the number of inputs that failed.
pub fn run(command: &Command) -> Result<usize, UsageError> {
    match command {
        Command::Detect(args) => detect::run(args),
        Command::Segment(args) => segment::run(args),
        Command::Gait(args) => gait::run(args),
        Command::Score(args) => score::run(args),
        Command::Clean(args) => clean::run(args),
        Command::Info(args) => info::run(args),
    }
}
