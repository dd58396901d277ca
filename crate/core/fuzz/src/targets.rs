//! Functions that must hold for any bytes.

use std::ops::Range;
use std::sync::{Arc, OnceLock};

use peak_alloc::PeakAlloc;
use plantigrade::bvh::{self, Clip, Options, Parsed, Reader};
use plantigrade::foot::{Part, Side};
use plantigrade::formats::{
    self, PlantExport, PlantFormat, SegmentExport, SegmentFormat, SegmentsDocument, Source,
};
use plantigrade::gait::Gait;
use plantigrade::plants::{self, Corrections, Detection, Edit, Feet};
use plantigrade::segments;
use plantigrade::skate::{self, Contacts};
use plantigrade::skeleton::{Overrides, Skeleton, Up};
use plantigrade_synth::{full_set, generate, hard_cases};
use serde_json::Value;

/// Memory that a target may use per byte of its input, …
const BYTES_PER_BYTE: usize = 200;
/// … and for an input of any length, in bytes.
const BASE_BYTES: usize = 4 << 20;

/// Codes below this one select all segmentation methods, the others the fast ones.
const SLOW_CODES: u8 = 12;
/// Number of frames that are segmented by unfolding.
const MVU_FRAMES: usize = 6;

/// Runs a target and checks the memory that it uses.
///
/// # Panics
/// If the target panics or uses too much memory.
pub fn run(allocator: &PeakAlloc, target: fn(&[u8]), data: &[u8]) {
    // The clips to change do not count.
    clips();
    let before = allocator.current_usage();
    allocator.reset_peak_usage();
    target(data);
    let used = allocator.peak_usage().saturating_sub(before);
    let limit = BASE_BYTES + BYTES_PER_BYTE * data.len();
    assert!(used <= limit, "{used} bytes of memory for an input of {} bytes", data.len());
}

/// The bytes as a BVH file: chunks do not change the result, values are finite, what is written is read back,
/// and rewriting an unchanged clip preserves its bytes.
///
/// The first byte selects the options and the length of chunks.
pub fn bvh(data: &[u8]) {
    let Some((&first, file)) = data.split_first() else { return };
    let options = Options { lenient: first & 1 == 1, ..Options::default() };
    let parsed = bvh::parse(file, options);
    let chunk = usize::from(first >> 1) + 1;
    let mut reader = Reader::new(options);
    let chunked = file.chunks(chunk).try_for_each(|chunk| reader.push(chunk)).and_then(|()| reader.finish());
    assert_eq!(parsed, chunked, "chunks of {chunk} bytes");
    let Ok(Parsed { clip, layout, .. }) = parsed else { return };
    assert!(clip.values().iter().all(|value| value.is_finite()));
    assert!(clip.frame_time() > 0.0 && clip.frame_time().is_finite());

    let written = bvh::write(&clip);
    let back = bvh::parse(written.as_bytes(), Options::default()).expect("a written clip is valid");
    assert_eq!(back.clip.values(), clip.values());
    assert_eq!(back.clip.joints().len(), clip.joints().len());

    let clip = Arc::new(clip);
    let rewritten = bvh::rewrite(file, &layout, &clip, 0..clip.frame_count());
    let again = bvh::parse(&rewritten, options).expect("a rewritten clip is valid");
    assert_eq!(again.clip.values(), clip.values());
}

/// The bytes as labels of any format: labels have one value per frame, and segments cover the clip.
///
/// The first two bytes are the number of frames.
pub fn labels(data: &[u8]) {
    let Some((frames, file)) = data.split_first_chunk::<2>() else { return };
    let frames = usize::from(u16::from_le_bytes(*frames));
    if let Ok(annotation) = formats::read_plants(file, frames) {
        for labels in annotation.parts.iter().flat_map(|(_, feet)| feet) {
            assert_eq!(labels.len(), frames);
        }
    }
    if let Ok(edits) = formats::read_edits(file, frames) {
        assert!(edits.iter().all(|edit| edit.start < edit.end && edit.end <= frames));
    }
    let Ok(text) = std::str::from_utf8(file) else { return };
    let rate = 30.0;
    let _ = formats::has_segments(text, "clip");
    if let Ok(segments) = formats::read_segments(text, "clip", frames, rate) {
        assert_cover(segments.iter().map(|segment| segment.frames.clone()), frames);
    }
    if let Ok(cuts) = formats::read_cuts(text, "clip", frames, rate) {
        assert!(cuts.iter().all(|cut| cut.earliest <= cut.latest && cut.latest <= frames as f64));
    }
}

