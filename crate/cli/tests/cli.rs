//! The command line as a person meets it.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Output;

use assert_cmd::Command;
use serde_json::Value;

fn project(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path)
}

fn plantigrade(args: &[&str]) -> Output {
    let mut command = Command::cargo_bin("plantigrade").expect("the binary");
    command.current_dir(project("tests/files")).args(args).output().expect("it runs")
}

fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).expect("text")
}

fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).expect("text")
}

fn code(output: &Output) -> i32 {
    output.status.code().expect("an exit code")
}

#[test]
fn every_file_is_read_or_refused_as_expected() {
    let expected = fs::read_to_string(project("tests/files/expected.txt")).expect("the list");
    let expected: Vec<&str> = expected.lines().filter(|line| !line.starts_with('#')).collect();
    for line in &expected {
        let file = &line[..line.find(".bvh").expect("a file") + 4];
        let output = plantigrade(&["info", "--format", "json", file]);
        if line.contains("error:") {
            assert_eq!((code(&output), stdout(&output)), (1, String::new()), "{line}");
            assert!(stderr(&output).starts_with(line), "{line}\n{}", stderr(&output));
            assert_eq!(stderr(&output).lines().count(), 1, "one line a failure");
        } else {
            let info: Value = serde_json::from_str(&stdout(&output)).expect(line);
            let notices = info["notices"].as_array().expect("a list");
            let codes: Vec<&str> = notices.iter().filter_map(|notice| notice["code"].as_str()).collect();
            let said = [
                vec![format!("{file}: {} frames", info["frames"])],
                codes.iter().map(|&c| c.into()).collect(),
            ];
            assert_eq!(&said.concat().join(", "), line);
            assert_eq!(info["roles"]["left_toe"], "LeftToeBase", "{line}");
        }
    }
    let files = ["good", "bad"]
        .map(|folder| fs::read_dir(project("tests/files").join(folder)).expect(folder).count());
    assert_eq!(expected.len(), files[0] + files[1], "every file is in the list");
}

#[test]
fn labels_come_in_every_format() {
    let sample = project("samples/curved-walk.bvh");
    let detect = |format: &str, method: &str| {
        let output = plantigrade(&[
            "detect",
            "--format",
            format,
            "--method",
            method,
            sample.to_str().expect("a path"),
        ]);
        assert_eq!((code(&output), stderr(&output)), (0, String::new()));
        stdout(&output)
    };
    let csv = detect("csv", "robust");
    let mut lines = csv.lines();
    let head = "frame,time,left_contact,left_heel,left_toe,right_contact,right_heel,right_toe";
    assert_eq!(lines.next(), Some(head));
    assert_eq!(lines.clone().count(), 245);
    assert!(lines.all(|line| line.split(',').skip(2).all(|label| label == "0" || label == "1")));
    assert!(detect("csv", "paper").starts_with("frame,time,left_toe,right_toe\n0,0,"));
    assert!(
        detect("intervals", "robust")
            .starts_with("foot,part,start_frame,end_frame,start_s,end_s\nleft,contact,")
    );
    let events = detect("events", "robust");
    assert!(events.starts_with("time,frame,context,event\n"));
    let frames: Vec<usize> = events
        .lines()
        .skip(1)
        .map(|line| line.split(',').nth(1).and_then(|f| f.parse().ok()).expect(line))
        .collect();
    assert!(frames.is_sorted() && !frames.is_empty());

    let json: Value = serde_json::from_str(&detect("json", "robust")).expect("JSON");
    assert_eq!((&json["format"], &json["version"]), (&"plantigrade-labels".into(), &1.into()));
    assert_eq!((&json["frames"], &json["method"]["name"]), (&245.into(), &"robust".into()));
    assert_eq!(json["source"]["sha256"].as_str().map(str::len), Some(64));
    assert_eq!(json["left"]["contact"][0]["source"], "auto");
}

#[test]
fn several_skeletons_have_a_column() {
    let output = plantigrade(&["detect", "--format", "csv", "good/two-skeletons.bvh"]);
    let table = stdout(&output);
    assert!(table.starts_with("root,frame,time,left_contact,"));
    assert_eq!(table.lines().filter(|line| line.starts_with("B:Hips,")).count(), 12);
}

