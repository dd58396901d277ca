//! Recorded motion for tests, where there is any.

use std::fs;
use std::path::{Path, PathBuf};

use plantigrade::bvh::{self, Parsed};

/// The folder of recorded motion, if this machine has one: `PLANTIGRADE_CORPUS`,
/// or `../shared/corpus` beside the project.
///
/// Tests that need it call this first and return when there is none, having said so.
pub fn corpus() -> Option<PathBuf> {
    let beside = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/corpus");
    let folder = std::env::var_os("PLANTIGRADE_CORPUS").map_or(beside, PathBuf::from);
    if folder.is_dir() {
        return Some(folder);
    }
    println!("skipped: no recorded motion here; PLANTIGRADE_CORPUS can name its folder");
    None
}

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
