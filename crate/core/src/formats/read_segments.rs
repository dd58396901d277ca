//! Segments from elsewhere: documents, tables, BABEL's files and truth files.

use std::ops::Range;

use serde::Deserialize;
use serde_json::{Map, Value};

use crate::formats::babel::Sequence;
use crate::formats::read_plants::document;
use crate::formats::{LabelsError, SEGMENTS_FORMAT, SegmentsDocument, babel, csv};
use crate::numeric::sort;
use crate::score::TrueCut;
use crate::segments::{Kind, Segment};

/// Seconds that segments from elsewhere may miss at the ends or between two of them:
/// some are known in tenths of a second.
const SLACK: f64 = 0.1;

/// Reads the segments of a clip: a segments document, a table with the columns `start_frame`,
/// `end_frame` and `label`, BABEL's JSON, or a truth file.
///
/// `clip` is the clip's name without an ending; BABEL's files and truth files hold several.
/// A truth file is `{"86_01": [{"start": 1, "end": 550, "label": "walk"}, ...], ...}`,
/// or has the list as `{"segments": [...]}`, which alone is of the clip at hand; its frames count from 1, and `end` is the last.
/// Where the clip has one frame more than its truth, that is a T-pose before the first.
/// The segments tile the clip; what nobody labelled between them has no name.
///
/// # Errors
/// If the text is none of these, has no such clip, or is of another number of frames.
pub fn read_segments(text: &str, clip: &str, frames: usize, rate: f64) -> Result<Vec<Segment>, LabelsError> {
    let pieces = pieces(find(text, clip)?, frames, rate)?;
    Ok(pieces.into_iter().map(|piece| piece.segment).collect())
}

/// Reads the cuts of a clip, as [`read_segments`] does its segments: the first frame of each but
/// the first, or the range that truth files give as `cut_earliest` and `cut_latest` of the one before.
///
/// # Errors
/// Those of [`read_segments`].
pub fn read_cuts(text: &str, clip: &str, frames: usize, rate: f64) -> Result<Vec<TrueCut>, LabelsError> {
    let mut pieces = pieces(find(text, clip)?, frames, rate)?;
    // The clip's end is no cut.
    pieces.pop();
    Ok(pieces.iter().map(|piece| piece.cut.unwrap_or(TrueCut::at(piece.segment.frames.end as f64))).collect())
}

/// Whether there are segments of a clip in a text, be they right or wrong.
pub fn has_segments(text: &str, clip: &str) -> bool {
    !matches!(find(text, clip), Err(LabelsError::NoSegments | LabelsError::NoClip(_)))
}

/// What holds the segments of a clip.
enum Found {
    Document(SegmentsDocument),
    Table(Vec<Piece>),
    Babel(Sequence),
    Truth(Vec<TrueAction>),
}

/// A segment, with where the cut after it lies, if that is known better than to the frame.
struct Piece {
    segment: Segment,
    cut: Option<TrueCut>,
}

impl Piece {
    fn new(frames: Range<usize>, kind: Kind, label: impl Into<String>) -> Piece {
        Piece { segment: Segment { frames, kind, label: label.into() }, cut: None }
    }
}

/// An action in a truth file; frames count from 1, and `end` is the last one.
#[derive(Deserialize)]
struct TrueAction {
    start: usize,
    end: usize,
    #[serde(default)]
    label: String,
    cut_earliest: Option<usize>,
    cut_latest: Option<usize>,
}

