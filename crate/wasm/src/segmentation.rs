//! The segments of a clip.

use std::ops::Range;

use js_sys::Function;
use plantigrade::labels::{self, SegmentsDocument, Source};
use plantigrade::score::{self, Tolerance, TrueCut};
use plantigrade::segments::{self, Method, Segment, Segmentation};
use serde::{Deserialize, Serialize};
use tsify::{Ts, Tsify};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::RawClip;
use crate::records::{Failure, NoticeText, SegmentFacts, SegmentMethodFacts, SegmentOptions, from_js, to_js};

/// All methods of segmentation, the default first.
///
/// # Errors
/// None.
#[wasm_bindgen(js_name = segmentMethods)]
pub fn segment_methods() -> Result<Vec<Ts<SegmentMethodFacts>>, Failure> {
    Method::ALL.into_iter().map(|method| to_js(&SegmentMethodFacts::from(method))).collect()
}

/// The segments of a clip.
#[wasm_bindgen]
pub struct RawSegmentation(Segmentation);

#[wasm_bindgen]
impl RawClip {
    /// Cuts the clip into actions; `progress` is called with the share done, from 0 to 1.
    ///
    /// # Errors
    /// If there is no motion, the method's joints are not known, or an option breaks its rule.
    pub fn segment(
        &self,
        options: Ts<SegmentOptions>,
        progress: &Function,
    ) -> Result<RawSegmentation, Failure> {
        let params = segments::Params::try_from(&from_js(&options)?)?.check()?;
        let mut report = |share: f64| {
            // Whoever listens may fail: that is theirs to tell.
            let _ = progress.call1(&JsValue::NULL, &share.into());
            Ok(())
        };
        Ok(RawSegmentation(segments::segment(self.core(), self.skeleton(), params, &mut report)?))
    }

    /// The segments as a document, with a person's names for them: `json`, `csv` or `babel`.
    ///
    /// # Errors
    /// If there is no such format.
    #[wasm_bindgen(js_name = saveSegments)]
    pub fn save_segments(
        &self,
        segmentation: &RawSegmentation,
        names: Vec<String>,
        format: &str,
        name: String,
        sha256: Option<String>,
    ) -> Result<String, Failure> {
        let source = Source { name, sha256 };
        let mut document =
            SegmentsDocument::of(source, self.core(), self.skeleton(), &segmentation.0, self.notices());
        document.with_labels(&names);
        Ok(match format {
            "json" => document.to_json(),
            "csv" => labels::segments_csv(&[document]),
            "babel" => labels::babel_json(&[document]),
            _ => return Err(Failure::from(format!("there is no format {format:?}"))),
        })
    }

    /// The frames from `start` to before `end` as the bytes of a BVH file of their own.
    ///
    /// # Errors
    /// If there are no such frames.
    pub fn cut(&self, start: usize, end: usize) -> Result<Vec<u8>, Failure> {
        let frames = self.core().frame_count();
        if start >= end || end > frames {
            return Err(format!("there are no frames {start} to {end}: the clip has {frames}").into());
        }
        Ok(plantigrade::bvh::write(&self.core().part(start..end)).into_bytes())
    }
}

#[wasm_bindgen]
impl RawSegmentation {
    /// The segments in order; they tile the clip.
    ///
    /// # Errors
    /// None that a clip can cause.
    pub fn segments(&self) -> Result<Vec<Ts<SegmentFacts>>, Failure> {
        self.0.segments.iter().map(|segment| to_js(&SegmentFacts::from(segment))).collect()
    }

    /// Frames in which one action goes over into the next: start, end, start, end, ...; half-open.
    pub fn transitions(&self) -> Vec<u32> {
        self.0.transitions.iter().flat_map(ends).collect()
    }

    /// The pieces of motion between turning points: start, end, start, end, ...; half-open.
    pub fn motifs(&self) -> Vec<u32> {
        self.0.motifs.iter().flat_map(|motif| ends(&motif.frames)).collect()
    }

    /// The class of each motif, from 1: those that are alike have the same.
    #[wasm_bindgen(js_name = motifClasses)]
    pub fn motif_classes(&self) -> Vec<u32> {
        self.0.motifs.iter().map(|motif| motif.class as u32).collect()
    }

