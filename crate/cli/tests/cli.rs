//! Tests of the command line.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Output;

use assert_cmd::Command;
use plantigrade::formats;
use plantigrade::segments::Segment;
use serde_json::Value;

fn project(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path)
}

fn plantigrade(args: &[&str]) -> Output {
    let mut command = Command::cargo_bin("plantigrade").expect("the binary");
    command.current_dir(project("tests/files")).args(args).output().expect("the program runs")
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
fn joints_and_unit_can_be_set() {
    let walk = project("samples/curved-walk.bvh");
    let walk = walk.to_str().expect("a path");
    let info = |options: &[&str]| plantigrade(&[&["info", walk, "--format", "json"], options].concat());
    let detected: Value = serde_json::from_str(&stdout(&info(&[]))).expect("JSON");
    let joint = |role: &str| detected["roles"][role].as_str().expect("a joint").to_owned();

    let swapped =
        [format!("left_ankle={}", joint("right_ankle")), format!("right_ankle={}", joint("left_ankle"))];
    let output =
        info(&["--joint", &swapped[0], "--joint", &swapped[1], "--joint", "left_tip=", "--unit", "0.5"]);
    let overridden: Value = serde_json::from_str(&stdout(&output)).expect("JSON");
    assert_eq!(overridden["roles"]["left_ankle"], detected["roles"]["right_ankle"]);
    assert_eq!(overridden["roles"]["right_ankle"], detected["roles"]["left_ankle"]);
    assert_eq!(overridden["roles"]["left_toe"], detected["roles"]["left_toe"]);
    assert_eq!(
        (&overridden["roles"]["left_tip"], &overridden["metres_per_unit"]),
        (&Value::Null, &0.5.into())
    );

    // Other joints give other labels, and existing results are recomputed.
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().to_str().expect("a path");
    let labels = |options: &[&str]| {
        let output = plantigrade(&[&["detect", walk, "--format", "csv", "--out", out], options].concat());
        assert_eq!(code(&output), 0, "{}", stderr(&output));
        fs::read_to_string(folder.path().join("curved-walk.frames.csv")).expect("labels")
    };
    let toes = [format!("left_toe={}", joint("right_toe")), format!("right_toe={}", joint("left_toe"))];
    let own = labels(&[]);
    let others =
        labels(&["--joint", &swapped[0], "--joint", &swapped[1], "--joint", &toes[0], "--joint", &toes[1]]);
    assert_ne!(own, others);

    let output = info(&["--joint", "left_ankle=Hoof"]);
    assert_eq!(code(&output), 1);
    assert!(
        stderr(&output).contains("curved-walk.bvh: error: unknown joint \"Hoof\""),
        "{}",
        stderr(&output)
    );
    let output = info(&["--joint", "paw=Hoof"]);
    assert_eq!(code(&output), 2);
    assert!(stderr(&output).contains("unknown role \"paw\": expected one of hips, "), "{}", stderr(&output));
}

#[test]
fn a_joint_belongs_to_one_skeleton() {
    let two = fs::read_to_string(project("tests/files/good/two-skeletons.bvh")).expect("a file");
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("two.bvh");
    // Both skeletons have the same names.
    fs::write(&path, two.replace("B:", "")).expect("a file");
    let path = path.to_str().expect("a path");
    let detect = |options: &[&str]| plantigrade(&[&["detect", path], options].concat());
    let labels = |output: &Output| -> Vec<Value> { serde_json::from_str(&stdout(output)).expect("JSON") };
    let detected = labels(&detect(&[]));
    assert_eq!(detected.len(), 2);

    let ambiguous = detect(&["--joint", "left_ankle=LeftLeg"]);
    assert_eq!(code(&ambiguous), 1);
    let message = "error: several joints are named \"LeftLeg\": use 1/LeftLeg or 2/LeftLeg";
    assert!(stderr(&ambiguous).contains(message), "{}", stderr(&ambiguous));
    for (skeleton, other) in [(0, 1), (1, 0)] {
        let name = format!("left_toe={}/LeftFoot", skeleton + 1);
        let overridden = labels(&detect(&["--joint", &name]));
        assert_eq!(overridden[skeleton]["joints"]["left"]["toe"], "LeftFoot");
        assert_eq!(overridden[other], detected[other]);
    }
    // Commands that describe one skeleton describe the one of the named joint.
    let info = plantigrade(&["info", "--format", "json", path, "--joint", "left_toe=2/LeftFoot"]);
    let info: Value = serde_json::from_str(&stdout(&info)).expect("JSON");
    assert_eq!(info["roles"]["left_toe"], "LeftFoot");
    for unknown in ["left_toe=3/LeftFoot", "left_toe=0/LeftFoot", "left_toe=Spine/LeftFoot"] {
        assert!(stderr(&detect(&["--joint", unknown])).contains("unknown joint"), "{unknown}");
    }
    let single = project("tests/files/good/plain.bvh");
    let single = single.to_str().expect("a path");
    let info = plantigrade(&["info", single, "--joint", "left_toe=LeftLeg/LeftFoot"]);
    assert!(stdout(&info).contains("toe LeftFoot"), "{}", stdout(&info));
}

#[test]
fn joint_names_in_documents_are_readable_and_their_bytes_recoverable() {
    let output = plantigrade(&["detect", "good/shift-jis-names.bvh", "--joint", "left_ankle=左ひざ"]);
    let document: Value = serde_json::from_str(&stdout(&output)).expect("JSON");
    assert_eq!(document["joints"]["left"]["heel"], "左ひざ");
    assert_eq!(document["source"]["name_encoding"], "Shift_JIS");
    let output = plantigrade(&["detect", "good/plain.bvh"]);
    assert!(!stdout(&output).contains("name_encoding"));
}

#[test]
fn folders_are_read_without_companion_files_of_macos() {
    let folder = tempfile::tempdir().expect("a folder");
    let (clips, out) = (folder.path().join("clips"), folder.path().join("out"));
    let plain = fs::read(project("tests/files/good/plain.bvh")).expect("a file");
    for (name, bytes) in [
        ("walk.bvh", &plain[..]),
        ("._walk.bvh", b"\0\x05\x16\x07"),
        ("take 1/._walk.BVH", b"\0\x05\x16\x07"),
        ("__MACOSX/walk.bvh", b"\0\x05\x16\x07"),
    ] {
        let path = clips.join(name);
        fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
        fs::write(path, bytes).expect("a file");
    }
    let [clips, out] = [clips, out].map(|path| path.to_str().expect("a path").to_owned());
    let output = plantigrade(&["detect", &clips, "--out", &out]);
    assert_eq!((code(&output), stderr(&output)), (0, String::new()));
    assert!(Path::new(&out).join("walk.plants.json").is_file());
    // A file that is named is read.
    let output = plantigrade(&["info", &format!("{clips}/._walk.bvh")]);
    assert!(stderr(&output).contains("binary data"), "{}", stderr(&output));
}

#[test]
fn a_closed_pipe_ends_the_program_quietly() {
    let folder = tempfile::tempdir().expect("a folder");
    for extension in ["bvh", "json"] {
        let name = format!("curved-walk.{extension}");
        fs::copy(project("samples").join(&name), folder.path().join(&name)).expect("a sample");
    }
    let folder = folder.path().to_str().expect("a path");
    for args in [
        &["info", folder][..],
        &["info", folder, "--format", "json"],
        &["detect", folder],
        &["segment", folder],
        &["gait", folder],
        &["gait", folder, "--format", "csv"],
        &["score", folder],
    ] {
        let (reader, writer) = std::io::pipe().expect("a pipe");
        drop(reader);
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_plantigrade"));
        let output = command.args(args).stdout(writer).output().expect("the program runs");
        assert_eq!((code(&output), stderr(&output)), (141, String::new()), "{args:?}");
    }
    // So does a closed pipe of the messages.
    let (reader, writer) = std::io::pipe().expect("a pipe");
    drop(reader);
    let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_plantigrade"));
    let output = command.args(["info", "missing.bvh"]).stderr(writer).output().expect("the program runs");
    assert_eq!((code(&output), stdout(&output)), (1, String::new()));
}

#[test]
fn files_are_read_or_rejected_as_listed_in_expected_txt() {
    let expected = fs::read_to_string(project("tests/files/expected.txt")).expect("the list");
    for line in expected.lines().filter(|line| line.starts_with("good") || line.starts_with("bad")) {
        let file = &line[..line.find(".bvh").expect("a file") + 4];
        let (location, result) = line[file.len()..].split_once(": ").expect("a result");
        if file.starts_with("bad") {
            let output = plantigrade(&["info", "--format", "json", file]);
            assert_eq!((code(&output), stdout(&output)), (1, String::new()), "{line}");
            let (_, message) = result.split_once(": ").expect("a message");
            let expected = format!("{file}{location}: error: {message}.");
            assert!(stderr(&output).starts_with(&expected), "{line}\n{}", stderr(&output));
            assert_eq!(stderr(&output).lines().count(), 1, "one line per failure");
        } else if file.split('/').count() == 2 {
            let output = plantigrade(&["info", "--format", "json", file]);
            let info: Value = serde_json::from_str(&stdout(&output)).expect(line);
            let mut notices = info["notices"].as_array().expect("a list").iter().map(|notice| {
                let code = notice["code"].as_str().expect("a code");
                match notice["line"].as_u64() {
                    Some(line) => format!(", {code} {line}:{}", notice["column"]),
                    None => format!(", {code}"),
                }
            });
            let listed = result.split(", ").count() - 1;
            let described: String = notices.by_ref().take(listed).collect();
            assert_eq!(format!("{} frames{described}", info["frames"]), result, "{file}");
            // Detection uses one of several skeletons.
            assert!(notices.all(|notice| notice == ", several-roots"), "{file}");
            assert_eq!(info["roles"]["left_toe"], "LeftToeBase", "{line}");
        }
    }
}

#[test]
fn detect_writes_all_formats() {
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
    assert!(events.starts_with("time,frame,context,event,uncertainty_ms\n"));
    let times = |events: &str| -> Vec<f64> {
        events.lines().skip(1).filter_map(|line| line.split(',').next()?.parse().ok()).collect()
    };
    assert!(times(&events).is_sorted() && times(&events).iter().any(|time| (time * 120.0).fract() > 0.1));
    let frames_only = detect("events", "paper");
    assert!(frames_only.lines().skip(1).all(|line| line.ends_with(',')));
    let frames: Vec<usize> = events
        .lines()
        .skip(1)
        .map(|line| line.split(',').nth(1).and_then(|f| f.parse().ok()).expect(line))
        .collect();
    assert!(frames.is_sorted() && !frames.is_empty());
    let part_events = detect("part-events", "robust");
    assert!(times(&part_events).is_sorted());
    assert!(events.lines().all(|line| part_events.contains(line)));
    let names: Vec<&str> = part_events
        .lines()
        .filter(|line| line.contains("Left"))
        .filter_map(|line| line.split(',').nth(3))
        .collect();
    let stance = ["Foot Strike", "Heel Strike", "Toe Strike", "Foot Flat", "Heel Off", "Toe Off", "Foot Off"];
    assert!(names.windows(7).any(|events| events == stance), "{names:?}");

    let json: Value = serde_json::from_str(&detect("json", "robust")).expect("JSON");
    assert_eq!((&json["format"], &json["version"]), (&"plantigrade-labels".into(), &1.into()));
    assert_eq!((&json["frames"], &json["method"]["name"]), (&245.into(), &"robust".into()));
    assert_eq!(json["source"]["sha256"].as_str().map(str::len), Some(64));
    assert_eq!(json["left"]["contact"][0]["source"], "auto");
    let time = |instant: &Value| instant["time_s"].as_f64().expect("a time");
    let (contact, heel, toe) =
        (&json["left"]["contact"][1], &json["left"]["heel"][1], &json["left"]["toe"][1]);
    assert_eq!(
        (&heel["strike"], &toe["strike"], &toe["off"]),
        (&contact["strike"], &contact["flat"], &contact["off"])
    );
    assert!(time(&contact["strike"]) < time(&contact["flat"]) && time(&contact["flat"]) < time(&heel["off"]));
}

#[test]
fn detect_adds_a_root_column_for_several_skeletons() {
    let output = plantigrade(&["detect", "--format", "csv", "good/two-skeletons.bvh"]);
    let table = stdout(&output);
    assert!(table.starts_with("root,frame,time,left_contact,"));
    assert_eq!(table.lines().filter(|line| line.starts_with("B:Hips,")).count(), 12);
}

#[test]
fn detect_reads_standard_input() {
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
fn detect_processes_folders_despite_failures_and_reuses_results() {
    let out = tempfile::tempdir().expect("a folder");
    let folder = out.path().to_str().expect("a path");
    // The folders contain further files in folders of their own.
    let inputs = tempfile::tempdir().expect("a folder");
    for kind in ["good", "bad"] {
        for entry in fs::read_dir(project("tests/files").join(kind)).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_file() {
                fs::copy(&path, inputs.path().join(path.file_name().expect("a name"))).expect("a copy");
            }
        }
    }
    let inputs = inputs.path().to_str().expect("a path");
    let run = |more: &[&str]| {
        plantigrade(&[&["detect", inputs, "--format", "csv", "--out", folder], more].concat())
    };
    let output = run(&[]);
    assert_eq!((code(&output), stdout(&output)), (1, String::new()));
    // Nine files are invalid, and one has no motion.
    assert_eq!(stderr(&output).lines().count(), 10);
    let modification_times = || {
        let files = fs::read_dir(out.path()).expect("a folder").filter_map(Result::ok);
        let tables = files.filter(|file| file.file_name().to_string_lossy().ends_with(".csv"));
        tables
            .map(|file| file.metadata().and_then(|data| data.modified()).expect("a time"))
            .collect::<Vec<_>>()
    };
    let first = modification_times();
    assert_eq!(first.len(), 15);
    run(&[]);
    assert_eq!(modification_times(), first, "results are reused");
    run(&["--r", "0.002"]);
    assert_ne!(modification_times(), first, "other parameters change the results");
    let second = modification_times();
    run(&["--r", "0.002", "--force"]);
    assert_ne!(modification_times(), second);
}

#[test]
fn score_compares_plants_with_truth() {
    let output = plantigrade(&["score", "../../samples", "--part", "contact"]);
    assert_eq!((code(&output), stderr(&output)), (0, String::new()));
    let text = stdout(&output);
    let pooled = text.lines().find(|line| line.starts_with("all frames ")).expect(&text);
    let accuracies: Vec<f64> = pooled.split_whitespace().filter_map(|word| word.parse().ok()).collect();
    assert!(accuracies.len() == 5 && accuracies.is_sorted() && accuracies[3] > 98.0, "{pooled}");
    assert!(text.contains("frog-jumps") && text.contains("F1 0.9"), "{text}");
    assert_eq!(code(&plantigrade(&["score", "good"])), 2);
}

#[test]
fn segment_writes_all_formats() {
    let segment = |format: &str, method: &str| {
        let args = ["segment", "../../samples/limp-to-run.bvh", "--format", format, "--method", method];
        let output = plantigrade(&args);
        assert_eq!((code(&output), stderr(&output)), (0, String::new()), "{method}");
        stdout(&output)
    };
    let json: Value = serde_json::from_str(&segment("json", "auto")).expect("JSON");
    assert_eq!((&json["format"], &json["version"]), (&"plantigrade-segments".into(), &1.into()));
    assert_eq!((&json["method"]["name"], &json["segments"][0]["source"]), (&"auto".into(), &"auto".into()));
    let (frames, rate) = (json["frames"].as_u64().expect("frames") as usize, json["rate"].as_f64());
    for method in ["auto", "lsd", "pca", "pca-tail", "ppca"] {
        let table = segment("csv", method);
        let mut lines = table.lines();
        assert_eq!(
            lines.next(),
            Some("start_frame,end_frame,start_s,end_s,kind,label,action,period_s,cycles")
        );
        let end = lines.fold(0, |end, line| {
            let fields: Vec<&str> = line.split(',').collect();
            assert_eq!((fields.len(), fields[0]), (9, end.to_string().as_str()), "{method}: {line}");
            fields[1].parse().expect(line)
        });
        assert_eq!(end, frames, "{method}");
        // Every format can be read back.
        let read = |text: &str| formats::read_segments(text, "limp-to-run", frames, rate.expect("a rate"));
        let segments = read(&table).expect(method);
        assert_eq!(read(&segment("json", method)).as_ref(), Ok(&segments));
        let cuts = |segments: &[Segment]| segments.iter().map(|s| s.frames.clone()).collect::<Vec<_>>();
        assert_eq!(cuts(&read(&segment("babel", method)).expect(method)), cuts(&segments));
    }
}

#[test]
fn segment_names_the_actions_of_all_clips_together() {
    let folder = tempfile::tempdir().expect("a folder");
    let samples = [("a", "frog-jumps"), ("b", "skipping"), ("c", "frog-jumps"), ("d", "straight-jog")];
    for (name, sample) in samples {
        let copy = folder.path().join(name).with_extension("bvh");
        fs::copy(format!("../../samples/{sample}.bvh"), copy).expect("copied");
    }
    let path = |name: &str| folder.path().join(name).to_str().expect("UTF-8").to_owned();
    let run = |out: &str, clips: &[&str]| {
        let clips: Vec<String> = clips.iter().map(|name| path(&format!("{name}.bvh"))).collect();
        let clips: Vec<&str> = clips.iter().map(String::as_str).collect();
        let output = plantigrade(&[&["segment", "--out", &path(out)], &clips[..]].concat());
        assert_eq!((code(&output), stderr(&output)), (0, String::new()));
    };
    let result = |out: &str, name: &str| {
        fs::read_to_string(format!("{}/{name}.segments.json", path(out))).expect("a result")
    };
    let actions = |out: &str, name: &str| -> Vec<String> {
        let document: Value = serde_json::from_str(&result(out, name)).expect("JSON");
        let segments = document["segments"].as_array().expect("a list").iter();
        segments.map(|segment| segment["action"].as_str().expect("a name").into()).collect()
    };
    run("all", &["a", "b", "c", "d"]);
    assert_eq!(actions("all", "a")[0], "A");
    assert_eq!(actions("all", "a"), actions("all", "c"));
    // Frog jumps and skipping differ; the actor stands still before and after both.
    assert!(!actions("all", "a").contains(&actions("all", "b")[1]));
    // A batch that is continued has the same results.
    run("continued", &["b", "a"]);
    assert_eq!(actions("continued", "b")[0], "A");
    run("continued", &["a", "b", "c", "d"]);
    fs::remove_file(format!("{}/b.segments.json", path("continued"))).expect("removed");
    run("continued", &["a", "b", "c", "d"]);
    for name in ["a", "b", "c", "d"] {
        assert_eq!(result("continued", name), result("all", name), "{name}");
    }
}

#[test]
fn segment_adds_a_root_column_for_several_skeletons() {
    let segment = |format| stdout(&plantigrade(&["segment", "good/two-skeletons.bvh", "--format", format]));
    let table = segment("csv");
    assert!(table.starts_with("root,start_frame,"), "{table}");
    assert!(table.lines().any(|line| line.starts_with("B:Hips,0,")), "{table}");
    let json: Value = serde_json::from_str(&segment("json")).expect("JSON");
    assert_eq!(json[1]["root"], "B:Hips");
}

#[test]
fn segment_fails_only_for_clips_without_motion() {
    let out = tempfile::tempdir().expect("a folder");
    let folder = out.path().to_str().expect("a path");
    let files = ["good/no-motion.bvh", "good/plain.bvh"];
    let run = |more: &[&str]| plantigrade(&[&["segment"], &files[..], &["--out", folder], more].concat());
    let output = run(&[]);
    assert_eq!((code(&output), stdout(&output)), (1, String::new()));
    assert!(stderr(&output).starts_with("good/no-motion.bvh: error: the clip has no motion"));
    assert_eq!(stderr(&output).lines().count(), 1);
    // Labels of the same clip do not conflict with segments.
    plantigrade(&["detect", "good/plain.bvh", "--out", folder]);
    let modified = |name: &str| {
        let file = fs::metadata(out.path().join(name)).expect(name);
        file.modified().expect("a time")
    };
    let first = (modified("plain.plants.json"), modified("plain.segments.json"));
    run(&[]);
    assert_eq!((modified("plain.plants.json"), modified("plain.segments.json")), first, "results are reused");
    run(&["--published"]);
    assert_ne!(modified("plain.segments.json"), first.1, "other parameters change the results");
}

#[test]
fn score_compares_cuts_with_truth() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().to_str().expect("a path");
    let copy = |sample: &str, name: &str| {
        fs::copy(project("samples").join(sample), folder.path().join(name)).expect(sample);
    };
    // Truth in NAME.segments.json, in NAME.json, in segmentation.json next to labels, and none.
    for name in ["own.bvh", "named.bvh", "shared.bvh", "no-truth.bvh"] {
        copy("limp-to-run.bvh", name);
    }
    copy("limp-to-run.json", "shared.json");
    let clips = ["own.bvh", "named.bvh"].map(|name| folder.path().join(name).display().to_string());
    let output = plantigrade(&["segment", &clips[0], &clips[1], "--out", path]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    fs::rename(folder.path().join("named.segments.json"), folder.path().join("named.json")).expect("moved");
    let text = fs::read(folder.path().join("own.segments.json")).expect("a document");
    let document: Value = serde_json::from_slice(&text).expect("JSON");
    let (frames, segments) = (document["frames"].as_u64().expect("frames"), &document["segments"]);
    let cuts = segments.as_array().expect("a list").len() - 1;
    assert!(cuts > 0, "limp and run are separated");
    // The truth has only the first cut, with a range; all other cuts are false positives.
    let cut = segments[0]["end"].as_u64().expect("a frame");
    let truth = serde_json::json!({"_meta": {}, "shared": [
        {"start": 1, "end": cut, "label": "limp", "cut_earliest": cut - 3, "cut_latest": cut + 3},
        {"start": cut + 1, "end": frames, "label": "run"},
    ]});
    fs::write(folder.path().join("segmentation.json"), truth.to_string()).expect("written");

    let output = plantigrade(&["score", path, "--cuts"]);
    assert_eq!((code(&output), stderr(&output)), (0, String::new()));
    let text = stdout(&output);
    let row = |name: &str| -> Vec<&str> {
        let line = text.lines().find_map(|line| line.strip_prefix(name));
        line.expect(&text).split_whitespace().collect()
    };
    let all = cuts.to_string();
    for name in ["own ", "named "] {
        let perfect = [&[all.as_str(), &all][..], &["1.000"; 6], &["-"; 3]].concat();
        assert_eq!(row(name), perfect, "{text}");
    }
    assert_eq!((row("shared ")[1], row("shared ")[3], row("shared ")[9]), ("1", "1.000", "1.000"), "{text}");
    assert_eq!(row("all cuts ")[1], (2 * cuts + 1).to_string());
    assert!(!text.contains("no-truth"));
    assert_eq!(code(&plantigrade(&["score", path, "--cuts", "--method", "pca-tail", "--dims", "3"])), 0);
    let classes = plantigrade(&["score", path, "--cuts", "--classes"]);
    let classes = stdout(&classes).split_once("\nclasses: ").expect("a second table").1.to_owned();
    for name in ["own ", "named "] {
        let line = classes.lines().find(|line| line.starts_with(name)).expect(&classes);
        assert!(line.ends_with("     1.000   1.000"), "{classes}");
    }
    assert!(classes.lines().any(|line| line.starts_with("all frames ")), "{classes}");

    let other = serde_json::json!({"shared": [{"start": 1, "end": 9}]});
    fs::write(folder.path().join("segmentation.json"), other.to_string()).expect("written");
    let output = plantigrade(&["score", path, "--cuts"]);
    assert_eq!(code(&output), 1);
    assert!(stderr(&output).contains("segmentation.json: error: the file has 9 frames"));
}

#[test]
fn all_methods_detect() {
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
fn invalid_command_lines_exit_with_2_and_failed_inputs_with_1() {
    for args in [
        &["detect"][..],
        &["detect", "good/plain.bvh", "--method", "best"],
        &["detect", "good/plain.bvh", "--r", "0"],
        &["detect", "good/plain.bvh", "--up", "w"],
        &["detect", "good/plain.bvh", "--fps", "-3"],
        &["detect", "good"],
        &["detect", "../files"],
        &["info", "good/plain.bvh", "--format", "xml"],
        &["segment", "good/plain.bvh", "--method", "robust"],
        &["segment", "good/plain.bvh", "--dims", "0"],
        &["segment", "good/plain.bvh", "--residual", "none"],
        &["segment", "good/plain.bvh", "--template", "-1"],
        &["segment", "good"],
        &["score", "good", "--cuts"],
        &["score", "../../samples", "--dims", "2"],
        &["score", "../../samples", "--cuts", "--r", "0.001"],
        &["score", "../../samples", "--cuts", "--part", "toe"],
        &["score", "../../samples", "--cuts", "--method", "robust"],
        &["score", "../../samples", "--method", "lsd"],
        &["gait", "good/plain.bvh", "--labels", "labels.json", "--method", "paper"],
        &["gait", "good/plain.bvh", "--labels", "labels.json", "--r", "0.001"],
    ] {
        let output = plantigrade(args);
        assert_eq!((code(&output), stdout(&output)), (2, String::new()), "{args:?}");
        assert!(stderr(&output).starts_with("error: "), "{args:?}: {}", stderr(&output));
    }
    for (rate, message) in [
        ("0.0083333", "0.0083333 looks like a frame time: did you mean --fps 120?"),
        ("1e-6", "must be a number from 1 to 1000"),
        ("1e300", "must be a number from 1 to 1000"),
    ] {
        for command in [&["info", "good/plain.bvh"][..], &["clean", "good/plain.bvh", "-o", "none.bvh"]] {
            let output = plantigrade(&[command, &["--fps", rate]].concat());
            assert_eq!((code(&output), stdout(&output)), (2, String::new()), "{rate}");
            assert!(stderr(&output).contains(message), "{rate}: {}", stderr(&output));
        }
    }
    for args in [
        &["detect", "--r", "-1"][..],
        &["detect", "--w", "-1"],
        &["detect", "--sigma", "-1"],
        &["detect", "--height", "-0.1"],
        &["detect", "--speed", "-0.1"],
        &["detect", "--unit", "-1"],
        &["detect", "--jobs", "-1"],
        &["segment", "--dims", "-1"],
        &["segment", "--template", "-1"],
        &["gait", "--jobs", "-1"],
    ] {
        let output = plantigrade(&[args, &["good/plain.bvh"]].concat());
        assert_eq!((code(&output), stdout(&output)), (2, String::new()), "{args:?}");
        assert!(!stderr(&output).contains("unexpected argument"), "{args:?}: {}", stderr(&output));
    }
    for folder in ["nowhere", "-"] {
        let output = plantigrade(&["score", folder]);
        assert_eq!((code(&output), stdout(&output)), (2, String::new()), "{folder}");
        assert!(stderr(&output).contains("does not exist: name a folder of clips"), "{}", stderr(&output));
    }
    let output = plantigrade(&["info", "nowhere.bvh"]);
    assert_eq!(code(&output), 1);
    assert!(stderr(&output).starts_with("nowhere.bvh: error: "));
}
