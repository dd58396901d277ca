//! Where recorded motion lies, where there is any.

use std::path::{Path, PathBuf};

/// The folder of recorded motion, if this machine has one: `PLANTIGRADE_CORPUS`,
/// or `../shared/corpus` beside the project.
///
/// Tests that need it call this first and return when there is none, having said so.
pub fn folder() -> Option<PathBuf> {
    let beside = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/corpus");
    let folder = std::env::var_os("PLANTIGRADE_CORPUS").map_or(beside, PathBuf::from);
    if folder.is_dir() {
        return Some(folder);
    }
    println!("skipped: no recorded motion here; PLANTIGRADE_CORPUS can name its folder");
    None
}
