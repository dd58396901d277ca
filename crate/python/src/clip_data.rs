//! Data of a clip, which its results share.

use std::sync::Arc;

use plantigrade::bvh::{Clip, Layout};
use plantigrade::formats::Source;
use plantigrade::notice::Notice;
use plantigrade::plants::{DetectError, Feet};
use plantigrade::skate::CleanedPlant;
use plantigrade::skeleton::{Overrides, Skeleton};
use pyo3::pybacked::PyBackedBytes;
use sha2::{Digest, Sha256};

use crate::failure::Failure;

/// The file of a clip, whose text is preserved when the clip is written.
#[derive(Clone)]
pub struct File {
    /// Bytes of the file.
    pub bytes: Arc<PyBackedBytes>,
    /// Positions of its numbers.
    pub layout: Arc<Layout>,
}

/// Data of a clip, shared by its results.
#[derive(Clone)]
pub struct ClipData {
    /// The clip.
    pub clip: Arc<Clip>,
    /// The main skeleton.
    pub skeleton: Skeleton,
    /// Notices of the reader, and of the clean-up if the clip is its result.
    pub notices: Vec<Notice>,
    /// File name without folders; empty if unknown.
    pub name: String,
    /// The file, if the clip was read from one.
    pub file: Option<File>,
    /// Joint of each point, if the clip is one of points.
    pub points: Option<Arc<[usize]>>,
    /// Values that override those found.
    pub overrides: Overrides,
    /// Result of the clean-up that made the clip.
    pub cleaned: Arc<[CleanedPlant]>,
}

impl ClipData {
    /// Returns the source entry of documents about the clip.
    pub fn source(&self) -> Source {
        let Some(File { bytes, layout }) = &self.file else {
            return Source { name: self.name.clone(), ..Source::default() };
        };
        let hash = Sha256::digest(&bytes[..]);
        Source {
            name: self.name.clone(),
            sha256: Some(hash.iter().map(|byte| format!("{byte:02x}")).collect()),
            name_encoding: layout.name_encoding().map(Into::into),
        }
    }

    /// True if another clip is this one: read from an equal file, or of equal positions.
    pub fn is_same(&self, other: &ClipData) -> bool {
        Arc::ptr_eq(&self.clip, &other.clip)
            || match (&self.file, &other.file) {
                (Some(file), Some(other)) => file.bytes[..] == other.bytes[..],
                (None, None) => self.clip == other.clip,
                _ => false,
            }
    }

    /// Computes the tracks of the feet.
    pub fn feet(&self) -> Result<Feet, Failure> {
        Feet::new(&self.clip, &self.skeleton).map_err(|error| match (error, &self.points) {
            (DetectError::NoFeet, _) if self.skeleton.roles.has_feet() => Failure::new(
                "the length of the legs is 0 in every frame",
                "Check that the roles of hips, knees and ankles have different joints, and that the positions \
                 of these joints differ.",
            ),
            (error, _) => Failure::from(error).in_file(&self.name),
        })
    }

    /// Returns the joint of an index of Python.
    pub fn joint(&self, index: usize) -> usize {
        self.points.as_ref().map_or(index, |points| points[index])
    }

    /// Returns the joints in the order of Python.
    pub fn joints(&self) -> Vec<usize> {
        match &self.points {
            Some(points) => points.to_vec(),
            None => (0..self.clip.joints().len()).collect(),
        }
    }

    /// Returns the index in Python of a joint; `None` for an added one.
    pub fn index(&self, joint: usize) -> Option<usize> {
        match &self.points {
            Some(points) => points.iter().position(|&other| other == joint),
            None => Some(joint),
        }
    }
}
