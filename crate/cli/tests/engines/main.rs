//! Tests of exports for game engines: the scripts are executed against stubs of the documented functions of
//! the engines. Tests are ignored where Python, or a compiler and runtime of C#, are missing.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use libtest_mimic::{Arguments, Trial};
use serde_json::Value;

fn main() {
    let arguments = Arguments::from_args();
    let test = |name: &str, run: fn(), is_runnable: bool| {
        let run = move || {
            run();
            Ok(())
        };
        Trial::test(name, run).with_ignored_flag(!is_runnable)
    };
    let runs = |program: &str| Command::new(program).arg("--version").output().is_ok();
    let (python, mono) = (runs("python3"), runs("mcs") && runs("mono"));
    let tests = vec![
        test("unreal_script_adds_and_removes_events_at_any_rate", unreal_script, python),
        test("unreal_script_scales_times_to_the_animation", unreal_script_scales, python),
        test("unreal_curves_equal_the_labels", unreal_curves, python),
        test("unity_script_adds_and_removes_events_at_any_rate", unity_script, mono),
        test("unity_events_of_a_part_of_a_take_are_those_of_the_part", unity_part_of_take, mono),
        test("unreal_script_adds_and_removes_segments", unreal_segments, python),
        test("unity_script_adds_and_removes_segments", unity_segments, mono),
        test("scripts_of_several_skeletons_name_the_roots", several_skeletons, true),
    ];
    libtest_mimic::run(&arguments, tests).exit();
}

/// Frame rates of the clips, in Hz.
const RATES: [&str; 4] = ["24", "30", "60", "120"];

fn project(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path)
}

/// Returns the result of `detect` for a clip.
fn detect(clip: &str, format: &str, rate: &str) -> String {
    output_of("detect", clip, format, rate)
}

/// Returns the result of a command for a clip.
fn output_of(command: &str, clip: &str, format: &str, rate: &str) -> String {
    let arguments = [command, clip, "--format", format, "--fps", rate];
    let mut command = assert_cmd::Command::cargo_bin("plantigrade").expect("the binary");
    let output = command.current_dir(project("samples")).args(arguments).output().expect("the program runs");
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
    String::from_utf8(output.stdout).expect("text")
}

/// Returns the events of a clip: time in seconds and name, in order of time.
fn expected(clip: &str, rate: &str) -> Vec<(f64, String)> {
    let table = detect(clip, "part-events", rate);
    let mut rows = table.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let head = rows.next().expect("a head");
    let column = |name: &str| head.iter().position(|other| *other == name).expect(name);
    let (time, context, label) = (column("time"), column("context"), column("event"));
    rows.map(|row| {
        let name = format!("{}_{}", row[label].replace(' ', ""), &row[context][..1]);
        (row[time].parse().expect("a time"), name)
    })
    .collect()
}

/// Duration of a clip of some frames, from the first to the last, in seconds.
fn duration(clip: &str, rate: &str) -> f64 {
    let frames = detect(clip, "csv", rate).lines().count() - 1;
    (frames - 1) as f64 / rate.parse::<f64>().expect("a rate")
}

/// Asserts that events have the expected names, and times within half a frame.
fn assert_events(found: &[(f64, String)], expected: &[(f64, String)], rate: &str) {
    assert!(expected.len() > 8, "{expected:?}");
    let sorted = |events: &[(f64, String)]| {
        let mut by_name: BTreeMap<String, Vec<f64>> = BTreeMap::new();
        for (time, name) in events {
            by_name.entry(name.clone()).or_default().push(*time);
        }
        by_name
    };
    let (found, expected) = (sorted(found), sorted(expected));
    assert_eq!(found.keys().collect::<Vec<_>>(), expected.keys().collect::<Vec<_>>());
    let half_frame = 0.5 / rate.parse::<f64>().expect("a rate") + 1e-4;
    for (name, times) in &expected {
        assert_eq!(times.len(), found[name].len(), "{name}");
        for (time, found) in times.iter().zip(&found[name]) {
            assert!((time - found).abs() <= half_frame, "{name} at {time}: {found} ({rate} Hz)");
        }
    }
}

/// Runs a script for Unreal on an animation of `length` seconds.
fn run_unreal(script: &str, length: f64) -> Value {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("clip.unreal.py"), script).expect("a script");
    let mut command = Command::new("python3");
    command.arg("-c").arg(include_str!("unreal_stub.py")).arg(length.to_string());
    let output = command.current_dir(folder.path()).output().expect("Python runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).expect("JSON")
}

/// Returns the entries of a list of a run that the script has added: time and name.
fn added(run: &Value, list: &str) -> Vec<(f64, String)> {
    let entries = run[list].as_array().expect("a list").iter();
    let of_script = entries.filter(|entry| entry[2] == "Plantigrade");
    of_script
        .map(|entry| (entry[1].as_f64().expect("a time"), entry[0].as_str().expect("a name").into()))
        .collect()
}