#[test]
fn standard_input_is_a_file() {
    let text = fs::read(project("tests/files/good/plain.bvh")).expect("a file");
    let mut command = Command::cargo_bin("plantigrade").expect("the binary");
    let output = command
        .args(["detect", "-", "--format", "csv", "--fps", "60"])
        .write_stdin(text)
        .output()
        .expect("runs");
    assert!(stdout(&output).lines().nth(2).is_some_and(|line| line.starts_with("1,0.016667,")));
}

#[test]
fn folders_are_done_once_and_failures_do_not_stop_them() {
    let out = tempfile::tempdir().expect("a folder");
    let folder = out.path().to_str().expect("a path");
    let run = |more: &[&str]| {
        plantigrade(&[&["detect", "good", "bad", "--format", "csv", "--out", folder], more].concat())
    };
    let output = run(&[]);
    assert_eq!((code(&output), stdout(&output)), (1, String::new()));
    // Eight are bad, and one has no motion to detect in.
    assert_eq!(stderr(&output).lines().count(), 9);
    let made = || {
        let files = fs::read_dir(out.path()).expect("a folder").filter_map(Result::ok);
        let tables = files.filter(|file| file.file_name().to_string_lossy().ends_with(".csv"));
        tables
            .map(|file| file.metadata().and_then(|data| data.modified()).expect("a time"))
            .collect::<Vec<_>>()
    };
    let first = made();
    assert_eq!(first.len(), 9);
    run(&[]);
    assert_eq!(made(), first, "what is made is not made again");
    run(&["--r", "0.002"]);
    assert_ne!(made(), first, "other parameters give other results");
    let second = made();
    run(&["--r", "0.002", "--force"]);
    assert_ne!(made(), second);
}

#[test]
fn labels_are_scored_against_truth() {
    let output = plantigrade(&["score", "../../samples", "--part", "contact"]);
    assert_eq!((code(&output), stderr(&output)), (0, String::new()));
    let text = stdout(&output);
    let pooled = text.lines().find(|line| line.starts_with("all frames ")).expect(&text);
    let shares: Vec<f64> = pooled.split_whitespace().filter_map(|word| word.parse().ok()).collect();
    assert!(shares.len() == 5 && shares.is_sorted() && shares[3] > 98.0, "{pooled}");
    assert!(text.contains("frog-jumps") && text.contains("F1 0.9"), "{text}");
    assert_eq!(code(&plantigrade(&["score", "good"])), 2);
}

#[test]
fn every_method_detects() {
    for method in ["robust", "paper", "sigma", "njw", "gmm", "hmm", "dual", "min-speed"] {
        let output =
            plantigrade(&["detect", "../../samples/curved-walk.bvh", "--method", method, "--format", "csv"]);
        assert_eq!(stdout(&output).lines().count(), 246, "{method}: {}", stderr(&output));
    }
    let still = [
        "detect",
        "../../samples/curved-walk.bvh",
        "--method",
        "paper",
        "--still",
        "../../samples/bowling.bvh",
    ];
    assert_eq!(code(&plantigrade(&still)), 0);
}

#[test]
fn a_wrong_command_line_is_told_apart() {
    for args in [
        &["detect"][..],
        &["detect", "good/plain.bvh", "--method", "best"],
        &["detect", "good/plain.bvh", "--r", "0"],
        &["detect", "good/plain.bvh", "--up", "w"],
        &["detect", "good/plain.bvh", "--fps", "-3"],
        &["detect", "good"],
        &["detect", "../files"],
        &["info", "good/plain.bvh", "--format", "xml"],
    ] {
        let output = plantigrade(args);
        assert_eq!((code(&output), stdout(&output)), (2, String::new()), "{args:?}");
        assert!(stderr(&output).starts_with("error: "), "{args:?}: {}", stderr(&output));
    }
    let output = plantigrade(&["info", "nowhere.bvh"]);
    assert_eq!(code(&output), 1);
    assert!(stderr(&output).starts_with("nowhere.bvh: error: "));
}
