//! Segmentation of a clip into actions.

use std::ops::Range;

use js_sys::Function;
use plantigrade::bvh::Rewriter;
use plantigrade::formats::{self, SegmentExport, SegmentFormat, SegmentsDocument};
use plantigrade::score::{self, Tolerance, TrueCut};
use plantigrade::segments::{self, ActionMovements, CutEdit, Method, Segment, Segmentation};
use serde::{Deserialize, Serialize};
use tsify::{Ts, Tsify};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::second::second_module;
use crate::types::{
    ArgumentError, CutEditInfo, Failure, FormatInfo, NoticeInfo, SegmentInfo, SegmentMethodInfo,
    SegmentOptions, from_js, parse_name, to_js,
};
use crate::{WasmClip, WasmRewriter};

/// All segmentation methods, the default first.
///
/// # Errors
/// Only if the conversion to JavaScript fails.
#[wasm_bindgen(js_name = segmentMethods)]
pub fn segment_methods() -> Result<Vec<Ts<SegmentMethodInfo>>, Failure> {
    Method::ALL.iter().map(|&method| to_js(&SegmentMethodInfo::from(method))).collect()
}

/// All file formats of segments, the default first.
///
/// # Errors
/// Only if the conversion to JavaScript fails.
#[wasm_bindgen(js_name = segmentFormats)]
pub fn segment_formats() -> Result<Vec<Ts<FormatInfo>>, Failure> {
    SegmentFormat::ALL.iter().map(|&format| to_js(&FormatInfo::from(format))).collect()
}

/// Returns the names of the actions of several clips, such that equal actions have equal names: letters in order
/// of first appearance. `movements` are the `actionMovements` of the clips, one after another.
#[wasm_bindgen(js_name = commonActions)]
pub fn common_actions(movements: &[f32]) -> Vec<String> {
    name_actions(movements)
}

/// The segments of a clip.
#[wasm_bindgen]
pub struct WasmSegmentation {
    /// The segments with edits applied.
    current: Segmentation,
    /// The segments of the method.
    detected: Vec<Segment>,
}

#[wasm_bindgen]
impl WasmClip {
    /// Segments the clip into actions; `progress` is called with the completed fraction, 0 to 1.
    ///
    /// # Errors
    /// If the clip has no motion, the joints of the method are unknown, or an option is invalid.
    pub fn segment(
        &self,
        options: Ts<SegmentOptions>,
        progress: &Function,
    ) -> Result<WasmSegmentation, Failure> {
        segment(self, options, progress)
    }

    /// Returns the segments with the given labels and names of actions as a file in a format that
    /// `segmentFormats` lists. Without names of actions, they are those of the clip.
    ///
    /// # Errors
    /// If the format does not exist.
    #[wasm_bindgen(js_name = saveSegments)]
    pub fn save_segments(
        &self,
        segmentation: &WasmSegmentation,
        labels: Vec<String>,
        actions: Vec<String>,
        format: &str,
        name: String,
        sha256: Option<String>,
    ) -> Result<Vec<u8>, Failure> {
        save_segments(self, segmentation, labels, actions, format, name, sha256)
    }

    /// Returns a writer of the frames `start..end`, to which the file of the clip is given.
    ///
    /// # Errors
    /// If the range is empty or extends beyond the clip.
    pub fn cut(&self, start: usize, end: usize) -> Result<WasmRewriter, Failure> {
        cut(self, start, end)
    }
}

#[wasm_bindgen]
impl WasmSegmentation {
    /// Applies edits of the cuts to the segments of the method, replacing earlier edits; later entries take
    /// precedence.
    ///
    /// # Errors
    /// If an entry is not a valid edit.
    #[wasm_bindgen(js_name = editCuts)]
    pub fn edit_cuts(&mut self, edits: Vec<Ts<CutEditInfo>>) -> Result<(), Failure> {
        edit_cuts(self, edits)
    }

    /// The segments in order; they cover the clip without gaps.
    ///
    /// # Errors
    /// Only if the conversion to JavaScript fails.
    pub fn segments(&self) -> Result<Vec<Ts<SegmentInfo>>, Failure> {
        segments_to_js(&self.current.segments)
    }

