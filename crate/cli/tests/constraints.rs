//! Tests of `detect --constraints`.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Output;

use assert_cmd::Command;
use plantigrade::formats::{Origin, PlantsDocument};
use plantigrade::plants::Edit;
use serde_json::{Value, json};

fn project(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path)
}

fn detect(args: &[&str]) -> Output {
    let mut command = Command::cargo_bin("plantigrade").expect("the binary");
    command.current_dir(project("samples")).arg("detect").args(args).output().expect("the program runs")
}

fn document(args: &[&str]) -> PlantsDocument {
    let output = detect(args);
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
    serde_json::from_slice(&output.stdout).expect("a document")
}

fn plants(document: &PlantsDocument) -> Vec<(usize, usize, Origin)> {
    let plants = document.left.contact.iter().chain(&document.right.contact).flatten();
    plants.map(|plant| (plant.frames.start, plant.frames.end, plant.source)).collect()
}

/// Writes annotated contact in which the tenth plant of the left foot ends four frames early.
fn annotate(detected: &PlantsDocument, path: &Path) {
    let plant = &detected.left.contact.as_ref().expect("contact")[9].frames;
    let mut left = vec![-1; detected.header.frames];
    left[plant.start..plant.end - 4].fill(1);
    left[plant.end - 4..plant.end + 3].fill(0);
    let annotation = json!({ "left": left, "right": vec![-1; detected.header.frames] });
    fs::write(path, annotation.to_string()).expect("an annotation");
}

#[test]
fn a_corrected_foot_off_moves_similar_ones() {
    let folder = tempfile::tempdir().expect("a folder");
    let labels = folder.path().join("labels.json");
    let before = document(&["straight-jog.bvh"]);
    annotate(&before, &labels);
    let after = document(&["straight-jog.bvh", "--constraints", labels.to_str().expect("a path")]);
    let (old, new) = (plants(&before), plants(&after));
    assert_eq!(old.len(), new.len());
    let moved = old.iter().zip(&new).filter(|(old, new)| new.1 + 3 <= old.1).count();
    // The first and the last steps differ.
    assert!(moved >= old.len() / 2 && moved < old.len(), "{old:?} {new:?}");
    assert_eq!(new.iter().filter(|plant| plant.2 == Origin::Edited).count(), 1);
    let edits: Vec<Edit> = after.edits.clone();
    assert_eq!(edits.iter().map(|edit| edit.planted).collect::<Vec<_>>(), [true, false]);
    let notice = after.notices.iter().find(|notice| notice.code.name() == "corrections").expect("a notice");
    assert!(notice.text.contains("similar plants"), "{}", notice.text);

    // The document itself is a constraint, for this clip and for others of the same character.
    let saved = folder.path().join("saved.json");
    fs::write(&saved, serde_json::to_string(&after).expect("JSON")).expect("a document");
    let saved = saved.to_str().expect("a path");
    assert_eq!(plants(&document(&["straight-jog.bvh", "--constraints", saved])), new);
    let clip = ["--constraints-clip", "straight-jog.bvh"];
    let same = document(&[&["straight-jog.bvh", "--constraints", saved][..], &clip].concat());
    assert_eq!(plants(&same), new);
    let other = document(&[&["ballet.bvh", "--constraints", saved][..], &clip].concat());
    assert_eq!(plants(&other), plants(&document(&["ballet.bvh"])), "other motion retains its labels");
}

#[test]
fn unusable_constraints_are_errors() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).to_str().expect("a path").to_owned();
    let fails = |args: &[&str], code: i32, expected: &str| {
        let output = detect(args);
        let text = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(text.contains(expected), "{args:?}: {text}");
        assert_eq!(output.status.code(), Some(code), "{text}");
        assert!(output.stdout.is_empty());
        assert!(code == 2 || text.lines().count() == 1, "{text}");
    };
    let (missing, no_edits) = (path("missing.json"), path("auto.json"));
    fails(&["ballet.bvh", "--constraints", &missing], 1, "missing.json: error:");
    fails(&["ballet.bvh", "--still", &missing], 1, "missing.json: error:");
    let detected: Value = serde_json::to_value(document(&["ballet.bvh"])).expect("JSON");
    fs::write(&no_edits, detected.to_string()).expect("a document");
    fails(&["ballet.bvh", "--constraints", &no_edits], 1, "the document has no edits");
    let other = path("other.json");
    fs::copy(project("samples/straight-jog.json"), &other).expect("truth");
    fails(&["ballet.bvh", "--constraints", &other], 1, "frames, but the clip has");
    let truth = ["straight-jog.bvh", "--constraints", &other];
    for method in ["paper", "dual"] {
        let expected = format!("which the method {method} does not label: use --method robust");
        fails(&[&truth[..], &["--method", method]].concat(), 1, &expected);
        let clip = ["--method", method, "--constraints-clip", "straight-jog.bvh"];
        fails(&[&truth[..], &clip].concat(), 1, &expected);
    }
    let out = path("out");
    let several = ["ballet.bvh", "bowling.bvh", "--out", &out, "--constraints", &other];
    fails(&several, 2, "name it with --constraints-clip to label 2 clips");
    fails(&["ballet.bvh", "--constraints-clip", "bowling.bvh"], 2, "--constraints");
}
