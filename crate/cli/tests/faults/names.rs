//! Names of files and joints with control characters or invalid UTF-8, and names that clash.

use std::ffi::{OsStr, OsString};
use std::fs;
use std::os::unix::ffi::OsStrExt;
use std::path::Path;
use std::process::{Command, Stdio};

use crate::support::{clip, empty_folder, output, project, relative_snapshot, results, run, write};

/// Characters that change the terminal or break lines.
const HOSTILE: &str = "a\u{1b}[2J\n\rb\u{7f}\u{9b}31m\u{202e}c\td";
const ESCAPED: &str = r"a\u{1b}[2J\n\rb\u{7f}\u{9b}31m\u{202e}c\td";

/// Asserts that a text has no control characters except line ends.
fn assert_is_plain(text: &str) {
    let is_control = |c: char| (c.is_control() && c != '\n') || c == '\u{202e}';
    assert!(!text.contains(is_control), "{text:?}");
}

#[test]
fn control_characters_in_file_names_are_escaped() {
    let folder = empty_folder();
    let folder = folder.path();
    let sample = fs::read(project("samples/curved-walk.bvh")).expect("a sample");
    write(&folder.join(format!("good/{HOSTILE}.bvh")), &sample);
    write(
        &folder.join(format!("good/{HOSTILE}.json")),
        &fs::read(project("samples/curved-walk.json")).expect("truth"),
    );
    write(&folder.join(format!("bad/{HOSTILE}.bvh")), b"HIERARCHY\n");
    write(&folder.join(format!("bad/{HOSTILE}.json")), b"{}");
    fs::create_dir(folder.join(HOSTILE)).expect("a folder");

    for args in
        [&["info", "good"][..], &["gait", "good"], &["gait", "good", "--format", "csv"], &["score", "good"]]
    {
        let (code, text, messages) = run(folder, args);
        assert_eq!((code, messages.as_str()), (0, ""), "{args:?}");
        assert_is_plain(&text);
        assert!(text.contains(ESCAPED), "{args:?}: {text}");
    }
    for command in ["info", "gait", "score", "detect", "segment"] {
        let (code, _, messages) = run(folder, &[command, "bad"]);
        assert_eq!((code, messages.lines().count()), (1, 1), "{command}: {messages}");
        assert!(messages.starts_with(&format!("bad/{ESCAPED}.bvh:")), "{messages}");
        assert_is_plain(&messages);
    }
    let bad = format!("bad/{HOSTILE}.bvh");
    let good = format!("good/{HOSTILE}.bvh");
    for args in [
        &["clean", &bad, "-o", "out.bvh"][..],
        &["clean", &good, "-o", "out.bvh"],
        &["clean", &good, "-o", "out.bvh", "--labels", HOSTILE],
        &["clean", &good, "-o", HOSTILE],
        &["info", HOSTILE],
        &["detect", "good", "--still", &bad],
        &["detect", HOSTILE],
        &["score", HOSTILE],
        &["score", "good", "--method", HOSTILE],
        &["detect", "good", "--joint", &format!("left_ankle={HOSTILE}")],
        &["detect", "good", "--method", HOSTILE],
        &["detect", "good", &format!("--{HOSTILE}")],
        &[HOSTILE],
    ] {
        let (_, _, messages) = run(folder, args);
        assert!(messages.contains(r"\u{1b}[2J"), "{args:?}: {messages:?}");
        assert_is_plain(&messages);
    }
    // JSON has its own escapes and preserves the names.
    let (_, json, _) = run(folder, &["info", "good", "--format", "json"]);
    let info: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    assert_eq!(info["path"], format!("good/{HOSTILE}.bvh"));
}

