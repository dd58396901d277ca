//! Permissions, links and folders that cannot be used.

use std::fs;
use std::os::unix::fs::{PermissionsExt, symlink};
use std::os::unix::process::CommandExt;
use std::path::Path;

use crate::support::{clip, empty_folder, mode, output, program, project, run, shell, write};

/// User without rights, as whom tests of permissions run if they are started by the superuser.
const NOBODY: u32 = 65534;

fn set_mode(path: &Path, mode: u32) {
    fs::set_permissions(path, fs::Permissions::from_mode(mode)).expect("permissions");
}

fn is_superuser() -> bool {
    let output = std::process::Command::new("id").arg("-u").output().expect("id runs");
    output.stdout == b"0\n"
}

fn sample() -> String {
    project("samples/curved-walk.bvh").display().to_string()
}

#[test]
fn new_files_follow_the_umask() {
    let folder = empty_folder();
    let folder = folder.path();
    write(&folder.join("walk.bvh"), &clip(1));
    for (umask, expected) in [("022", 0o644), ("027", 0o640), ("000", 0o666), ("077", 0o600)] {
        let script = format!("umask {umask}; exec \"$@\"");
        let out = format!("out{umask}");
        let (code, _, messages) = output(&mut shell(folder, &script, &["detect", "walk.bvh", "--out", &out]));
        assert_eq!(code, 0, "{messages}");
        for entry in fs::read_dir(folder.join(&out)).expect("a folder") {
            let path = entry.expect("an entry").path();
            assert_eq!(mode(&path), expected, "{}", path.display());
        }
        let clean = format!("clean{umask}.bvh");
        let (code, _, messages) = output(&mut shell(folder, &script, &["clean", &sample(), "-o", &clean]));
        assert_eq!(code, 0, "{messages}");
        assert_eq!(mode(&folder.join(clean)), expected);
    }
}

#[test]
fn existing_files_keep_their_mode() {
    let folder = empty_folder();
    let folder = folder.path();
    write(&folder.join("walk.bvh"), &clip(1));
    for expected in [0o664, 0o640, 0o755, 0o600] {
        for path in ["clean.bvh", "out/walk.plants.json"] {
            write(&folder.join(path), b"earlier");
            set_mode(&folder.join(path), expected);
        }
        assert_eq!(run(folder, &["detect", "walk.bvh", "--out", "out", "--force"]).0, 0);
        assert_eq!(run(folder, &["clean", &sample(), "-o", "clean.bvh"]).0, 0);
        for path in ["clean.bvh", "out/walk.plants.json"] {
            assert_eq!(mode(&folder.join(path)), expected, "{path}");
            assert_ne!(fs::read(folder.join(path)).expect("a file"), b"earlier");
        }
    }
}

#[test]
fn symbolic_links_are_written_through() {
    let folder = empty_folder();
    let folder = folder.path();
    write(&folder.join("walk.bvh"), &clip(1));
    write(&folder.join("elsewhere/file"), b"earlier");
    for (link, target) in [
        ("relative", "elsewhere/file"),
        ("link-to-link", "relative"),
        ("dangling", "elsewhere/new"),
        ("out/walk.plants.json", "../elsewhere/labels"),
    ] {
        fs::create_dir_all(folder.join("out")).expect("a folder");
        symlink(target, folder.join(link)).expect("a link");
    }
    symlink(folder.join("elsewhere/other"), folder.join("absolute")).expect("a link");
    for link in ["relative", "link-to-link", "dangling", "absolute", "out/walk.plants.json"] {
        let command = match link.strip_prefix("out/") {
            Some(_) => vec!["detect", "walk.bvh", "--out", "out"],
            None => vec!["clean", "sample.bvh", "-o", link],
        };
        fs::copy(sample(), folder.join("sample.bvh")).expect("a sample");
        let (code, _, messages) = run(folder, &command);
        assert_eq!(code, 0, "{link}: {messages}");
        assert!(folder.join(link).is_symlink(), "{link}");
        assert!(fs::read(folder.join(link)).expect("a file").len() > 500, "{link}");
    }
    let mut names: Vec<_> = fs::read_dir(folder.join("elsewhere"))
        .expect("a folder")
        .map(|entry| entry.expect("an entry").file_name())
        .collect();
    names.sort();
    assert_eq!(names, ["file", "labels", "new", "other"], "no temporary files are left");

    symlink("loop", folder.join("loop")).expect("a link");
    let (code, _, messages) = run(folder, &["clean", "sample.bvh", "-o", "loop"]);
    assert_eq!((code, messages.lines().count()), (1, 1), "{messages}");
    assert!(messages.starts_with("loop: error: cannot write the result: "), "{messages}");
    assert!(folder.join("loop").is_symlink());
}

