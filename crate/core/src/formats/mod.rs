//! File formats of plants, segments and gait: the only place that writes and reads them.
//!
//! [`PlantFormat`], [`SegmentFormat`] and [`GaitFormat`] list the formats with their name, file extension, media
//! type, writer and reader. The command line, the bindings and the app offer what they list.

mod crc32;
mod csv;
mod document;
mod format_info;
mod gait;
mod npy;
mod plants;
mod scripts;
mod segments;
mod zip;

pub use document::{FrameRange, Header, Origin, ReadError, Source, VERSION, to_json};
pub use gait::{GaitExport, GaitFormat, SkeletonGait};
pub use plants::{
    Belt, EventKind, FootJoints, FootPlants, GaitEvent, GroundUsed, Instant, Joints, MethodUsed, Noise,
    Plant, PlantExport, PlantFormat, PlantsDocument, events, part_events, read_edits, read_plants,
};
pub use segments::{
    DocumentMotif, DocumentSegment, SegmentExport, SegmentFormat, SegmentsDocument, SegmentsMethod,
    has_segments, read_cuts, read_segments,
};
