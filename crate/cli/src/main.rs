//! Command line of Plantigrade: foot plants and actions in BVH files.

mod args;
mod batch;
mod commands;
mod error;
mod file;
mod input;
mod output;
mod output_folder;
mod parallel;
mod text;

use std::process::ExitCode;

use clap::Parser;

use crate::args::Args;

fn main() -> ExitCode {
    parallel::keep_panic_messages();
    let args = match Args::try_parse() {
        Ok(args) => args,
        Err(error) => {
            // The message quotes arguments, which may be names of files.
            let escaped = std::env::args_os().map(|arg| text::escape(&text::decode(&arg)));
            let error = Args::try_parse_from(escaped).err().unwrap_or(error);
            return ExitCode::from(output::print_command_line_error(&error));
        }
    };
    match parallel::catch_panic(|| commands::run(&args.command)) {
        Ok(Ok(failures)) => ExitCode::from(u8::from(failures > 0)),
        Ok(Err(error)) => {
            output::report(format_args!("error: {error}"));
            // Same format as clap's own usage errors.
            output::report(format_args!(""));
            output::report(format_args!("For more information, try '--help'."));
            ExitCode::from(2)
        }
        Err(message) => {
            output::report(format_args!("error: internal error: {message}. Please report it"));
            ExitCode::FAILURE
        }
    }
}
