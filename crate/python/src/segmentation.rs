//! Segments of a clip.

use std::path::Path;

use plantigrade::formats::{self, SegmentExport, SegmentFormat, SegmentsDocument};
use plantigrade::score::{self, CutTally, Tolerance};
use plantigrade::segments::{Segment, Segmentation};
use pyo3::prelude::*;

use crate::clip_data::ClipData;
use crate::failure::Failure;
use crate::params::{self, NoticeTuple};

/// The segments of a clip.
#[pyclass(frozen)]
pub struct RawSegmentation {
    data: ClipData,
    segmentation: Segmentation,
}

impl RawSegmentation {
    pub fn new(data: ClipData, segmentation: Segmentation) -> RawSegmentation {
        RawSegmentation { data, segmentation }
    }
}

/// A segment: first frame, end, kind, label, action, period in seconds, number of cycles.
type SegmentTuple = (usize, usize, &'static str, String, String, Option<f64>, Option<f64>);

/// Precision, recall and F1 of cuts for one tolerance: seconds, or `None` for the range of the reference.
type CutScore = (Option<f64>, f64, f64, f64);

/// Scores of the cuts, and the fraction of frames in the right class with the adjusted Rand index.
type Agreement = (Vec<CutScore>, Option<(f64, f64)>);

#[pymethods]
impl RawSegmentation {
    /// Segments in order; they cover the clip.
    fn segments(&self) -> Vec<SegmentTuple> {
        let tuple = |segment: &Segment| {
            let cycles = segment.cycles;
            (
                segment.frames.start,
                segment.frames.end,
                segment.kind.name(),
                segment.label.clone(),
                segment.action.clone(),
                cycles.map(|cycles| cycles.period_s),
                cycles.map(|cycles| cycles.count),
            )
        };
        self.segmentation.segments.iter().map(tuple).collect()
    }

    /// Frame ranges in which one action changes into the next.
    fn transitions(&self) -> Vec<(usize, usize)> {
        self.segmentation.transitions.iter().map(|range| (range.start, range.end)).collect()
    }

    /// Motifs: first frame, end, class, amplitude.
    fn motifs(&self) -> Vec<(usize, usize, usize, f64)> {
        let motifs = self.segmentation.motifs.iter();
        motifs.map(|motif| (motif.frames.start, motif.frames.end, motif.class, motif.amplitude)).collect()
    }

    /// Name of the method.
    fn method(&self) -> &'static str {
        self.segmentation.params.method().name()
    }

    /// Frame rate of the clip, in Hz.
    fn fps(&self) -> f64 {
        self.data.clip.rate()
    }

    /// Number of frames.
    fn frames(&self) -> usize {
        self.data.clip.frame_count()
    }

    /// Name of the file of the clip.
    fn name(&self) -> &str {
        &self.data.name
    }

    /// Notices of the reader, the skeleton and the method.
    fn notices(&self) -> Vec<NoticeTuple> {
        let ClipData { notices, skeleton, .. } = &self.data;
        params::notices(notices.iter().chain(&skeleton.notices).chain(&self.segmentation.notices))
    }

    /// Returns the segments as a file.
    fn to_bytes(&self, py: Python<'_>, format: &str) -> PyResult<Vec<u8>> {
        let format: SegmentFormat = format.parse().map_err(Failure::from)?;
        Ok(py.detach(|| {
            let ClipData { clip, skeleton, notices, .. } = &self.data;
            let source = self.data.source();
            let document = SegmentsDocument::new(source, clip, skeleton, &self.segmentation, notices);
            format.write(&SegmentExport { documents: vec![document], as_array: false })
        }))
    }

    /// Agreement with the cuts and classes of a file. Returns a score per tolerance, and the fraction of
    /// frames in the right class with the adjusted Rand index, if the file has classes.
    fn score(&self, py: Python<'_>, text: &str, name: &str) -> PyResult<Agreement> {
        Ok(py.detach(|| self.agreement(text, name))?)
    }
}

impl RawSegmentation {
    fn agreement(&self, text: &str, name: &str) -> Result<Agreement, Failure> {
        let stem = Path::new(name).file_stem().unwrap_or_default().to_string_lossy();
        let clip = &self.data.clip;
        let truth = formats::read_cuts(text, &stem, clip.frame_count(), clip.rate())?;
        let actions = formats::read_segments(text, &stem, clip.frame_count(), clip.rate())?;
        let cuts = self.segmentation.cuts();
        let has_ranges = truth.iter().any(|cut| cut.earliest < cut.latest);
        let tolerances = Tolerance::REPORTED.into_iter().filter(|t| *t != Tolerance::Inside || has_ranges);
        let scores = tolerances.map(|tolerance| {
            let tally: CutTally = score::cuts(&cuts, &truth, clip.frame_time(), tolerance);
            let seconds = match tolerance {
                Tolerance::Seconds(seconds) => Some(seconds),
                Tolerance::Inside => None,
            };
            (seconds, tally.precision(), tally.recall(), tally.f1())
        });
        let class = |segment: &Segment| {
            if segment.label.is_empty() { segment.action.clone() } else { segment.label.clone() }
        };
        let classes: Vec<_> =
            actions.iter().map(|segment| (segment.frames.clone(), class(segment))).collect();
        let true_classes: Vec<_> = classes.iter().map(|(frames, class)| (frames.clone(), &**class)).collect();
        let detected: Vec<_> =
            self.segmentation.segments.iter().map(|s| (s.frames.clone(), &*s.action)).collect();
        let has_classes = classes.iter().any(|(_, class)| !class.is_empty());
        let of_classes = has_classes.then(|| {
            let score = score::classes(&detected, &true_classes);
            (score.frames.accuracy(), score.adjusted_rand)
        });
        Ok((scores.collect(), of_classes))
    }
}
