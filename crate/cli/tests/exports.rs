//! Tests of exports in other programs: NumPy, pandas and Blender scripts. Tests that need Python
//! or its modules are ignored where these are missing.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Output;

use assert_cmd::Command;
use libtest_mimic::{Arguments, Trial};
use plantigrade::foot::Part;
use plantigrade::formats;
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
    let (python, numpy) = (has_python("ast, json"), has_python("numpy, pandas"));
    let tests = vec![
        test("npz_archives_can_be_read_back", npz_archives_can_be_read_back, true),
        test("numpy_and_pandas_read_exports", numpy_and_pandas_read_exports, numpy),
        test("blender_script_adds_markers_and_keyframes", blender_script_adds_markers_and_keyframes, python),
        test("blender_script_escapes_file_names", blender_script_escapes_file_names, python),
        test("gait_writes_all_formats", gait_writes_all_formats, true),
        test("gait_writes_steps_angles_and_reports", gait_writes_steps_angles_and_reports, true),
        test(
            "gait_fails_only_for_clips_without_feet_or_motion",
            gait_fails_only_for_clips_without_feet_or_motion,
            true,
        ),
    ];
    libtest_mimic::run(&arguments, tests).exit();
}

fn project(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path)
}

fn plantigrade(args: &[&str]) -> Output {
    let mut command = Command::cargo_bin("plantigrade").expect("the binary");
    command.current_dir(project("samples")).args(args).output().expect("the program runs")
}

fn stdout(output: &Output) -> String {
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
    assert_eq!(output.status.code(), Some(0));
    String::from_utf8(output.stdout.clone()).expect("text")
}

/// Runs a script in `folder`, with the interpreter of `PLANTIGRADE_PYTHON` or `python3`.
fn run_python(script: &str, folder: &Path) -> std::io::Result<Output> {
    let program = std::env::var("PLANTIGRADE_PYTHON").unwrap_or_else(|_| "python3".into());
    std::process::Command::new(program).args(["-c", script]).current_dir(folder).output()
}

/// True if Python and the modules, separated by commas, are installed.
fn has_python(modules: &str) -> bool {
    run_python(&format!("import {modules}"), Path::new(".")).is_ok_and(|output| output.status.success())
}