/// Finds the segments of a clip in a text.
fn find(text: &str, clip: &str) -> Result<Found, LabelsError> {
    let text = text.trim_start_matches('\u{feff}').trim_start();
    if !text.starts_with(['{', '[']) {
        return table(text);
    }
    let mut value: Value = serde_json::from_str(text)?;
    let first = value.get(0).unwrap_or(&value);
    if first["format"] == SEGMENTS_FORMAT {
        return match value {
            Value::Array(_) => {
                Err(LabelsError::Wrong("documents of several skeletons are not compared".into()))
            }
            value => Ok(Found::Document(document(value)?)),
        };
    }
    let is_bare = value.get_mut("segments").is_some_and(is_truth);
    let clips = value.as_object_mut().ok_or(LabelsError::NoSegments)?;
    match entry(clips, clip).and_then(|name| clips.remove(&name)) {
        Some(sequence) if babel::is_sequence(&sequence) => {
            Ok(Found::Babel(serde_json::from_value(sequence)?))
        }
        Some(mut actions) => Ok(Found::Truth(serde_json::from_value(list(&mut actions).take())?)),
        None if is_bare => Ok(Found::Truth(serde_json::from_value(value["segments"].take())?)),
        None if clips.values_mut().any(|value| babel::is_sequence(value) || is_truth(value)) => {
            Err(LabelsError::NoClip(clip.into()))
        }
        None => Err(LabelsError::NoSegments),
    }
}

/// The name under which a clip stands, in BABEL's files and truth files.
fn entry(clips: &mut Map<String, Value>, clip: &str) -> Option<String> {
    let stands = |value: &mut Value| babel::is_sequence(value) || is_truth(value);
    if clips.get_mut(clip).is_some_and(stands) {
        return Some(clip.into());
    }
    // The names of BABEL's sequences say nothing.
    let is_only = clips.len() == 1;
    let mut sequences = clips.iter().filter(|(_, value)| babel::is_sequence(value));
    sequences.find(|(_, value)| is_only || babel::is_of(value, clip)).map(|(name, _)| name.clone())
}

/// The list of actions in an entry of a truth file.
fn list(entry: &mut Value) -> &mut Value {
    if entry.get("segments").is_some() { &mut entry["segments"] } else { entry }
}

fn is_truth(entry: &mut Value) -> bool {
    list(entry).get(0).is_some_and(|action| action["end"].is_number())
}

fn table(text: &str) -> Result<Found, LabelsError> {
    let mut rows = csv::rows(text).into_iter();
    let head = rows.next().unwrap_or_default();
    let column = |name| csv::column(&head, name);
    let (Some(start), Some(end), Some(label)) = (column("start_frame"), column("end_frame"), column("label"))
    else {
        return Err(LabelsError::NoSegments);
    };
    if column("root").is_some() {
        return Err(LabelsError::Wrong("tables of several skeletons are not compared".into()));
    }
    let kinds = column("kind");
    let piece = |row: csv::Row| {
        let frame = |column| {
            let found = row.field(column);
            found.and_then(|text| text.parse().ok()).ok_or_else(|| row.wrong("a frame", found))
        };
        let kind = match kinds.map(|column| row.field(column)) {
            None => Kind::Action,
            Some(found) => Kind::ALL
                .into_iter()
                .find(|kind| Some(kind.name()) == found)
                .ok_or_else(|| row.wrong("a kind", found))?,
        };
        Ok(Piece::new(frame(start)?..frame(end)?, kind, row.field(label).unwrap_or_default()))
    };
    Ok(Found::Table(rows.map(piece).collect::<Result<_, LabelsError>>()?))
}

/// The pieces of a clip: they tile it.
fn pieces(found: Found, frames: usize, rate: f64) -> Result<Vec<Piece>, LabelsError> {
    match found {
        Found::Document(document) if document.frames != frames => {
            Err(LabelsError::Length { found: document.frames, frames })
        }
        Found::Document(document) => {
            let pieces = document.segments.into_iter().map(|segment| {
                Piece::new(segment.stretch.start..segment.stretch.end, segment.kind, segment.label)
            });
            tiles(pieces.collect(), frames)
        }
        Found::Table(pieces) => tiles(pieces, frames),
        Found::Babel(sequence) => of_babel(sequence, frames, rate),
        Found::Truth(actions) => of_truth(actions, frames, rate),
    }
}

