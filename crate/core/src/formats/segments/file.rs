//! Segments of a file, completed to cover the clip.

use std::ops::Range;

use serde::Deserialize;

use crate::formats::document::ReadError;
use crate::formats::segments::document::{DocumentSegment, SegmentsDocument};
use crate::numeric::sort;
use crate::score::TrueCut;
use crate::segments::{Kind, Segment};

/// Maximum gap that is closed at the ends or between two segments, and maximum difference of the
/// durations of clip and file, in seconds; some files have times in tenths of a second.
const MAX_GAP: f64 = 0.1;

/// Segments of one clip in a file.
pub(crate) enum SegmentFile {
    Document(Box<SegmentsDocument>),
    Table(Vec<FileSegment>),
    Timed(TimedActions),
    Annotation(Vec<AnnotatedAction>),
}

/// A segment, and the range of the cut after it if the file has one.
pub(crate) struct FileSegment {
    pub segment: Segment,
    pub cut: Option<TrueCut>,
}

impl FileSegment {
    pub fn new(frames: Range<usize>, kind: Kind, label: impl Into<String>) -> FileSegment {
        FileSegment { segment: Segment::new(frames, kind, label), cut: None }
    }
}

/// Actions with times.
pub(crate) struct TimedActions {
    /// Duration of the clip, in seconds, if the file has it.
    pub duration: Option<f64>,
    pub actions: Vec<TimedAction>,
}

/// An action with times.
pub(crate) struct TimedAction {
    /// Start, in seconds.
    pub start: f64,
    /// End, in seconds.
    pub end: f64,
    /// Label; may be empty.
    pub label: String,
    /// Name of the action; may be empty.
    pub action: String,
}

/// One annotated action. Frames count from 1, and `end` is the last frame.
#[derive(Deserialize)]
pub(crate) struct AnnotatedAction {
    start: usize,
    end: usize,
    #[serde(default)]
    label: String,
    cut_earliest: Option<usize>,
    cut_latest: Option<usize>,
}

impl SegmentFile {
    /// Returns the segments, which cover the clip without gaps.
    pub fn parts(self, frames: usize, rate: f64) -> Result<Vec<FileSegment>, ReadError> {
        match self {
            SegmentFile::Document(document) if document.header.frames != frames => {
                Err(ReadError::Length { found: document.header.frames, frames })
            }
            SegmentFile::Document(document) => {
                let segments = document.segments.into_iter().map(DocumentSegment::segment);
                let parts = segments.map(|segment| FileSegment { segment, cut: None });
                check_partition(parts.collect(), frames)
            }
            SegmentFile::Table(parts) => check_partition(parts, frames),
            SegmentFile::Timed(actions) => timed_parts(actions, frames, rate),
            SegmentFile::Annotation(actions) => annotated_parts(actions, frames, rate),
        }
    }
}

fn timed_parts(file: TimedActions, frames: usize, rate: f64) -> Result<Vec<FileSegment>, ReadError> {
    // Casts saturate: negative times become frame 0.
    let frame = |seconds: f64| (seconds * rate).round() as usize;
    if let Some(seconds) = file.duration
        && (seconds - frames as f64 / rate).abs() > MAX_GAP
    {
        return Err(ReadError::Length { found: frame(seconds), frames });
    }
    let end = file.actions.iter().map(|action| action.end).fold(0.0, f64::max);
    if file.duration.is_none() && end - frames as f64 / rate > MAX_GAP {
        return Err(ReadError::Length { found: frame(end), frames });
    }
    let parts = file.actions.into_iter().map(|TimedAction { start, end, label, action }| {
        let mut part =
            FileSegment::new(frame(start).min(frames)..frame(end).min(frames), Kind::Action, label);
        part.segment.action = action;
        part
    });
    Ok(complete(parts.collect(), frames, rate))
}

