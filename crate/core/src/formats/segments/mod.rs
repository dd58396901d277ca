//! Formats of segments.

mod audacity;
mod babel;
mod document;
mod elan;
mod engines;
mod export;
mod file;
mod json;
mod npz;
mod table;

pub use document::{DocumentMotif, DocumentSegment, SegmentsDocument, SegmentsMethod};
pub use export::SegmentExport;

use crate::formats::document::ReadError;
use crate::formats::format_info::FormatInfo;
use crate::registry::registry;
use crate::score::TrueCut;
use crate::segments::Segment;
use export::{Reader, Writer};
use file::SegmentFile;

registry! {
    /// File format of segments.
    pub enum SegmentFormat: FormatInfo<Writer, Reader> as "format" {
        /// Document with the segments.
        #[default]
        Json => json::FORMAT_INFO,
        /// Table with one row per segment.
        Csv => table::FORMAT_INFO,
        /// BABEL file.
        Babel => babel::FORMAT_INFO,
        /// Label track for Audacity.
        Audacity => audacity::FORMAT_INFO,
        /// Tab-delimited tiers for ELAN.
        Elan => elan::FORMAT_INFO,
        /// NumPy archive.
        Npz => npz::FORMAT_INFO,
        /// Script for Unreal Engine.
        Unreal => engines::UNREAL,
        /// Script for Unity.
        Unity => engines::UNITY,
    }
    with {
        /// Returns the file extension, without the leading dot.
        extension: &'static str,
        /// Returns the media (MIME) type.
        media_type: &'static str,
    }
}

impl SegmentFormat {
    /// Returns segments as the bytes of a file.
    ///
    /// # Panics
    /// If there is no document, or a NumPy archive would exceed 4 GiB.
    pub fn write(self, export: &SegmentExport) -> Vec<u8> {
        (self.entry().write)(export)
    }

    /// Reads the text if it looks like this format.
    fn read(self, text: &str, clip: &str) -> Option<Result<SegmentFile, ReadError>> {
        let reader = self.entry().read.as_ref()?;
        (reader.recognises)(text).then(|| (reader.read)(text, clip))
    }
}

/// Reads the segments of a clip, in any format of [`SegmentFormat`] or from annotated segments.
///
/// `clip` is the name of the clip without extension; BABEL files and annotations may have several clips.
/// Annotated segments are `{"86_01": [{"start": 1, "end": 550, "label": "walk"}, ...], ...}`, or have the
/// list as `{"segments": [...]}`, which alone applies to the given clip. Their frames count from 1, and
/// `end` is the last frame. If the clip has one frame more than its annotation, the first frame is a
/// T-pose. The segments cover the clip; gaps become segments without a label.
///
/// # Errors
/// If the text has none of these formats, no such clip, or another number of frames.
pub fn read_segments(text: &str, clip: &str, frames: usize, rate: f64) -> Result<Vec<Segment>, ReadError> {
    let parts = find(text, clip)?.parts(frames, rate)?;
    Ok(parts.into_iter().map(|part| part.segment).collect())
}

/// Reads the cuts of a clip, like [`read_segments`]: the first frame of each segment except the first, or
/// the range that annotated segments have as `cut_earliest` and `cut_latest` of the previous segment.
///
/// # Errors
/// The errors of [`read_segments`].
pub fn read_cuts(text: &str, clip: &str, frames: usize, rate: f64) -> Result<Vec<TrueCut>, ReadError> {
    let mut parts = find(text, clip)?.parts(frames, rate)?;
    // The end of the clip is not a cut.
    parts.pop();
    Ok(parts.iter().map(|part| part.cut.unwrap_or(TrueCut::at(part.segment.frames.end as f64))).collect())
}

/// True if a text has segments of a clip, valid or not.
pub fn has_segments(text: &str, clip: &str) -> bool {
    !matches!(find(text, clip), Err(ReadError::NoSegments | ReadError::NoClip(_)))
}

/// Finds the segments of a clip in a text.
fn find(text: &str, clip: &str) -> Result<SegmentFile, ReadError> {
    let text = text.trim_start_matches('\u{feff}').trim_start();
    let found = SegmentFormat::ALL.iter().find_map(|format| format.read(text, clip));
    found.unwrap_or(Err(ReadError::NoSegments))
}

#[cfg(test)]
mod tests {
    use std::ops::Range;

    use super::*;
    use crate::formats::to_json;
    use crate::formats::{DocumentSegment, FrameRange, Header, Origin, SegmentsMethod, Source, VERSION};
    use crate::segments::{Cycles, Kind};

