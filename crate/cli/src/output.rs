//! Results in a folder: whole or not at all, and not made twice.

use std::collections::BTreeMap;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

/// The file in an output folder that says what its results were made of.
const RECORD: &str = ".plantigrade.json";

/// A folder of results.
pub struct OutputFolder {
    folder: PathBuf,
    made: Mutex<Made>,
}

/// For each result, the digest of what it was made of.
#[derive(Default, Serialize, Deserialize)]
struct Made(BTreeMap<PathBuf, String>);

impl OutputFolder {
    /// Opens a folder, creating it where it does not exist.
    pub fn open(folder: &Path) -> io::Result<OutputFolder> {
        fs::create_dir_all(folder)?;
        // A record that is missing or damaged only means that all is made again.
        let record = fs::read(folder.join(RECORD)).ok();
        let made = record.and_then(|bytes| serde_json::from_slice(&bytes).ok()).unwrap_or_default();
        Ok(OutputFolder { folder: folder.into(), made: Mutex::new(made) })
    }

    /// Where a result stands.
    pub fn path(&self, name: &Path) -> PathBuf {
        self.folder.join(name)
    }

    /// Whether a result is there and was made of the same.
    pub fn is_made(&self, name: &Path, recipe: &Recipe) -> bool {
        let made = self.made.lock().unwrap_or_else(PoisonError::into_inner);
        made.0.get(name) == Some(&recipe.digest()) && self.path(name).is_file()
    }

    /// Writes a result: to a temporary file first, so that nobody ever sees half of it.
    pub fn write(&self, name: &Path, result: &[u8], recipe: &Recipe) -> io::Result<()> {
        replace(&self.path(name), result)?;
        let mut made = self.made.lock().unwrap_or_else(PoisonError::into_inner);
        made.0.insert(name.into(), recipe.digest());
        Ok(())
    }

    /// Writes down what the results were made of.
    pub fn close(self) -> io::Result<()> {
        let made = self.made.into_inner().unwrap_or_else(PoisonError::into_inner);
        replace(&self.folder.join(RECORD), &serde_json::to_vec_pretty(&made)?)
    }
}

/// What a result is made of.
pub struct Recipe<'a> {
    /// SHA-256 of the input.
    pub sha256: &'a str,
    /// Everything of the command line that changes the result.
    pub settings: String,
}

impl Recipe<'_> {
    fn digest(&self) -> String {
        let whole = format!("{} {} {}", env!("CARGO_PKG_VERSION"), self.sha256, self.settings);
        Sha256::digest(whole).iter().map(|byte| format!("{byte:02x}")).collect()
    }
}

/// Writes a file whole: to a temporary one first, that then takes its place.
pub fn replace(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let folder = path.parent().unwrap_or(Path::new("."));
    fs::create_dir_all(folder)?;
    let mut file = tempfile::NamedTempFile::new_in(folder)?;
    file.write_all(bytes)?;
    file.persist(path).map_err(|error| error.error)?;
    Ok(())
}
