//! Segments as a NumPy archive (`.npz`) with a value per frame.

use crate::formats::document::FrameRange;
use crate::formats::format_info::FormatInfo;
use crate::formats::segments::document::{DocumentSegment, SegmentsDocument};
use crate::formats::segments::export::{Reader, Writer};
use crate::formats::{npy, zip};

pub(super) const FORMAT_INFO: FormatInfo<Writer, Reader> = FormatInfo {
    name: "npz",
    title: "Arrays",
    description: "Arrays for NumPy with the segment and the action of each frame.",
    extension: "segments.npz",
    media_type: "application/zip",
    write: |export| arrays(&export.documents),
    read: None,
};

/// Returns an archive of arrays for a clip of F frames with S segments, N different actions and M
/// different labels.
///
/// | array | shape and type | content |
/// |---|---|---|
/// | `segment` | (F) int32 | number of the segment of each frame, from 0 |
/// | `action` | (F) int32 | index in `actions` of the action of each frame; −1 if unknown |
/// | `label` | (F) int32 | index in `labels` of the label of each frame; −1 if there is none |
/// | `actions` | (N) text | names of the actions, sorted |
/// | `labels` | (M) text | labels, sorted |
/// | `bounds` | (S, 2) int32 | first frame of each segment and first frame after it |
/// | `period` | (S) float64 | period of the action's cycles, in seconds; NaN if it does not repeat |
/// | `cycles` | (S) float64 | number of cycles; NaN likewise |
/// | `time` | (F) float64 | time from the start of the clip, in seconds |
/// | `rate` | () float64 | frame rate, in Hz |
/// | `source` | () text | file name of the clip |
///
/// With R skeletons, `segment`, `action` and `label` have a first axis of length R, `roots` (R) has the
/// names of the root joints, `root` (S) int32 has the index of the root of each segment, and segments are
/// numbered over all skeletons.
fn arrays(documents: &[SegmentsDocument]) -> Vec<u8> {
    let header = &documents[0].header;
    let segments: Vec<(usize, &DocumentSegment)> = documents
        .iter()
        .enumerate()
        .flat_map(|(root, document)| document.segments.iter().map(move |segment| (root, segment)))
        .collect();
    let names = |name: fn(&DocumentSegment) -> &str| -> Vec<&str> {
        let mut names: Vec<&str> = segments.iter().map(|(_, segment)| name(segment)).collect();
        names.sort_unstable();
        names.dedup();
        names.retain(|name| !name.is_empty());
        names
    };
    let [action, label]: [fn(&DocumentSegment) -> &str; 2] =
        [|segment| &segment.action, |segment| &segment.label];
    let (actions, labels) = (names(action), names(label));
    let index = |names: &[&str], name: &str| names.binary_search(&name).map_or(-1, |index| index as i32);
    let roots: Vec<&str> = documents.iter().filter_map(|document| document.header.root.as_deref()).collect();
    let skeletons = (!roots.is_empty()).then_some(documents.len());
    let frame_shape: Vec<usize> = skeletons.into_iter().chain([header.frames]).collect();
    let by_frame = |value: &dyn Fn(usize, &DocumentSegment) -> i32| {
        let values = segments.iter().enumerate().flat_map(|(number, (_, segment))| {
            let FrameRange { start, end, .. } = segment.frames;
            std::iter::repeat_n(value(number, segment).to_le_bytes(), end - start)
        });
        npy::write("<i4", &frame_shape, &values.flatten().collect::<Vec<u8>>())
    };
    let by_segment = |value: fn(&DocumentSegment) -> Option<f64>| {
        let values =
            segments.iter().flat_map(|(_, segment)| value(segment).unwrap_or(f64::NAN).to_le_bytes());
        npy::write("<f8", &[segments.len()], &values.collect::<Vec<u8>>())
    };
    let bounds = segments.iter().flat_map(|(_, segment)| {
        [segment.frames.start, segment.frames.end].map(|frame| (frame as i32).to_le_bytes())
    });
    let time = (0..header.frames).flat_map(|frame| (frame as f64 / header.rate).to_le_bytes());
    let mut files = vec![
        ("segment.npy", by_frame(&|number, _| number as i32)),
        ("action.npy", by_frame(&|_, segment| index(&actions, &segment.action))),
        ("label.npy", by_frame(&|_, segment| index(&labels, &segment.label))),
        ("actions.npy", npy::texts(&[actions.len()], &actions)),
        ("labels.npy", npy::texts(&[labels.len()], &labels)),
        ("bounds.npy", npy::write("<i4", &[segments.len(), 2], &bounds.flatten().collect::<Vec<u8>>())),
        ("period.npy", by_segment(|segment| segment.period_s)),
        ("cycles.npy", by_segment(|segment| segment.cycles)),
        ("time.npy", npy::write("<f8", &[header.frames], &time.collect::<Vec<u8>>())),
        ("rate.npy", npy::write("<f8", &[], &header.rate.to_le_bytes())),
        ("source.npy", npy::texts(&[], &[&header.source.name])),
    ];
    if !roots.is_empty() {
        let root = segments.iter().flat_map(|(root, _)| (*root as i32).to_le_bytes());
        files.push(("root.npy", npy::write("<i4", &[segments.len()], &root.collect::<Vec<u8>>())));
        files.push(("roots.npy", npy::texts(&[roots.len()], &roots)));
    }
    zip::store(&files)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_have_the_indices_of_their_segment_action_and_label() {
        let text = r#"{"format": "plantigrade-segments", "version": 1, "source": {"name": "a.bvh"},
            "frames": 4, "rate": 30, "method": {"name": "auto"}, "segments": [
            {"start": 0, "end": 1, "start_s": 0, "end_s": 0.1, "kind": "action", "action": "B", "source": "auto"},
            {"start": 1, "end": 3, "start_s": 0.1, "end_s": 0.2, "kind": "action", "action": "A",
             "label": "walk", "period_s": 0.5, "cycles": 2.5, "source": "auto"},
            {"start": 3, "end": 4, "start_s": 0.2, "end_s": 0.3, "kind": "action", "source": "auto"}]}"#;
        let document: SegmentsDocument = serde_json::from_str(text).unwrap();
        let archive = arrays(std::slice::from_ref(&document));
        let numbers = |archive: &[u8], name: &str| {
            let file = zip::file(archive, &format!("{name}.npy"), 1 << 20).unwrap().unwrap();
            let array = npy::read(name, &file).unwrap();
            (array.shape.clone(), array.numbers().unwrap())
        };
        assert_eq!(numbers(&archive, "segment"), (vec![4], vec![0.0, 1.0, 1.0, 2.0]));
        assert_eq!(numbers(&archive, "action"), (vec![4], vec![1.0, 0.0, 0.0, -1.0]));
        assert_eq!(numbers(&archive, "label"), (vec![4], vec![-1.0, 0.0, 0.0, -1.0]));
        assert_eq!(numbers(&archive, "bounds"), (vec![3, 2], vec![0.0, 1.0, 1.0, 3.0, 3.0, 4.0]));
        let cycles = numbers(&archive, "cycles").1;
        assert!(cycles[0].is_nan() && cycles[1] == 2.5);
        let several = ["A", "B"].map(|root| {
            let mut document = document.clone();
            document.header.root = Some(root.into());
            document
        });
        let archive = arrays(&several);
        assert_eq!(numbers(&archive, "segment").0, [2, 4]);
        assert_eq!(numbers(&archive, "root").1, [0.0, 0.0, 0.0, 1.0, 1.0, 1.0]);
    }
}