    fn document() -> SegmentsDocument {
        let rate = 1.0 / 0.0083333;
        let segments = [(0..40, "walk", "A"), (40..41, "", ""), (41..500, "kick, \"high\"", "AB")];
        let segments = segments.map(|(frames, label, action)| DocumentSegment {
            frames: FrameRange::new(frames, rate),
            kind: Kind::Action,
            label: label.into(),
            action: action.into(),
            period_s: (label == "walk").then_some(1.125),
            cycles: (label == "walk").then_some(2.5),
            source: Origin::Edited,
        });
        SegmentsDocument {
            header: Header {
                format: SegmentsDocument::FORMAT.into(),
                version: VERSION,
                source: Source { name: "86_01.bvh".into(), sha256: None, name_encoding: None },
                root: None,
                frames: 500,
                rate,
            },
            method: SegmentsMethod { name: "auto".into(), ..SegmentsMethod::default() },
            segments: segments.into(),
            transitions: vec![FrameRange::new(30..45, rate)],
            motifs: Vec::new(),
            notices: Vec::new(),
        }
    }

    fn ranges(segments: &[Segment]) -> Vec<(Range<usize>, &str)> {
        segments.iter().map(|segment| (segment.frames.clone(), segment.label.as_str())).collect()
    }

    #[test]
    fn every_format_is_read_back() {
        let document = document();
        assert_eq!(serde_json::from_str::<SegmentsDocument>(&to_json(&document)).unwrap(), document);
        let (frames, rate) = (document.header.frames, document.header.rate);
        let export = SegmentExport { documents: vec![document], as_array: false };
        for format in SegmentFormat::ALL.iter().filter(|format| format.entry().read.is_some()) {
            let text = String::from_utf8(format.write(&export)).unwrap();
            let read = read_segments(&text, "86_01", frames, rate).unwrap();
            assert_eq!(ranges(&read), [(0..40, "walk"), (40..41, ""), (41..500, "kick, \"high\"")], "{text}");
            let actions = if *format == SegmentFormat::Audacity { ["", "", ""] } else { ["A", "", "AB"] };
            assert!(read.iter().map(|segment| segment.action.as_str()).eq(actions), "{text}");
            let cycles = Some(Cycles { period_s: 1.125, count: 2.5 });
            let has_cycles = matches!(format, SegmentFormat::Json | SegmentFormat::Csv);
            assert_eq!(read[0].cycles, cycles.filter(|_| has_cycles), "{text}");
            assert_eq!(read[2].cycles, None, "{text}");
            let cuts = read_cuts(&text, "86_01", frames, rate).unwrap();
            assert_eq!(cuts, [40.0, 41.0].map(TrueCut::at));
            let short = read_segments(&text, "86_01", 400, rate);
            assert_eq!(short, Err(ReadError::Length { found: 500, frames: 400 }));
        }
    }

    #[test]
    fn several_skeletons_are_distinguished() {
        let documents = ["A:Hips", "B:Hips"].map(|root| {
            let mut document = document();
            document.header.root = Some(root.into());
            document
        });
        let export = SegmentExport { documents: documents.into(), as_array: true };
        let write = |format: SegmentFormat| String::from_utf8(format.write(&export)).unwrap();
        let table = write(SegmentFormat::Csv);
        assert!(table.starts_with(
            "root,start_frame,end_frame,start_s,end_s,kind,label,action,period_s,cycles\nA:Hips,0,40,0,"
        ));
        assert!(write(SegmentFormat::Babel).contains("\"86_01 B:Hips\""));
        assert!(write(SegmentFormat::Audacity).contains("\tB:Hips: walk\n"));
        assert!(write(SegmentFormat::Elan).contains("\nB:Hips action\t"));
        for text in [table, write(SegmentFormat::Json)] {
            assert_eq!(read_cuts(&text, "86_01", 500, 120.0), Err(ReadError::SeveralSkeletons));
        }
    }

    #[test]
    fn one_of_several_skeletons_is_read_back_from_every_format() {
        let mut document = document();
        document.header.root = Some("A:Hips".into());
        let export = SegmentExport { documents: vec![document], as_array: false };
        for format in SegmentFormat::ALL {
            let text = String::from_utf8_lossy(&format.write(&export)).into_owned();
            let is_read = format.entry().read.is_some() || *format == SegmentFormat::Babel;
            let read = is_read.then(|| read_segments(&text, "86_01", 500, 120.0).unwrap());
            let Some(read) = read else { continue };
            assert_eq!(ranges(&read), [(0..40, "walk"), (40..41, ""), (41..500, "kick, \"high\"")], "{text}");
            let actions = if *format == SegmentFormat::Audacity { ["", "", ""] } else { ["A", "", "AB"] };
            assert!(read.iter().map(|segment| segment.action.as_str()).eq(actions), "{text}");
        }
    }

