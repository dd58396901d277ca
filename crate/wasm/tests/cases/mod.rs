//! What the bindings must do, wherever they run.

use js_sys::Function;
use plantigrade::bvh;
use plantigrade::labels::{Document, Part, Side};
use plantigrade::plants::{self, Feet};
use plantigrade::skeleton::Skeleton;
use plantigrade_wasm::{
    ClipFacts, DetectOptions, EditFacts, Failure, Overrides, RawClip, RawDetection, RawLabelling, RawReader,
    RawSegments, SegmentFacts, SegmentOptions, has_segments,
};
use tsify::{Ts, Tsify};
use wasm_bindgen_test::wasm_bindgen_test;

const WALK: &[u8] = include_bytes!("../../../../samples/curved-walk.bvh");

fn walk() -> RawClip {
    let mut reader = RawReader::new(false, WALK.len() as f64);
    for chunk in WALK.chunks(10_000) {
        reader.push(chunk).unwrap();
    }
    reader.finish().unwrap()
}

/// What a detection is saved as, where that is text.
fn saved(clip: &RawClip, detection: &RawDetection, format: &str) -> String {
    String::from_utf8(clip.save(detection, format, "walk.bvh".into(), None).unwrap()).unwrap()
}

fn options(method: &str) -> Ts<DetectOptions> {
    DetectOptions { method: method.into(), r: 0.001, w: 1, height: None, speed: None, exact: None }
        .into_ts()
        .unwrap()
}

fn facts(clip: &RawClip) -> ClipFacts {
    clip.facts().unwrap().to_rust().unwrap()
}

#[wasm_bindgen_test]
fn a_clip_comes_with_its_facts() {
    let clip = walk();
    let facts = facts(&clip);
    assert_eq!((facts.frames, facts.rate.round()), (245, 120.0));
    assert!(facts.roles.contains_key("left_toe") && facts.roles.contains_key("right_toe"));
    assert_eq!(clip.positions().length() as usize, facts.frames * facts.joints.len() * 3);
}

#[wasm_bindgen_test]
fn labels_are_those_of_the_core() {
    let clip = bvh::parse(WALK, bvh::Options::default()).unwrap().clip;
    let feet = Feet::of(&clip, &Skeleton::main(&clip, &Default::default())).unwrap();
    let expected = plants::detect(&feet, plants::ValidParams::default());
    let found = walk().detect(options("robust")).unwrap();
    assert_eq!(found.parts(), ["contact", "toe", "heel"]);
    for labels in &expected.parts {
        let part = labels.part.name();
        let left: Vec<u8> = labels.feet[0].planted.iter().map(|&planted| u8::from(planted)).collect();
        assert_eq!(found.planted(part, "left").unwrap(), left);
        assert_eq!(found.intervals(part, "left").unwrap().len() % 2, 0);
        assert_eq!(found.confidence(part, "right").unwrap().len(), 245);
    }
    assert!(found.planted("shoulder", "left").is_err());
}

#[wasm_bindgen_test]
fn labels_follow_from_the_evidence() {
    let found = walk().detect(options("paper")).unwrap();
    let facts = found.evidence("toe").unwrap().to_rust().unwrap();
    let sorted = found.sorted_norms("toe").unwrap();
    assert_eq!((sorted.len(), sorted.len()), (490, found.running_variance("toe").unwrap().len()));
    assert_eq!((facts.sigma as f32, facts.tolerance), (sorted[facts.knee], 0.001));
    assert!(facts.planted_is_high && facts.planted_middle > facts.threshold);
    for side in ["left", "right"] {
        let roots = found.roots("toe", side).unwrap();
        let planted: Vec<u8> =
            roots.iter().map(|root| u8::from(f64::from(*root) > facts.threshold)).collect();
        assert_eq!(planted, found.planted("toe", side).unwrap());
        let norms = found.norms("toe", side).unwrap();
        assert!(norms.iter().all(|norm| sorted.contains(norm)));
    }
    let field = found.field("toe", &[0.0, 1.0], &[0.0, 0.5, 9.0]).unwrap();
    assert_eq!(field.len(), 6);
    assert!(f64::from(field[0]) > facts.threshold && f64::from(field[5]) < facts.threshold);
    assert!(found.field("heel", &[0.0], &[0.0]).is_err());
    let limits = found.limits().unwrap().to_rust().unwrap();
    assert_eq!((limits.height, limits.speed), (None, None));
}

