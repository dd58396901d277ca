//! Tests of the files next to the clip that commands read: labels, segments, constraints.

use std::fs;
use std::path::{Path, PathBuf};

use assert_cmd::Command;

fn sample(name: &str) -> String {
    let path: PathBuf = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../samples").join(name);
    path.canonicalize().expect("a sample").to_str().expect("a path").into()
}

/// Runs the program in `folder`. Returns exit code, standard output and standard error.
fn run(folder: &Path, args: &[&str], input: &[u8]) -> (i32, String, String) {
    let mut command = Command::cargo_bin("plantigrade").expect("the binary");
    let output = command.current_dir(folder).args(args).write_stdin(input).output().expect("it runs");
    let text = |bytes| String::from_utf8(bytes).expect("text");
    (output.status.code().expect("an exit code"), text(output.stdout), text(output.stderr))
}

#[test]
fn gait_reads_labels_and_segments_from_standard_input() {
    let folder = tempfile::tempdir().expect("a folder");
    let clip = sample("curved-walk.bvh");
    let truth = fs::read(sample("curved-walk.json")).expect("truth");
    let steps =
        |labels: &str| run(folder.path(), &["gait", &clip, "--labels", labels, "--format", "steps"], &truth);
    assert_eq!(steps("-").0, 0, "{}", steps("-").2);
    assert_eq!(steps("-"), steps(&sample("curved-walk.json")));
    let track = b"0.0\t1.0\twalk\n1.0\t2.0\tturn\n";
    for format in ["text", "json"] {
        let args = ["gait", &clip, "--segments", "-", "--format", format];
        let (code, out, stderr) = run(folder.path(), &args, track);
        assert_eq!((code, out.contains("walk"), out.contains("turn")), (0, true, true), "{stderr}");
    }
}

#[test]
fn standard_input_is_read_only_once() {
    let folder = tempfile::tempdir().expect("a folder");
    for args in [
        &["gait", "-", "--labels", "-"][..],
        &["gait", "walk.bvh", "--labels", "-", "--segments", "-"],
        &["detect", "-", "--constraints", "-"],
        &["detect", "-", "--still", "-"],
        &["detect", "walk.bvh", "--constraints", "-", "--constraints-clip", "-"],
        &["clean", "-", "-o", "out.bvh", "--labels", "-"],
        &["info", "-", "-"],
        &["segment", "-", "-", "--out", "out"],
    ] {
        let (code, out, stderr) = run(folder.path(), args, b"HIERARCHY\n");
        assert_eq!((code, out.as_str()), (2, ""), "{args:?}: {stderr}");
        assert!(stderr.starts_with("error: standard input (-) can be read only once"), "{args:?}: {stderr}");
    }
}

#[test]
fn segments_that_are_not_text_have_a_message() {
    let folder = tempfile::tempdir().expect("a folder");
    let clip = sample("curved-walk.bvh");
    let (code, out, stderr) =
        run(folder.path(), &["gait", &clip, "--segments", "-"], b"0.0\t1.0\tL\xe4uft\n");
    assert_eq!((code, out.as_str(), stderr.lines().count()), (1, "", 1), "{stderr}");
    assert!(stderr.contains("<stdin>: error: the file cannot be read: it is not text in UTF-8"), "{stderr}");
}
