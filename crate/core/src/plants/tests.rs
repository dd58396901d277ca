//! Tests of detection on synthetic feet.

use nalgebra::Vector3;
use proptest::prelude::*;

use super::*;
use crate::bvh::Axis;
use crate::foot::{Part, Side};
use crate::intervals::intervals;
use crate::notice::Code;
use crate::skeleton::Up;

/// Duration of a gait cycle, in seconds, and the fraction of it in stance.
const CYCLE: f64 = 1.2;
const STANCE: f64 = 0.6;

/// Returns the position of a foot at a time of its cycle: stance, then a swing of 1.3 m. In metres,
/// Y up.
fn foot(time: f64) -> Vector3<f64> {
    let (cycles, phase) = ((time / CYCLE).floor(), (time / CYCLE).fract());
    let swing = ((phase - STANCE) / (1.0 - STANCE)).max(0.0);
    let eased = swing * swing * (3.0 - 2.0 * swing);
    Vector3::new(0.1, 0.15 * (std::f64::consts::PI * swing).sin().powi(2), 1.3 * (cycles + eased))
}

/// Methods that must label the walk exactly; the others are for comparison.
const EXACT_METHODS: [Method; 2] = [Method::Robust, Method::Paper];

/// A walk with legs of 0.8 m; the feet are half a cycle apart.
fn walk(frames: usize, rate: f64) -> Feet {
    let tracks = [0.0, CYCLE / 2.0].map(|ahead| {
        let at = |lift: Vector3<f64>| -> Vec<_> {
            (0..frames).map(|frame| foot(frame as f64 / rate + ahead) + lift).collect()
        };
        FootTracks {
            ankle: at(Vector3::new(0.0, 0.08, -0.13)),
            toe: at(Vector3::new(0.0, 0.02, 0.0)),
            tip: None,
        }
    });
    let hips = (0..frames).map(|frame| Vector3::new(0.0, 0.9, 1.08 * frame as f64 / rate)).collect();
    Feet { tracks, hips, up: Up::Y, leg: 0.8, metres_per_unit: 1.0, frame_time: 1.0 / rate }
}

/// Returns the feet with every position mapped by `change`.
fn map_positions(feet: &Feet, up: Up, scale: f64, change: impl Fn(Vector3<f64>) -> Vector3<f64>) -> Feet {
    let all = |track: &[Vector3<f64>]| track.iter().map(|position| change(*position)).collect();
    Feet {
        tracks: feet.tracks.clone().map(|foot| FootTracks {
            ankle: all(&foot.ankle),
            toe: all(&foot.toe),
            tip: None,
        }),
        hips: all(&feet.hips),
        up,
        leg: feet.leg * scale,
        metres_per_unit: feet.metres_per_unit / scale,
        frame_time: feet.frame_time,
    }
}

fn params(method: Method) -> ValidParams {
    Params { method, ..Params::default() }.check().unwrap()
}

fn planted(detection: &Detection) -> Vec<&[bool]> {
    detection.parts.iter().flat_map(|part| &part.feet).map(|foot| foot.planted.as_slice()).collect()
}

fn has(detection: &Detection, code: Code) -> bool {
    detection.notices.iter().any(|notice| notice.code == code)
}

#[test]
fn a_walk_is_labelled_exactly() {
    for rate in [24.0, 30.0, 60.0, 120.0, 250.0] {
        let feet = walk((8.0 * rate) as usize, rate);
        for method in EXACT_METHODS {
            let detection = detect(&feet, params(method));
            for (side, ahead) in [(0, 0.0), (1, CYCLE / 2.0)] {
                let labels = &detection.principal().feet[side].planted;
                let wrong = labels.iter().enumerate().filter(|(frame, planted)| {
                    let phase = ((*frame as f64 / rate + ahead) / CYCLE).fract();
                    // Within 0.1 s of an edge either label is accepted.
                    let near = [0.0, STANCE, 1.0].iter().any(|edge| (phase - edge).abs() * CYCLE < 0.1);
                    !near && **planted != (phase < STANCE)
                });
                assert_eq!(wrong.count(), 0, "{method} at {rate} Hz");
            }
        }
    }
}

#[test]
fn methods_label_their_parts() {
    // Mixtures need noise: without it, stance is a single point.
    let mut noisy = walk(300, 60.0);
    for (index, position) in noisy.tracks.iter_mut().flat_map(|foot| &mut foot.toe).enumerate() {
        *position += 0.002 * Vector3::new(index as f64, 2.1 * index as f64, 4.7 * index as f64).map(f64::sin);
    }
    for &method in Method::ALL {
        let detection = detect(&noisy, params(method));
        let parts: Vec<Part> = detection.parts.iter().map(|labels| labels.part).collect();
        assert_eq!(parts, method.parts(), "{method}");
        assert_eq!(detection.principal().evidence.is_some(), method.family() == Family::Spectral, "{method}");
        let planted = detection.principal().feet.iter().flat_map(|foot| &foot.planted);
        let fraction = planted.clone().filter(|planted| **planted).count() as f64 / planted.count() as f64;
        // The feet are in stance for 0.6 of the time.
        assert!((0.5..0.8).contains(&fraction), "{method}: {fraction}");
        assert_eq!(method.name().parse(), Ok(method));
    }
}

