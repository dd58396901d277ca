//! Folders of results with a record of their origins, from which an interrupted batch resumes.

use std::collections::BTreeMap;
use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::slice;

use plantigrade::formats::MethodUsed;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use sha2::{Digest, Sha256};

use crate::file;
use crate::input::hexadecimal;

/// Name of the record: one line of JSON per result. Lines are appended before results are written, the last
/// line about a result holds, and damaged lines are ignored. The last process that uses a folder sorts the
/// record when it finishes.
const RECORD_FILE: &str = ".plantigrade.jsonl";

/// Name of a file without content, of which each process that appends to the record holds a shared lock. The
/// record itself cannot be locked because it is replaced when it is sorted.
const LOCK_FILE: &str = ".plantigrade.lock";

/// Name of the record of earlier versions, which would take results of this one for its own.
const EARLIER_RECORD_FILE: &str = ".plantigrade.json";

/// Names in an output folder that results cannot have.
pub const RESERVED_NAMES: [&str; 2] = [RECORD_FILE, LOCK_FILE];

/// A folder of results.
pub struct OutputFolder {
    folder: PathBuf,
    /// True if all results are computed again and all files are replaced.
    force: bool,
    /// Record at the time when the folder was opened.
    entries: BTreeMap<String, Entry>,
    record: File,
    lock: File,
}

/// Line of the record.
#[derive(Serialize, Deserialize)]
struct Entry {
    /// Path of the result in the folder, escaped without loss.
    result: String,
    /// Digest of the origin.
    origin: String,
    /// SHA-256 of the result.
    sha256: String,
}

impl OutputFolder {
    /// Opens a folder for results of the given names, creating it if necessary. Removes the temporary files
    /// of killed processes. With `force`, no result is up to date and every file is replaced.
    pub fn open<'a>(
        folder: &Path,
        names: impl IntoIterator<Item = &'a Path>,
        force: bool,
    ) -> io::Result<OutputFolder> {
        fs::create_dir_all(folder)?;
        let lock = appendable(&folder.join(LOCK_FILE))?;
        match lock.lock_shared() {
            Err(error) if error.kind() != io::ErrorKind::Unsupported => return Err(error),
            _ => {}
        }
        let paths: Vec<PathBuf> = names.into_iter().map(|name| folder.join(name)).collect();
        file::remove_temporary_files(paths.iter().map(PathBuf::as_path).chain([&*folder.join(RECORD_FILE)]));
        let _ = fs::remove_file(folder.join(EARLIER_RECORD_FILE));
        let mut record = appendable(&folder.join(RECORD_FILE))?;
        let bytes = fs::read(folder.join(RECORD_FILE))?;
        if !bytes.is_empty() && !bytes.ends_with(b"\n") {
            // Ends the line of a killed process.
            record.write_all(b"\n")?;
        }
        Ok(OutputFolder { folder: folder.into(), force, entries: entries(&bytes), record, lock })
    }

    /// Returns the path of a result.
    pub fn path(&self, name: &Path) -> PathBuf {
        self.folder.join(name)
    }

    /// True if names that differ in case only are the same file.
    pub fn ignores_case(&self) -> bool {
        self.folder.join(LOCK_FILE.to_uppercase()).exists()
    }

    /// True if a result has the given origin and was not changed since.
    pub fn is_up_to_date(&self, name: &Path, origin: &Origin) -> bool {
        // Reading a pipe would wait for its writer.
        let path = self.path(name);
        !self.force
            && self.entries.get(&key(name)).is_some_and(|entry| {
                entry.origin == origin.digest()
                    && path.is_file()
                    && fs::read(&path).is_ok_and(|bytes| entry.sha256 == hex_digest(&bytes))
            })
    }

    /// Records the origin of a result, and writes the result atomically.
    ///
    /// # Errors
    /// Those of writing, if something other than a file has the name of the result, and if the work of a
    /// person would be lost.
    pub fn write(&self, name: &Path, result: &[u8], origin: &Origin) -> io::Result<()> {
        let path = self.path(name);
        let exists = |message| io::Error::new(io::ErrorKind::AlreadyExists, message);
        if let Ok(existing) = fs::metadata(&path) {
            if !existing.is_file() {
                return Err(exists("a folder, pipe or device has this name"));
            }
            if !self.force && !self.is_replaceable(name, &fs::read(&path)?, result)? {
                return Err(exists(
                    "it was changed after it was written, or has edits. Move it, or replace it with \
                     --force",
                ));
            }
        }
        let entry = Entry { result: key(name), origin: origin.digest(), sha256: hex_digest(result) };
        // Before the result, so that the record contains every result. One write, so that lines of several
        // processes do not mix.
        (&self.record).write_all(&line(&entry))?;
        file::write(&path, result)
    }

    /// True if an existing file is not the work of a person: it has been written as a result, is the beginning
    /// of the new result, or is not in the record and not edited.
    fn is_replaceable(&self, name: &Path, existing: &[u8], result: &[u8]) -> io::Result<bool> {
        let key = key(name);
        let sha256 = hex_digest(existing);
        if result.starts_with(existing) || self.entries.get(&key).is_some_and(|entry| entry.sha256 == sha256)
        {
            return Ok(true);
        }
        // Another process may have written it since, or a killed process may have recorded a newer result.
        let record = fs::read(self.folder.join(RECORD_FILE))?;
        let written: Vec<Entry> = lines(&record).filter(|entry| entry.result == key).collect();
        Ok(match written.is_empty() {
            true => !is_edited(existing),
            false => written.iter().any(|entry| entry.sha256 == sha256),
        })
    }

    /// Sorts the record and leaves out lines that no longer hold, unless another process uses the folder.
    pub fn close(self) -> io::Result<()> {
        let OutputFolder { folder, lock, record, .. } = self;
        drop(record);
        let is_last = lock.unlock().is_ok() && lock.try_lock().is_ok();
        if !is_last {
            return Ok(());
        }
        let path = folder.join(RECORD_FILE);
        let bytes = fs::read(&path)?;
        let sorted: Vec<u8> = entries(&bytes).values().flat_map(line).collect();
        if sorted != bytes {
            file::write(&path, &sorted)?;
        }
        Ok(())
    }
}

