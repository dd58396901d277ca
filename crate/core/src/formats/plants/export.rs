//! Plants to write, and the interface of writers and readers.

use crate::bvh::Clip;
use crate::formats::document::{ReadError, Source};
use crate::formats::plants::document::PlantsDocument;
use crate::notice::Notice;
use crate::plants::{Annotation, Detection};
use crate::skeleton::Skeleton;

/// Writes plants as the bytes of a file.
pub(crate) type Writer = fn(&PlantExport) -> Vec<u8>;

/// Reads plants of a clip with the given number of frames.
pub(crate) struct Reader {
    /// True if the bytes look like this format.
    pub recognises: fn(&[u8]) -> bool,
    pub read: fn(&[u8], usize) -> Result<Annotation, ReadError>,
}

/// Plants to write.
#[derive(Clone, Debug)]
pub struct PlantExport<'a> {
    /// Name and digest of the clip's file.
    pub source: Source,
    /// The clip.
    pub clip: &'a Clip,
    /// Notices of the reader.
    pub notices: &'a [Notice],
    /// Skeletons with their detections.
    pub skeletons: Vec<(&'a Skeleton, &'a Detection)>,
    /// If true, JSON is an array with one document per skeleton; if false, the first document.
    pub as_array: bool,
}

impl PlantExport<'_> {
    /// Returns one document per skeleton.
    pub fn documents(&self) -> Vec<PlantsDocument> {
        let document = |&(skeleton, detection): &(&Skeleton, &Detection)| {
            PlantsDocument::new(self.source.clone(), self.clip, skeleton, detection, self.notices)
        };
        self.skeletons.iter().map(document).collect()
    }

    /// Returns each detection with the name of its root joint, if the clip has several skeletons.
    pub(crate) fn labelled(&self) -> Vec<DetectionRef<'_>> {
        let has_several = self.clip.roots().count() > 1;
        let root_name = |skeleton: &Skeleton| self.clip.joints()[skeleton.root].name.as_str();
        self.skeletons
            .iter()
            .map(|&(skeleton, detection)| DetectionRef {
                root: has_several.then(|| root_name(skeleton)),
                detection,
            })
            .collect()
    }
}

/// Detection of one skeleton.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DetectionRef<'a> {
    /// Name of the root joint, if the clip has several skeletons.
    pub root: Option<&'a str>,
    pub detection: &'a Detection,
}
