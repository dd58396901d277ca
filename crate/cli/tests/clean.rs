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
