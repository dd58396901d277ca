//! Standard streams that are closed or full.

use std::fs::{self, File, OpenOptions};
use std::path::Path;
use std::process::Stdio;

use tempfile::TempDir;

use crate::support::{empty_folder, output, program, project, run, shell};

/// Returns a folder with two clips and their truth.
fn clips() -> TempDir {
    let folder = empty_folder();
    for (sample, name) in [("bvh", "a.bvh"), ("json", "a.json"), ("bvh", "b.bvh"), ("json", "b.json")] {
        let sample = project(&format!("samples/curved-walk.{sample}"));
        fs::copy(sample, folder.path().join(name)).expect("a sample");
    }
    folder
}

/// Commands that write to standard output.
const WRITERS: &[&[&str]] = &[
    &["info", "."],
    &["info", "a.bvh", "--format", "json"],
    &["gait", "."],
    &["gait", ".", "--format", "csv"],
    &["gait", "a.bvh", "--format", "json"],
    &["score", "."],
    &["detect", "a.bvh"],
    &["detect", "a.bvh", "--format", "npz"],
    &["segment", "a.bvh", "--format", "csv"],
    &["--help"],
    &["help", "detect"],
    &["--version"],
];

#[test]
fn a_full_device_is_a_failure_in_one_line() {
    if !Path::new("/dev/full").exists() {
        return;
    }
    let folder = clips();
    for args in WRITERS {
        let full = OpenOptions::new().write(true).open("/dev/full").expect("the device");
        let (code, _, messages) = output(program(folder.path(), args).stdout(full));
        assert_eq!((code, messages.lines().count()), (1, 1), "{args:?}: {messages}");
        assert!(
            messages.starts_with("<stdout>: error: cannot write the result: No space left"),
            "{messages}"
        );
    }
}

#[test]
fn a_closed_standard_output_is_a_failure_in_one_line() {
    let folder = clips();
    for args in WRITERS {
        let (code, _, messages) = output(&mut shell(folder.path(), "exec \"$@\" >&-", args));
        assert_eq!((code, messages.lines().count()), (1, 1), "{args:?}: {messages}");
        assert!(messages.starts_with("<stdout>: error: cannot write the result: "), "{messages}");
        assert!(messages.contains("standard output is closed"), "{messages}");
    }
    // It is not needed where results are written to files.
    let args = ["detect", ".", "--out", "out"];
    assert_eq!(output(&mut shell(folder.path(), "exec \"$@\" >&-", &args)), (0, "".into(), "".into()));
    assert!(folder.path().join("out/a.plants.json").is_file());
}

#[test]
fn the_null_device_is_not_a_closed_standard_output() {
    let folder = clips();
    let null = || OpenOptions::new().read(true).write(true).open("/dev/null").expect("the device");
    for stdout in [Stdio::null(), null().into()] {
        let (code, _, messages) = output(program(folder.path(), &["info", "a.bvh"]).stdout(stdout));
        assert_eq!((code, messages.as_str()), (0, ""));
    }
}

#[test]
fn a_closed_pipe_of_the_help_ends_the_program_quietly() {
    for args in [&["--help"][..], &["--version"], &["help", "detect"]] {
        let (reader, writer) = std::io::pipe().expect("a pipe");
        drop(reader);
        let (code, _, messages) = output(program(Path::new("."), args).stdout(writer));
        assert_eq!((code, messages.as_str()), (141, ""), "{args:?}");
    }
}

#[test]
fn closed_standard_input_and_error_are_survived() {
    let folder = clips();
    let folder = folder.path();
    let (code, stdout, _) = output(&mut shell(folder, "exec \"$@\" 2>&-", &["info", "a.bvh", "none.bvh"]));
    assert!(code == 1 && stdout.starts_with("a.bvh\n"), "{code}: {stdout}");
    let (code, _, messages) = output(&mut shell(folder, "exec \"$@\" <&-", &["info", "-"]));
    assert_eq!((code, messages.lines().count()), (1, 1), "{messages}");
    assert!(messages.starts_with("<stdin>:"), "{messages}");
}

#[test]
fn clean_writes_to_pipes_and_devices_without_replacing_them() {
    let folder = clips();
    let folder = folder.path();
    assert_eq!(run(folder, &["clean", "a.bvh", "-o", "file.bvh"]).0, 0);
    let made = std::process::Command::new("mkfifo").arg(folder.join("pipe")).status();
    assert!(made.expect("mkfifo runs").success());
    let pipe = folder.join("pipe");
    let reader = std::thread::spawn(move || std::io::read_to_string(File::open(pipe).expect("the pipe")));
    assert_eq!(run(folder, &["clean", "a.bvh", "-o", "pipe"]).0, 0);
    if folder.join("pipe").is_file() {
        panic!("the pipe was replaced by a file");
    }
    let text = reader.join().expect("the reader ends").expect("text");
    assert_eq!(text, fs::read_to_string(folder.join("file.bvh")).expect("a file"));
}

#[test]
fn a_pipe_with_the_name_of_a_result_is_an_error() {
    let folder = clips();
    let folder = folder.path();
    assert_eq!(run(folder, &["detect", "a.bvh", "--out", "out"]).0, 0);
    let mut paths =
        fs::read_dir(folder.join("out")).expect("a folder").map(|entry| entry.expect("an entry").path());
    let result = paths.find(|path| path.extension().is_some_and(|end| end == "json")).expect("a result");
    fs::remove_file(&result).expect("a file");
    assert!(std::process::Command::new("mkfifo").arg(&result).status().expect("mkfifo runs").success());
    // Opening the pipe would wait for a process at its other end.
    let (code, _, messages) = run(folder, &["detect", "a.bvh", "--out", "out"]);
    assert!(code == 1 && messages.contains("pipe"), "{code}: {messages}");
}