#[test]
fn control_characters_in_joint_names_are_escaped() {
    let folder = empty_folder();
    let folder = folder.path();
    let text = fs::read_to_string(project("samples/curved-walk.bvh")).expect("a sample");
    let name = text.lines().find_map(|line| line.trim().strip_prefix("ROOT ")).expect("a root").to_owned();
    let hostile = text.replace(&name, &format!("{name}\u{1b}[2J\u{9b}31m"));
    // Two characters, and names that are used twice.
    write(&folder.join("walk.bvh"), format!("{hostile}{hostile}").as_bytes());
    write(&folder.join("one.bvh"), hostile.as_bytes());
    let escaped = format!(r"{name}\u{{1b}}[2J\u{{9b}}31m");
    let joint = format!("left_ankle={name}\u{1b}[2J\u{9b}31m");
    for args in [
        &["info", "walk.bvh"][..],
        &["info", "one.bvh", "--joint", &joint],
        &["gait", "walk.bvh"],
        &["gait", "walk.bvh", "--format", "csv"],
        &["clean", "walk.bvh", "-o", "out.bvh"],
        &["clean", "one.bvh", "-o", "out.bvh", "--joint", &joint],
    ] {
        let (_, text, messages) = run(folder, args);
        assert_is_plain(&text);
        assert_is_plain(&messages);
    }
    let (code, text, messages) = run(folder, &["info", "one.bvh", "--joint", &joint]);
    assert!(code == 0 && text.contains(&escaped), "{text}{messages}");
}

#[test]
fn control_characters_in_results_are_escaped_on_a_terminal_only() {
    let folder = empty_folder();
    let folder = folder.path();
    let text = fs::read_to_string(project("tests/files/good/two-skeletons.bvh")).expect("a clip");
    write(&folder.join("walk.bvh"), text.replace("B:Hips", "B:Hips\u{1b}[2J").as_bytes());
    let args = ["detect", "walk.bvh", "--format", "csv"];
    assert!(run(folder, &args).1.contains("\nB:Hips\u{1b}[2J,"), "files have the names as they are");
    // A terminal is simulated by `script`, if it is installed.
    let line = format!("'{}' {}", env!("CARGO_BIN_EXE_plantigrade"), args.join(" "));
    let mut terminal = Command::new("script");
    terminal.current_dir(folder).args(["-qec", &line, "/dev/null"]).stdin(Stdio::null());
    if terminal.output().is_ok() {
        let (code, text, _) = output(&mut terminal);
        assert!(code == 0 && text.contains(r"B:Hips\u{1b}[2J,"), "{text}");
        assert_is_plain(&text.replace('\r', ""));
    }
}

#[test]
fn names_that_are_not_utf_8_are_recorded_and_told_apart() {
    let folder = empty_folder();
    let folder = folder.path();
    let names = [&b"\xff.bvh"[..], b"\xfe.bvh", "é.bvh".as_bytes(), b"plain.bvh", b"\\xff.bvh"];
    for (number, name) in names.into_iter().enumerate() {
        let path = folder.join("clips").join(OsStr::from_bytes(name));
        // Some file systems accept UTF-8 only.
        fs::create_dir_all(folder.join("clips")).expect("a folder");
        if fs::write(path, clip(number)).is_err() {
            return;
        }
    }
    let args = ["detect", "clips", "--out", "out"];
    assert_eq!(run(folder, &args), (0, "".into(), "".into()));
    let written = results(&folder.join("out"));
    assert_eq!(written.len(), names.len());
    assert_eq!(run(folder, &args), (0, "".into(), "".into()));
    assert_eq!(results(&folder.join("out")), written, "results are reused");
    // Messages tell the names apart.
    for name in [&b"\xff.bvh"[..], b"\xfe.bvh"] {
        fs::write(folder.join("clips").join(OsStr::from_bytes(name)), "no clip").expect("a file");
    }
    let (code, _, messages) = run(folder, &args);
    assert_eq!((code, messages.lines().count()), (1, 2), "{messages}");
    assert!(messages.contains(r"clips/\xff.bvh:") && messages.contains(r"clips/\xfe.bvh:"), "{messages}");
}

