//! Input files: from paths to clips.

use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use plantigrade::bvh::{self, Clip, Limits, Options, Parsed, Reader};
use plantigrade::formats::Source;
use plantigrade::skeleton::{Overrides, Role};
use sha2::{Digest, Sha256};
use walkdir::WalkDir;

use crate::args::ReadArgs;
use crate::error::{InputError, UsageError};

/// One file to read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Input {
    /// Path of the file; `-` is standard input.
    pub path: PathBuf,
    /// Path of the result relative to the output folder, without extension.
    pub stem: PathBuf,
}

/// A clip that was read.
pub struct LoadedClip {
    /// The clip, with the frame rate of `--fps` applied, and the reader's notices.
    pub parsed: Parsed,
    /// SHA-256 of the file in hexadecimal.
    pub sha256: String,
    /// Joints, up axis and unit given on the command line.
    pub overrides: Overrides,
}

impl LoadedClip {
    /// Returns the source entry of documents about the clip.
    pub fn source(&self, input: &Input) -> Source {
        let name = input.path.file_name().unwrap_or(input.path.as_os_str());
        Source { name: name.to_string_lossy().into_owned(), sha256: Some(self.sha256.clone()) }
    }
}

/// Collects the input files. Folders are searched recursively for BVH files.
pub fn collect(args: &ReadArgs) -> Result<Vec<Input>, UsageError> {
    let mut inputs = Vec::new();
    for path in &args.paths {
        if path.is_dir() {
            collect_folder(path, &mut inputs)?;
        } else {
            let stem = if path == Path::new("-") { "stdin".into() } else { path.with_extension("") };
            let stem = stem.file_name().map_or_else(|| stem.clone(), PathBuf::from);
            inputs.push(Input { path: path.clone(), stem });
        }
    }
    Ok(inputs)
}

fn collect_folder(folder: &Path, inputs: &mut Vec<Input>) -> Result<(), UsageError> {
    let count_before = inputs.len();
    for entry in WalkDir::new(folder).sort_by_file_name() {
        let path = entry?.into_path();
        if path.is_file() && path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("bvh")) {
            let stem = path.strip_prefix(folder).unwrap_or(&path).with_extension("");
            inputs.push(Input { path, stem });
        }
    }
    if inputs.len() == count_before {
        return Err(UsageError::EmptyFolder(folder.into()));
    }
    Ok(())
}

/// Returns the overrides of the command line, or the first joint name that the clip lacks.
fn overrides(clip: &Clip, args: &ReadArgs) -> Result<Overrides, String> {
    let joint = |(role, name): &(Role, String)| match &name[..] {
        "" => Ok((*role, None)),
        name => match clip.joints().iter().position(|joint| joint.name == name) {
            Some(joint) => Ok((*role, Some(joint))),
            None => Err(name.to_owned()),
        },
    };
    let roles = args.joints.iter().map(joint).collect::<Result<_, _>>()?;
    Ok(Overrides { roles, up: args.up, metres_per_unit: args.unit })
}

/// Reads one file.
pub fn load(input: &Input, args: &ReadArgs) -> Result<LoadedClip, InputError> {
    let path = &input.path;
    let read_error = |error| InputError::Read { path: path.clone(), error };
    let parse_error = |error: bvh::Error| InputError::Parse { path: path.clone(), error: error.into() };
    let (mut file, expected_bytes): (Box<dyn Read>, u64) = if path == Path::new("-") {
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
    let mut chunk = vec![0; 1 << 16];
    loop {
        let count = file.read(&mut chunk).map_err(read_error)?;
        if count == 0 {
            break;
        }
        hash.update(&chunk[..count]);
        reader.push(&chunk[..count]).map_err(parse_error)?;
    }
    let mut parsed = reader.finish().map_err(parse_error)?;
    if let Some(fps) = args.fps {
        parsed.clip.set_frame_time(1.0 / fps);
    }
    let sha256 = hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect();
    let overrides = overrides(&parsed.clip, args);
    let overrides = overrides.map_err(|joint| InputError::UnknownJoint { path: path.clone(), joint })?;
    Ok(LoadedClip { parsed, sha256, overrides })
}
