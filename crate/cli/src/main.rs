//! Command line of Plantigrade: foot plants and actions in BVH files.

mod args;
mod batch;
mod commands;
mod error;
mod input;
mod output;
mod parallel;

use std::process::ExitCode;

use clap::Parser;

use crate::args::{Args, Command};
use crate::commands::{clean, detect, gait, info, score, segment};

fn main() -> ExitCode {
    let args = Args::parse();
    let result = match &args.command {
        Command::Detect(args) => detect::run(args),
        Command::Segment(args) => segment::run(args),
        Command::Gait(args) => gait::run(args),
        Command::Score(args) => score::run(args),
        Command::Clean(args) => clean::run(args),
        Command::Info(args) => info::run(args),
    };
    match result {
        Ok(failures) => ExitCode::from(u8::from(failures > 0)),
        // Same format as clap's own usage errors.
        Err(error) => {
            eprintln!("error: {error}\n\nFor more information, try '--help'.");
            ExitCode::from(2)
        }
    }
}