#[wasm_bindgen_test]
fn methods_without_a_field_say_so() {
    let clip = walk();
    let found = clip.detect(options("njw")).unwrap();
    assert!(!found.evidence("toe").unwrap().to_rust().unwrap().has_field);
    assert!(found.field("toe", &[0.0], &[0.0]).is_err());
    let found = clip.detect(options("dual")).unwrap();
    assert!(!found.has_evidence("toe").unwrap() && found.evidence("toe").is_err());
    let limits = found.limits().unwrap().to_rust().unwrap();
    assert_eq!((limits.height, limits.speed), (Some(0.05), Some(0.5)));
}

#[wasm_bindgen_test]
fn edits_lie_over_what_was_found_until_they_are_taken_back() {
    let clip = walk();
    let mut found = clip.detect(options("robust")).unwrap();
    let before = found.intervals("contact", "left").unwrap();
    let edit = EditFacts {
        side: Side::Left,
        part: Part::Contact,
        start: before[0] as usize,
        end: before[1] as usize,
        planted: false,
    };
    found.edit(vec![edit.into_ts().unwrap()]).unwrap();
    assert_eq!(found.intervals("contact", "left").unwrap(), before[2..]);
    let moved = EditFacts {
        side: Side::Left,
        part: Part::Contact,
        start: before[2] as usize,
        end: before[3] as usize + 2,
        planted: true,
    };
    found.edit(vec![moved.into_ts().unwrap()]).unwrap();
    assert_eq!(found.intervals("contact", "left").unwrap()[3], before[3] + 2);
    assert!(found.has_evidence("contact").unwrap(), "the evidence is that of what was found");
    let mut marks = vec![0; before.len() / 2];
    marks[1] = 1;
    assert_eq!(found.edited("contact", "left").unwrap(), marks);
    let text = saved(&clip, &found, "json");
    assert_eq!(text.matches("\"edited\"").count(), 1);
    let read = RawLabelling::new(text.as_bytes(), 245).unwrap();
    found.edit(read.edits().unwrap()).unwrap();
    assert_eq!(found.intervals("contact", "left").unwrap()[3], before[3] + 2);
    found.edit(Vec::new()).unwrap();
    assert_eq!(found.intervals("contact", "left").unwrap(), before);
}

#[wasm_bindgen_test]
fn labels_come_back_from_an_archive() {
    let clip = walk();
    let found = clip.detect(options("robust")).unwrap();
    let archive = clip.save(&found, "npz", "walk.bvh".into(), None).unwrap();
    let read = RawLabelling::new(&archive, 245).unwrap();
    for part in found.parts() {
        let ours: Vec<i8> = found.planted(&part, "right").unwrap().iter().map(|&label| label as i8).collect();
        assert_eq!(read.planted(&part, "right").unwrap(), ours);
    }
    assert!(saved(&clip, &found, "blender").contains("import bpy"));
}

#[wasm_bindgen_test]
fn planted_feet_are_held_still() {
    let clip = walk();
    let found = clip.detect(options("robust")).unwrap();
    let slides: Vec<f64> =
        clip.skate(&found).unwrap().iter().map(|slide| slide.to_rust().unwrap().farthest).collect();
    assert_eq!(slides.len(), 5);
    let cleaned = clip.clean(&found).unwrap();
    for (plant, before) in cleaned.plants().unwrap().iter().zip(slides) {
        let plant = plant.to_rust().unwrap();
        assert_eq!((plant.before, plant.why_not), (before, None));
        assert!(plant.after < 1e-3, "{}", plant.after);
    }
    assert_eq!(cleaned.positions().length() as usize, clip.positions().length() as usize);
    let read = bvh::parse(&cleaned.bvh(), bvh::Options::default()).unwrap().clip;
    assert_eq!(read.frame_count(), 245);
    assert!(cleaned.notices().unwrap().is_empty());
}