    const TRUTH: &str = r#"{"_meta": {"frame_rate": 120}, "86_01": [
        {"start": 1, "end": 550, "label": "walk", "cut_earliest": 500, "cut_latest": 600},
        {"start": 551, "end": 1150, "label": "jump", "cut_earliest": 1200, "cut_latest": 1160},
        {"start": 1151, "end": 1300, "label": "walk", "cut_earliest": 1300, "cut_latest": 1300}],
        "13_30": {"segments": [{"start": 1, "end": 204, "label": "JumpJack"},
        {"start": 205, "end": 792, "label": "Twist"}], "frames_10fps": 66}}"#;

    #[test]
    fn annotated_frames_count_from_one() {
        let cuts = |clip, frames| read_cuts(TRUTH, clip, frames, 120.0);
        let range = |earliest, latest| TrueCut { earliest, latest };
        // The second range does not contain its cut, and the end of the clip is not a cut.
        assert_eq!(cuts("86_01", 1300).unwrap(), [range(500.0, 600.0), TrueCut::at(1150.0)]);
        assert_eq!(cuts("86_01", 1301).unwrap(), [range(501.0, 601.0), TrueCut::at(1151.0)], "a T-pose");
        assert_eq!(cuts("13_30", 795).unwrap(), [TrueCut::at(204.0)], "known in tenths of a second");
        assert_eq!(cuts("13_30", 900), Err(ReadError::Length { found: 792, frames: 900 }));
        assert_eq!(cuts("13_30", 700), Err(ReadError::Length { found: 792, frames: 700 }));
        let read = read_segments(TRUTH, "86_01", 1301, 120.0).unwrap();
        assert_eq!(ranges(&read), [(0..551, "walk"), (551..1151, "jump"), (1151..1301, "walk")]);
    }

    #[test]
    fn annotations_without_names_apply_to_the_given_clip() {
        let bare = r#"{"fps": 120, "segments": [{"start": 1, "end": 4, "label": "walk"},
            {"start": 5, "end": 10, "label": "run", "cut_earliest": 9, "cut_latest": 12}]}"#;
        assert!(has_segments(bare, "86_01"));
        let read = read_segments(bare, "86_01", 10, 120.0).unwrap();
        assert_eq!(ranges(&read), [(0..4, "walk"), (4..10, "run")]);
        assert_eq!(read_cuts(bare, "86_01", 10, 120.0).unwrap(), [TrueCut::at(4.0)]);
        let long = read_segments(bare, "86_01", 100, 120.0);
        assert_eq!(long, Err(ReadError::Length { found: 10, frames: 100 }));
        // An entry with the name of the clip takes precedence.
        let named = bare.replace("\"fps\": 120", "\"13_30\": [{\"start\": 1, \"end\": 10}]");
        assert_eq!(ranges(&read_segments(&named, "13_30", 10, 120.0).unwrap()), [(0..10, "")]);
        for text in [r#"{"segments": []}"#, r#"{"segments": [1]}"#, r#"{"segments": 1}"#, r#"["segments"]"#] {
            assert_eq!(read_segments(text, "86_01", 10, 120.0).unwrap_err(), ReadError::NoSegments, "{text}");
        }
    }

    #[test]
    fn clips_are_found_by_name() {
        assert!(has_segments(TRUTH, "13_30") && !has_segments(TRUTH, "86_02"));
        assert_eq!(read_cuts(TRUTH, "86_02", 9, 1.0), Err(ReadError::NoClip("86_02".into())));
        let sequences = r#"{"7": {"feat_p": "CMU/13/13_30_poses.npz", "dur": 1, "frame_ann": {"labels": []}},
            "8": {"feat_p": "CMU/86/86_01_poses.npz", "dur": 4.01, "frame_ann": {"labels": [
            {"raw_label": "kick", "start_t": 2, "end_t": 3}, {"raw_label": "walk", "start_t": 0.04, "end_t": 2},
            {"raw_label": "clap", "start_t": 1.5, "end_t": 1.7}]}}}"#;
        let read = read_segments(sequences, "86_01", 400, 100.0).unwrap();
        assert_eq!(ranges(&read), [(0..200, "walk"), (200..300, "kick"), (300..400, "")]);
        assert!(!has_segments(sequences, "86_02"));
    }

    #[test]
    fn errors_state_the_reason() {
        let read = |text: &str| read_segments(text, "walk", 10, 1.0);
        let truth = r#"{"fps": 100, "left": [0, 1], "right": [1, 1]}"#;
        for text in ["", "hello", "frame,time\n", "[]", "[1]", "{}", "{\"walk\": 1}", truth] {
            assert_eq!(read(text), Err(ReadError::NoSegments), "{text}");
            assert!(!has_segments(text, "walk"));
        }
        let newer = format!("{{\"format\": \"{}\", \"version\": 99}}", SegmentsDocument::FORMAT);
        assert_eq!(read(&newer), Err(ReadError::Version(99)));
        for text in [
            "{",
            "start_frame,end_frame,label\n0,x,walk\n",
            "start_frame,end_frame,label\n0,4,walk\n5,10,walk\n",
            "start_frame,end_frame,label\n0,10,walk\n10,10,walk\n",
            "start_frame,end_frame,kind,label\n0,10,odd,walk\n",
            "start_frame,end_frame,label,period_s,cycles\n0,10,walk,1,often\n",
            r#"{"walk": [{"start": 0, "end": 10}]}"#,
            r#"{"walk": [{"start": 3, "end": 1}, {"start": 1, "end": 10}]}"#,
            r#"{"walk": [{"start": -1, "end": 10}]}"#,
        ] {
            assert!(matches!(read(text), Err(ReadError::Invalid(_))), "{text}");
        }
    }
}
