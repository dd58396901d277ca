//! Batches on a full disk: a small file system in memory, mounted in a name space of its own. The test is
//! ignored where that is impossible.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use libtest_mimic::{Arguments, Trial};

/// Number of clips; their results need more space than there is.
const CLIPS: usize = 60;

/// Creates the file system in `small`, runs the program, and shows what it has written.
const SCRIPT: &str = "mount -t tmpfs -o size=64k tmpfs small || exit 99
\"$@\"; code=$?
cat small/*.plants.json; echo; echo files; ls -A small
exit $code";

fn main() {
    let arguments = Arguments::from_args();
    let is_possible = in_small_file_system(&std::env::temp_dir(), "true", &[]).is_some();
    let test = || {
        a_full_disk_fails_single_files();
        Ok(())
    };
    let tests = vec![Trial::test("a_full_disk_fails_single_files", test).with_ignored_flag(!is_possible)];
    libtest_mimic::run(&arguments, tests).exit();
}

/// Runs a program in a folder whose subfolder `small` is a file system of 64 kB; `None` if that is
/// impossible.
fn in_small_file_system(folder: &Path, program: &str, args: &[&str]) -> Option<Output> {
    let folder = tempfile::tempdir_in(folder).expect("a folder");
    fs::create_dir(folder.path().join("small")).expect("a folder");
    let text =
        fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/files/good/plain.bvh"));
    let text = text.expect("a clip");
    fs::create_dir(folder.path().join("clips")).expect("a folder");
    for number in 0..CLIPS {
        let clip = text.replace("OFFSET 10 0 0", &format!("OFFSET 10.{number:04} 0 0"));
        fs::write(folder.path().join(format!("clips/{number:04}.bvh")), clip).expect("a clip");
    }
    let mut command = Command::new("unshare");
    command.current_dir(folder.path()).args(["--mount", "--map-root-user", "sh", "-c", SCRIPT, "sh"]);
    let output = command.arg(program).args(args).output().ok()?;
    (output.status.code() != Some(99) && !output.stderr.starts_with(b"unshare")).then_some(output)
}

/// Each failure is one line, results are whole or missing, and the exit code is 1.
fn a_full_disk_fails_single_files() {
    let args = ["detect", "clips", "--out", "small"];
    let output =
        in_small_file_system(&std::env::temp_dir(), env!("CARGO_BIN_EXE_plantigrade"), &args).expect("a run");
    let messages = String::from_utf8(output.stderr).expect("UTF-8");
    let stdout = String::from_utf8(output.stdout).expect("UTF-8");
    assert_eq!(output.status.code(), Some(1), "{messages}");
    let (documents, files) = stdout.split_once("\nfiles\n").expect("a list of files");
    let results = files.lines().filter(|file| file.ends_with(".plants.json")).count();
    assert!(results > 0 && results < CLIPS, "{files}");
    assert!(!files.contains(".tmp"), "{files}");
    let documents = serde_json::Deserializer::from_str(documents).into_iter::<serde_json::Value>();
    assert_eq!(documents.filter(|document| document.is_ok()).count(), results, "results are whole");
    let failures = messages.lines().count();
    assert!(failures >= CLIPS - results && failures <= CLIPS + 1, "{messages}");
    for line in messages.lines() {
        assert!(line.starts_with("small") && line.contains(": error: "), "{line}");
        assert!(line.contains("No space left on device"), "{line}");
    }
}