fn of_babel(sequence: Sequence, frames: usize, rate: f64) -> Result<Vec<Piece>, LabelsError> {
    // Casts saturate: what is negative becomes the first frame.
    let frame = |seconds: f64| (seconds * rate).round() as usize;
    if let Some(seconds) = sequence.seconds()
        && (seconds - frames as f64 / rate).abs() > SLACK
    {
        return Err(LabelsError::Length { found: frame(seconds), frames });
    }
    let actions = sequence.actions();
    let pieces = actions.map(|(start, end, label)| {
        Piece::new(frame(start).min(frames)..frame(end).min(frames), Kind::Action, label)
    });
    Ok(filled(pieces.collect(), frames, rate))
}

fn of_truth(actions: Vec<TrueAction>, frames: usize, rate: f64) -> Result<Vec<Piece>, LabelsError> {
    let last = actions.iter().map(|action| action.end).max().unwrap_or(0);
    if last > frames || (frames - last) as f64 / rate > SLACK {
        return Err(LabelsError::Length { found: last, frames });
    }
    let t_pose = usize::from(frames - last == 1);
    if let Some(action) = actions.iter().find(|action| action.start == 0 || action.start > action.end) {
        let what = format!("no action goes from frame {} to frame {}", action.start, action.end);
        return Err(LabelsError::Wrong(what));
    }
    let pieces = actions.into_iter().map(|action| {
        // Counted from 0, the frame after the last has the last one's number.
        let cut = |frame: usize| (frame.min(frames) + t_pose) as f64;
        let mut piece =
            Piece::new(action.start - 1 + t_pose..action.end + t_pose, Kind::Action, action.label);
        // Ranges without their cut are slips of the pen.
        piece.cut = action
            .cut_earliest
            .zip(action.cut_latest)
            .filter(|(earliest, latest)| (earliest..=latest).contains(&&action.end))
            .map(|(earliest, latest)| TrueCut { earliest: cut(earliest), latest: cut(latest) });
        piece
    });
    Ok(filled(pieces.collect(), frames, rate))
}

/// Pieces that tile the clip as they are.
fn tiles(pieces: Vec<Piece>, frames: usize) -> Result<Vec<Piece>, LabelsError> {
    let mut end = 0;
    for Piece { segment: Segment { frames, .. }, .. } in &pieces {
        if frames.start != end || frames.is_empty() {
            let what =
                format!("expected a segment from frame {end} on, found {}..{}", frames.start, frames.end);
            return Err(LabelsError::Wrong(what));
        }
        end = frames.end;
    }
    if end == frames { Ok(pieces) } else { Err(LabelsError::Length { found: end, frames }) }
}

/// Tiles the clip with pieces: of two that overlap the first goes on to its end.
fn filled(pieces: Vec<Piece>, frames: usize, rate: f64) -> Vec<Piece> {
    let slack = (SLACK * rate).round() as usize;
    let mut tiles: Vec<Piece> = Vec::new();
    for mut piece in sort::sort_by_frames(pieces, |piece| (piece.segment.frames.start, 0)) {
        let range = &mut piece.segment.frames;
        range.start = range.start.max(tiles.last().map_or(0, |tile| tile.segment.frames.end));
        if range.start >= range.end {
            continue;
        }
        if tiles.is_empty() && range.start <= slack {
            range.start = 0;
        }
        reach(&mut tiles, range.start, slack);
        tiles.push(piece);
    }
    reach(&mut tiles, frames, slack);
    tiles
}