/// Runs a batch with clashing results: `refused` fails, all others are written.
fn assert_clash(files: &[&str], args: &[&str], refused: &str) {
    let folder = empty_folder();
    let folder = folder.path();
    for (number, name) in files.iter().enumerate() {
        write(&folder.join(name), &clip(number));
    }
    let out = folder.join("out");
    let args = [&["detect"], args, &["--jobs", "1", "--out", "out"]].concat();
    let (code, _, messages) = run(folder, &args);
    assert_eq!((code, messages.lines().count()), (1, 1), "{args:?}: {messages}");
    assert!(messages.starts_with(&format!("{refused}: error: its result ")), "{messages}");
    assert_eq!(results(&out).len() + usize::from(out.join("a").is_dir()), files.len() - 1, "{args:?}");
    let first = relative_snapshot(&out);
    assert_eq!(run(folder, &args).2, messages);
    assert!(relative_snapshot(&out) == first, "{args:?}");
}

#[test]
fn clips_with_the_same_result_do_not_overwrite_each_other() {
    assert_clash(&["a/walk.bvh", "b/walk.bvh"], &["a", "b"], "b/walk.bvh");
    assert_clash(&["a/walk.bvh", "b/walk.bvh"], &["a/walk.bvh", "b"], "b/walk.bvh");
    assert_clash(&["c/walk.BVH", "c/walk.bvh"], &["c"], "c/walk.bvh");
    assert_clash(&["walk.bvh", "walk"], &["walk.bvh", "walk"], "walk");
    // The result of one is a folder of the other.
    assert_clash(&["c/walk.bvh", "c/walk.plants.json/run.bvh"], &["c"], "c/walk.plants.json/run.bvh");
    let files = ["c/walk.plants.json/run.bvh", "walk.bvh"];
    assert_clash(&files, &["c", "walk.bvh"], "walk.bvh");
    // The record is not overwritten.
    assert_clash(&["c/.plantigrade.jsonl/a.bvh", "c/z.bvh"], &["c"], "c/.plantigrade.jsonl/a.bvh");
    assert_clash(&["c/.plantigrade.lock/a.bvh", "c/z.bvh"], &["c"], "c/.plantigrade.lock/a.bvh");
}

#[test]
fn results_of_all_commands_and_formats_have_names_of_their_own() {
    let folder = empty_folder();
    let folder = folder.path();
    let stems = [
        "walk",
        "walk.segments",
        "walk.plants",
        "walk.frames",
        "walk.part-events",
        "walk.json",
        ".plantigrade",
        ".plantigrade.jsonl",
        ".plantigrade-a1B2c3.tmp",
    ];
    for (number, stem) in stems.iter().enumerate() {
        write(&folder.join(format!("clips/{stem}.bvh")), &clip(number));
    }
    let formats = [
        ("detect", &["json", "csv", "intervals", "events", "part-events", "npz", "blender"][..]),
        ("segment", &["json", "csv", "babel"]),
    ];
    let commands: Vec<[&str; 6]> = formats
        .iter()
        .flat_map(|(command, formats)| {
            formats.iter().map(move |format| [command, "clips", "--format", format, "--out", "out"])
        })
        .collect();
    for args in &commands {
        assert_eq!(run(folder, args), (0, "".into(), "".into()), "{args:?}");
    }
    let written = relative_snapshot(&folder.join("out"));
    assert_eq!(written.len(), commands.len() * stems.len() + 2, "{:?}", written.keys());
    for args in &commands {
        assert_eq!(run(folder, args).0, 0, "{args:?}");
    }
    assert!(relative_snapshot(&folder.join("out")) == written, "nothing is written again");
}

#[test]
fn folders_with_names_that_are_not_utf_8_are_read() {
    let folder = empty_folder();
    let folder = folder.path();
    let name = Path::new(OsStr::from_bytes(b"\xff"));
    if fs::create_dir(folder.join(name)).is_err() {
        return;
    }
    write(&folder.join(name).join("walk.bvh"), &clip(1));
    let args: [OsString; 4] = ["detect".into(), name.into(), "--out".into(), name.join("out").into()];
    assert_eq!(run(folder, &args), (0, "".into(), "".into()));
    assert!(folder.join(name).join("out/walk.plants.json").is_file());
}
