//! Output: JSON on standard output; files that are written atomically and reused while up to date.

use std::collections::BTreeMap;
use std::fmt::Arguments;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use crate::error::InputError;

/// Name of the file in an output folder that records the origin of its results.
const RECORD_FILE: &str = ".plantigrade.json";

/// Exit code of a program that is ended by the signal for a closed pipe, as shells report it.
const CLOSED_PIPE: i32 = 141;

/// Prints a value as indented JSON.
pub fn print_json(value: &impl Serialize) {
    let json = serde_json::to_string_pretty(value).expect("text, numbers and lists");
    print(format_args!("{json}\n"));
}

/// Prints text on standard output. Ends the program if that is impossible.
pub fn print(text: Arguments<'_>) {
    if let Err(error) = print_bytes(text.to_string().as_bytes()) {
        report(format_args!("{}", InputError::Write { path: "<stdout>".into(), error }));
        std::process::exit(1);
    }
}

/// Writes bytes to standard output. Ends the program quietly if the reader has closed the pipe.
pub fn print_bytes(bytes: &[u8]) -> io::Result<()> {
    let mut stdout = io::stdout().lock();
    match stdout.write_all(bytes).and_then(|()| stdout.flush()) {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => std::process::exit(CLOSED_PIPE),
        result => result,
    }
}

/// Prints a line on standard error, unless its reader has closed the pipe.
pub fn report(line: Arguments<'_>) {
    let _ = writeln!(io::stderr(), "{line}");
}

/// A folder of results.
pub struct OutputFolder {
    folder: PathBuf,
    record: Mutex<Record>,
}

/// Digest of the origin of each result, by file name.
#[derive(Default, Serialize, Deserialize)]
struct Record(BTreeMap<PathBuf, String>);

impl OutputFolder {
    /// Opens a folder, creating it if necessary.
    pub fn open(folder: &Path) -> io::Result<OutputFolder> {
        fs::create_dir_all(folder)?;
        // With a missing or damaged record all results are computed again.
        let bytes = fs::read(folder.join(RECORD_FILE)).ok();
        let record = bytes.and_then(|bytes| serde_json::from_slice(&bytes).ok()).unwrap_or_default();
        Ok(OutputFolder { folder: folder.into(), record: Mutex::new(record) })
    }

    /// Returns the path of a result.
    pub fn path(&self, name: &Path) -> PathBuf {
        self.folder.join(name)
    }

    /// True if a result exists and has the given origin.
    pub fn is_up_to_date(&self, name: &Path, origin: &Origin) -> bool {
        let record = self.record.lock().unwrap_or_else(PoisonError::into_inner);
        record.0.get(name) == Some(&origin.digest()) && self.path(name).is_file()
    }

    /// Writes a result atomically.
    pub fn write(&self, name: &Path, result: &[u8], origin: &Origin) -> io::Result<()> {
        write_atomically(&self.path(name), result)?;
        let mut record = self.record.lock().unwrap_or_else(PoisonError::into_inner);
        record.0.insert(name.into(), origin.digest());
        Ok(())
    }

    /// Writes the record of origins.
    pub fn close(self) -> io::Result<()> {
        let record = self.record.into_inner().unwrap_or_else(PoisonError::into_inner);
        write_atomically(&self.folder.join(RECORD_FILE), &serde_json::to_vec_pretty(&record)?)
    }
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
        Sha256::digest(text).iter().map(|byte| format!("{byte:02x}")).collect()
    }
}

/// Writes a file atomically: to a temporary file that then replaces `path`.
pub fn write_atomically(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let folder = path.parent().unwrap_or(Path::new("."));
    fs::create_dir_all(folder)?;
    let mut file = tempfile::NamedTempFile::new_in(folder)?;
    file.write_all(bytes)?;
    file.persist(path).map_err(|error| error.error)?;
    Ok(())
}