#[test]
fn an_unreadable_folder_fails_alone() {
    let folder = empty_folder();
    let folder = folder.path();
    set_mode(folder, 0o777);
    for name in ["clips/a.bvh", "clips/secret/b.bvh", "clips/z.bvh"] {
        write(&folder.join(name), &fs::read(sample()).expect("a sample"));
    }
    for name in ["clips/a.json", "clips/z.json"] {
        write(&folder.join(name), &fs::read(project("samples/curved-walk.json")).expect("truth"));
    }
    set_mode(&folder.join("clips/secret"), 0o000);
    set_mode(&folder.join("clips"), 0o755);
    let run = |args: &[&str]| {
        let mut command = program(folder, args);
        if is_superuser() {
            command.uid(NOBODY).gid(NOBODY);
        }
        output(&mut command)
    };
    for args in [
        &["detect", "clips", "--out", "out"][..],
        &["segment", "clips", "--out", "out"],
        &["info", "clips"],
        &["gait", "clips"],
        &["score", "clips"],
    ] {
        let (code, _, messages) = run(args);
        assert_eq!((code, messages.lines().count()), (1, 1), "{args:?}: {messages}");
        assert!(messages.starts_with("clips/secret: error: "), "{messages}");
        assert!(messages.contains("Permission denied"), "{messages}");
    }
    for name in ["a.plants.json", "z.plants.json", "a.segments.json"] {
        assert!(folder.join("out").join(name).is_file(), "{name}");
    }
    // Alone, it is a failure and not an empty folder.
    let (code, _, messages) = run(&["info", "clips/secret"]);
    assert_eq!((code, messages.lines().count()), (1, 1), "{messages}");
    set_mode(&folder.join("clips/secret"), 0o755);
}

#[test]
fn loops_of_links_are_survived() {
    let folder = empty_folder();
    let folder = folder.path();
    write(&folder.join("clips/a.bvh"), &clip(1));
    write(&folder.join("clips/sub/z.bvh"), &clip(2));
    symlink("..", folder.join("clips/sub/up")).expect("a link");
    symlink(".", folder.join("clips/here")).expect("a link");
    symlink("self.bvh", folder.join("clips/self.bvh")).expect("a link");
    symlink("gone", folder.join("clips/dangling.bvh")).expect("a link");
    symlink("a.bvh", folder.join("clips/link.bvh")).expect("a link");
    let (code, _, messages) = run(folder, &["detect", "clips", "--jobs", "1", "--out", "out"]);
    let lines: Vec<&str> = messages.lines().collect();
    assert_eq!((code, lines.len()), (1, 2), "{messages}");
    assert!(lines[0].starts_with("clips/dangling.bvh: error: No such file"), "{messages}");
    assert!(lines[1].starts_with("clips/self.bvh: error: Too many levels of symbolic links"), "{messages}");
    for name in ["a.plants.json", "link.plants.json", "sub/z.plants.json"] {
        assert!(folder.join("out").join(name).is_file(), "{name}");
    }
}

#[test]
fn outputs_that_cannot_be_written_are_failures() {
    let folder = empty_folder();
    let folder = folder.path();
    for name in ["clips/a.bvh", "clips/sub/b.bvh", "clips/z.bvh"] {
        write(&folder.join(name), &clip(1));
    }
    // A file instead of the output folder.
    write(&folder.join("file"), b"a file");
    let (code, _, messages) = run(folder, &["detect", "clips", "--out", "file"]);
    assert_eq!((code, messages.lines().count()), (1, 1), "{messages}");
    assert!(messages.starts_with("file: error: cannot write results to the folder: "), "{messages}");
    // A file instead of a folder in it, and a folder instead of a result.
    write(&folder.join("out/sub"), b"a file");
    fs::create_dir_all(folder.join("out/z.plants.json")).expect("a folder");
    let (code, _, messages) = run(folder, &["detect", "clips", "--jobs", "1", "--out", "out"]);
    let lines: Vec<&str> = messages.lines().collect();
    assert_eq!((code, lines.len()), (1, 2), "{messages}");
    assert!(lines[0].starts_with("out/sub/b.plants.json: error: cannot write the result: "), "{messages}");
    assert!(lines[1].starts_with("out/z.plants.json: error: cannot write the result: "), "{messages}");
    assert!(folder.join("out/a.plants.json").is_file());
    // A folder instead of the record.
    fs::create_dir_all(folder.join("other/.plantigrade.jsonl")).expect("a folder");
    let (code, _, messages) = run(folder, &["detect", "clips", "--out", "other"]);
    assert_eq!((code, messages.lines().count()), (1, 1), "{messages}");
}
