//! Formats of plants.

mod blender;
mod document;
mod engines;
mod events;
mod export;
mod json;
mod npz;
mod tables;

pub use document::{
    Belt, FootJoints, FootPlants, GroundUsed, Instant, Joints, MethodUsed, Noise, Plant, PlantsDocument,
};
pub use events::{EventKind, GaitEvent, events, part_events};
pub use export::PlantExport;

use crate::formats::document::ReadError;
use crate::formats::format_info::FormatInfo;
use crate::plants::{Annotation, Edit};
use crate::registry::registry;
use export::{Reader, Writer};

registry! {
    /// File format of plants.
    pub enum PlantFormat: FormatInfo<Writer, Reader> as "format" {
        /// Document with the plants per foot and part.
        #[default]
        Json => json::FORMAT_INFO,
        /// Table with one row per frame.
        Csv => tables::FRAMES,
        /// Table with one row per plant.
        Intervals => tables::INTERVALS,
        /// Table with one row per foot strike and foot off.
        Events => tables::EVENTS,
        /// Table with one row per event of foot, heel and toe.
        PartEvents => tables::PART_EVENTS,
        /// NumPy archive.
        Npz => npz::FORMAT_INFO,
        /// Blender script.
        Blender => blender::FORMAT_INFO,
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

impl PlantFormat {
    /// Returns plants as the bytes of a file.
    ///
    /// # Panics
    /// If there is no skeleton, or a NumPy archive would exceed 4 GiB.
    pub fn write(self, export: &PlantExport) -> Vec<u8> {
        (self.entry().write)(export)
    }

    /// Reads the bytes if they look like this format.
    fn read(self, bytes: &[u8], frames: usize) -> Option<Result<Annotation, ReadError>> {
        let reader = self.entry().read.as_ref()?;
        (reader.recognises)(bytes).then(|| (reader.read)(bytes, frames))
    }
}

/// Reads plants of a clip with `frames` frames, in any format of [`PlantFormat`] that has a reader, or
/// an annotation of contact as `{"left": [0, 1, -1, ...], "right": [...]}` with −1 for unknown.
///
/// # Errors
/// If the bytes have none of these formats or another number of frames.
pub fn read_plants(bytes: &[u8], frames: usize) -> Result<Annotation, ReadError> {
    let read = PlantFormat::ALL.iter().find_map(|format| format.read(bytes, frames));
    let annotation = read.unwrap_or(Err(ReadError::NoPlants))?;
    for labels in annotation.parts.iter().flat_map(|(_, feet)| feet) {
        if labels.len() != frames {
            return Err(ReadError::Length { found: labels.len(), frames });
        }
    }
    if annotation.parts.is_empty() { Err(ReadError::NoPlants) } else { Ok(annotation) }
}

/// Reads the corrections of a person in a clip with `frames` frames: the edits of a plants document, or edits
/// that state the known labels of another file of [`read_plants`].
///
/// # Errors
/// If the file cannot be read, belongs to a clip of another length, or is the document of a method without
/// edits.
pub fn read_edits(bytes: &[u8], frames: usize) -> Result<Vec<Edit>, ReadError> {
    match json::document(bytes)? {
        Some(document) if document.header.frames != frames => {
            Err(ReadError::Length { found: document.header.frames, frames })
        }
        Some(document) if !document.edits.is_empty() => {
            let is_invalid = |edit: &&Edit| edit.start >= edit.end || edit.end > frames;
            match document.edits.iter().find(is_invalid) {
                Some(Edit { start, end, .. }) => {
                    let message =
                        format!("an edit cannot last from frame {start} to {end} of {frames} frames");
                    Err(ReadError::Invalid(message))
                }
                None => Ok(document.edits),
            }
        }
        Some(document) if document.method.name != MethodUsed::TRUTH => Err(ReadError::NoEdits),
        _ => Ok(read_plants(bytes, frames)?.edits()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bvh;
    use crate::foot::{Part, Side};
    use crate::formats::document::Source;
    use crate::plants::{Feet, Params, detect};
    use crate::skeleton::{Overrides, Skeleton};

    fn read(text: &str, frames: usize) -> Result<Annotation, ReadError> {
        read_plants(text.as_bytes(), frames)
    }

    #[test]
    fn a_byte_order_mark_is_ignored() {
        let text = r#"{"left": [0, 1], "right": [1, 0]}"#;
        let marked = [b"\xef\xbb\xbf", text.as_bytes()].concat();
        assert_eq!(read_plants(&marked, 2), read(text, 2));
        assert_eq!(read_plants(b"\xff\xfe{", 2), Err(ReadError::NoPlants));
    }

    #[test]
    fn known_labels_become_edits() {
        let annotation = read(r#"{"left": [0, 1, 1, -1], "right": [-1, -1, -1, 1]}"#, 4).unwrap();
        let edit = |side, start, end, planted| Edit { side, part: Part::Contact, start, end, planted };
        let expected =
            [edit(Side::Left, 0, 1, false), edit(Side::Left, 1, 3, true), edit(Side::Right, 3, 4, true)];
        assert_eq!(annotation.edits(), expected);
    }

    #[test]
    fn edits_are_read_from_documents_and_annotations() {
        let document = |method: &str, edits: &str| {
            format!(
                r#"{{"format": "{}", "version": 1, "source": {{"name": "a"}}, "frames": 4, "rate": 30,
                "method": {{"name": "{method}"}}, "left": {{"contact": []}}, "right": {{"contact": []}},
                "edits": [{edits}]}}"#,
                PlantsDocument::FORMAT
            )
        };
        let read = |text: &str| read_edits(text.as_bytes(), 4);
        let stated = r#"{"side": "left", "part": "toe", "start": 1, "end": 3, "planted": true}"#;
        let edit = Edit { side: Side::Left, part: Part::Toe, start: 1, end: 3, planted: true };
        assert_eq!(read(&document("robust", stated)), Ok(vec![edit]));
        assert_eq!(read(&document("robust", "")), Err(ReadError::NoEdits));
        assert_eq!(read(&document("truth", "")).map(|edits| edits.len()), Ok(2));
        assert!(matches!(read(&document("robust", &stated.replace('3', "5"))), Err(ReadError::Invalid(_))));
        let length = read_edits(document("robust", stated).as_bytes(), 5);
        assert_eq!(length, Err(ReadError::Length { found: 4, frames: 5 }));
        let annotated = read(r#"{"left": [-1, 1, 0, -1], "right": [-1, -1, -1, -1]}"#).unwrap();
        assert_eq!(annotated.iter().map(|edit| edit.planted).collect::<Vec<_>>(), [true, false]);
    }

    #[test]
    fn annotated_contacts_are_read() {
        let read = read(r#"{"fps": 100, "left": [0, 1, -1], "right": [1, 1, 0]}"#, 3).unwrap();
        assert_eq!(read.part(Part::Contact).unwrap()[0], [Some(false), Some(true), None]);
        assert_eq!(read.part(Part::Toe), None);
    }

    #[test]
    fn tables_have_named_columns() {
        let text = "frame,time,left_toe,right_toe\n0,0,1,0\n1,0.1,,1\n";
        assert_eq!(read(text, 2).unwrap().part(Part::Toe).unwrap()[0], [Some(true), None]);
        assert!(matches!(read("left_toe,right_toe\nx,0\n", 1), Err(ReadError::Invalid(_))));
    }

    #[test]
    fn tables_of_plants_are_read() {
        let header = "foot,part,start_frame,end_frame,start_s,end_s\n";
        let table = |rows: &str| read(&format!("{header}{rows}"), 4);
        let read = table("left,toe,1,3,0.1,0.3\nright,heel,0,1,0,0.1\nleft,toe,3,4,0,0\n").unwrap();
        let known = |labels: [u8; 4]| labels.map(|label| Some(label == 1)).to_vec();
        assert_eq!(read.part(Part::Toe), Some(&[known([0, 1, 1, 1]), known([0; 4])]));
        assert_eq!(read.part(Part::Heel), Some(&[known([0; 4]), known([1, 0, 0, 0])]));
        assert_eq!(read.part(Part::Contact), None);
        assert_eq!(table("").unwrap().parts, [(Part::Contact, [known([0; 4]), known([0; 4])])]);
        for (row, expected) in [
            ("left,toe,2,2,0,0", "start_frame before end_frame"),
            ("left,toe,1,5,0,0", "end_frame at most 4"),
            ("left,toe,-1,3,0,0", "start_frame before"),
            ("left,toe", "found \"nothing\""),
            ("both,toe,1,3,0,0", "expected left or right, found \"both\""),
            ("left,sole,1,3,0,0", "expected contact, toe or heel, found \"sole\""),
        ] {
            let error = table(&format!("left,toe,0,1,0,0\n{row}\n")).unwrap_err().to_string();
            assert!(error.contains(" row 3: ") && error.contains(expected), "{row}: {error}");
        }
        // Tables of gait events and of segments have no plants.
        assert_eq!(self::read("time,frame,context,event,uncertainty_ms\n", 4), Err(ReadError::NoPlants));
        assert_eq!(self::read("start_frame,end_frame,label\n0,4,walk\n", 4), Err(ReadError::NoPlants));
    }

    #[test]
    fn labels_of_one_skeleton_of_several_are_read() {
        let file = include_bytes!("../../../../../tests/files/good/two-skeletons.bvh");
        let clip = bvh::parse(file, bvh::Options::default()).unwrap().clip;
        let skeletons = Skeleton::all(&clip, &Overrides::default()).into_iter();
        let params = Params::default().check().unwrap();
        let detected: Vec<_> = skeletons
            .map(|skeleton| {
                let detection = detect(&Feet::new(&clip, &skeleton).unwrap(), params);
                (skeleton, detection)
            })
            .collect();
        let file = |count: usize, as_array: bool, format: PlantFormat| {
            let skeletons = detected.iter().map(|(skeleton, detection)| (skeleton, detection));
            format.write(&PlantExport {
                source: Source { name: "two.bvh".into(), ..Source::default() },
                clip: &clip,
                notices: &[],
                skeletons: skeletons.take(count).collect(),
                as_array,
            })
        };
        assert_eq!(detected.len(), 2);
        let expected = read_plants(&file(1, false, PlantFormat::Json), clip.frame_count()).unwrap();
        for format in [PlantFormat::Json, PlantFormat::Csv, PlantFormat::Npz, PlantFormat::Intervals] {
            let read = |count: usize| read_plants(&file(count, true, format), clip.frame_count());
            assert_eq!(read(2), Err(ReadError::SeveralSkeletons), "{format}");
            let read = read(1).unwrap();
            for (part, labels) in &read.parts {
                assert_eq!(expected.part(*part), Some(labels), "{format}");
            }
            assert!(!read.parts.is_empty(), "{format}");
        }
    }

    #[test]
    fn errors_state_the_reason() {
        assert_eq!(read("hello", 3), Err(ReadError::NoPlants));
        assert_eq!(read("", 3), Err(ReadError::NoPlants));
        assert_eq!(read("{\"a\": 1}", 3), Err(ReadError::NoPlants));
        let text = format!("{{\"format\": \"{}\", \"version\": 99}}", PlantsDocument::FORMAT);
        assert_eq!(read(&text, 3), Err(ReadError::Version(99)));
        for (label, reason) in [("true", "boolean"), ("2", "found 2"), ("-7", "found -7"), ("0.5", "0.5")] {
            let text = format!(r#"{{"left": [0, {label}, 1], "right": [1, 1, 1]}}"#);
            let error = read(&text, 3).unwrap_err().to_string();
            assert!(error.contains(reason), "{error}");
        }
        assert_eq!(read("[{\"format\": 3}]", 3), Err(ReadError::NoPlants));
        let annotation = r#"{"left": [0], "right": [1]}"#;
        assert_eq!(read(annotation, 3), Err(ReadError::Length { found: 1, frames: 3 }));
        for (start, end) in [(2, 1), (1, 1), (0, 4), (0, usize::MAX)] {
            let text = format!(
                r#"{{"format": "{}", "version": 1, "source": {{"name": "a"}}, "frames": 3, "rate": 30,
                "method": {{"name": "truth"}}, "left": {{}}, "right": {{"heel": [{{"start": {start},
                "end": {end}, "start_s": 0, "end_s": 0, "source": "truth"}}]}}}}"#,
                PlantsDocument::FORMAT
            );
            assert!(matches!(read(&text, 3), Err(ReadError::Invalid(_))), "{start}..{end}");
        }
        for frames in ["1\n0\n", "0\n0\n", "0\n\n"] {
            let rows: String = frames.lines().map(|frame| format!("{frame},1,0\n")).collect();
            let table = read(&format!("frame,left_toe,right_toe\n{rows}"), 2);
            assert!(matches!(table, Err(ReadError::Invalid(_))), "{frames:?}");
        }
        for found in [1_000_000_000, usize::MAX] {
            let text = format!(
                r#"{{"format": "{}", "version": 1, "source": {{"name": "a"}}, "frames": {found}, "rate": 30,
                "method": {{"name": "truth"}}, "left": {{"contact": []}}, "right": {{"contact": []}}}}"#,
                PlantsDocument::FORMAT
            );
            assert_eq!(read(&text, 3), Err(ReadError::Length { found, frames: 3 }));
        }
    }

    #[test]
    fn formats_have_unique_names_and_extensions() {
        for (index, format) in PlantFormat::ALL.iter().enumerate() {
            assert_eq!(format.name().parse(), Ok(*format));
            let others = &PlantFormat::ALL[index + 1..];
            assert!(others.iter().all(|other| other.extension() != format.extension()), "{format}");
        }
    }
}
