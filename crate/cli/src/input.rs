//! Input files: from paths to clips.

use std::ffi::OsStr;
use std::fs::{self, File};
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use plantigrade::bvh::{self, Clip, Limits, Options, Parsed, Reader};
use plantigrade::formats::{ReadError, Source};
use plantigrade::skeleton::{Overrides, Role, Skeleton};
use sha2::{Digest, Sha256};
use walkdir::WalkDir;

use crate::args::ReadArgs;
use crate::error::{InputError, UsageError};
use crate::file::is_stream;

/// Number of bytes read at a time.
const CHUNK_BYTES: usize = 1 << 16;

/// One file to read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Input {
    /// Path of the file; `-` is standard input.
    pub path: PathBuf,
    /// Path of the result relative to the output folder, without extension.
    pub stem: PathBuf,
    /// Reason why the file cannot be processed, if it was found before reading.
    pub problem: Option<String>,
}

/// A clip that was read.
pub struct LoadedClip {
    /// The clip, with the frame rate of `--fps` applied, and the reader's notices.
    pub parsed: Parsed,
    /// SHA-256 of the file in hexadecimal.
    pub sha256: String,
    /// Joints, up axis and unit given on the command line.
    overrides: Overrides,
}

impl LoadedClip {
    /// Returns the source entry of documents about the clip.
    pub fn source(&self, input: &Input) -> Source {
        let name = input.path.file_name().unwrap_or(input.path.as_os_str());
        Source {
            name: name.to_string_lossy().into_owned(),
            sha256: Some(self.sha256.clone()),
            name_encoding: self.parsed.layout.name_encoding().map(Into::into),
        }
    }

    /// Returns the skeletons of the clip, one per root.
    pub fn skeletons(&self) -> Vec<Skeleton> {
        Skeleton::all(&self.parsed.clip, &self.overrides)
    }

    /// Returns the main skeleton of the clip.
    pub fn main_skeleton(&self) -> Skeleton {
        Skeleton::main(&self.parsed.clip, &self.overrides)
    }
}

/// Returns the root of the skeleton that owns `joint`.
fn root_of(clip: &Clip, joint: usize) -> usize {
    ancestors(clip, joint).last().unwrap_or(joint)
}

/// Returns the joint and its ancestors, up to the root.
fn ancestors(clip: &Clip, joint: usize) -> impl Iterator<Item = usize> + '_ {
    std::iter::successors(Some(joint), |&joint| clip.joints()[joint].parent)
}

/// Collects the input files. Folders are searched recursively for BVH files; the companion files
/// that macOS adds to archives are left out. A folder that cannot be listed is an input with a problem.
pub fn collect(args: &ReadArgs) -> Result<Vec<Input>, UsageError> {
    check_stdin(args, &[])?;
    let mut inputs = Vec::new();
    for path in &args.paths {
        if path.is_dir() {
            collect_folder(path, &mut inputs)?;
        } else {
            let stem = if is_stream(path) { "stdin".into() } else { path.with_extension("") };
            let stem = stem.file_name().map_or_else(|| stem.clone(), PathBuf::from);
            inputs.push(Input { path: path.clone(), stem, problem: None });
        }
    }
    Ok(inputs)
}

/// Checks that standard input is read only once, for a clip or for one of the other files.
pub fn check_stdin(read: &ReadArgs, files: &[&Option<PathBuf>]) -> Result<(), UsageError> {
    let paths = read.paths.iter().chain(files.iter().copied().flatten());
    if paths.filter(|path| is_stream(path)).count() > 1 { Err(UsageError::StdinTwice) } else { Ok(()) }
}

fn collect_folder(folder: &Path, inputs: &mut Vec<Input>) -> Result<(), UsageError> {
    let count_before = inputs.len();
    let is_companion = |name: &OsStr| name == "__MACOSX" || name.as_encoded_bytes().starts_with(b"._");
    let entries = WalkDir::new(folder).sort_by_file_name().into_iter();
    for entry in entries.filter_entry(|entry| entry.depth() == 0 || !is_companion(entry.file_name())) {
        let (path, problem) = match entry {
            Ok(entry) => (entry.into_path(), None),
            Err(error) => (error.path().unwrap_or(folder).to_owned(), Some(list_error(error))),
        };
        let is_bvh = || {
            let has_extension = path.extension().is_some_and(|name| name.eq_ignore_ascii_case("bvh"));
            // A link without a target is an input; reading it fails.
            has_extension && fs::metadata(&path).map_or(true, |data| data.is_file())
        };
        if problem.is_some() || is_bvh() {
            let stem = path.strip_prefix(folder).unwrap_or(&path).with_extension("");
            inputs.push(Input { path, stem, problem });
        }
    }
    if inputs.len() == count_before {
        return Err(UsageError::EmptyFolder(folder.into()));
    }
    Ok(())
}

/// Returns the message of a folder that cannot be listed.
fn list_error(error: walkdir::Error) -> String {
    error.into_io_error().map_or_else(|| "the folder cannot be listed".into(), |error| error.to_string())
}

/// Returns the overrides of the command line.
fn overrides(path: &Path, clip: &Clip, args: &ReadArgs) -> Result<Overrides, InputError> {
    let joint = |(role, name): &(Role, String)| match &name[..] {
        "" => Ok((*role, None)),
        name => Ok((*role, Some(find_joint(path, clip, name)?))),
    };
    let roles = args.joints.iter().map(joint).collect::<Result<_, _>>()?;
    Ok(Overrides { roles, up: args.up, metres_per_unit: args.unit })
}