    /// Movements of the actions of the clip, in order of first appearance, for `commonActions`.
    #[wasm_bindgen(js_name = actionMovements)]
    pub fn action_movements(&self) -> Vec<f32> {
        write_actions(self)
    }

    /// Transitions between actions, as half-open frame ranges: start, end, start, end, ….
    pub fn transitions(&self) -> Vec<u32> {
        self.current.transitions.iter().flat_map(bounds).collect()
    }

    /// Motifs, the intervals between turning points, as half-open frame ranges: start, end, ….
    pub fn motifs(&self) -> Vec<u32> {
        self.current.motifs.iter().flat_map(|motif| bounds(&motif.frames)).collect()
    }

    /// Class of each motif, from 1; similar motifs share a class.
    #[wasm_bindgen(js_name = motifClasses)]
    pub fn motif_classes(&self) -> Vec<u32> {
        self.current.motifs.iter().map(|motif| motif.class as u32).collect()
    }

    /// Title of the method's curve.
    #[wasm_bindgen(js_name = curveTitle)]
    pub fn curve_title(&self) -> String {
        self.current.curve.title.into()
    }

    /// Positions of the curve's values, in fractional frames, ascending.
    #[wasm_bindgen(js_name = curveFrames)]
    pub fn curve_frames(&self) -> Vec<f32> {
        to_f32(&self.current.curve.frames)
    }

    /// The values of the curve.
    #[wasm_bindgen(js_name = curveValues)]
    pub fn curve_values(&self) -> Vec<f32> {
        to_f32(&self.current.curve.values)
    }

    /// Threshold at each value of the curve; empty if the method has none.
    #[wasm_bindgen(js_name = curveThreshold)]
    pub fn curve_threshold(&self) -> Vec<f32> {
        to_f32(&self.current.curve.threshold)
    }

    /// Indices of the extrema of the curve, if the method uses them.
    pub fn extrema(&self) -> Vec<u32> {
        self.current.curve.extrema.iter().map(|&index| index as u32).collect()
    }

    /// Assumptions and omissions of the method.
    ///
    /// # Errors
    /// Only if the conversion to JavaScript fails.
    pub fn notices(&self) -> Result<Vec<Ts<NoticeInfo>>, Failure> {
        self.current.notices.iter().map(|notice| to_js(&NoticeInfo::from(notice))).collect()
    }
}

/// True if a text contains segments, valid or not, of the clip with that name (without extension).
#[wasm_bindgen(js_name = hasSegments)]
pub fn has_segments(text: &str, clip: &str) -> bool {
    contains_segments(text, clip)
}

/// Segments of the clip read from a file.
#[wasm_bindgen]
pub struct WasmSegmentAnnotation {
    segments: Vec<Segment>,
    cuts: Vec<TrueCut>,
}

#[wasm_bindgen]
impl WasmSegmentAnnotation {
    /// Reads a segments document, a table, BABEL JSON or a truth file, for the clip with that name
    /// (without extension).
    ///
    /// # Errors
    /// If the text has none of these formats, or belongs to another clip.
    #[wasm_bindgen(constructor)]
    pub fn new(text: &str, name: &str, clip: &WasmClip) -> Result<WasmSegmentAnnotation, Failure> {
        read(text, name, clip)
    }

    /// The segments in order; they cover the clip without gaps.
    ///
    /// # Errors
    /// Only if the conversion to JavaScript fails.
    pub fn segments(&self) -> Result<Vec<Ts<SegmentInfo>>, Failure> {
        segments_to_js(&self.segments)
    }

    /// Agreement of the cuts of a segmentation with these, within 0.5 s and within 1 s.
    ///
    /// # Errors
    /// Only if the conversion to JavaScript fails.
    pub fn score(
        &self,
        clip: &WasmClip,
        segmentation: &WasmSegmentation,
    ) -> Result<Vec<Ts<CutScore>>, Failure> {
        score(self, clip, segmentation)
    }
}

/// Agreement of cuts; fractions from 0 to 1.
#[derive(Debug, Serialize, Deserialize, Tsify)]
pub struct CutScore {
    /// Tolerance, in seconds.
    pub within: f64,
    /// Fraction of the detected cuts that are annotated.
    pub precision: f64,
    /// Fraction of the annotated cuts that were detected.
    pub recall: f64,
    /// Harmonic mean of precision and recall.
    pub f1: f64,
}

