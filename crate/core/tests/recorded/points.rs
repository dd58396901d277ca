//! Clips of points.

use std::path::Path;

use crate::support::{bvh_files, read};
use crate::support_points::have_the_labels_of;

/// The labels of positions are those of the clip, to the frame.
pub fn points_of_clips_have_the_labels_of_the_clips(corpus: &Path) {
    let plates = corpus.join("../plates");
    let folders = [corpus, &*plates].into_iter().filter(|folder| folder.is_dir());
    let files: Vec<_> = folders.flat_map(bvh_files).collect();
    let labelled =
        files.iter().filter(|path| have_the_labels_of(&read(path).clip, &path.display().to_string()));
    let labelled = labelled.count();
    assert!(labelled > files.len() / 2, "{labelled} of {} clips have feet", files.len());
}