/// Runs a script that must succeed.
fn python(script: &str, folder: &Path) {
    let output = run_python(script, folder).expect("Python runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

/// Exports the labels of the curved walk to a temporary folder, in the given formats.
fn exported(formats: &[&str]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    for format in formats {
        let path = folder.path().to_str().expect("a path");
        stdout(&plantigrade(&["detect", "curved-walk.bvh", "--format", format, "--out", path]));
    }
    folder
}

fn npz_archives_can_be_read_back() {
    let folder = exported(&["npz", "csv"]);
    let bytes = fs::read(folder.path().join("curved-walk.contacts.npz")).expect("an archive");
    let table = fs::read(folder.path().join("curved-walk.frames.csv")).expect("a table");
    let labels = formats::read_plants(&bytes, 245).expect("labels");
    assert_eq!(labels, formats::read_plants(&table, 245).expect("labels"));
    let piped = plantigrade(&["detect", "curved-walk.bvh", "--format", "npz"]);
    assert_eq!(piped.stdout, bytes);
    let toes = plantigrade(&["detect", "curved-walk.bvh", "--format", "npz", "--method", "paper"]);
    let toes = formats::read_plants(&toes.stdout, 245).expect("labels");
    assert_eq!(toes.parts.iter().map(|(part, _)| *part).collect::<Vec<_>>(), [Part::Toe]);
}

fn numpy_and_pandas_read_exports() {
    let folder = exported(&["npz", "csv"]);
    let path = folder.path().join("two.npz");
    let two = plantigrade(&["detect", "../tests/files/good/two-skeletons.bvh", "--format", "npz"]);
    fs::write(path, two.stdout).expect("written");
    let script = r#"
import numpy, pandas
arrays = numpy.load("curved-walk.contacts.npz")
assert list(arrays["columns"]) == ["left_heel", "left_toe", "right_heel", "right_toe"]
assert arrays["contacts"].shape == arrays["confidence"].shape == (245, 4)
assert arrays["contacts"].dtype == bool and arrays["confidence"].dtype == numpy.float32
assert (arrays["confidence"] >= 0.5).all() and arrays["source"] == "curved-walk.bvh"
frames = pandas.read_csv("curved-walk.frames.csv")
for table in ("contacts", "contact"):
    names = arrays["columns" if table == "contacts" else "contact_columns"]
    assert (frames[list(names)].to_numpy() == arrays[table]).all()
assert numpy.allclose(frames["time"], arrays["time"], atol=1e-6)
assert abs(arrays["rate"] - 120) < 0.01
two = numpy.load("two.npz")
assert two["contacts"].shape == (2, 12, 4) and list(two["roots"])[1] == "B:Hips"
names = ["right_toe", "left_toe"]
for save, name in [(numpy.savez, "stored.npz"), (numpy.savez_compressed, "packed.npz")]:
    save(name, contacts=frames[names].to_numpy(), columns=numpy.array(names))
"#;
    python(script, folder.path());
    let table = fs::read(folder.path().join("curved-walk.frames.csv")).expect("a table");
    let table = formats::read_plants(&table, 245).expect("labels");
    for name in ["stored.npz", "packed.npz"] {
        let bytes = fs::read(folder.path().join(name)).expect(name);
        let labels = formats::read_plants(&bytes, 245).expect(name);
        assert_eq!(labels.part(Part::Toe), table.part(Part::Toe), "{name}");
    }
}

/// Mock of the Blender API that runs the exported script and checks markers and keyframes.
const BLENDER: &str = r#"
import json, sys, types

class Curve:
    def __init__(self, path):
        self.data_path, self.keyframe_points = path, []

class Armature(dict):
    type, animation_data = "ARMATURE", None
    def keyframe_insert(self, data_path, frame):
        if self.animation_data is None:
            self.animation_data = types.SimpleNamespace(action=types.SimpleNamespace(fcurves=[]))
        curves = self.animation_data.action.fcurves
        curve = next((curve for curve in curves if curve.data_path == data_path), None)
        if curve is None:
            curves.append(curve := Curve(data_path))
        value = self[json.loads(data_path[1:-1])]
        curve.keyframe_points.append(types.SimpleNamespace(co=(frame, value), interpolation="BEZIER"))

class Markers(list):
    def new(self, name, frame):
        self.append(types.SimpleNamespace(name=name, frame=frame))

armature, markers = Armature(), Markers()
render = types.SimpleNamespace(fps=24, fps_base=1.0)
bpy = types.ModuleType("bpy")
bpy.context = types.SimpleNamespace(
    object=armature, scene=types.SimpleNamespace(render=render, timeline_markers=markers))
bpy.utils = types.SimpleNamespace(escape_identifier=lambda name: json.dumps(name)[1:-1])
sys.modules["bpy"] = bpy
script = open("curved-walk.blender.py", encoding="utf-8").read()
# A second run changes nothing.
for _ in range(2):
    exec(script, {})

events = [line.split(",") for line in open("curved-walk.events.csv").read().split("\n")[1:-1]]
assert [(m.frame, m.name) for m in markers] == [(int(e[1]) + 1, e[2] + " " + e[3]) for e in events]
rows = [line.split(",") for line in open("curved-walk.frames.csv").read().split("\n")[:-1]]
curves = {curve.data_path[2:-2]: curve.keyframe_points for curve in armature.animation_data.action.fcurves}
assert sorted(curves) == sorted(rows[0][2:]), curves.keys()
for name, keys in curves.items():
    assert all(key.interpolation == "CONSTANT" for key in keys)
    column = rows[0].index(name)
    for row in rows[1:]:
        frame = int(row[0]) + 1
        assert [key.co[1] for key in keys if key.co[0] <= frame][-1] == int(row[column]), (name, frame)
"#;

fn blender_script_adds_markers_and_keyframes() {
    let folder = exported(&["blender", "csv", "events"]);
    let script = fs::read_to_string(folder.path().join("curved-walk.blender.py")).expect("a script");
    assert!(script.contains("FRAME_START = 1\n") && script.contains("SOURCE = \"curved-walk.bvh\"\n"));
    python(BLENDER, folder.path());
}

fn blender_script_escapes_file_names() {
    let folder = tempfile::tempdir().expect("a folder");
    let name = "\"] + [exit(3)] #\\' é.bvh";
    // Some file systems reject such names.
    if fs::copy(project("samples/bowling.bvh"), folder.path().join(name)).is_err() {
        return;
    }
    let path = folder.path().join(name);
    let script = plantigrade(&["detect", path.to_str().expect("a path"), "--format", "blender"]);
    fs::write(folder.path().join("script.py"), stdout(&script)).expect("written");
    let check = r#"
import ast
tree = ast.parse(open("script.py", encoding="ascii").read())
named = {node.targets[0].id: node.value for node in tree.body if isinstance(node, ast.Assign)}
assert ast.literal_eval(named["SOURCE"]) == "\"] + [exit(3)] #\\' é.bvh"
for name in ("RATE", "FRAMES", "FRAME_START", "EVENTS", "PLANTS"):
    ast.literal_eval(named[name])
"#;
    python(check, folder.path());
}

fn gait_writes_all_formats() {
    let json: Value =
        serde_json::from_str(&stdout(&plantigrade(&["gait", "curved-walk.bvh", "--format", "json"])))
            .expect("JSON");
    let cadence = json["gait"]["cadence_steps_per_min"].as_f64().expect("a cadence");
    assert!((100.0..125.0).contains(&cadence), "{json:#}");
    assert_eq!((&json["path"], &json["method"]), (&"curved-walk.bvh".into(), &"robust".into()));

    let table =
        stdout(&plantigrade(&["gait", "curved-walk.bvh", "bowling.bvh", "--format", "csv", "--jobs", "2"]));
    let rows: Vec<Vec<&str>> = table.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(rows.len(), 3);
    assert!(rows.iter().all(|row| row.len() == rows[0].len()));
    let column = |name: &str| rows[0].iter().position(|other| *other == name).expect(name);
    assert_eq!((rows[1][0], rows[2][0]), ("curved-walk.bvh", "bowling.bvh"), "in input order");
    let value: f64 = rows[1][column("cadence_steps_per_min")].parse().expect("a number");
    assert!((value - cadence).abs() < 1e-6);
    for name in ["left_stance_s", "right_step_width_m", "double_support_share", "flight_share_count"] {
        rows[1][column(name)].parse::<f64>().expect(name);
    }

    let text = stdout(&plantigrade(&["gait", "curved-walk.bvh", "frog-jumps.bvh"]));
    assert!(text.contains("cadence") && text.contains("double support"), "{text}");
    assert!(text.contains("frog-jumps.bvh\n  no complete strides"), "{text}");
    let still = stdout(&plantigrade(&["gait", "frog-jumps.bvh", "--format", "json"]));
    let still: Value = serde_json::from_str(&still).expect("JSON");
    assert!(still["gait"]["cadence_steps_per_min"].is_null());
}

fn gait_writes_steps_angles_and_reports() {
    let folder = tempfile::tempdir().expect("a folder");
    let lines = |format: &str| {
        let text = stdout(&plantigrade(&["gait", "limp-to-run.bvh", "--format", format]));
        text.lines().map(str::to_owned).collect::<Vec<_>>()
    };
    let steps = lines("steps");
    assert!(steps[0].starts_with("foot,strike_frame,strike_s,") && steps.len() > 60, "{}", steps[0]);
    let angles = lines("angles");
    assert!(angles[0].starts_with("percent,left_hip_flexion_deg,") && angles.len() == 102, "{}", angles[0]);

    let json = stdout(&plantigrade(&["gait", "limp-to-run.bvh", "--per-action", "--format", "json"]));
    let json: Value = serde_json::from_str(&json).expect("JSON");
    assert_eq!(json["steps"].as_array().map(Vec::len), Some(steps.len() - 1));
    assert_eq!(json["curves"]["knee_flexion"]["left"]["mean"].as_array().map(Vec::len), Some(101));
    let cadence = |gait: &Value| gait["gait"]["cadence_steps_per_min"].as_f64().expect("a cadence");
    let actions = json["actions"].as_array().expect("actions");
    assert_eq!(actions[0]["name"], "A");
    assert!(cadence(&actions[0]) + 20.0 < cadence(&json) && cadence(&json) + 20.0 < cadence(&actions[1]));

    // A file, which has its name, or a folder with a file per clip.
    let file = folder.path().join("report.html");
    let out = file.to_str().expect("a name");
    stdout(&plantigrade(&["gait", "limp-to-run.bvh", "--report", "html", "-o", out]));
    let report = fs::read_to_string(&file).expect("a report");
    assert!(report.contains("<h1>limp-to-run.bvh</h1>") && report.contains("Knee flexion"), "{report}");
    let pages = folder.path().join("reports");
    let out = pages.to_str().expect("a name");
    let args = ["gait", "limp-to-run.bvh", "curved-walk.bvh", "--per-action", "--report", "html", "-o", out];
    stdout(&plantigrade(&args));
    let report = fs::read_to_string(pages.join("limp-to-run.gait.html")).expect("a report");
    assert!(report.contains(">Action B</th>"), "{report}");
    assert!(pages.join("curved-walk.gait.html").is_file());

    // Corrected labels and segments of a person replace those of the methods.
    let labels = folder.path().join("labels.json");
    let segments = folder.path().join("segments.json");
    fs::write(&labels, stdout(&plantigrade(&["detect", "limp-to-run.bvh"]))).expect("labels");
    fs::write(&segments, r#"{"segments": [{"start": 1, "end": 300, "label": "slow"}, {"start": 301, "end": 744, "label": "rest"}]}"#)
        .expect("segments");
    let with_labels =
        ["gait", "limp-to-run.bvh", "--labels", labels.to_str().expect("a name"), "--format", "steps"];
    assert_eq!(stdout(&plantigrade(&with_labels)).lines().collect::<Vec<_>>(), steps);
    let with_segments = ["gait", "limp-to-run.bvh", "--segments", segments.to_str().expect("a name")];
    let text = stdout(&plantigrade(&with_segments));
    assert!(text.contains("action slow, frames 0-299\n"), "{text}");
    for args in [
        &["gait", "limp-to-run.bvh", "-o", "x.txt"][..],
        &["gait", "limp-to-run.bvh", "curved-walk.bvh", "--format", "steps"],
        &["gait", "limp-to-run.bvh", "curved-walk.bvh", "--labels", "labels.json"],
        &["gait", "limp-to-run.bvh", "--report", "html", "--format", "csv"],
    ] {
        assert_eq!(plantigrade(args).status.code(), Some(2), "{args:?}");
    }
}

fn gait_fails_only_for_clips_without_feet_or_motion() {
    let files = ["../tests/files/good/no-motion.bvh", "../tests/files/good/two-skeletons.bvh"];
    let output = plantigrade(&[&["gait", "--format", "json"], &files[..]].concat());
    assert_eq!(output.status.code(), Some(1));
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert!(stderr.starts_with(files[0]) && stderr.lines().count() == 1, "{stderr}");
    let json: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(json[1]["root"], "B:Hips");
    for args in
        [&["gait"][..], &["gait", "bowling.bvh", "--r", "0"], &["gait", "bowling.bvh", "--format", "npz"]]
    {
        assert_eq!(plantigrade(args).status.code(), Some(2), "{args:?}");
    }
}
