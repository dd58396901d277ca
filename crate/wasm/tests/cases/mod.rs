//! Tests of the bindings that run both in a page and in a worker.

use js_sys::Function;
use plantigrade::bvh;
use plantigrade::foot::{Part, Side};
use plantigrade::formats::PlantsDocument;
use plantigrade::plants::{self, Feet};
use plantigrade::segments;
use plantigrade::skate::{self, Contacts};
use plantigrade::skeleton::Skeleton;
use plantigrade_wasm::{
    ClipInfo, DetectOptions, EditInfo, Failure, Overrides, SegmentInfo, SegmentOptions, WasmAnnotation,
    WasmClip, WasmDetection, WasmReader, WasmRewriter, WasmSegmentAnnotation, common_actions, has_segments,
};
use tsify::{Ts, Tsify};
use wasm_bindgen_test::wasm_bindgen_test;

const WALK: &[u8] = include_bytes!("../../../../samples/curved-walk.bvh");

fn walk() -> WasmClip {
    let mut reader = WasmReader::new(false, WALK.len() as f64);
    for chunk in WALK.chunks(10_000) {
        reader.push(chunk).unwrap();
    }
    reader.finish().unwrap()
}

/// Returns a detection in a text format.
fn save_text(clip: &WasmClip, detection: &WasmDetection, format: &str) -> String {
    String::from_utf8(clip.save(detection, format, "walk.bvh".into(), None).unwrap()).unwrap()
}

fn options(method: &str) -> Ts<DetectOptions> {
    DetectOptions { method: method.into(), r: 0.001, w: 1, height: None, speed: None, exact: None }
        .into_ts()
        .unwrap()
}

fn info(clip: &WasmClip) -> ClipInfo {
    clip.info().unwrap().to_rust().unwrap()
}

#[wasm_bindgen_test]
fn clip_info_matches_the_file() {
    let clip = walk();
    let info = info(&clip);
    assert_eq!((info.frames, info.rate.round()), (245, 120.0));
    assert!(info.roles.contains_key("left_toe") && info.roles.contains_key("right_toe"));
    assert_eq!(clip.positions().length() as usize, info.frames * info.joints.len() * 3);
}

#[wasm_bindgen_test]
fn labels_equal_those_of_the_core() {
    let clip = bvh::parse(WALK, bvh::Options::default()).unwrap().clip;
    let feet = Feet::new(&clip, &Skeleton::main(&clip, &Default::default())).unwrap();
    let expected = plants::detect(&feet, plants::ValidParams::default());
    let detection = walk().detect(options("robust")).unwrap();
    assert_eq!(detection.parts(), ["contact", "toe", "heel"]);
    let ground = detection.ground().unwrap().to_rust().unwrap();
    assert_eq!(
        (ground.normal, ground.tilt, &ground.levels[..], ground.belt),
        ([0.0, 1.0, 0.0], 0.0, &[0.0][..], None)
    );
    assert!((ground.origin[1] - detection.floor()).abs() < 0.02, "{ground:?}");
    let noise = detection.noise().unwrap().unwrap().to_rust().unwrap();
    assert!((1e-4..1e-3).contains(&noise.position) && (0.03..0.1).contains(&noise.speed), "{noise:?}");
    for labels in &expected.parts {
        let part = labels.part.name();
        for (side, foot) in ["left", "right"].into_iter().zip(&labels.feet) {
            let planted: Vec<u8> = foot.planted.iter().map(|&planted| u8::from(planted)).collect();
            assert_eq!(detection.planted(part, side).unwrap(), planted);
            let mut rebuilt = vec![0; planted.len()];
            for range in detection.intervals(part, side).unwrap().chunks(2) {
                rebuilt[range[0] as usize..range[1] as usize].fill(1);
            }
            assert_eq!(rebuilt, planted);
            assert_eq!(detection.confidence(part, side).unwrap(), foot.confidence);
        }
    }
    assert!(detection.planted("shoulder", "left").is_err());
}