/// All processing of a short clip with some absurd values: results are finite, and every file that is written
/// is read back.
///
/// The first bytes select methods, options, the clip and what is processed: labels and their files, gait and
/// clean-up, segments, or all; each of the following four bytes changes a value.
pub fn pipeline(data: &[u8]) {
    let Some((&[method, segmentation, flags, rate], edits)) = data.split_first_chunk::<4>() else { return };
    let clip = changed_clip(flags, rate, edits);
    let up = (flags & 0x10 != 0).then(|| Up::ALL[usize::from(rate) % Up::ALL.len()]);
    let overrides = Overrides { up, ..Overrides::default() };
    for skeleton in Skeleton::all(&clip, &overrides) {
        assert!(skeleton.metres_per_unit.is_finite() && skeleton.metres_per_unit > 0.0);
        assert!(skeleton.positions(&clip).iter().all(|position| position.is_finite()));
        let stage = Stage::of(method);
        if stage != Stage::Segments {
            label(&clip, &skeleton, method & 0x3f, flags, stage, edits);
        }
        if matches!(stage, Stage::Segments | Stage::All) {
            segment(&clip, &skeleton, segmentation, flags);
        }
    }
}

/// What an execution processes, so that most are quick.
#[derive(Clone, Copy, PartialEq)]
enum Stage {
    All,
    Labels,
    CleanUp,
    Segments,
}

impl Stage {
    fn of(method: u8) -> Stage {
        [Stage::All, Stage::Labels, Stage::CleanUp, Stage::Segments][usize::from(method >> 6)]
    }
}

fn label(clip: &Clip, skeleton: &Skeleton, method: u8, flags: u8, stage: Stage, edits: &[u8]) {
    let Ok(feet) = Feet::new(clip, skeleton) else { return };
    let method = plants::Method::ALL[usize::from(method) % plants::Method::ALL.len()];
    let params = plants::Params { method, exact: flags & 0x20 != 0, ..plants::Params::default() };
    let detection = plants::detect(&feet, params.check().expect("valid parameters"));
    if stage != Stage::CleanUp {
        write_labels(clip, skeleton, &detection);
        write_labels(clip, skeleton, &corrected(&feet, &detection, edits));
    }
    if stage != Stage::Labels {
        measure_and_clean(clip, skeleton, &feet, &detection);
    }
}

/// Applies the corrections of a person, which the first bytes of `edits` determine, to similar motion. The last
/// of them holds in all its frames.
fn corrected(feet: &Feet, detection: &Detection, edits: &[u8]) -> Detection {
    let frames = feet.frame_count();
    let edit = |&[frame, part, length, planted]: &[u8; 4]| {
        let start = usize::from(frame) % frames;
        Edit {
            side: Side::BOTH[usize::from(part & 1)],
            part: Part::ALL[usize::from(part >> 1) % Part::ALL.len()],
            start,
            end: (start + 1 + usize::from(length % 8)).min(frames),
            planted: planted & 1 == 1,
        }
    };
    let edits: Vec<Edit> = edits.as_chunks::<4>().0.iter().take(4).map(edit).collect();
    let corrected = Corrections::learn(feet, detection, &edits).apply(feet, detection, &edits).detection;
    if let Some(&Edit { side, part, start, end, planted }) = edits.last()
        && let Some(labels) = corrected.part(part)
    {
        assert!(labels.foot(side).planted[start..end].iter().all(|&label| label == planted));
    }
    corrected
}

/// Every file that is written is read back.
fn write_labels(clip: &Clip, skeleton: &Skeleton, detection: &Detection) {
    let export = PlantExport {
        source: Source { name: "clip.bvh".into(), ..Source::default() },
        clip,
        notices: &[],
        skeletons: vec![(skeleton, detection)],
        as_array: false,
    };
    for &format in PlantFormat::ALL {
        let file = format.write(&export);
        let without_plants = format == PlantFormat::Intervals;
        if without_plants || matches!(format, PlantFormat::Json | PlantFormat::Csv | PlantFormat::Npz) {
            let read = formats::read_plants(&file, clip.frame_count()).expect("a written file is read");
            for labels in &detection.parts {
                let Some(feet) = read.part(labels.part) else {
                    let planted = Side::BOTH.map(|side| labels.foot(side).planted.contains(&true));
                    assert!(without_plants && planted == [false; 2], "{} is missing", labels.part.name());
                    continue;
                };
                for side in Side::BOTH {
                    let planted = labels.foot(side).planted.iter().map(|&planted| Some(planted));
                    assert!(feet[side as usize].iter().copied().eq(planted));
                }
            }
        }
    }
    for document in export.documents() {
        assert_finite(&serde_json::to_value(document).expect("a document"));
    }
}

/// Gait measures and the cleaned clip are finite.
fn measure_and_clean(clip: &Clip, skeleton: &Skeleton, feet: &Feet, detection: &Detection) {
    let gait = Gait::from_detection(feet, detection);
    let text = serde_json::to_string(&gait).expect("gait");
    assert_eq!(serde_json::from_str::<Gait>(&text).expect("gait"), gait, "not finite");

    let contacts = Contacts::from(detection);
    let Ok(cleaned) = skate::clean(clip, skeleton, &contacts, &skate::Options::default()) else { return };
    assert!(cleaned.clip.values().iter().all(|value| value.is_finite()));
    for plant in &cleaned.plants {
        assert!(plant.before.is_finite() && plant.after.is_finite());
        assert!(plant.position.is_none_or(|position| position.iter().all(|value| value.is_finite())));
    }
}

