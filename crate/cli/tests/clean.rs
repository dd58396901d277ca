//! Tests of `plantigrade clean`.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Output;

use assert_cmd::Command;
use plantigrade::bvh::{self, Clip};

fn project(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path)
}

/// Runs the program in `folder`. Returns exit code, standard output and standard error.
fn run(folder: &Path, args: &[&str], input: &[u8]) -> (i32, String, String) {
    let mut command = Command::cargo_bin("plantigrade").expect("the binary");
    let Output { status, stdout, stderr } =
        command.current_dir(folder).args(args).write_stdin(input).output().expect("it runs");
    let text = |bytes| String::from_utf8(bytes).expect("text");
    (status.code().expect("an exit code"), text(stdout), text(stderr))
}

fn clip(path: &Path) -> Clip {
    bvh::parse(&fs::read(path).expect("a file"), bvh::Options::default()).expect("BVH").clip
}

#[test]
fn clean_moves_feet_and_leaves_other_joints_unchanged() {
    let folder = tempfile::tempdir().expect("a folder");
    let sample = project("samples/curved-walk.bvh").canonicalize().expect("a sample");
    let sample = sample.to_str().expect("a path");
    let (code, out, stderr) = run(folder.path(), &["clean", sample, "-o", "out.bvh"], b"");
    assert_eq!((code, out.as_str()), (0, ""));
    assert!(stderr.contains(" plants, ") && stderr.contains(" corrected; slide: mean "), "{stderr}");
    assert!(stderr.contains(" → 0.0 mm, maximum "), "{stderr}");
    assert_eq!(stderr.lines().count(), 1);
    let (before, after) = (clip(Path::new(sample)), clip(&folder.path().join("out.bvh")));
    assert_eq!(before.joints(), after.joints());
    assert_eq!(before.frame_count(), after.frame_count());
    assert_ne!(before, after);
    let channels = |clip: &Clip, frame: usize| {
        let head = clip.joints().iter().position(|joint| joint.name.ends_with("Head")).expect("a head");
        clip.row(frame)[clip.channel_range(head)].to_vec()
    };
    assert!((0..before.frame_count()).all(|frame| channels(&before, frame) == channels(&after, frame)));
}

#[test]
fn clean_reads_labels_from_a_file_and_the_clip_from_standard_input() {
    let folder = tempfile::tempdir().expect("a folder");
    let labels = project("samples/curved-walk.json").canonicalize().expect("truth");
    let labels = labels.to_str().expect("a path");
    let bytes = fs::read(project("samples/curved-walk.bvh")).expect("a sample");
    let (code, _, stderr) =
        run(folder.path(), &["clean", "-", "-o", "new/out.bvh", "--labels", labels], &bytes);
    assert_eq!(code, 0, "{stderr}");
    assert!(stderr.starts_with("<stdin>: 5 plants, 5 corrected"), "{stderr}");
    assert!(folder.path().join("new/out.bvh").is_file());
}

#[test]
fn clean_writes_nothing_if_it_fails() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = |path: &str| project(path).canonicalize().expect("a file").to_string_lossy().into_owned();
    let (sample, other) = (file("samples/curved-walk.bvh"), file("samples/ballet.json"));
    let (code, _, stderr) = run(folder.path(), &["clean", &sample, "-o", "out.bvh", "--labels", &other], b"");
    assert_eq!((code, stderr.lines().count()), (1, 1), "{stderr}");
    assert!(stderr.contains("the file has 298 frames, but the clip has 245"), "{stderr}");
    let (code, _, stderr) = run(folder.path(), &["clean", "-", "-o", "out.bvh"], b"HIERARCHY\n");
    assert_eq!((code, stderr.starts_with("<stdin>:")), (1, true), "{stderr}");
    for wrong in [
        &["clean", &sample][..],
        &["clean", &sample, &sample, "-o", "out.bvh"],
        &["clean", &file("samples"), "-o", "out.bvh"],
        &["clean", "-", "-o", "out.bvh", "--labels", "-"],
        &["clean", &sample, "-o", "out.bvh", "--labels", &other, "--r", "0.1"],
    ] {
        assert_eq!(run(folder.path(), wrong, b"").0, 2, "{wrong:?}");
    }
    assert!(!folder.path().join("out.bvh").exists());
}

#[test]
fn the_slide_of_no_plants_is_zero() {
    let folder = tempfile::tempdir().expect("a folder");
    let sample = project("samples/curved-walk.bvh").canonicalize().expect("a sample");
    let labels = serde_json::json!({ "left": vec![0; 245], "right": vec![0; 245] });
    let args = ["clean", sample.to_str().expect("a path"), "-o", "out.bvh", "--labels", "-"];
    let (code, _, stderr) = run(folder.path(), &args, labels.to_string().as_bytes());
    assert_eq!(code, 0, "{stderr}");
    assert!(stderr.contains("0 plants, 0 corrected; slide: mean 0.0 → 0.0 mm"), "{stderr}");
}