#[wasm_bindgen_test]
fn a_walk_has_a_gait() {
    let clip = walk();
    let found = clip.detect(options("robust")).unwrap();
    let gait = clip.gait(&found).unwrap().to_rust().unwrap();
    assert!((100.0..125.0).contains(&gait.cadence.unwrap()), "{gait:?}");
    assert_eq!(gait.sides.len(), 7);
    assert!(gait.double_support_share.unwrap().mean > 0.1);
}

#[wasm_bindgen_test]
fn the_paper_method_labels_toes_only() {
    assert_eq!(walk().detect(options("paper")).unwrap().parts(), ["toe"]);
    assert!(walk().detect(options("best")).is_err());
}

#[wasm_bindgen_test]
fn overrides_take_the_place_of_those_before() {
    let mut clip = walk();
    let overrides = Overrides { rate: Some(30.0), up: Some("z".into()), ..Overrides::default() };
    clip.apply(overrides.into_ts().unwrap()).unwrap();
    let changed = facts(&clip);
    assert_eq!((changed.rate.round(), changed.up.as_str()), (30.0, "z"));
    let wrong = Overrides { rate: Some(-1.0), ..Overrides::default() };
    assert!(clip.apply(wrong.into_ts().unwrap()).is_err());
    clip.apply(Overrides::default().into_ts().unwrap()).unwrap();
    assert_eq!(facts(&clip).rate.round(), 120.0);
}

#[wasm_bindgen_test]
fn documents_read_back() {
    let clip = walk();
    let labels = clip.detect(options("robust")).unwrap();
    let text = saved(&clip, &labels, "json");
    let document: Document = serde_json::from_str(&text).unwrap();
    assert_eq!((document.frames, document.source.name.as_str()), (245, "walk.bvh"));
    let table = saved(&clip, &labels, "csv");
    assert_eq!(table.lines().count(), 246);
}

#[wasm_bindgen_test]
fn truth_stands_beside_the_labels() {
    let clip = walk();
    let labels = clip.detect(options("robust")).unwrap();
    let truth = include_str!("../../../../samples/curved-walk.json");
    let other = RawLabelling::new(truth.as_bytes(), 245).unwrap();
    assert_eq!(other.parts(), ["contact", "toe", "heel"]);
    assert_eq!(other.planted("toe", "left").unwrap().len(), 245);
    let scores = other.score(&clip, &labels).unwrap();
    let contact = scores[0].to_rust().unwrap();
    assert!(contact.rows[3].lenient > 0.98 && contact.events.f1 > 0.9);
    assert!(RawLabelling::new(truth.as_bytes(), 244).is_err());
}

#[wasm_bindgen_test]
fn every_method_is_listed_and_works() {
    let clip = walk();
    for method in plantigrade_wasm::methods().unwrap() {
        let method = method.to_rust().unwrap();
        assert_eq!(clip.detect(options(&method.name)).unwrap().parts(), method.parts, "{}", method.name);
    }
}

#[wasm_bindgen_test]
fn refusals_say_where() {
    let mut reader = RawReader::new(false, 0.0);
    let refused = reader.push(b"HIERARCHY\nROOT a\n{\n  OFFSET 0 x 0\n}\n").unwrap_err();
    let Failure { message, line, column, hint, .. } = refused;
    assert_eq!((line, column), (Some(4), Some(12)));
    assert!(message.contains("expected a number") && hint.is_some());
}

/// A walk that becomes a run.
fn limp() -> RawClip {
    let mut reader = RawReader::new(false, 0.0);
    reader.push(include_bytes!("../../../../samples/limp-to-run.bvh")).unwrap();
    reader.finish().unwrap()
}

