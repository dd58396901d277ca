//! Files of plants and segments: the only place that writes and reads them.

mod babel;
mod blender;
mod csv;
mod npz;
mod plants;
mod read_plants;
mod read_segments;
mod segments;
mod tables;

pub use babel::babel_json;
pub use blender::blender_script;
pub use npz::npz;
pub use plants::{Document, FORMAT, Foot, FootJoints, Joints, MethodUsed, Source, Span, SpanSource, VERSION};
pub use read_plants::{LabelsError, read, read_bytes};
pub use read_segments::{has_segments, read_cuts, read_segments};
pub use segments::{MotifSpan, SEGMENTS_FORMAT, SegmentSpan, SegmentsDocument, SegmentsMethod, Stretch};
pub use tables::{Labelled, events_csv, frames_csv, intervals_csv, segments_csv};
