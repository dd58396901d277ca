//! Contact of one foot: labels with the instants at which they change.

use crate::plants::{Edge, FootLabels};

/// Labels of one foot per frame, with the instants at which they change where these are known.
#[derive(Clone, Copy, Debug)]
pub struct Contact<'a> {
    /// True while the foot is planted.
    pub planted: &'a [bool],
    /// Instants in order of frames; an edge applies where the labels change at its frame.
    pub edges: &'a [Edge],
}

impl<'a> Contact<'a> {
    /// Creates labels whose instants are unknown: each change lies midway between its frames.
    pub fn from_frames(planted: &'a [bool]) -> Contact<'a> {
        Contact { planted, edges: &[] }
    }

    /// Returns the time of the boundary before `frame`, in seconds from the first frame of the clip.
    pub(crate) fn boundary_time(&self, frame: usize, frame_time: f64) -> f64 {
        let index = self.edges.binary_search_by_key(&frame, |edge| edge.frame);
        index.map_or((frame as f64 - 0.5) * frame_time, |index| self.edges[index].time)
    }
}

impl<'a> From<&'a FootLabels> for Contact<'a> {
    fn from(labels: &'a FootLabels) -> Contact<'a> {
        Contact { planted: &labels.planted, edges: &labels.edges }
    }
}