/// Returns a walk in a file with names in Shift-JIS, named end sites, comments, CRLF and unusual spacing.
fn unusual_file() -> Vec<u8> {
    let text = fs::read_to_string(project("samples/curved-walk.bvh")).expect("a sample");
    let (header, motion) = text.split_once("MOTION\n").expect("motion");
    let mut bytes = b"# a walk\r\n".to_vec();
    for (index, line) in header.lines().enumerate() {
        let line = line.replace('\t', "   ").replace("End Site", &format!("End Site  Tip_{index}"));
        bytes.extend_from_slice(line.as_bytes());
        if line.contains("Spine") || line.contains("Head") {
            // The first character is 83 7B in Shift-JIS, whose second byte is a brace in ASCII.
            bytes.extend_from_slice(b"_\x83\x7b\x81\x5b\x83\x93");
        }
        bytes.extend_from_slice(b" \r\n");
    }
    bytes.extend_from_slice(b"MOTION // 245 frames\r\n");
    for line in motion.lines() {
        bytes.extend_from_slice(format!(" {}\t\r\n", line.replace(' ', "  ")).as_bytes());
    }
    bytes.extend_from_slice(b"the end");
    bytes
}

#[test]
fn clean_changes_only_the_numbers_of_legs_and_hips() {
    let folder = tempfile::tempdir().expect("a folder");
    let before = unusual_file();
    fs::write(folder.path().join("in.bvh"), &before).expect("a file");
    let (code, _, stderr) = run(folder.path(), &["clean", "in.bvh", "-o", "out.bvh"], b"");
    assert_eq!(code, 0, "{stderr}");
    let after = fs::read(folder.path().join("out.bvh")).expect("a file");

    let clip = bvh::parse(&before, bvh::Options::default()).expect("BVH").clip;
    let may_move: Vec<bool> = clip
        .joints()
        .iter()
        .flat_map(|joint| {
            let is_moved = joint.parent.is_none()
                || ["Thigh", "Calf", "Foot", "Toe"].iter().any(|part| joint.name.contains(part));
            joint.channels.iter().map(move |_| is_moved)
        })
        .collect();
    let lines = |bytes: &[u8]| bytes.split(|&byte| byte == b'\n').map(<[u8]>::to_vec).collect::<Vec<_>>();
    let (before, after) = (lines(&before), lines(&after));
    assert_eq!(before.len(), after.len());
    let first = before.iter().position(|line| line.starts_with(b" Frame  Time")).expect("a frame time") + 1;
    assert_eq!(before[..first], after[..first]);
    assert_eq!(before.last(), after.last());
    let mut changed = 0;
    for (before, after) in before.iter().zip(&after).skip(first) {
        let [before, after] = [before, after].map(|line| String::from_utf8(line.clone()).expect("numbers"));
        let (before, after) = (before.split(' '), after.split(' '));
        let places = |number: &str| number.trim_end().split_once('.').map_or(0, |(_, places)| places.len());
        let mut channel = 0;
        for (before, after) in before.zip(after) {
            if before != after {
                assert!(may_move[channel], "channel {channel}: {before:?} became {after:?}");
                assert!(places(after) >= places(before), "{before:?} became {after:?}");
                assert_eq!(before.ends_with("\t\r"), after.ends_with("\t\r"));
                changed += 1;
            }
            channel += usize::from(!before.trim().is_empty());
        }
    }
    assert!(changed > 1000, "{changed}");
}

#[test]
fn clean_writes_the_given_rate() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("in.bvh"), unusual_file()).expect("a file");
    let (code, _, stderr) = run(folder.path(), &["clean", "in.bvh", "-o", "out.bvh", "--fps", "100"], b"");
    assert_eq!(code, 0, "{stderr}");
    let after = fs::read(folder.path().join("out.bvh")).expect("a file");
    assert_eq!(clip(&folder.path().join("out.bvh")).frame_time(), 0.01);
    let line = b" Frame  Time:  0.01\t\r\n";
    assert!(after.windows(line.len()).any(|window| window == line));
}

#[test]
fn spikes_are_repaired_or_left_alone() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut lines: Vec<String> = fs::read_to_string(project("samples/curved-walk.bvh"))
        .expect("a sample")
        .lines()
        .map(String::from)
        .collect();
    let first = 1 + lines.iter().position(|line| line.starts_with("Frame Time")).expect("a motion section");
    let mut row: Vec<String> = lines[first + 81].split(' ').map(String::from).collect();
    row[1] = (row[1].parse::<f64>().expect("a height") + 12.0).to_string();
    lines[first + 81] = row.join(" ");
    fs::write(folder.path().join("spike.bvh"), lines.join("\n")).expect("a file");
    let height = |name: &str, frame: usize| clip(&folder.path().join(name)).row(frame)[1];
    for (option, is_repaired) in [(None, true), (Some("--keep-spikes"), false)] {
        let args: Vec<&str> = ["clean", "spike.bvh", "-o", "out.bvh"].into_iter().chain(option).collect();
        let (code, _, stderr) = run(folder.path(), &args, b"");
        assert_eq!(code, 0, "{stderr}");
        assert_eq!(stderr.contains("The hips have a spike, from frame 81 on"), is_repaired, "{stderr}");
        let jump = height("out.bvh", 81) - height("out.bvh", 80);
        assert_eq!(jump.abs() < 1.0, is_repaired, "{jump}");
        // Other frames are not harmed: 4 units are a tenth of a leg.
        let frames = (0..245).filter(|&frame| frame != 81);
        let moved = frames.map(|frame| (height("out.bvh", frame) - height("spike.bvh", frame)).abs());
        assert!(moved.fold(0.0, f64::max) < 4.0);
    }
}
