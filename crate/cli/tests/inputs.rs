//! Tests of the files that commands read: clips, labels, segments, constraints.

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
fn labels_are_read_in_every_format_that_has_plants() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let clip = sample("straight-jog.bvh");
    let labels = |format: &str, extension: &str| {
        let (code, _, stderr) = run(folder, &["detect", &clip, "--format", format, "--out", "."], b"");
        assert_eq!(code, 0, "{stderr}");
        format!("straight-jog.{extension}")
    };
    let clean = |labels: &str| {
        let (code, cleaned, stderr) = run(folder, &["clean", &clip, "--labels", labels, "-o", "-"], b"");
        (code, cleaned, stderr.replace(labels, "LABELS"))
    };
    let document = clean(&labels("json", "plants.json"));
    assert_eq!(document.0, 0, "{}", document.2);
    for (format, extension) in
        [("csv", "frames.csv"), ("intervals", "intervals.csv"), ("npz", "contacts.npz")]
    {
        assert!(clean(&labels(format, extension)) == document, "{format}");
    }
    let (code, _, stderr) = clean(&labels("events", "events.csv"));
    assert_eq!(code, 1);
    assert!(stderr.starts_with("LABELS: error: the file has no plants: expected"), "{stderr}");
}

#[test]
fn feet_that_share_a_joint_have_a_notice() {
    let folder = tempfile::tempdir().expect("a folder");
    let clip = sample("curved-walk.bvh");
    let info = |joints: &[&str]| {
        let joints = joints.iter().flat_map(|joint| ["--joint", joint]);
        let args: Vec<&str> = ["info", &clip].into_iter().chain(joints).collect();
        run(folder.path(), &args, b"").1
    };
    let shared = info(&["left_ankle=Bip01 R Foot", "left_toe=Bip01 R Toe0"]);
    assert!(shared.contains("Both ankles are Bip01 R Foot. Set another joint"), "{shared}");
    assert!(shared.contains("Both toes are Bip01 R Toe0."), "{shared}");
    assert!(!info(&[]).contains("Both"));
}

#[test]
fn options_without_effect_have_a_warning() {
    let folder = tempfile::tempdir().expect("a folder");
    let clip = sample("curved-walk.bvh");
    let warnings = |args: &[&str]| {
        let (code, _, stderr) = run(folder.path(), &[&args[..1], &[&*clip], &args[1..]].concat(), b"");
        assert_eq!(code, 0, "{stderr}");
        let option = |line: &str| line.split(' ').nth(1).expect("an option").to_owned();
        let is_warning = |line: &&str| line.contains(" has no effect with the method ");
        stderr.lines().filter(is_warning).map(option).collect::<Vec<_>>()
    };
    for (args, expected) in [
        (&["detect", "--r", "0.002", "--w", "2", "--sigma", "0.5", "--exact"][..], &[][..]),
        (&["detect", "--height", "0.1", "--still", &clip], &["--height", "--still"]),
        (&["detect", "--method", "paper", "--still", &clip, "--speed", "1"], &["--speed"]),
        (&["detect", "--method", "dual", "--height", "0.1", "--speed", "1", "--r", "0.1"], &["--r"]),
        (
            &["detect", "--method", "height-speed", "--height", "0.1", "--still", &clip],
            &["--height", "--still"],
        ),
        (&["gait", "--height", "0.1"], &["--height"]),
        (&["clean", "-o", "-", "--method", "speed", "--exact"], &["--exact"]),
        (&["segment", "--dims", "3", "--residual", "ratio"], &["--dims", "--residual"]),
        (&["segment", "--method", "pca-tail", "--dims", "3", "--published"], &["--published"]),
        (&["segment", "--method", "lsd", "--published", "--template", "tpose"], &[]),
        (&["segment", "--method", "lsd", "--dims", "2"], &["--dims"]),
    ] {
        assert_eq!(warnings(args), expected, "{args:?}");
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

#[test]
fn files_that_are_read_are_not_replaced_by_other_results() {
    let folder = tempfile::tempdir().expect("a folder");
    for name in ["curved-walk.bvh", "curved-walk.json"] {
        fs::copy(sample(name), folder.path().join(name)).expect("a copy");
    }
    fs::write(folder.path().join("track.txt"), "0.0\t1.0\twalk\n").expect("a track");
    fs::create_dir(folder.path().join("sub")).expect("a folder");
    let files = ["curved-walk.bvh", "curved-walk.json", "track.txt"];
    let contents = || files.map(|name| fs::read(folder.path().join(name)).expect("a file"));
    let before = contents();
    let steps = ["gait", "curved-walk.bvh", "--format", "steps"];
    let labels = ["--labels", "curved-walk.json", "--segments", "track.txt"];
    for args in [
        &["gait", "curved-walk.bvh", "--report", "html", "-o", "curved-walk.bvh"][..],
        &[&steps[..], &["-o", "sub/../curved-walk.bvh"]].concat(),
        &[&steps[..], &labels, &["-o", "curved-walk.json"]].concat(),
        &[&steps[..], &labels, &["-o", "./track.txt"]].concat(),
        &["clean", "curved-walk.bvh", "--labels", "curved-walk.json", "-o", "curved-walk.json"],
    ] {
        let (code, _, stderr) = run(folder.path(), args, b"");
        assert_eq!(code, 2, "{args:?}: {stderr}");
        assert!(stderr.contains(", which is read: name another file"), "{args:?}: {stderr}");
        assert_eq!(contents(), before, "{args:?}");
    }
    // A clip may be cleaned in place.
    assert_eq!(run(folder.path(), &["clean", "curved-walk.bvh", "-o", "curved-walk.bvh"], b"").0, 0);
}

#[test]
fn results_are_written_to_standard_output() {
    let folder = tempfile::tempdir().expect("a folder");
    let clip = sample("curved-walk.bvh");
    for (args, start) in [
        (&["clean", &clip, "-o", "-"][..], "HIERARCHY"),
        (&["gait", &clip, "--format", "steps", "-o", "-"], "foot,"),
        (&["gait", &clip, "--report", "html", "-o", "-"], "<!doctype html>"),
        (&["gait", &clip, "--format", "csv", "-o", "-"], "clip,"),
        (&["detect", &clip, "--format", "json", "--out", "-"], "{"),
        (&["segment", &clip, "--out", "-"], "{"),
    ] {
        let (code, out, stderr) = run(folder.path(), args, b"");
        assert_eq!(code, 0, "{args:?}: {stderr}");
        assert!(out.to_lowercase().starts_with(&start.to_lowercase()), "{args:?}: {out:.80}");
        assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 0, "{args:?}");
    }
    let several = ["gait", &clip, &sample("ballet.bvh"), "--report", "html", "-o", "-"];
    let (code, out, stderr) = run(folder.path(), &several, b"");
    assert_eq!((code, out.as_str()), (2, ""), "{stderr}");
}