/// Brings tiles up to a frame: a small gap is closed, another becomes a segment without a name.
fn reach(tiles: &mut Vec<Piece>, frame: usize, slack: usize) {
    let end = tiles.last().map_or(0, |tile| tile.segment.frames.end);
    match tiles.last_mut() {
        Some(tile) if frame - end <= slack => tile.segment.frames.end = frame,
        _ if frame > end => tiles.push(Piece::new(end..frame, Kind::Action, "")),
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::formats::{
        SegmentSpan, SegmentsMethod, Source, SpanSource, Stretch, VERSION, babel_json, segments_csv,
    };

    fn document() -> SegmentsDocument {
        let rate = 1.0 / 0.0083333;
        let segments = [(0..40, "walk"), (40..41, ""), (41..500, "kick, \"high\"")];
        let segments = segments.map(|(frames, label)| SegmentSpan {
            stretch: Stretch::of(frames, rate),
            kind: Kind::Action,
            label: label.into(),
            source: SpanSource::Edited,
        });
        SegmentsDocument {
            format: SEGMENTS_FORMAT.into(),
            version: VERSION,
            source: Source { name: "86_01.bvh".into(), sha256: None },
            root: None,
            frames: 500,
            rate,
            method: SegmentsMethod { name: "auto".into(), ..SegmentsMethod::default() },
            segments: segments.into(),
            transitions: vec![Stretch::of(30..45, rate)],
            motifs: Vec::new(),
            notices: Vec::new(),
        }
    }

    fn ranges(segments: &[Segment]) -> Vec<(Range<usize>, &str)> {
        segments.iter().map(|segment| (segment.frames.clone(), segment.label.as_str())).collect()
    }

    #[test]
    fn what_is_written_is_read_back() {
        let document = document();
        assert_eq!(serde_json::from_str::<SegmentsDocument>(&document.to_json()).unwrap(), document);
        let (frames, rate) = (document.frames, document.rate);
        let documents = std::slice::from_ref(&document);
        for text in [document.to_json(), segments_csv(documents), babel_json(documents)] {
            let read = read_segments(&text, "86_01", frames, rate).unwrap();
            assert_eq!(ranges(&read), [(0..40, "walk"), (40..41, ""), (41..500, "kick, \"high\"")], "{text}");
            let cuts = read_cuts(&text, "86_01", frames, rate).unwrap();
            assert_eq!(cuts, [40.0, 41.0].map(TrueCut::at));
            let short = read_segments(&text, "86_01", 400, rate);
            assert_eq!(short, Err(LabelsError::Length { found: 500, frames: 400 }));
        }
    }

    #[test]
    fn several_skeletons_are_told_apart_in_what_is_written() {
        let documents = ["A:Hips", "B:Hips"].map(|root| {
            let root = Some(root.to_string());
            SegmentsDocument { root, ..document() }
        });
        let table = segments_csv(&documents);
        assert!(table.starts_with("root,start_frame,end_frame,start_s,end_s,kind,label\nA:Hips,0,40,0,"));
        assert!(babel_json(&documents).contains("\"86_01 B:Hips\""));
        for text in [table, SegmentsDocument::all_to_json(&documents)] {
            assert!(matches!(read_cuts(&text, "86_01", 500, 120.0), Err(LabelsError::Wrong(_))));
        }
    }

    const TRUTH: &str = r#"{"_meta": {"frame_rate": 120}, "86_01": [
        {"start": 1, "end": 550, "label": "walk", "cut_earliest": 500, "cut_latest": 600},
        {"start": 551, "end": 1150, "label": "jump", "cut_earliest": 1200, "cut_latest": 1160},
        {"start": 1151, "end": 1300, "label": "walk", "cut_earliest": 1300, "cut_latest": 1300}],
        "13_30": {"segments": [{"start": 1, "end": 204, "label": "JumpJack"},
        {"start": 205, "end": 792, "label": "Twist"}], "frames_10fps": 66}}"#;

    #[test]
    fn truth_files_count_from_one() {
        let cuts = |clip, frames| read_cuts(TRUTH, clip, frames, 120.0);
        let range = |earliest, latest| TrueCut { earliest, latest };
        // The second range has not its cut in it, and the end is no cut.
        assert_eq!(cuts("86_01", 1300).unwrap(), [range(500.0, 600.0), TrueCut::at(1150.0)]);
        assert_eq!(cuts("86_01", 1301).unwrap(), [range(501.0, 601.0), TrueCut::at(1151.0)], "a T-pose");
        assert_eq!(cuts("13_30", 795).unwrap(), [TrueCut::at(204.0)], "known in tenths of a second");
        assert_eq!(cuts("13_30", 900), Err(LabelsError::Length { found: 792, frames: 900 }));
        assert_eq!(cuts("13_30", 700), Err(LabelsError::Length { found: 792, frames: 700 }));
        let read = read_segments(TRUTH, "86_01", 1301, 120.0).unwrap();
        assert_eq!(ranges(&read), [(0..551, "walk"), (551..1151, "jump"), (1151..1301, "walk")]);
    }

    #[test]
    fn a_truth_without_names_is_of_the_clip_at_hand() {
        let bare = r#"{"fps": 120, "segments": [{"start": 1, "end": 4, "label": "walk"},
            {"start": 5, "end": 10, "label": "run", "cut_earliest": 9, "cut_latest": 12}]}"#;
        assert!(has_segments(bare, "86_01"));
        let read = read_segments(bare, "86_01", 10, 120.0).unwrap();
        assert_eq!(ranges(&read), [(0..4, "walk"), (4..10, "run")]);
        assert_eq!(read_cuts(bare, "86_01", 10, 120.0).unwrap(), [TrueCut::at(4.0)]);
        let long = read_segments(bare, "86_01", 100, 120.0);
        assert_eq!(long, Err(LabelsError::Length { found: 10, frames: 100 }));
        // A clip's own entry goes before.
        let named = bare.replace("\"fps\": 120", "\"13_30\": [{\"start\": 1, \"end\": 10}]");
        assert_eq!(ranges(&read_segments(&named, "13_30", 10, 120.0).unwrap()), [(0..10, "")]);
        for text in [r#"{"segments": []}"#, r#"{"segments": [1]}"#, r#"{"segments": 1}"#, r#"["segments"]"#] {
            assert_eq!(
                read_segments(text, "86_01", 10, 120.0).unwrap_err(),
                LabelsError::NoSegments,
                "{text}"
            );
        }
    }

    #[test]
    fn clips_are_found_by_name() {
        assert!(has_segments(TRUTH, "13_30") && !has_segments(TRUTH, "86_02"));
        assert_eq!(read_cuts(TRUTH, "86_02", 9, 1.0), Err(LabelsError::NoClip("86_02".into())));
        let sequences = r#"{"7": {"feat_p": "CMU/13/13_30_poses.npz", "dur": 1, "frame_ann": {"labels": []}},
            "8": {"feat_p": "CMU/86/86_01_poses.npz", "dur": 4.01, "frame_ann": {"labels": [
            {"raw_label": "kick", "start_t": 2, "end_t": 3}, {"raw_label": "walk", "start_t": 0.04, "end_t": 2},
            {"raw_label": "clap", "start_t": 1.5, "end_t": 1.7}]}}}"#;
        let read = read_segments(sequences, "86_01", 400, 100.0).unwrap();
        assert_eq!(ranges(&read), [(0..200, "walk"), (200..300, "kick"), (300..400, "")]);
        assert!(!has_segments(sequences, "86_02"));
    }

    #[test]
    fn refusals_say_why() {
        let read = |text: &str| read_segments(text, "walk", 10, 1.0);
        let truth = r#"{"fps": 100, "left": [0, 1], "right": [1, 1]}"#;
        for text in ["", "hello", "frame,time\n", "[]", "[1]", "{}", "{\"walk\": 1}", truth] {
            assert_eq!(read(text), Err(LabelsError::NoSegments), "{text}");
            assert!(!has_segments(text, "walk"));
        }
        let newer = format!("{{\"format\": \"{SEGMENTS_FORMAT}\", \"version\": 99}}");
        assert_eq!(read(&newer), Err(LabelsError::Version(99)));
        for text in [
            "{",
            "start_frame,end_frame,label\n0,x,walk\n",
            "start_frame,end_frame,label\n0,4,walk\n5,10,walk\n",
            "start_frame,end_frame,label\n0,10,walk\n10,10,walk\n",
            "start_frame,end_frame,kind,label\n0,10,odd,walk\n",
            r#"{"walk": [{"start": 0, "end": 10}]}"#,
            r#"{"walk": [{"start": 3, "end": 1}, {"start": 1, "end": 10}]}"#,
            r#"{"walk": [{"start": -1, "end": 10}]}"#,
        ] {
            assert!(matches!(read(text), Err(LabelsError::Wrong(_))), "{text}");
        }
    }
}
