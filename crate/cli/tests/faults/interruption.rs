//! Batches that are killed, resumed, or run twice at once.

use std::fs;
use std::path::Path;
use std::process::{Child, Stdio};
use std::thread;
use std::time::Duration;

use crate::support::{Random, clip, empty_folder, program, project, relative_snapshot, results, run, write};

/// Clips processed in parallel.
const JOBS: usize = 2;

const BATCH: [&str; 8] = ["detect", "clips", "--format", "json", "--jobs", "2", "--out", "OUT"];

/// Beginning of a plants document with an edit.
const EDITED: &str =
    r#"{"edits": [{"side": "left", "part": "contact", "start": 0, "end": 1, "planted": true}], "#;

/// Returns the arguments of a batch with a folder for the results.
fn batch(out: &'static str) -> Vec<&'static str> {
    BATCH.iter().map(|&arg| if arg == "OUT" { out } else { arg }).collect()
}

/// Writes `count` clips, `hostile` of which are damaged, to `folder/clips`.
fn write_clips(folder: &Path, count: usize, hostile: usize) {
    let mut random = Random(count as u64 + 1);
    for number in 0..count {
        let mut bytes = clip(number);
        if number * hostile / count != (number + 1) * hostile / count {
            bytes = damaged(bytes, number, &mut random);
        }
        write(&folder.join(format!("clips/{number:04}.bvh")), &bytes);
    }
}

/// Returns a file that the reader must reject.
fn damaged(bytes: Vec<u8>, kind: usize, random: &mut Random) -> Vec<u8> {
    let text = String::from_utf8(bytes).expect("a clip");
    let replaced = |from: &str, to: &str| {
        assert!(text.contains(from), "{from}");
        text.replacen(from, to, 1).into_bytes()
    };
    match kind / 20 % 7 {
        0 => text.as_bytes()[..text.len() / 3].to_vec(),
        1 => (0..4000).map(|_| random.below(256) as u8).collect(),
        2 => [b"\0".repeat(100), text.into_bytes()].concat(),
        3 => Vec::new(),
        4 => replaced("Zrotation", "Wrotation"),
        5 => {
            let (header, _) = text.split_once("MOTION").expect("motion");
            format!("{header}MOTION\nFrames: 18446744073709551615\nFrame Time: 0.04\n1 2 x\n").into_bytes()
        }
        _ => b"JOINT a {\n".repeat(3000),
    }
}

/// Starts a batch whose messages are dropped.
fn start(folder: &Path, args: &[&str]) -> Child {
    program(folder, args).stderr(Stdio::null()).spawn().expect("the program starts")
}

/// Waits until a folder has a number of results, or the process has ended.
fn wait_for_results(child: &mut Child, folder: &Path, count: usize) {
    while results(folder).len() < count && child.try_wait().expect("a status").is_none() {
        thread::yield_now();
    }
}

/// Kills a process after a random time of at most `microseconds`.
fn kill(child: &mut Child, microseconds: usize, random: &mut Random) {
    thread::sleep(Duration::from_micros(random.below(microseconds) as u64));
    child.kill().expect("the process is killed");
    child.wait().expect("the process has ended");
}

/// Runs a batch, kills another one repeatedly and resumes it. The folders must be equal.
fn kill_and_resume(count: usize, hostile: usize, kills: usize) {
    let folder = empty_folder();
    let folder = folder.path();
    write_clips(folder, count, hostile);
    let sorted = |text: &str| {
        let mut lines: Vec<String> = text.lines().map(String::from).collect();
        lines.sort();
        lines
    };
    let (code, _, messages) = run(folder, &batch("undisturbed"));
    assert_eq!((code, sorted(&messages).len()), (i32::from(hostile > 0), hostile), "{messages}");

    let mut random = Random(7);
    let out = folder.join("killed");
    let mut killed = 0;
    for kill_number in 1..=kills {
        let before = results(&out);
        let mut child = start(folder, &batch("killed"));
        let count = (count - hostile) * kill_number / (kills + 1) + random.below(3);
        wait_for_results(&mut child, &out, count);
        killed += usize::from(child.try_wait().expect("a status").is_none());
        kill(&mut child, 3000, &mut random);
        let after = results(&out);
        let rewritten = before.iter().filter(|(path, version)| after.get(*path) != Some(version)).count();
        assert!(rewritten <= JOBS, "{rewritten} of {} results were computed again", before.len());
    }
    assert!(killed >= kills / 2, "only {killed} processes were killed while they ran");
    let before = results(&out);
    let (code, _, resumed_messages) = run(folder, &batch("killed"));
    assert_eq!((code, sorted(&resumed_messages)), (i32::from(hostile > 0), sorted(&messages)));
    let after = results(&out);
    let rewritten = before.iter().filter(|(path, version)| after.get(*path) != Some(version)).count();
    assert!(rewritten <= JOBS, "{rewritten} of {} results were computed again", before.len());
    assert_eq!(after.len(), count - hostile);
    assert!(relative_snapshot(&out) == relative_snapshot(&folder.join("undisturbed")));
}

#[test]
fn a_killed_batch_resumes() {
    kill_and_resume(80, 0, 6);
}

#[test]
fn a_killed_batch_with_hostile_files_resumes() {
    kill_and_resume(1000, 50, 10);
}

#[test]
fn two_processes_write_to_one_folder() {
    let folder = empty_folder();
    let folder = folder.path();
    write_clips(folder, 60, 3);
    assert_eq!(run(folder, &batch("alone")).0, 1);
    let expected = relative_snapshot(&folder.join("alone"));

    let mut processes = [start(folder, &batch("shared")), start(folder, &batch("shared"))];
    for process in &mut processes {
        assert_eq!(process.wait().expect("the process ends").code(), Some(1));
    }
    assert!(relative_snapshot(&folder.join("shared")) == expected);
    let written = results(&folder.join("shared"));
    assert_eq!(run(folder, &batch("shared")).0, 1);
    assert_eq!(results(&folder.join("shared")), written, "results are reused");

    // One of two is killed; the other one finishes, and the next one removes what is left.
    let mut processes = [start(folder, &batch("half")), start(folder, &batch("half"))];
    wait_for_results(&mut processes[0], &folder.join("half"), 20);
    kill(&mut processes[0], 1000, &mut Random(3));
    assert_eq!(processes[1].wait().expect("the process ends").code(), Some(1));
    assert_eq!(run(folder, &batch("half")).0, 1);
    assert!(relative_snapshot(&folder.join("half")) == expected);
}

#[test]
fn results_of_other_options_or_other_authors_are_not_taken_for_up_to_date() {
    let folder = empty_folder();
    let folder = folder.path();
    write_clips(folder, 2, 0);
    let first = batch("out");
    let other = [&first[..], &["--r", "0.002"]].concat();
    assert_eq!(run(folder, &first).0, 0);
    let expected = relative_snapshot(&folder.join("out"));
    let result = folder.join("out/0000.plants.json");
    let record = || fs::read(folder.join("out/.plantigrade.jsonl")).expect("a record");
    let first_record = record();
    assert_eq!(run(folder, &other).0, 0);
    let of_other = relative_snapshot(&folder.join("out"));
    assert!(of_other != expected);
    // As if the process with other options had been killed between its line of the record and the result.
    let both = [first_record, record()].concat();
    for (args, snapshot) in [(&first, &expected), (&other, &of_other)] {
        write(&result, expected[Path::new("0000.plants.json")].as_ref().expect("a result"));
        fs::write(folder.join("out/.plantigrade.jsonl"), &both).expect("a record");
        assert_eq!(run(folder, args).0, 0);
        assert!(relative_snapshot(&folder.join("out")) == *snapshot);
    }
    assert_eq!(run(folder, &first).0, 0);
    // An incomplete result is written again.
    fs::write(&result, "{").expect("a result");
    assert_eq!(run(folder, &first).0, 0);
    assert!(relative_snapshot(&folder.join("out")) == expected);
}

#[test]
fn files_that_a_person_changed_are_not_replaced() {
    let folder = empty_folder();
    let folder = folder.path();
    write_clips(folder, 3, 0);
    let first = batch("out");
    let other = [&first[..], &["--r", "0.002"]].concat();
    assert_eq!(run(folder, &first).0, 0);
    let path = |number: usize| folder.join(format!("out/{number:04}.plants.json"));
    let result = fs::read_to_string(path(0)).expect("a result");
    let edited = result.replacen('{', EDITED, 1);
    for args in [&first, &other] {
        write(&path(0), edited.as_bytes());
        write(&path(1), b"not a result");
        let (code, _, messages) = run(folder, args);
        assert_eq!((code, messages.lines().count()), (1, 2), "{messages}");
        assert!(messages.lines().all(|line| line.contains("was changed") && line.contains("--force")));
        assert_eq!(fs::read_to_string(path(0)).expect("a file"), edited);
        assert_eq!(fs::read_to_string(path(1)).expect("a file"), "not a result");
    }
    assert_eq!(run(folder, &[&first[..], &["--force"]].concat()).0, 0);
    assert_eq!(fs::read_to_string(path(0)).expect("a result"), result);
    assert_eq!(run(folder, &other).0, 0, "results are replaced");
}

#[test]
fn edited_files_that_are_not_in_the_record_are_not_replaced() {
    let folder = empty_folder();
    let folder = folder.path();
    write_clips(folder, 1, 0);
    assert_eq!(run(folder, &["segment", "clips", "--out", "out"]).0, 0);
    assert_eq!(run(folder, &batch("out")).0, 0);
    let read = |name: &str| fs::read_to_string(folder.join("out").join(name)).expect("a file");
    let [plants, segments] = ["0000.plants.json", "0000.segments.json"].map(read);
    let cases = [
        ("0000.plants.json", plants.clone(), false),
        ("0000.plants.json", plants.replacen('{', EDITED, 1), true),
        ("0000.plants.json", plants.replacen("\"robust\"", "\"truth\"", 1), true),
        ("0000.plants.json", r#"{"left": [0, 1], "right": [1, 1]}"#.into(), true),
        ("0000.plants.json", "from elsewhere".into(), false),
        ("0000.segments.json", segments.clone(), false),
        ("0000.segments.json", segments.replace("\"source\": \"auto\"", "\"source\": \"edited\""), true),
        ("0000.segments.json", r#"{"0000": [{"start": 1, "end": 4, "label": "walk"}]}"#.into(), true),
    ];
    for (name, content, is_work) in cases {
        fs::remove_file(folder.join("out/.plantigrade.jsonl")).expect("a record");
        fs::write(folder.join("out").join(name), &content).expect("a file");
        let command = if name.contains("plants") { "detect" } else { "segment" };
        let (code, _, messages) = run(folder, &[command, "clips", "--out", "out", "--fps", "20"]);
        assert_eq!(code, i32::from(is_work), "{content}: {messages}");
        assert_eq!(read(name) == content, is_work, "{content}");
    }
}

#[test]
fn corrected_results_of_a_killed_batch_are_replaced() {
    let folder = empty_folder();
    let folder = folder.path();
    write(&folder.join("walk.bvh"), &fs::read(project("samples/curved-walk.bvh")).expect("a sample"));
    let detect = ["detect", "walk.bvh", "--format", "json", "--out", "out"];
    let corrected = [&detect[..], &["--constraints", "edited.json"]].concat();
    let result = || fs::read(folder.join("out/walk.plants.json")).expect("a result");
    let record = || fs::read(folder.join("out/.plantigrade.jsonl")).expect("a record");
    let (_, automatic, _) = run(folder, &["detect", "walk.bvh", "--format", "json"]);
    write(&folder.join("edited.json"), automatic.replacen('{', EDITED, 1).as_bytes());
    let (code, _, messages) = run(folder, &corrected);
    assert_eq!(code, 0, "{messages}");
    let (first, line) = (result(), record());
    assert_eq!(run(folder, &detect).0, 0);
    let (second, newer_line) = (result(), record());
    assert!(first != second);
    // As if the second process had been killed before the result was written.
    fs::write(folder.join("out/walk.plants.json"), &first).expect("a result");
    fs::write(folder.join("out/.plantigrade.jsonl"), [line, newer_line].concat()).expect("a record");
    assert_eq!(run(folder, &detect).0, 0);
    assert!(result() == second);
}

#[test]
fn results_depend_on_the_content_of_the_standing_clip() {
    let folder = empty_folder();
    let folder = folder.path();
    let sample = |name: &str| fs::read(project(&format!("samples/{name}.bvh"))).expect("a sample");
    write(&folder.join("walk.bvh"), &sample("curved-walk"));
    let args = ["detect", "walk.bvh", "--method", "paper", "--still", "still.bvh", "--out", "out"];
    let documents = ["curved-walk", "bowling"].map(|still| {
        write(&folder.join("still.bvh"), &sample(still));
        assert_eq!(run(folder, &args).0, 0);
        fs::read(folder.join("out/walk.plants.json")).expect("a result")
    });
    assert!(documents[0] != documents[1]);
}

#[test]
fn a_damaged_record_costs_only_its_damaged_lines() {
    let folder = empty_folder();
    let folder = folder.path();
    write_clips(folder, 6, 0);
    assert_eq!(run(folder, &batch("out")).0, 0);
    let expected = relative_snapshot(&folder.join("out"));
    let record = folder.join("out/.plantigrade.jsonl");
    let lines = fs::read(&record).expect("a record");
    // The record ends within its last line.
    let torn = lines[..lines.len() - 20].to_vec();
    let garbage = [b"\xff\0{}\n[1, 2]\n\n{\"result\":3}\n", &lines[..]].concat();
    for (damaged, most) in [(torn, 1), (garbage, 0), (b"\0".repeat(1000), 6), (Vec::new(), 6)] {
        fs::write(&record, damaged).expect("a record");
        let before = results(&folder.join("out"));
        assert_eq!(run(folder, &batch("out")).0, 0);
        let after = results(&folder.join("out"));
        let rewritten = before.iter().filter(|(path, version)| after.get(*path) != Some(version)).count();
        assert_eq!(rewritten, most);
        assert!(relative_snapshot(&folder.join("out")) == expected);
    }
}

#[test]
fn records_of_earlier_versions_are_replaced() {
    let folder = empty_folder();
    let folder = folder.path();
    write_clips(folder, 2, 0);
    assert_eq!(run(folder, &batch("new")).0, 0);
    write(&folder.join("out/.plantigrade.json"), br#"{"0000.plants.json": "0123"}"#);
    assert_eq!(run(folder, &batch("out")).0, 0);
    assert!(relative_snapshot(&folder.join("out")) == relative_snapshot(&folder.join("new")));
}

#[test]
fn temporary_files_of_killed_processes_are_removed() {
    let folder = empty_folder();
    let folder = folder.path();
    write(&folder.join("clips/sub/walk.bvh"), &clip(1));
    let is_clean = || {
        let snapshot = relative_snapshot(folder);
        !snapshot.keys().any(|path| path.extension().is_some_and(|extension| extension == "tmp"))
    };
    for path in ["out/.plantigrade-a1B2c3.tmp", "out/sub/.plantigrade-a1B2c3.tmp"] {
        write(&folder.join(path), b"part of a result");
    }
    write(&folder.join("out/own.tmp.txt"), b"not a temporary file");
    assert_eq!(run(folder, &batch("out")).0, 0);
    assert!(is_clean() && folder.join("out/own.tmp.txt").exists());
    // `clean` removes those next to its output.
    write(&folder.join("clean/.plantigrade-a1B2c3.tmp"), b"part of a result");
    let sample = project("samples/curved-walk.bvh");
    let sample = sample.to_str().expect("a path");
    assert_eq!(run(folder, &["clean", sample, "-o", "clean/out.bvh"]).0, 0);
    assert!(is_clean());
}