#[wasm_bindgen_test]
fn labels_follow_from_the_evidence() {
    let detection = walk().detect(options("paper")).unwrap();
    let evidence = detection.evidence("toe").unwrap().to_rust().unwrap();
    let sorted = detection.sorted_norms("toe").unwrap();
    let mut norms: Vec<f32> =
        ["left", "right"].iter().flat_map(|side| detection.norms("toe", side).unwrap()).collect();
    norms.sort_by(f32::total_cmp);
    assert_eq!(sorted, norms);
    let variances = detection.running_variance("toe").unwrap();
    assert_eq!((sorted.len(), variances.len()), (490, 490));
    for count in [2, evidence.knee + 1, 490] {
        let first: Vec<f64> = sorted[..count].iter().map(|&norm| f64::from(norm)).collect();
        let mean = first.iter().sum::<f64>() / count as f64;
        let squares: f64 = first.iter().map(|norm| (norm - mean).powi(2)).sum();
        let variance = squares / (count - 1) as f64;
        assert!((f64::from(variances[count - 1]) / variance - 1.0).abs() < 1e-3, "{count}");
    }
    assert_eq!((evidence.sigma as f32, evidence.tolerance), (sorted[evidence.knee], 0.001));
    assert!(evidence.planted_is_high && evidence.planted_median > evidence.threshold);
    for side in ["left", "right"] {
        let values = detection.decision_values("toe", side).unwrap();
        let planted: Vec<u8> =
            values.iter().map(|&value| u8::from(f64::from(value) > evidence.threshold)).collect();
        assert_eq!(planted, detection.planted("toe", side).unwrap());
    }
    let field = detection.decision_field("toe", &[0.0, 1.0], &[0.0, 0.5, 9.0]).unwrap();
    assert_eq!(field.len(), 6);
    assert!(f64::from(field[0]) > evidence.threshold && f64::from(field[5]) < evidence.threshold);
    assert!(detection.decision_field("heel", &[0.0], &[0.0]).is_err());
    let thresholds = detection.thresholds().unwrap().to_rust().unwrap();
    assert_eq!((thresholds.height, thresholds.speed), (None, None));
}

#[wasm_bindgen_test]
fn methods_without_decision_field_report_it() {
    let mut clip = walk();
    let detection = clip.detect(options("njw")).unwrap();
    assert!(!detection.evidence("toe").unwrap().to_rust().unwrap().has_field);
    assert!(detection.decision_field("toe", &[0.0], &[0.0]).is_err());
    let detection = clip.detect(options("dual")).unwrap();
    assert!(!detection.has_evidence("toe").unwrap() && detection.evidence("toe").is_err());
    let thresholds = detection.thresholds().unwrap().to_rust().unwrap();
    assert_eq!((thresholds.height, thresholds.speed), (Some(0.05), Some(0.5)));
}

#[wasm_bindgen_test]
fn edits_apply_until_they_are_removed() {
    let mut clip = walk();
    let mut detection = clip.detect(options("robust")).unwrap();
    let before = detection.intervals("contact", "left").unwrap();
    let edit = EditInfo {
        side: Side::Left,
        part: Part::Contact,
        start: before[0] as usize,
        end: before[1] as usize,
        planted: false,
        instants: Vec::new(),
    };
    detection.edit(vec![edit.into_ts().unwrap()]).unwrap();
    assert_eq!(detection.intervals("contact", "left").unwrap(), before[2..]);
    let extended = EditInfo {
        side: Side::Left,
        part: Part::Contact,
        start: before[2] as usize,
        end: before[3] as usize + 2,
        planted: true,
        instants: Vec::new(),
    };
    detection.edit(vec![extended.into_ts().unwrap()]).unwrap();
    assert_eq!(detection.intervals("contact", "left").unwrap()[3], before[3] + 2);
    assert!(detection.has_evidence("contact").unwrap(), "evidence does not depend on edits");
    let mut edited = vec![0; before.len() / 2];
    edited[1] = 1;
    assert_eq!(detection.edited("contact", "left").unwrap(), edited);
    let text = save_text(&clip, &detection, "json");
    assert_eq!(text.matches("\"edited\"").count(), 1);
    let read = WasmAnnotation::new(text.as_bytes(), 245).unwrap();
    detection.edit(read.edits().unwrap()).unwrap();
    assert_eq!(detection.intervals("contact", "left").unwrap()[3], before[3] + 2);
    detection.edit(Vec::new()).unwrap();
    assert_eq!(detection.intervals("contact", "left").unwrap(), before);
}