    /// What the method's curve shows.
    #[wasm_bindgen(js_name = curveTitle)]
    pub fn curve_title(&self) -> String {
        self.0.curve.title.into()
    }

    /// Where the values of the curve lie: frames with fractions, ascending.
    #[wasm_bindgen(js_name = curveFrames)]
    pub fn curve_frames(&self) -> Vec<f32> {
        single(&self.0.curve.frames)
    }

    /// The values of the curve.
    #[wasm_bindgen(js_name = curveValues)]
    pub fn curve_values(&self) -> Vec<f32> {
        single(&self.0.curve.values)
    }

    /// What each value was compared with; empty where there is no such threshold.
    #[wasm_bindgen(js_name = curveThreshold)]
    pub fn curve_threshold(&self) -> Vec<f32> {
        single(&self.0.curve.threshold)
    }

    /// Indices of the values at which the curve turns, where that matters.
    pub fn extrema(&self) -> Vec<u32> {
        self.0.curve.extrema.iter().map(|&index| index as u32).collect()
    }

    /// What was assumed or left out.
    ///
    /// # Errors
    /// None that a clip can cause.
    pub fn notices(&self) -> Result<Vec<Ts<NoticeText>>, Failure> {
        self.0.notices.iter().map(|notice| to_js(&NoticeText::from(notice))).collect()
    }
}

/// Whether a text holds segments of the clip of that name (without its ending), right or wrong.
#[wasm_bindgen(js_name = hasSegments)]
pub fn has_segments(text: &str, clip: &str) -> bool {
    labels::has_segments(text, clip)
}

/// Segments of the clip by someone else.
#[wasm_bindgen]
pub struct RawSegments {
    segments: Vec<Segment>,
    cuts: Vec<TrueCut>,
}

#[wasm_bindgen]
impl RawSegments {
    /// Reads a segments document, a table, BABEL's JSON or a truth file, for a clip of that name
    /// (without its ending).
    ///
    /// # Errors
    /// If the text is none of these, or is of another clip.
    #[wasm_bindgen(constructor)]
    pub fn new(text: &str, name: &str, clip: &RawClip) -> Result<RawSegments, Failure> {
        let (frames, rate) = (clip.core().frame_count(), clip.core().rate());
        Ok(RawSegments {
            segments: labels::read_segments(text, name, frames, rate)?,
            cuts: labels::read_cuts(text, name, frames, rate)?,
        })
    }

    /// The segments in order; they tile the clip.
    ///
    /// # Errors
    /// None that segments can cause.
    pub fn segments(&self) -> Result<Vec<Ts<SegmentFacts>>, Failure> {
        self.segments.iter().map(|segment| to_js(&SegmentFacts::from(segment))).collect()
    }

    /// How well the cuts of a segmentation of the clip agree, within half a second and within one.
    ///
    /// # Errors
    /// None that segments can cause.
    pub fn score(&self, clip: &RawClip, found: &RawSegmentation) -> Result<Vec<Ts<CutScore>>, Failure> {
        let score = |within: f64| {
            let tolerance = Tolerance::Seconds(within);
            let tally = score::cuts(&found.0.cuts(), &self.cuts, clip.core().frame_time(), tolerance);
            let (precision, recall, f1) = (tally.precision(), tally.recall(), tally.f1());
            to_js(&CutScore { within, precision, recall, f1 })
        };
        [0.5, 1.0].into_iter().map(score).collect()
    }
}

/// How well cuts agree; shares from 0 to 1.
#[derive(Debug, Serialize, Deserialize, Tsify)]
pub struct CutScore {
    /// Seconds by which a cut may miss.
    pub within: f64,
    /// Share of the cuts found that there are.
    pub precision: f64,
    /// Share of the cuts that were found.
    pub recall: f64,
    /// Harmonic mean of both.
    pub f1: f64,
}

fn ends(frames: &Range<usize>) -> [u32; 2] {
    [frames.start as u32, frames.end as u32]
}

fn single(values: &[f64]) -> Vec<f32> {
    values.iter().map(|&value| value as f32).collect()
}
