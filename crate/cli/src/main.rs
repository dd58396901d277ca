//! `plantigrade`: foot plants and actions in BVH files, from the command line.

mod args;
mod clean;
mod detect;
mod failure;
mod gait;
mod info;
mod inputs;
mod output;
mod parallel;
mod results;
mod score;
mod segment;

use std::process::ExitCode;

use clap::Parser;

use crate::args::{Args, Command};

fn main() -> ExitCode {
    let args = Args::parse();
    let done = match &args.command {
        Command::Detect(args) => detect::run(args),
        Command::Segment(args) => segment::run(args),
        Command::Gait(args) => gait::run(args),
        Command::Score(args) => score::run(args),
        Command::Clean(args) => clean::run(args),
        Command::Info(args) => info::run(args),
    };
    match done {
        Ok(failed) => ExitCode::from(u8::from(failed > 0)),
        // As clap does for what it finds wrong itself.
        Err(usage) => {
            eprintln!("error: {usage}\n\nFor more information, try '--help'.");
            ExitCode::from(2)
        }
    }
}