#[wasm_bindgen_test]
fn labels_read_back_from_npz() {
    let mut clip = walk();
    let detection = clip.detect(options("robust")).unwrap();
    let archive = clip.save(&detection, "npz", "walk.bvh".into(), None).unwrap();
    let read = WasmAnnotation::new(&archive, 245).unwrap();
    for part in detection.parts() {
        let expected: Vec<i8> =
            detection.planted(&part, "right").unwrap().iter().map(|&label| label as i8).collect();
        assert_eq!(read.planted(&part, "right").unwrap(), expected);
    }
    assert!(save_text(&clip, &detection, "blender").contains("import bpy"));
}

/// Gives the file of the walk to a writer in chunks.
fn rewrite(mut rewriter: WasmRewriter) -> Vec<u8> {
    let mut written: Vec<u8> = WALK.chunks(10_000).flat_map(|chunk| rewriter.push(chunk)).collect();
    written.append(&mut rewriter.finish().unwrap());
    written
}

#[wasm_bindgen_test]
fn clean_up_removes_slides() {
    let mut clip = walk();
    let detection = clip.detect(options("robust")).unwrap();
    let slides: Vec<f64> =
        clip.skate(&detection).unwrap().iter().map(|slide| slide.to_rust().unwrap().max_distance).collect();
    assert_eq!(slides.len(), 5);
    let cleaned = clip.clean(&detection, false, Vec::new()).unwrap();
    for (plant, before) in cleaned.plants().unwrap().iter().zip(slides) {
        let plant = plant.to_rust().unwrap();
        assert_eq!((plant.before, plant.skip_reason), (before, None));
        assert!(plant.after < 1e-3, "{}", plant.after);
    }
    assert_eq!(cleaned.positions().length() as usize, clip.positions().length() as usize);
    let saved = rewrite(cleaned.rewriter());
    let read = bvh::parse(&saved, bvh::Options::default()).unwrap().clip;
    assert_eq!(read.frame_count(), 245);
    // The saved file itself no longer slides in those frames.
    let skeleton = Skeleton::main(&read, &Default::default());
    let feet = Feet::new(&bvh::parse(WALK, bvh::Options::default()).unwrap().clip, &skeleton).unwrap();
    let contacts = Contacts::from(&plants::detect(&feet, plants::ValidParams::default()));
    let saved = skate::measure(&read, &skeleton, &contacts).unwrap();
    assert_eq!(saved.plants.len(), 5);
    assert!(saved.plants.iter().all(|slide| slide.distance < 2e-3), "{:?}", saved.plants);
    assert!(cleaned.notices().unwrap().is_empty());
}

#[wasm_bindgen_test]
fn gait_of_a_walk_is_plausible() {
    let mut clip = walk();
    let detection = clip.detect(options("robust")).unwrap();
    let gait = clip.gait(&detection, None).unwrap().to_rust().unwrap();
    assert!((100.0..125.0).contains(&gait.cadence.unwrap()), "{gait:?}");
    assert_eq!(gait.sides.len(), 11);
    assert!(gait.steps.len() >= gait.strides && gait.curves.len() == 3, "{gait:?}");
    assert!(gait.double_support_share.unwrap().mean > 0.1);
}

#[wasm_bindgen_test]
fn names_in_other_encodings_are_decoded() {
    // Shift-JIS: 腰, 左足首, 右足首.
    let names: [&[u8]; 3] = [b"\x8d\x98", b"\x8d\xb6\x91\xab\x8e\xf1", b"\x89\x45\x91\xab\x8e\xf1"];
    let mut file = b"HIERARCHY\nROOT ".to_vec();
    file.extend(names[0]);
    file.extend(b"\n{\nOFFSET 0 0 0\n");
    for name in &names[1..] {
        file.extend(b"JOINT ");
        file.extend(*name);
        file.extend(b"\n{\nOFFSET 1 -80 0\nEnd Site\n{\nOFFSET 0 0 9\n}\n}\n");
    }
    file.extend(b"}\n");
    let mut reader = WasmReader::new(false, file.len() as f64);
    reader.push(&file).unwrap();
    let info = info(&reader.finish().unwrap());
    let read = ["腰", "左足首", "End Site", "右足首", "End Site"];
    assert_eq!(info.joints.iter().map(|joint| joint.name.as_str()).collect::<Vec<_>>(), read);
    assert_eq!((info.roles["left_ankle"], info.roles["right_ankle"]), (1, 3));
}