/// Returns the joint with a name. If several have it, `SKELETON/NAME` names one of them: by the number
/// of its skeleton, from 1, or by a joint above it.
fn find_joint(path: &Path, clip: &Clip, name: &str) -> Result<usize, InputError> {
    let named = |name: &str| -> Vec<usize> {
        (0..clip.joints().len()).filter(|&joint| clip.joints()[joint].name == name).collect()
    };
    let mut found = named(name);
    if let ([], Some((above, name))) = (&found[..], name.split_once('/')) {
        let root = above.parse().ok().and_then(|number: usize| clip.roots().nth(number.checked_sub(1)?));
        let is_above = |joint: usize| root == Some(joint) || clip.joints()[joint].name == above;
        found = named(name);
        found.retain(|&joint| ancestors(clip, joint).any(is_above));
    }
    let (path, joint) = (path.to_owned(), name.to_owned());
    match found[..] {
        [] => Err(InputError::UnknownJoint { path, joint }),
        [found] => Ok(found),
        _ => {
            let name = name.rsplit_once('/').map_or(name, |(_, name)| name);
            let choices = found.iter().map(|&joint| {
                let root = root_of(clip, joint);
                let number = clip.roots().position(|other| other == root).map_or(0, |index| index + 1);
                let is_only = found.iter().filter(|&&other| root_of(clip, other) == root).count() == 1;
                match clip.joints()[joint].parent {
                    Some(parent) if !is_only => format!("{}/{name}", clip.joints()[parent].name),
                    _ => format!("{number}/{name}"),
                }
            });
            Err(InputError::AmbiguousJoint { path, joint, choices: choices.collect::<Vec<_>>().join(" or ") })
        }
    }
}

/// Returns the SHA-256 of a file in hexadecimal; `None` for standard input and files that cannot be read.
pub fn sha256(input: &Input) -> Option<String> {
    if is_stream(&input.path) {
        return None;
    }
    let mut hash = Sha256::new();
    let mut file = File::open(&input.path).ok()?;
    let mut chunk = vec![0; CHUNK_BYTES];
    loop {
        match file.read(&mut chunk).ok()? {
            0 => break,
            count => hash.update(&chunk[..count]),
        }
    }
    Some(hexadecimal(&hash.finalize()))
}

/// Returns bytes in hexadecimal.
pub fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// Reads one file.
pub fn load(input: &Input, args: &ReadArgs) -> Result<LoadedClip, InputError> {
    load_chunks(input, args, |_| {})
}

/// Reads a file, or standard input for `-`.
pub fn read_file(path: &Path) -> Result<Vec<u8>, InputError> {
    let mut bytes = Vec::new();
    let read =
        if is_stream(path) { io::stdin().read_to_end(&mut bytes).map(|_| bytes) } else { fs::read(path) };
    read.map_err(|error| InputError::Read { path: path.into(), error })
}

/// Returns the bytes of a file as text.
pub fn text<'a>(path: &Path, bytes: &'a [u8]) -> Result<&'a str, InputError> {
    let error = |_| {
        let message =
            "it is not text in UTF-8: save a document, a BABEL file or a table in this encoding".into();
        InputError::Labels { path: path.into(), error: ReadError::Invalid(message) }
    };
    std::str::from_utf8(bytes).map_err(error)
}

/// Reads one file and returns its bytes, too.
pub fn load_with_bytes(input: &Input, args: &ReadArgs) -> Result<(LoadedClip, Vec<u8>), InputError> {
    let mut bytes = Vec::new();
    let loaded = load_chunks(input, args, |chunk| bytes.extend_from_slice(chunk))?;
    Ok((loaded, bytes))
}

/// Reads one file and passes its bytes to `on_chunk`.
fn load_chunks(
    input: &Input,
    args: &ReadArgs,
    mut on_chunk: impl FnMut(&[u8]),
) -> Result<LoadedClip, InputError> {
    let path = &input.path;
    let read_error = |error| InputError::Read { path: path.clone(), error };
    let parse_error = |error: bvh::Error| InputError::Parse { path: path.clone(), error: error.into() };
    let (mut file, expected_bytes): (Box<dyn Read>, u64) = if is_stream(path) {
        (Box::new(io::stdin()), 0)
    } else {
        let file = File::open(path).map_err(read_error)?;
        let bytes = file.metadata().map_err(read_error)?.len();
        let limit = Limits::default().bytes;
        if bytes > limit {
            let error = io::Error::other(format!("the file has {bytes} bytes; the limit is {limit}"));
            return Err(read_error(error));
        }
        (Box::new(file), bytes)
    };
    let options = Options { lenient: args.lenient, expected_bytes, ..Options::default() };
    let mut reader = Reader::new(options);
    let mut hash = Sha256::new();
    let mut chunk = vec![0; CHUNK_BYTES];
    loop {
        let count = file.read(&mut chunk).map_err(read_error)?;
        if count == 0 {
            break;
        }
        hash.update(&chunk[..count]);
        reader.push(&chunk[..count]).map_err(parse_error)?;
        on_chunk(&chunk[..count]);
    }
    let mut parsed = reader.finish().map_err(parse_error)?;
    if let Some(fps) = args.fps {
        parsed.clip.set_frame_time(1.0 / fps);
    }
    let sha256 = hexadecimal(&hash.finalize());
    let overrides = overrides(path, &parsed.clip, args)?;
    Ok(LoadedClip { parsed, sha256, overrides })
}
