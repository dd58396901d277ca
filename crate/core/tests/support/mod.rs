//! Recorded motion for tests, where there is any.

use std::fs;
use std::path::{Path, PathBuf};

use plantigrade::bvh::{self, Parsed};

pub mod corpus;

/// All BVH files below a folder, in order.
pub fn bvh_files(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).expect("a folder that can be read") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            found.extend(bvh_files(&path));
        } else if path.extension().is_some_and(|extension| extension == "bvh") {
            found.push(path);
        }
    }
    found.sort();
    found
}

/// Reads a file that must be readable.
pub fn read(path: &Path) -> Parsed {
    let bytes = fs::read(path).expect("a file that can be read");
    bvh::parse(&bytes, bvh::Options::default()).unwrap_or_else(|error| panic!("{}:{error}", path.display()))
}