fn unreal_script() {
    for rate in RATES {
        let state = run_unreal(&detect("curved-walk.bvh", "unreal", rate), duration("curved-walk.bvh", rate));
        let events = expected("curved-walk.bvh", rate);
        let strikes: Vec<_> =
            events.iter().filter(|(_, name)| name.starts_with("FootStrike")).cloned().collect();
        for run in &state["runs"].as_array().expect("runs")[..2] {
            assert_events(&added(run, "notifies"), &events, rate);
            let markers = added(run, "markers");
            assert_eq!(markers.len(), strikes.len());
            assert!(markers.iter().all(|(_, name)| name.starts_with("FootStrike")));
            assert_eq!(run["curves"].as_object().expect("curves").len(), 7, "six parts and the other curve");
        }
        let removed = &state["runs"][2];
        assert!(added(removed, "notifies").is_empty() && added(removed, "markers").is_empty());
        assert_eq!(removed["notifies"].as_array().map(Vec::len), Some(1), "other notifies stay");
        assert_eq!(removed["markers"].as_array().map(Vec::len), Some(1));
        assert_eq!(removed["curves"].as_object().map(serde_json::Map::len), Some(1));
        assert_eq!(state["warnings"].as_array().map(Vec::len), Some(0));
    }
}

fn unreal_script_scales() {
    let (clip, rate) = ("curved-walk.bvh", "60");
    let state = run_unreal(&detect(clip, "unreal", rate), 2.0 * duration(clip, rate));
    let doubled: Vec<_> = expected(clip, rate).into_iter().map(|(time, name)| (2.0 * time, name)).collect();
    assert_events(&added(&state["runs"][1], "notifies"), &doubled, "30");
    assert_eq!(state["warnings"].as_array().map(Vec::len), Some(2), "one for each run that adds");
}

/// The value of each curve in the middle of each frame's neighbourhood equals the label.
fn unreal_curves() {
    let (clip, rate) = ("limp-to-run.bvh", "30");
    let state = run_unreal(&detect(clip, "unreal", rate), duration(clip, rate));
    let table = detect(clip, "csv", rate);
    let mut rows = table.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let head = rows.next().expect("a head");
    let rows: Vec<_> = rows.collect();
    for (part, side) in [("Heel", "left"), ("Toe", "right")] {
        let column = head.iter().position(|name| *name == format!("{side}_{}", part.to_lowercase()));
        let column = column.expect("a column");
        let name = format!("{part}_{}", side[..1].to_uppercase());
        let keys = state["runs"][1]["curves"][&name].as_array().expect("keys");
        for (frame, row) in rows.iter().enumerate() {
            let time = frame as f64 / 30.0;
            let before = keys.iter().rfind(|key| key[0].as_f64().expect("a time") <= time + 1e-9);
            let value = before.expect("a key at 0")[1].as_f64().expect("a value");
            let label: f64 = row[column].parse().expect("a label");
            let is_near_step = keys.iter().any(|key| (key[0].as_f64().expect("a time") - time).abs() < 0.001);
            // Instants of heel and toe may differ from their labels by some frames.
            let differs = value != label && !is_near_step;
            let near = keys.iter().any(|key| (key[0].as_f64().expect("a time") - time).abs() < 0.35);
            assert!(!differs || near, "{name} at frame {frame}");
        }
    }
}

/// Compiles a script for Unity and returns the output of its run on an animation of `length` seconds.
fn run_unity(script: &str, length: f64, options: &[&str]) -> String {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("clip.cs"), script).expect("a script");
    fs::write(folder.path().join("stub.cs"), include_str!("unity_stub.cs")).expect("a stub");
    let run = |program: &str, arguments: &[&str]| {
        let output = Command::new(program).args(arguments).current_dir(folder.path()).output();
        let output = output.expect("the program runs");
        let [text, errors] = [&output.stdout, &output.stderr].map(|bytes| String::from_utf8_lossy(bytes));
        assert!(output.status.success(), "{text}{errors}");
        text.into_owned()
    };
    run("mcs", &["-nologo", "-d:UNITY_EDITOR", "-out:test.exe", "clip.cs", "stub.cs"]);
    let length = length.to_string();
    run("mono", &[&["test.exe", length.as_str()], options].concat())
}

/// Returns the events of a line that the script has added, and the number of other events. Times are multiplied
/// by `unit`.
fn unity_events(list: &str, unit: f64) -> (Vec<(f64, String)>, usize) {
    let all = list.split(',').filter(|text| !text.is_empty()).map(|text| text.split(' ').collect::<Vec<_>>());
    let (own, others): (Vec<_>, Vec<_>) = all.partition(|words| words[1] == "OnFootEvent");
    let event = |words: &Vec<&str>| (unit * words[0].parse::<f64>().expect("a time"), words[2].to_owned());
    (own.iter().map(event).collect(), others.len())
}

