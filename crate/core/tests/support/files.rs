//! Reading of BVH files in tests.

use std::fs;
use std::path::{Path, PathBuf};

use plantigrade::bvh::{self, Parsed};

/// Returns all BVH files below a folder, sorted by path.
pub fn bvh_files(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).expect("a readable folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            files.extend(bvh_files(&path));
        } else if path.extension().is_some_and(|extension| extension == "bvh") {
            files.push(path);
        }
    }
    files.sort();
    files
}

/// Reads a file.
///
/// # Panics
/// If the file is not valid BVH.
pub fn read(path: &Path) -> Parsed {
    let bytes = fs::read(path).expect("a readable file");
    bvh::parse(&bytes, bvh::Options::default()).unwrap_or_else(|error| panic!("{}:{error}", path.display()))
}