/// Standing samples are clustered along, but only the clip is labelled. Methods that do not use the
/// samples of the paper ignore the standing clip.
#[test]
fn standing_samples_are_clustered_along() {
    let feet = walk(300, 60.0);
    let standing = map_positions(&walk(120, 60.0), Up::Y, 1.0, |_| Vector3::new(0.1, 0.02, 0.0));
    for &method in Method::ALL {
        let detection = detect_with_standing(&feet, &standing, params(method));
        if method == Method::Robust || method.family() != Family::Spectral {
            assert_eq!(detection, detect(&feet, params(method)), "{method}");
            continue;
        }
        let evidence = detection.principal().evidence.as_ref().expect("a walk is clustered");
        assert_eq!(evidence.sorted_norms.len(), 2 * (300 + 120), "{method}");
        assert_eq!(evidence.values.len(), 2 * 300, "{method}");
        assert!(detection.principal().feet.iter().all(|foot| foot.planted.len() == 300), "{method}");
    }
}

#[test]
fn labels_follow_from_the_evidence() {
    let feet = walk(300, 60.0);
    for method in EXACT_METHODS {
        let detection = detect(&feet, params(method));
        for part in &detection.parts {
            let evidence = part.evidence.as_ref().expect("a walk is clustered");
            assert_eq!(evidence.values.len(), 600);
            assert!(evidence.sorted_norms.is_sorted());
            assert_eq!(evidence.sigma, evidence.sorted_norms[evidence.knee]);
            let r = detection.params.tolerance();
            let is_within = evidence.running_variance().map(|variance| variance <= r);
            assert_eq!(
                is_within.enumerate().filter(|(_, within)| *within).last(),
                Some((evidence.knee, true))
            );
        }
    }
}

#[test]
fn a_given_sigma_is_used() {
    let set = Params { method: Method::Paper, sigma: Some(0.17), ..Params::default() }.check().unwrap();
    let detection = detect(&walk(300, 60.0), set);
    assert_eq!(detection.principal().evidence.as_ref().map(|evidence| evidence.sigma), Some(0.17));
}

#[test]
fn heel_and_toe_lie_within_contact() {
    let detection = detect(&walk(300, 60.0), params(Method::Robust));
    let contact = detection.part(Part::Contact).unwrap();
    for part in [Part::Toe, Part::Heel] {
        for side in Side::BOTH {
            let inner = &detection.part(part).unwrap().foot(side).planted;
            assert!(inner.iter().zip(&contact.foot(side).planted).all(|(inner, outer)| !inner || *outer));
        }
    }
}

#[test]
fn standing_still_is_contact_throughout() {
    let sway = |position: Vector3<f64>| Vector3::new(0.1, 0.02 + position.y * 0.05, 0.003 * position.z.sin());
    let feet = map_positions(&walk(600, 60.0), Up::Y, 1.0, sway);
    let detection = detect(&feet, params(Method::Robust));
    assert!(has(&detection, Code::StandingStill));
    assert!(planted(&detection).concat().iter().all(|&planted| planted));
    assert!(detection.principal().evidence.is_none());
}

#[test]
fn an_added_first_pose_does_not_change_labels() {
    let clean = walk(400, 120.0);
    let mut with_pose = clean.clone();
    for track in with_pose.tracks.iter_mut().flat_map(|foot| [&mut foot.ankle, &mut foot.toe]) {
        track[0] += Vector3::new(5.0, -0.4, 3.0);
    }
    let detection = detect(&with_pose, params(Method::Robust));
    assert!(has(&detection, Code::Trimmed));
    let expected = detect(&clean, params(Method::Robust));
    for (found, expected) in planted(&detection).into_iter().zip(planted(&expected)) {
        let wrong = found.iter().zip(expected).filter(|(found, expected)| found != expected).count();
        assert!(wrong <= 3, "{wrong}");
    }
}

#[test]
fn jumps_have_one_notice() {
    let jump = |frames: &[usize]| {
        let mut feet = walk(400, 120.0);
        for track in feet.tracks.iter_mut().flat_map(|foot| [&mut foot.ankle, &mut foot.toe]) {
            for (frame, position) in track.iter_mut().enumerate() {
                position.x += 3.0 * frames.iter().filter(|&&jump| frame >= jump).count() as f64;
            }
        }
        let notices = detect(&feet, params(Method::Robust)).notices;
        notices.into_iter().filter(|notice| notice.code == Code::Teleport).map(|notice| notice.text)
    };
    let one: Vec<String> = jump(&[200]).collect();
    assert_eq!(one, ["Both feet jump at frame 200; the motion is split there."]);
    let several: Vec<String> = jump(&[100, 200, 201, 300]).collect();
    assert_eq!(several.len(), 1);
    assert!(
        several[0].starts_with("Both feet jump at 4 frames, the first of which is 100;"),
        "{}",
        several[0]
    );
}

