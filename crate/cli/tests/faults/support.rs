//! Inputs and processes of the tests.

use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::fs;
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use tempfile::TempDir;

pub fn project(path: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path);
    path.canonicalize().expect("a file of the project")
}

/// Creates an empty folder for a test.
pub fn empty_folder() -> TempDir {
    tempfile::tempdir().expect("a folder")
}

/// Writes a file, creating its folder if necessary.
pub fn write(path: &Path, bytes: &[u8]) {
    fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
    fs::write(path, bytes).expect("a file");
}

/// Returns the bytes of a small valid clip; clips of different numbers differ.
pub fn clip(number: usize) -> Vec<u8> {
    let text = fs::read_to_string(project("tests/files/good/plain.bvh")).expect("a clip");
    text.replace("OFFSET 10 0 0", &format!("OFFSET 10.{number:04} 0 0")).into_bytes()
}

/// Returns a command that runs the program in a folder.
pub fn program<S: AsRef<OsStr>>(folder: &Path, args: &[S]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_plantigrade"));
    command.current_dir(folder).args(args);
    command
}

/// Returns a command that runs the program in a folder after a line of shell script; the script starts the
/// program by `"$@"`.
pub fn shell(folder: &Path, script: &str, args: &[&str]) -> Command {
    let mut command = Command::new("sh");
    command.current_dir(folder).args(["-c", script, "sh", env!("CARGO_BIN_EXE_plantigrade")]).args(args);
    command
}

/// Runs a command. Returns exit code, standard output and standard error.
pub fn output(command: &mut Command) -> (i32, String, String) {
    let Output { status, stdout, stderr } = command.output().expect("the program runs");
    let text = |bytes| String::from_utf8(bytes).expect("UTF-8");
    (status.code().expect("an exit code"), text(stdout), text(stderr))
}

/// Runs the program in a folder. Returns exit code, standard output and standard error.
pub fn run<S: AsRef<OsStr>>(folder: &Path, args: &[S]) -> (i32, String, String) {
    output(&mut program(folder, args))
}

/// Returns all files below a folder with their bytes; `None` for folders.
pub fn snapshot(folder: &Path) -> BTreeMap<PathBuf, Option<Vec<u8>>> {
    let mut entries = BTreeMap::new();
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            entries.extend(snapshot(&path));
            entries.insert(path, None);
        } else {
            let bytes = fs::read(&path).expect("a file");
            entries.insert(path, Some(bytes));
        }
    }
    entries
}

/// Returns a snapshot with paths relative to the folder.
pub fn relative_snapshot(folder: &Path) -> BTreeMap<PathBuf, Option<Vec<u8>>> {
    let relative = |path: PathBuf| path.strip_prefix(folder).expect("a path in the folder").to_owned();
    snapshot(folder).into_iter().map(|(path, bytes)| (relative(path), bytes)).collect()
}

/// Returns the results in a folder, with a value that changes when they are written again.
pub fn results(folder: &Path) -> BTreeMap<PathBuf, (u64, i64)> {
    let Ok(entries) = fs::read_dir(folder) else { return BTreeMap::new() };
    let paths = entries.filter_map(|entry| Some(entry.ok()?.path()));
    let is_result = |path: &PathBuf| path.file_name().is_some_and(|name| name.as_encoded_bytes()[0] != b'.');
    // A file that is replaced meanwhile is not there at times.
    let version = |path: &PathBuf| fs::metadata(path).ok().map(|data| (data.ino(), data.mtime_nsec()));
    paths.filter(is_result).filter_map(|path| Some((path.clone(), version(&path)?))).collect()
}

/// Returns the permissions of a file.
pub fn mode(path: &Path) -> u32 {
    fs::metadata(path).expect("a file").mode() & 0o7777
}

/// Generator of pseudo-random numbers (xorshift).
pub struct Random(pub u64);

impl Random {
    /// Returns a number below `limit`.
    pub fn below(&mut self, limit: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % limit.max(1) as u64) as usize
    }
}