fn annotated_parts(
    actions: Vec<AnnotatedAction>,
    frames: usize,
    rate: f64,
) -> Result<Vec<FileSegment>, ReadError> {
    let last = actions.iter().map(|action| action.end).max().unwrap_or(0);
    if last > frames || (frames - last) as f64 / rate > MAX_GAP {
        return Err(ReadError::Length { found: last, frames });
    }
    // A file that is one frame short does not count the T-pose before the motion.
    let t_pose_frames = usize::from(frames - last == 1);
    if let Some(action) = actions.iter().find(|action| action.start == 0 || action.start > action.end) {
        let message = format!("an action cannot last from frame {} to frame {}", action.start, action.end);
        return Err(ReadError::Invalid(message));
    }
    let parts = actions.into_iter().map(|action| {
        // The 1-based number of a last frame is the 0-based number of the next frame.
        let cut = |frame: usize| (frame.min(frames) + t_pose_frames) as f64;
        let mut part = FileSegment::new(
            action.start - 1 + t_pose_frames..action.end + t_pose_frames,
            Kind::Action,
            action.label,
        );
        // Ranges that do not contain their cut are annotation errors.
        part.cut = action
            .cut_earliest
            .zip(action.cut_latest)
            .filter(|(earliest, latest)| (earliest..=latest).contains(&&action.end))
            .map(|(earliest, latest)| TrueCut { earliest: cut(earliest), latest: cut(latest) });
        part
    });
    Ok(complete(parts.collect(), frames, rate))
}

/// True if the first line of a text has tabs.
pub(crate) fn is_tab_delimited(text: &str) -> bool {
    text.lines().next().is_some_and(|line| line.contains('\t'))
}

/// Returns a text without tabs and line ends, as a field of a tab-delimited file.
pub(crate) fn tab_field(text: &str) -> String {
    text.replace(['\t', '\n', '\r'], " ")
}

/// Returns the time of a row of a tab-delimited file, in seconds.
pub(crate) fn parse_seconds(text: &str, line: usize) -> Result<f64, ReadError> {
    let seconds = text.trim().parse().ok().filter(|seconds: &f64| seconds.is_finite());
    seconds
        .ok_or_else(|| ReadError::Invalid(format!("line {line}: expected a time in seconds, found {text:?}")))
}

/// Checks that the parts cover the clip without gaps.
fn check_partition(parts: Vec<FileSegment>, frames: usize) -> Result<Vec<FileSegment>, ReadError> {
    let mut end = 0;
    for FileSegment { segment: Segment { frames, .. }, .. } in &parts {
        if frames.start != end || frames.is_empty() {
            let message =
                format!("expected a segment from frame {end}, found {}..{}", frames.start, frames.end);
            return Err(ReadError::Invalid(message));
        }
        end = frames.end;
    }
    if end == frames { Ok(parts) } else { Err(ReadError::Length { found: end, frames }) }
}

/// Completes parts to cover the clip. Where two parts overlap, the second one is shortened.
fn complete(parts: Vec<FileSegment>, frames: usize, rate: f64) -> Vec<FileSegment> {
    let max_gap = (MAX_GAP * rate).round() as usize;
    let mut covering: Vec<FileSegment> = Vec::new();
    for mut part in sort::sort_by_frames(parts, |part| (part.segment.frames.start, 0)) {
        let range = &mut part.segment.frames;
        range.start = range.start.max(covering.last().map_or(0, |last| last.segment.frames.end));
        if range.start >= range.end {
            continue;
        }
        if covering.is_empty() && range.start <= max_gap {
            range.start = 0;
        }
        extend_to(&mut covering, range.start, max_gap);
        covering.push(part);
    }
    extend_to(&mut covering, frames, max_gap);
    covering
}

/// Extends parts to a frame: a small gap is closed, a larger one becomes a segment without a label.
fn extend_to(parts: &mut Vec<FileSegment>, frame: usize, max_gap: usize) {
    let end = parts.last().map_or(0, |part| part.segment.frames.end);
    match parts.last_mut() {
        Some(part) if frame - end <= max_gap => part.segment.frames.end = frame,
        _ if frame > end => parts.push(FileSegment::new(end..frame, Kind::Action, "")),
        _ => {}
    }
}
