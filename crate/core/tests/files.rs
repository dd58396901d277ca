//! Tests of the reader on the files of `tests/files`, which `expected.txt` lists.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use plantigrade::bvh::{Error, ErrorKind, Options, Parsed, Reader, parse, rewrite};
use plantigrade::notice::Code;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/files")
}

/// Returns the lines of `expected.txt`, without its comments.
fn expected() -> Vec<String> {
    let text = fs::read_to_string(folder().join("expected.txt")).expect("the list");
    text.lines().filter(|line| !line.is_empty() && !line.starts_with('#')).map(str::to_owned).collect()
}

/// Returns the paths of all files below `good` and `bad`, and their bytes, in alphabetical order.
fn files() -> Vec<(String, Vec<u8>)> {
    let mut files = Vec::new();
    let mut folders = vec![folder().join("good"), folder().join("bad")];
    while let Some(path) = folders.pop() {
        for entry in fs::read_dir(path).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
            } else {
                let name = path.strip_prefix(folder()).expect("a path below the folder");
                let name = name.to_str().expect("a name").replace('\\', "/");
                files.push((name, fs::read(&path).expect("a file")));
            }
        }
    }
    files.sort_unstable();
    files
}

fn read_in_chunks(bytes: &[u8], chunk: usize, options: Options) -> Result<Parsed, Error> {
    let mut reader = Reader::new(options);
    bytes.chunks(chunk).try_for_each(|chunk| reader.push(chunk))?;
    reader.finish()
}

/// Returns the line that `expected.txt` should have for a file.
fn description(name: &str, result: &Result<Parsed, Error>) -> String {
    match result {
        Ok(parsed) => {
            let notices = parsed.notices.iter().map(|notice| match notice.location {
                Some(location) => format!(", {} {location}", notice.code.name()),
                None => format!(", {}", notice.code.name()),
            });
            format!("{name}: {} frames{}", parsed.clip.frame_count(), notices.collect::<String>())
        }
        Err(error) => {
            let kind = format!("{:?}", error.kind);
            let end = kind.find(|c: char| !c.is_alphanumeric()).unwrap_or(kind.len());
            let location = error.location.map(|location| format!(":{location}")).unwrap_or_default();
            format!("{name}{location}: {}: {}", &kind[..end], error.kind)
        }
    }
}

#[test]
fn files_are_read_or_rejected_as_listed() {
    let found: Vec<String> =
        files().iter().map(|(name, bytes)| description(name, &parse(bytes, Options::default()))).collect();
    let expected = expected();
    let only_in = |lines: &[String], others: &[String]| {
        lines.iter().filter(|line| !others.contains(line)).cloned().collect::<Vec<_>>().join("\n")
    };
    let (missing, additional) = (only_in(&expected, &found), only_in(&found, &expected));
    assert!(
        missing.is_empty() && additional.is_empty(),
        "expected.txt has\n{missing}\nbut the reader gives\n{additional}"
    );
    assert_eq!(expected.len(), found.len(), "every file is listed once");
}

#[test]
fn results_do_not_depend_on_the_chunks() {
    for (name, bytes) in files() {
        for lenient in [false, true] {
            let options = Options { lenient, ..Options::default() };
            let expected = parse(&bytes, options);
            for chunk in [1, 7, 64] {
                assert_eq!(read_in_chunks(&bytes, chunk, options), expected, "{name}, chunks of {chunk}");
            }
        }
    }
}

#[test]
fn values_that_cannot_be_read_are_held_if_lenient() {
    for (name, bytes) in files() {
        let Err(error) = parse(&bytes, Options::default()) else { continue };
        let is_value = match &error.kind {
            ErrorKind::BadValue { .. } => true,
            ErrorKind::LargeValue { place, .. } => place != "OFFSET",
            _ => false,
        };
        // A line of text between rows is not a row with unreadable values.
        if is_value && name != "bad/row/text-between-rows-after-stated-frames.bvh" {
            let parsed = parse(&bytes, Options { lenient: true, ..Options::default() }).expect(&name);
            let held = parsed.notices.iter().find(|notice| notice.code == Code::HeldValue);
            assert_eq!(held.expect(&name).location, error.location, "{name}");
        }
    }
}

#[test]
fn unchanged_clips_are_written_as_the_same_bytes() {
    for (name, bytes) in files() {
        let Ok(parsed) = parse(&bytes, Options::default()) else { continue };
        if name == "good/encoding/utf16-odd-byte.bvh" {
            // Half a character cannot be written.
            continue;
        }
        let frames = 0..parsed.clip.frame_count();
        assert!(rewrite(&bytes, &parsed.layout, &Arc::new(parsed.clip), frames) == bytes, "{name}");
    }
}
