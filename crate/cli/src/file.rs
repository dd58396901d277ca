//! Files that are written whole or not at all.

use std::collections::BTreeSet;
use std::ffi::OsStr;
use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use tempfile::{Builder, NamedTempFile};

/// Temporary files are named by this, some random characters, and the suffix. Results have other suffixes.
const TEMPORARY_PREFIX: &str = ".plantigrade-";
const TEMPORARY_SUFFIX: &str = ".tmp";

/// Symbolic links that are followed; more are a loop.
const MAX_LINKS: usize = 40;

/// True for `-`, which stands for standard input or standard output.
pub fn is_stream(path: &Path) -> bool {
    path == Path::new("-")
}

/// Writes a file atomically: to a temporary file in the same folder that then replaces it. An existing file
/// retains its permissions, and a symbolic link its place: the file that it refers to is replaced. Pipes and
/// devices are written directly.
pub fn write(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let existing = fs::metadata(path).ok();
    if existing.as_ref().is_some_and(|existing| !existing.is_file()) {
        return OpenOptions::new().write(true).open(path)?.write_all(bytes);
    }
    let path = follow_links(path)?;
    let folder = folder(&path);
    fs::create_dir_all(folder)?;
    let mut file = temporary_file(folder)?;
    file.write_all(bytes)?;
    if let Some(existing) = existing {
        file.as_file().set_permissions(existing.permissions())?;
    }
    file.persist(&path).map_err(|error| error.error)?;
    Ok(())
}

/// True if both paths lead to the same regular file.
pub fn is_same(a: &Path, b: &Path) -> bool {
    let file = |path: &Path| fs::canonicalize(path).ok().filter(|path| path.is_file());
    file(a).is_some_and(|a| file(b) == Some(a))
}

/// Removes the temporary files that killed processes have left next to `paths`.
pub fn remove_temporary_files<'a>(paths: impl IntoIterator<Item = &'a Path>) {
    // A path that cannot be resolved cannot be written either, which is reported then.
    let paths: Vec<PathBuf> = paths.into_iter().filter_map(|path| follow_links(path).ok()).collect();
    let folders: BTreeSet<&Path> = paths.iter().map(|path| folder(path)).collect();
    let entries = folders.into_iter().filter_map(|folder| fs::read_dir(folder).ok()).flatten();
    for entry in entries.filter_map(Result::ok).filter(|entry| is_temporary(&entry.file_name())) {
        // The process that writes the file holds its lock.
        let file = File::open(entry.path());
        if file.is_ok_and(|file| file.try_lock().is_ok() && file.metadata().is_ok_and(|data| data.is_file()))
        {
            let _ = fs::remove_file(entry.path());
        }
    }
}

/// Creates a temporary file with the permissions of a new file. It is locked, so that other processes do not
/// remove it.
fn temporary_file(folder: &Path) -> io::Result<NamedTempFile> {
    let mut builder = Builder::new();
    builder.prefix(TEMPORARY_PREFIX).suffix(TEMPORARY_SUFFIX);
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    loop {
        let file = builder.tempfile_in(folder)?;
        // Some file systems have no locks; files on them cannot be locked by others either.
        let _ = file.as_file().lock();
        // Another process may have removed the file before it was locked.
        if file.path().exists() {
            return Ok(file);
        }
    }
}

fn is_temporary(name: &OsStr) -> bool {
    let name = name.as_encoded_bytes();
    name.starts_with(TEMPORARY_PREFIX.as_bytes()) && name.ends_with(TEMPORARY_SUFFIX.as_bytes())
}

/// Returns the path to which symbolic links lead; there need not be a file.
fn follow_links(path: &Path) -> io::Result<PathBuf> {
    let mut target = path.to_owned();
    for _ in 0..MAX_LINKS {
        match fs::read_link(&target) {
            Ok(link) => target = folder(&target).join(link),
            Err(_) => return Ok(target),
        }
    }
    // Returns the error of the operating system.
    fs::metadata(path).map(|_| target)
}

/// Returns the folder of a file.
fn folder(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn temporary_files_in_use_are_not_removed() {
        let folder = tempfile::tempdir().expect("a folder");
        let result = folder.path().join("result");
        let file = temporary_file(folder.path()).expect("a file");
        let path = file.path().to_owned();
        remove_temporary_files([&*result]);
        assert!(path.exists());
        // As a killed process leaves it.
        let (file, _) = file.keep().expect("a file");
        drop(file);
        let others = ["result", ".plantigrade-x.json", "x.tmp"].map(|name| folder.path().join(name));
        others.iter().for_each(|path| fs::write(path, "").expect("a file"));
        remove_temporary_files([&*result]);
        assert!(!path.exists() && others.iter().all(|path| path.exists()));
    }
}