/// True for JSON that is not an unedited document of this program, as edited and measured labels. A file has
/// several documents if the clip has several skeletons.
fn is_edited(file: &[u8]) -> bool {
    let Ok(file) = serde_json::from_slice::<Value>(file) else { return false };
    let documents = file.as_array().map_or(slice::from_ref(&file), Vec::as_slice);
    let is_unedited = |document: &Value| {
        let is_automatic = |segment: &Value| segment["source"] != "edited";
        document["format"].as_str().is_some_and(|format| format.starts_with("plantigrade-"))
            && document["method"]["name"] != MethodUsed::TRUTH
            && document["edits"].as_array().is_none_or(Vec::is_empty)
            && document["segments"].as_array().is_none_or(|segments| segments.iter().all(is_automatic))
    };
    !documents.iter().all(is_unedited)
}

/// Opens a file for appending, creating it if necessary.
fn appendable(path: &Path) -> io::Result<File> {
    // Windows locks files only if they can be read, too.
    OpenOptions::new().create(true).read(true).append(true).open(path)
}

/// Returns the valid lines of a record.
fn lines(record: &[u8]) -> impl Iterator<Item = Entry> {
    record.split(|&byte| byte == b'\n').filter_map(|line| serde_json::from_slice(line).ok())
}

/// Returns the last entries of a record by the names of their results.
fn entries(record: &[u8]) -> BTreeMap<String, Entry> {
    lines(record).map(|entry| (entry.result.clone(), entry)).collect()
}

/// Returns the line of an entry.
fn line(entry: &Entry) -> Vec<u8> {
    let mut line = serde_json::to_vec(entry).expect("an entry of text");
    line.push(b'\n');
    line
}

/// Returns the name of a result as text; different names have different texts.
fn key(name: &Path) -> String {
    name.as_os_str().as_encoded_bytes().escape_ascii().to_string()
}

/// Origin of a result: everything it depends on.
pub struct Origin<'a> {
    /// SHA-256 of the input.
    pub sha256: &'a str,
    /// All options that change the result.
    pub options: String,
}

impl Origin<'_> {
    fn digest(&self) -> String {
        let text = format!("{} {} {}", env!("CARGO_PKG_VERSION"), self.sha256, self.options);
        hex_digest(text.as_bytes())
    }
}

/// Returns the SHA-256 of bytes in hexadecimal.
pub fn hex_digest(bytes: &[u8]) -> String {
    hexadecimal(&Sha256::digest(bytes))
}