fn cutting(method: &str) -> Ts<SegmentOptions> {
    SegmentOptions { method: method.into(), ..SegmentOptions::default() }.into_ts().unwrap()
}

/// A listener that hears nothing.
fn deaf() -> Function {
    Function::new_no_args("")
}

#[wasm_bindgen_test]
fn every_method_of_segmentation_tiles_the_clip() {
    let clip = limp();
    let methods = plantigrade_wasm::segment_methods().unwrap();
    assert_eq!(methods.len(), 6);
    for method in methods {
        let method = method.to_rust().unwrap();
        let found = clip.segment(cutting(&method.name), &deaf()).unwrap();
        let segments: Vec<SegmentFacts> =
            found.segments().unwrap().into_iter().map(|segment| segment.to_rust().unwrap()).collect();
        assert_eq!((segments[0].start, segments[segments.len() - 1].end), (0, 744), "{}", method.name);
        assert!(segments.windows(2).all(|pair| pair[0].end == pair[1].start), "{}", method.name);
        let values = found.curve_values();
        assert_eq!(found.curve_frames().len(), values.len());
        assert!([0, values.len()].contains(&found.curve_threshold().len()));
        assert!(found.extrema().iter().all(|&index| (index as usize) < values.len()));
        assert_eq!(found.motifs().len(), 2 * found.motif_classes().len());
        assert!(!found.curve_title().is_empty() && !method.about.is_empty());
    }
    assert!(clip.segment(cutting("best"), &deaf()).is_err());
    let wrong = SegmentOptions { dims: Some(0), ..cutting("mvu").to_rust().unwrap() };
    assert!(clip.segment(wrong.into_ts().unwrap(), &deaf()).is_err());
}

#[wasm_bindgen_test]
fn segmentation_tells_how_far_it_is() {
    let told = Function::new_with_args("share", "(globalThis.told ??= []).push(share)");
    limp().segment(cutting("mvu"), &told).unwrap();
    let shares = js_sys::Reflect::get(&js_sys::global(), &"told".into()).unwrap();
    let shares: Vec<f64> = js_sys::Array::from(&shares).iter().filter_map(|share| share.as_f64()).collect();
    assert!(shares.len() > 3 && shares.iter().all(|share| (0.0..=1.0).contains(share)));
}

#[wasm_bindgen_test]
fn segments_read_back_under_the_names_given() {
    let clip = limp();
    let found = clip.segment(cutting("lsd"), &deaf()).unwrap();
    let count = found.segments().unwrap().len();
    let names: Vec<String> = (1..=count).map(|number| format!("move {number}")).collect();
    for format in ["json", "csv", "babel"] {
        let text = clip.save_segments(&found, names.clone(), format, "limp.bvh".into(), None).unwrap();
        assert!(has_segments(&text, "limp") && !has_segments("frame,left_toe\n", "limp"));
        let other = RawSegments::new(&text, "limp", &clip).unwrap();
        let read = other.segments().unwrap().into_iter().map(|segment| segment.to_rust().unwrap().label);
        assert_eq!(read.collect::<Vec<_>>(), names, "{format}");
        for score in other.score(&clip, &found).unwrap() {
            assert_eq!(score.to_rust().unwrap().f1, 1.0);
        }
    }
    assert!(clip.save_segments(&found, names, "xml", "limp.bvh".into(), None).is_err());
    assert!(RawSegments::new("{}", "limp", &clip).is_err());
}

#[wasm_bindgen_test]
fn a_cut_is_a_clip_of_its_own() {
    let clip = walk();
    let part = bvh::parse(&clip.cut(10, 30).unwrap(), bvh::Options::default()).unwrap().clip;
    let whole = bvh::parse(WALK, bvh::Options::default()).unwrap().clip;
    assert_eq!((part.frame_count(), part.row(0)), (20, whole.row(10)));
    assert!(clip.cut(10, 10).is_err() && clip.cut(0, 246).is_err());
}