#[test]
fn short_clips_are_contact_with_a_notice() {
    for frames in 1..10 {
        let detection = detect(&walk(frames, 30.0), params(Method::Robust));
        assert!(has(&detection, Code::ShortClip));
        assert_eq!(planted(&detection)[0], vec![true; frames]);
    }
}

#[test]
fn an_implausible_rate_has_a_notice() {
    let slow = Feet { frame_time: 1.0, ..walk(400, 120.0) };
    let fast = Feet { frame_time: 1e-3, ..walk(400, 60.0) };
    for feet in [slow, fast] {
        assert!(has(&detect(&feet, params(Method::Robust)), Code::ImplausibleRate));
    }
    assert!(!has(&detect(&walk(400, 120.0), params(Method::Robust)), Code::ImplausibleRate));
}

#[test]
fn ground_height_is_the_height_of_planted_feet() {
    let ground = detect(&walk(400, 60.0), params(Method::Robust)).ground_height;
    assert!((ground - 0.02).abs() < 0.005, "{ground}");
}

#[test]
fn labels_are_invariant_to_units_and_axes() {
    let feet = walk(300, 60.0);
    let turned =
        map_positions(&feet, Up { axis: Axis::Z, negative: false }, 1.0, |p| Vector3::new(p.x, -p.z, p.y));
    for &method in Method::ALL {
        let expected = detect(&feet, params(method));
        for scale in [0.01, 2.54, 100.0] {
            let scaled = map_positions(&feet, Up::Y, scale, |position| position * scale);
            assert_eq!(planted(&detect(&scaled, params(method))), planted(&expected), "{method} × {scale}");
        }
        assert_eq!(planted(&detect(&turned, params(method))), planted(&expected), "{method}, Z up");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// Random feet: no panic, finite numbers, a label for every frame.
    #[test]
    fn random_feet_never_panic(
        positions in prop::collection::vec(prop::array::uniform3(prop_oneof![Just(0.0), -2.0..2.0_f64]), 1..60),
        repeats in 1_usize..4,
        rate in 10.0..300.0_f64,
        window in 0_usize..5,
        tolerance in 1e-6..1.0_f64,
    ) {
        let track: Vec<Vector3<f64>> =
            positions.iter().flat_map(|position| vec![Vector3::from(*position); repeats]).collect();
        let other = track.iter().rev().copied().collect::<Vec<_>>();
        let foot = |ankle: &Vec<_>, toe: &Vec<_>| FootTracks { ankle: ankle.clone(), toe: toe.clone(), tip: None };
        let feet = Feet {
            tracks: [foot(&track, &other), foot(&other, &track)],
            hips: track.clone(),
            up: Up::Y,
            leg: 0.8,
            metres_per_unit: 1.0,
            frame_time: 1.0 / rate,
        };
        for &method in Method::ALL {
            let params = Params { method, window, tolerance, ..Params::default() }.check().unwrap();
            let detection = detect(&feet, params);
            prop_assert!(detection.ground_height.is_finite());
            for foot in detection.parts.iter().flat_map(|part| &part.feet) {
                prop_assert_eq!(foot.planted.len(), track.len());
                prop_assert!(foot.confidence.iter().all(|p| (0.5..=1.0).contains(p)), "{:?}", foot.confidence);
                prop_assert!(foot.height.iter().chain(&foot.speed).all(|value| value.is_finite()));
            }
            let _ = intervals(&detection.principal().feet[0].planted);
        }
    }
}

/// The samples of each foot are equal, and degrees differ by rounding only.
#[test]
fn motionless_feet_never_panic() {
    for frames in 1..12 {
        let at_height = |height: f64| vec![Vector3::new(0.0, height, 0.0); frames];
        let foot = |height| FootTracks { ankle: at_height(height + 0.1), toe: at_height(height), tip: None };
        for (step, method) in (0..50).flat_map(|step| Method::ALL.iter().map(move |&method| (step, method))) {
            let tracks = [foot(0.1), foot(0.1 + 0.0137 * f64::from(step))];
            let feet = Feet { tracks, hips: at_height(0.9), ..walk(1, 60.0) };
            let detection = detect(&feet, params(method));
            assert!(planted(&detection).iter().all(|foot| foot.len() == frames));
        }
    }
}

#[test]
fn a_detector_labels_like_detect() {
    // Long enough for the approximation by cells.
    let feet = walk(4500, 120.0);
    let mut detector = Detector::new(feet.clone());
    let default = Params::default();
    let changes = [
        default,
        Params { tolerance: 0.002, ..default },
        Params { window: 3, ..default },
        Params { method: Method::Paper, window: 3, ..default },
        Params { tolerance: 0.0005, window: 3, ..default },
        Params { sigma: Some(0.2), window: 3, ..default },
        Params { exact: true, ..default },
        Params { tolerance: 0.002, ..default },
        Params { window: 16, ..default },
        Params { window: 16, tolerance: 0.01, ..default },
        default,
    ];
    for params in changes.map(|params| params.check().unwrap()) {
        let found = detect(&feet, params);
        assert_eq!(detector.detect(params), found, "{params:?}");
    }
}