fn bounds(frames: &Range<usize>) -> [u32; 2] {
    [frames.start as u32, frames.end as u32]
}

fn to_f32(values: &[f64]) -> Vec<f32> {
    values.iter().map(|&value| value as f32).collect()
}

second_module! {
    "0d" fn segment(
        clip: &WasmClip,
        options: Ts<SegmentOptions>,
        progress: &Function,
    ) -> Result<WasmSegmentation, Failure> {
        let params = segments::Params::try_from(&from_js(&options)?)?.check()?;
        let mut report = |fraction: f64| {
            // An error in the callback does not stop the segmentation.
            let _ = progress.call1(&JsValue::NULL, &fraction.into());
            Ok(())
        };
        let current = segments::segment(clip.core(), clip.skeleton(), params, &mut report)?;
        Ok(WasmSegmentation { detected: current.segments.clone(), current })
    }

    "0e" fn save_segments(
        clip: &WasmClip,
        segmentation: &WasmSegmentation,
        labels: Vec<String>,
        actions: Vec<String>,
        format: &str,
        name: String,
        sha256: Option<String>,
    ) -> Result<Vec<u8>, Failure> {
        let format: SegmentFormat = parse_name(format)?;
        let source = clip.source(name, sha256);
        let mut document = SegmentsDocument::new(
            source,
            clip.core(),
            clip.skeleton(),
            &segmentation.current,
            clip.notices(),
        );
        document.set_labels(&labels);
        document.set_actions(&actions);
        Ok(format.write(&SegmentExport { documents: vec![document], as_array: false }))
    }

    "1b" fn name_actions(movements: &[f32]) -> Vec<String> {
        segments::common_names(&[&ActionMovements::read(movements)]).concat()
    }

    "1c" fn write_actions(segmentation: &WasmSegmentation) -> Vec<f32> {
        let mut values = Vec::new();
        segmentation.current.actions.iter().for_each(|action| action.write(&mut values));
        values
    }

    "0f" fn cut(clip: &WasmClip, start: usize, end: usize) -> Result<WasmRewriter, Failure> {
        let frames = clip.core().frame_count();
        if start >= end || end > frames {
            return Err(ArgumentError::FrameRange { start, end, frames }.into());
        }
        Ok(Rewriter::new(clip.layout().clone(), clip.core().clone(), start..end).into())
    }

    "10" fn edit_cuts(
        segmentation: &mut WasmSegmentation,
        edits: Vec<Ts<CutEditInfo>>,
    ) -> Result<(), Failure> {
        let edits = edits.iter().map(|edit| {
            let CutEditInfo { cut, present } = from_js(edit)?;
            Ok(CutEdit { frame: cut, present })
        });
        let edits = edits.collect::<Result<Vec<CutEdit>, Failure>>()?;
        segmentation.current.segments = segments::edit_cuts(&segmentation.detected, &edits);
        Ok(())
    }

    "11" fn segments_to_js(segments: &[Segment]) -> Result<Vec<Ts<SegmentInfo>>, Failure> {
        segments.iter().map(|segment| to_js(&SegmentInfo::from(segment))).collect()
    }

    "12" fn contains_segments(text: &str, clip: &str) -> bool {
        formats::has_segments(text, clip)
    }

    "13" fn read(text: &str, name: &str, clip: &WasmClip) -> Result<WasmSegmentAnnotation, Failure> {
        let (frames, rate) = (clip.core().frame_count(), clip.core().rate());
        Ok(WasmSegmentAnnotation {
            segments: formats::read_segments(text, name, frames, rate)?,
            cuts: formats::read_cuts(text, name, frames, rate)?,
        })
    }

    "14" fn score(
        annotation: &WasmSegmentAnnotation,
        clip: &WasmClip,
        segmentation: &WasmSegmentation,
    ) -> Result<Vec<Ts<CutScore>>, Failure> {
        let score = |within: f64| {
            let tolerance = Tolerance::Seconds(within);
            let tally =
                score::cuts(&segmentation.current.cuts(), &annotation.cuts, clip.core().frame_time(), tolerance);
            let (precision, recall, f1) = (tally.precision(), tally.recall(), tally.f1());
            to_js(&CutScore { within, precision, recall, f1 })
        };
        [0.5, 1.0].into_iter().map(score).collect()
    }
}