#[wasm_bindgen_test]
fn the_paper_method_labels_toes_only() {
    assert_eq!(walk().detect(options("paper")).unwrap().parts(), ["toe"]);
    assert!(walk().detect(options("best")).is_err());
}

#[wasm_bindgen_test]
fn overrides_replace_earlier_ones() {
    let mut clip = walk();
    let overrides = Overrides { rate: Some(30.0), up: Some("z".into()), ..Overrides::default() };
    clip.apply(overrides.into_ts().unwrap()).unwrap();
    let changed = info(&clip);
    assert_eq!((changed.rate.round(), changed.up.as_str()), (30.0, "z"));
    let invalid = Overrides { rate: Some(-1.0), ..Overrides::default() };
    assert!(clip.apply(invalid.into_ts().unwrap()).is_err());
    clip.apply(Overrides::default().into_ts().unwrap()).unwrap();
    assert_eq!(info(&clip).rate.round(), 120.0);
}

#[wasm_bindgen_test]
fn documents_read_back() {
    let mut clip = walk();
    let labels = clip.detect(options("robust")).unwrap();
    let text = save_text(&clip, &labels, "json");
    let document: PlantsDocument = serde_json::from_str(&text).unwrap();
    assert_eq!((document.header.frames, document.header.source.name.as_str()), (245, "walk.bvh"));
    let table = save_text(&clip, &labels, "csv");
    assert_eq!(table.lines().count(), 246);
}

#[wasm_bindgen_test]
fn labels_agree_with_the_truth() {
    let mut clip = walk();
    let labels = clip.detect(options("robust")).unwrap();
    let truth = include_str!("../../../../samples/curved-walk.json");
    let reference = WasmAnnotation::new(truth.as_bytes(), 245).unwrap();
    assert_eq!(reference.parts(), ["contact", "toe", "heel"]);
    assert_eq!(reference.planted("toe", "left").unwrap().len(), 245);
    let scores = reference.score(&clip, &labels).unwrap();
    let contact = scores[0].to_rust().unwrap();
    assert!(contact.rows[3].lenient > 0.98 && contact.events.f1 > 0.9);
    assert!(WasmAnnotation::new(truth.as_bytes(), 244).is_err());
}

#[wasm_bindgen_test]
fn every_listed_method_labels_its_parts() {
    let mut clip = walk();
    let methods = plantigrade_wasm::methods().unwrap();
    assert_eq!(methods.len(), plants::Method::ALL.len());
    for (method, expected) in methods.into_iter().zip(plants::Method::ALL) {
        let method = method.to_rust().unwrap();
        assert_eq!(method.name, expected.name());
        assert_eq!(clip.detect(options(&method.name)).unwrap().parts(), method.parts, "{}", method.name);
    }
}

#[wasm_bindgen_test]
fn failures_have_a_location() {
    let mut reader = WasmReader::new(false, 0.0);
    let failure = reader.push(b"HIERARCHY\nROOT a\n{\n  OFFSET 0 x 0\n}\n").unwrap_err();
    let Failure { message, line, column, hint, .. } = failure;
    assert_eq!((line, column), (Some(4), Some(12)));
    assert!(message.contains("expected a number") && hint.is_some());
}

/// Returns the sample of a walk that becomes a run.
fn limp_to_run() -> WasmClip {
    let mut reader = WasmReader::new(false, 0.0);
    reader.push(include_bytes!("../../../../samples/limp-to-run.bvh")).unwrap();
    reader.finish().unwrap()
}

fn segment_options(method: &str) -> Ts<SegmentOptions> {
    SegmentOptions { method: method.into(), ..SegmentOptions::default() }.into_ts().unwrap()
}

/// Returns a progress callback that does nothing.
fn no_progress() -> Function {
    Function::new_no_args("")
}

