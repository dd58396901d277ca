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

use crate::args::Args;

fn main() -> ExitCode {
    match commands::run(&Args::parse().command) {
        Ok(failures) => ExitCode::from(u8::from(failures > 0)),
        // Same format as clap's own usage errors.
        Err(error) => {
            output::report(format_args!("error: {error}\n\nFor more information, try '--help'."));
            ExitCode::from(2)
        }
    }
}