fn segment(clip: &Clip, skeleton: &Skeleton, method: u8, flags: u8) {
    // Few codes select the methods that take as long as everything else for tens or hundreds of clips.
    let all = segments::Method::ALL;
    let methods = if method < SLOW_CODES { all } else { &[segments::Method::Auto, segments::Method::Lsd] };
    let method = methods[usize::from(method) % methods.len()];
    let short = (method == segments::Method::Mvu).then(|| clip.slice(0..MVU_FRAMES));
    let clip = short.as_ref().unwrap_or(clip);
    let params = segments::Params { method, published: flags & 0x40 != 0, ..segments::Params::default() };
    let params = params.check().expect("valid parameters");
    let Ok(segmentation) = segments::segment(clip, skeleton, params, &mut |_| Ok(())) else { return };
    assert_cover(segmentation.segments.iter().map(|segment| segment.frames.clone()), clip.frame_count());
    assert!(segmentation.curve.values.iter().all(|value| value.is_finite()));
    let source = Source { name: "clip.bvh".into(), ..Source::default() };
    let document = SegmentsDocument::new(source, clip, skeleton, &segmentation, &[]);
    assert_finite(&serde_json::to_value(&document).expect("a document"));
    let export = SegmentExport { documents: vec![document], as_array: false };
    for &format in SegmentFormat::ALL {
        let file = format.write(&export);
        if matches!(format, SegmentFormat::Npz | SegmentFormat::Unreal | SegmentFormat::Unity) {
            continue;
        }
        let text = std::str::from_utf8(&file).expect("text");
        let read = formats::read_segments(text, "clip", clip.frame_count(), clip.rate());
        assert_cover(
            read.expect("a written file is read").into_iter().map(|read| read.frames),
            clip.frame_count(),
        );
    }
}

/// Returns a short clip in which each four bytes of `edits` replace a value: frame, channel and value.
fn changed_clip(flags: u8, rate: u8, edits: &[u8]) -> Clip {
    const RATES: [f64; 8] = [30.0, 120.0, 60.0, 24.0, 1.0, 10_000.0, 29.97, 300.0];
    let clips = clips();
    let clip = &clips[usize::from(flags & 0xf) % clips.len()];
    let mut values = clip.values().to_vec();
    let width = clip.channel_count();
    for &[frame, channel, low, high] in edits.as_chunks::<4>().0 {
        let value = absurd_value(u16::from_le_bytes([low, high]));
        // The last frames stand for ranges of frames.
        let frames = match usize::from(frame) {
            255 => 0..clip.frame_count(),
            254 => 0..clip.frame_count() / 2,
            frame => frame % clip.frame_count()..frame % clip.frame_count() + 1,
        };
        for frame in frames {
            values[frame * width + usize::from(channel) % width] = value;
        }
    }
    Clip::new(clip.joints().to_vec(), 1.0 / RATES[usize::from(rate) % RATES.len()], values)
}

/// Returns a value that a file may contain: an extreme one for small codes.
fn absurd_value(code: u16) -> f64 {
    const EXTREMES: [f64; 16] = [
        0.0, 1e9, -1e9, 1e-300, -1e-300, 90.0, -90.0, 180.0, 360.0, 1e6, -1e6, 5e-324, 1e-9, 100.0, -100.0,
        1.0,
    ];
    EXTREMES.get(usize::from(code)).copied().unwrap_or((f64::from(code) - 32768.0) / 100.0)
}

/// Returns short clips of several skeletons and motions, which are created once.
pub fn clips() -> &'static [Clip] {
    static CLIPS: OnceLock<Vec<Clip>> = OnceLock::new();
    CLIPS.get_or_init(|| {
        let specs = full_set(1.0).into_iter().step_by(20).chain(hard_cases(1.0).into_iter().step_by(5));
        let clip = |generated: plantigrade_synth::Generated| {
            let clip = generated.clip;
            let step = (clip.rate() / 30.0).round().max(1.0) as usize;
            let frames = (10..clip.frame_count()).step_by(step).take(24);
            let values = frames.flat_map(|frame| clip.row(frame).to_vec()).collect();
            Clip::new(clip.joints().to_vec(), 1.0 / 30.0, values)
        };
        specs.take(8).map(|spec| clip(generate(&spec, 0))).collect()
    })
}

fn assert_cover(ranges: impl Iterator<Item = Range<usize>>, frames: usize) {
    let end = ranges.fold(0, |end, range| {
        assert!(range.start == end && range.end > end, "{range:?} after {end}");
        range.end
    });
    assert_eq!(end, frames);
}

/// Checks that no number of a JSON value is infinite or not a number, which JSON writes as null.
fn assert_finite(value: &Value) {
    match value {
        Value::Null => panic!("a number is not finite"),
        Value::Array(values) => values.iter().for_each(assert_finite),
        Value::Object(values) => values.values().for_each(assert_finite),
        _ => {}
    }
}