#[wasm_bindgen_test]
fn every_segmentation_method_covers_the_clip() {
    let clip = limp_to_run();
    let methods = plantigrade_wasm::segment_methods().unwrap();
    assert_eq!(methods.len(), segments::Method::ALL.len());
    for (method, expected) in methods.into_iter().zip(segments::Method::ALL) {
        let method = method.to_rust().unwrap();
        assert_eq!(method.name, expected.name());
        let segmentation = clip.segment(segment_options(&method.name), &no_progress()).unwrap();
        let segments: Vec<SegmentInfo> =
            segmentation.segments().unwrap().into_iter().map(|segment| segment.to_rust().unwrap()).collect();
        assert_eq!((segments[0].start, segments[segments.len() - 1].end), (0, 744), "{}", method.name);
        assert!(segments.windows(2).all(|pair| pair[0].end == pair[1].start), "{}", method.name);
        let values = segmentation.curve_values();
        assert_eq!(segmentation.curve_frames().len(), values.len());
        assert!([0, values.len()].contains(&segmentation.curve_threshold().len()));
        assert!(segmentation.extrema().iter().all(|&index| (index as usize) < values.len()));
        assert_eq!(segmentation.motifs().len(), 2 * segmentation.motif_classes().len());
        assert!(!segmentation.curve_title().is_empty() && !method.description.is_empty());
    }
    assert!(clip.segment(segment_options("best"), &no_progress()).is_err());
    let invalid = SegmentOptions { dims: Some(0), ..segment_options("mvu").to_rust().unwrap() };
    assert!(clip.segment(invalid.into_ts().unwrap(), &no_progress()).is_err());
}

#[wasm_bindgen_test]
fn segmentation_reports_progress() {
    let report = Function::new_with_args("fraction", "(globalThis.fractions ??= []).push(fraction)");
    limp_to_run().segment(segment_options("mvu"), &report).unwrap();
    let fractions = js_sys::Reflect::get(&js_sys::global(), &"fractions".into()).unwrap();
    let fractions: Vec<f64> =
        js_sys::Array::from(&fractions).iter().filter_map(|fraction| fraction.as_f64()).collect();
    assert!(fractions.len() > 3 && fractions.iter().all(|fraction| (0.0..=1.0).contains(fraction)));
}

#[wasm_bindgen_test]
fn segments_read_back_under_given_names() {
    let clip = limp_to_run();
    let segmentation = clip.segment(segment_options("lsd"), &no_progress()).unwrap();
    let count = segmentation.segments().unwrap().len();
    let names: Vec<String> = (1..=count).map(|number| format!("move {number}")).collect();
    for format in ["json", "csv", "babel"] {
        let file = clip
            .save_segments(&segmentation, names.clone(), Vec::new(), format, "limp.bvh".into(), None)
            .unwrap();
        let text = String::from_utf8(file).unwrap();
        assert!(has_segments(&text, "limp") && !has_segments("frame,left_toe\n", "limp"));
        let reference = WasmSegmentAnnotation::new(&text, "limp", &clip).unwrap();
        let read = reference.segments().unwrap().into_iter().map(|segment| segment.to_rust().unwrap().label);
        assert_eq!(read.collect::<Vec<_>>(), names, "{format}");
        for score in reference.score(&clip, &segmentation).unwrap() {
            assert_eq!(score.to_rust().unwrap().f1, 1.0);
        }
    }
    assert!(clip.save_segments(&segmentation, names, Vec::new(), "xml", "limp.bvh".into(), None).is_err());
    assert!(WasmSegmentAnnotation::new("{}", "limp", &clip).is_err());
}

#[wasm_bindgen_test]
fn equal_actions_of_clips_have_equal_names() {
    let clip = limp_to_run();
    let segmentation = clip.segment(segment_options("auto"), &no_progress()).unwrap();
    let movements = segmentation.action_movements();
    let names = common_actions(&[movements.clone(), movements].concat());
    let (first, second) = names.split_at(names.len() / 2);
    assert!(first.len() > 1 && first == second, "{names:?}");
    let count = segmentation.segments().unwrap().len();
    let (labels, actions) = (vec![String::new(); count], vec!["Q".to_owned(); count]);
    let file = clip.save_segments(&segmentation, labels, actions, "json", "limp.bvh".into(), None).unwrap();
    assert_eq!(String::from_utf8(file).unwrap().matches(r#""action": "Q""#).count(), count);
}

#[wasm_bindgen_test]
fn cut_writes_the_frames_of_the_range() {
    let clip = walk();
    let part = bvh::parse(&rewrite(clip.cut(10, 30).unwrap()), bvh::Options::default()).unwrap().clip;
    let original = bvh::parse(WALK, bvh::Options::default()).unwrap().clip;
    assert_eq!((part.frame_count(), part.row(0)), (20, original.row(10)));
    assert!(clip.cut(10, 10).is_err() && clip.cut(0, 246).is_err());
}