fn unity_script() {
    for rate in RATES {
        let clip = "curved-walk.bvh";
        let length = duration(clip, rate);
        let output = run_unity(&detect(clip, "unity", rate), length, &[]);
        let events = expected(clip, rate);
        let lines: Vec<&str> = output.lines().collect();
        assert_eq!(lines.len(), 6);
        for (index, line) in lines.iter().enumerate() {
            let (kind, list) = line.split_once('|').expect("a kind");
            let (times, others) = unity_events(list, if kind == "model" { length } else { 1.0 });
            assert_eq!(others, usize::from(kind == "clip"), "other events stay");
            if index < 4 { assert_events(&times, &events, rate) } else { assert!(times.is_empty()) }
        }
    }
}

fn unity_part_of_take() {
    let (clip, rate) = ("curved-walk.bvh", "60");
    let length = duration(clip, rate);
    let output = run_unity(&detect(clip, "unity", rate), length, &["half"]);
    let model = output.lines().nth(1).and_then(|line| line.strip_prefix("model|")).expect("the model");
    let (times, _) = unity_events(model, length / 2.0);
    let second_half = expected(clip, rate).into_iter().map(|(time, name)| (time - length / 2.0, name));
    assert_events(&times, &second_half.filter(|(time, _)| *time >= 0.0).collect::<Vec<_>>(), rate);
}

/// Returns the segments of a clip: start and end in seconds, and name.
fn segments(clip: &str) -> Vec<(f64, f64, String)> {
    let table = output_of("segment", clip, "csv", "30");
    let mut rows = table.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let head = rows.next().expect("a head");
    let column = |name: &str| head.iter().position(|other| *other == name).expect(name);
    let (start, end, action) = (column("start_s"), column("end_s"), column("action"));
    let segments: Vec<_> = rows
        .map(|row| {
            let [start, end] = [start, end].map(|column| row[column].parse().expect("a time"));
            (start, end, row[action].to_owned())
        })
        .collect();
    assert!(segments.len() > 1, "{table}");
    segments
}

fn unreal_segments() {
    let clip = "limp-to-run.bvh";
    let length = duration(clip, "30");
    let state = run_unreal(&output_of("segment", clip, "unreal", "30"), length);
    let runs = state["runs"].as_array().expect("runs");
    for run in &runs[..2] {
        let states =
            run["notifies"].as_array().expect("notifies").iter().filter(|notify| notify[3].is_number());
        let found: Vec<_> = states.collect();
        let expected = segments(clip);
        assert_eq!(found.len(), expected.len());
        for (state, (start, end, name)) in found.iter().zip(expected) {
            assert_eq!(state[0], format!("Segment_{name}").as_str());
            let [at, lasts] = [1, 3].map(|index| state[index].as_f64().expect("a time"));
            assert!((at - start).abs() < 1e-4 && (at + lasts - end.min(length)).abs() < 1e-4, "{state}");
        }
    }
    assert_eq!(runs[2]["notifies"].as_array().map(Vec::len), Some(1), "other notifies stay");
}

fn unity_segments() {
    let clip = "limp-to-run.bvh";
    let length = duration(clip, "30");
    let output = run_unity(&output_of("segment", clip, "unity", "30"), length, &[]);
    let lines: Vec<&str> = output.lines().map(|line| line.strip_prefix("clips|").expect("clips")).collect();
    assert_eq!(lines.len(), 3);
    assert_eq!(lines[0], lines[1], "a second run changes nothing");
    let mut clips = lines[0].split(',').map(|text| text.splitn(4, ' ').collect::<Vec<_>>());
    assert_eq!(clips.next().expect("the take")[3], "walk", "other clips stay");
    let clips: Vec<_> = clips.collect();
    let expected = segments(clip);
    assert_eq!(clips.len(), expected.len());
    for (index, (words, (start, end, name))) in clips.iter().zip(expected).enumerate() {
        let [first, last] = [0, 1].map(|word| words[word].parse::<f64>().expect("a time"));
        assert!((first - start).abs() < 1e-3 && (last - end.min(length)).abs() < 1e-3, "{words:?}");
        assert_eq!(words[3], format!("limp-to-run - {} {name}", index + 1));
    }
    assert_eq!(lines[2].split(',').count(), 1, "only the take is left");
}

fn several_skeletons() {
    let script = detect("../tests/files/good/two-skeletons.bvh", "unreal", "30");
    assert!(script.contains("\"Hips_Contact_L\"") && script.contains("\"B_3aHips_Contact_R\""), "{script}");
    let script = detect("../tests/files/good/two-skeletons.bvh", "unity", "30");
    assert!(script.contains("static class FootEvents_two_2dskeletons_2ebvh"), "{script}");
    let script = output_of("segment", "../tests/files/good/two-skeletons.bvh", "unreal", "30");
    assert!(
        script.contains("\"Segment_Hips_20A\"") && script.contains("\"Segment_B_3aHips_20A\""),
        "{script}"
    );
}
