//! Standard output and messages.

use std::fmt::Arguments;
use std::io::{self, IsTerminal, Write};
#[cfg(unix)]
use std::os::fd::AsFd;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use serde::Serialize;

use crate::error::InputError;
use crate::file;
use crate::text::escape;

/// Name of standard output in messages.
pub const STDOUT: &str = "<stdout>";

/// Exit code of a program that is ended by the signal for a closed pipe, as shells report it.
const CLOSED_PIPE: i32 = 141;

/// True if standard output was closed when the program was started.
static IS_STDOUT_CLOSED: AtomicBool = AtomicBool::new(false);

// Runs before `main`: the runtime replaces closed streams by the null device, which would drop results
// silently. Safety: it only calls the operating system and stores a value.
#[cfg(unix)]
ctor::declarative::ctor! {
    #[ctor(unsafe)]
    fn check_stdout() {
        let is_closed = io::stdout().as_fd().try_clone_to_owned().is_err();
        IS_STDOUT_CLOSED.store(is_closed, Ordering::Relaxed);
    }
}

/// Writes a value as indented JSON.
pub fn print_json(value: &impl Serialize) {
    let json = serde_json::to_string_pretty(value).expect("text, numbers and lists");
    print(format_args!("{json}\n"));
}

/// Writes text on standard output. Ends the program if that is impossible.
pub fn print(text: Arguments<'_>) {
    end_on_error(print_bytes(text.to_string().as_bytes()));
}

/// Writes a result to standard output; on a terminal, control characters are escaped. Ends the program
/// quietly if the reader has closed the pipe.
pub fn print_bytes(bytes: &[u8]) -> io::Result<()> {
    print_with(|| {
        let mut stdout = io::stdout();
        if !stdout.is_terminal() {
            return stdout.write_all(bytes);
        }
        let lines: Vec<String> = String::from_utf8_lossy(bytes).split('\n').map(escape).collect();
        stdout.write_all(lines.join("\n").as_bytes())
    })
}

/// Writes a result to a file, whole or not at all, or to standard output for `-`.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), InputError> {
    let (path, written) = if file::is_stream(path) {
        (Path::new(STDOUT), print_bytes(bytes))
    } else {
        file::remove_temporary_files([path]);
        (path, file::write(path, bytes))
    };
    written.map_err(|error| InputError::Write { path: path.into(), error })
}

/// Writes the help, the version or an error of the command line. Returns the exit code.
pub fn print_command_line_error(error: &clap::Error) -> u8 {
    if error.use_stderr() {
        let _ = error.print();
    } else {
        end_on_error(print_with(|| error.print()));
    }
    u8::from(error.use_stderr()) * 2
}

/// Writes a line on standard error, unless its reader has closed the pipe. Control characters are escaped.
pub fn report(line: Arguments<'_>) {
    let line = escape(&line.to_string()) + "\n";
    let _ = io::stderr().write_all(line.as_bytes());
}

/// Writes to standard output by `write`. Ends the program quietly if the reader has closed the pipe.
fn print_with(write: impl FnOnce() -> io::Result<()>) -> io::Result<()> {
    if IS_STDOUT_CLOSED.load(Ordering::Relaxed) {
        return Err(io::Error::other("standard output is closed"));
    }
    match write().and_then(|()| io::stdout().flush()) {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => std::process::exit(CLOSED_PIPE),
        result => result,
    }
}

/// Reports an error of standard output and ends the program.
fn end_on_error(result: io::Result<()>) {
    if let Err(error) = result {
        report(format_args!("{}", InputError::Write { path: STDOUT.into(), error }));
        std::process::exit(1);
    }
}
