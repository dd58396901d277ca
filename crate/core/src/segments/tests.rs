//! Tests that apply to every method.

use nalgebra::Vector3;
use proptest::prelude::*;

use super::*;
use crate::bvh::{Axis, Channel, Clip, Joint, JointKind};
use crate::notice::Code;
use crate::skeleton::{Overrides, Skeleton};

/// A spine, a head, arms and legs; each joint rotates about one axis.
const BODY: [(&str, usize, [f64; 3]); 13] = [
    ("Hips", 0, [0.0, 95.0, 0.0]),
    ("Spine", 0, [0.0, 12.0, 0.0]),
    ("Chest", 1, [0.0, 20.0, 0.0]),
    ("Neck", 2, [0.0, 22.0, 0.0]),
    ("Head", 3, [0.0, 10.0, 0.0]),
    ("LeftArm", 2, [18.0, 15.0, 0.0]),
    ("LeftForeArm", 5, [28.0, 0.0, 0.0]),
    ("LeftUpLeg", 0, [9.0, 0.0, 0.0]),
    ("LeftLeg", 7, [0.0, -45.0, 0.0]),
    ("LeftFoot", 8, [0.0, -43.0, 0.0]),
    ("RightUpLeg", 0, [-9.0, 0.0, 0.0]),
    ("RightLeg", 10, [0.0, -45.0, 0.0]),
    ("RightFoot", 11, [0.0, -43.0, 0.0]),
];

/// The first `joints` of the body, with each joint's angle in degrees per frame.
fn clip(joints: usize, frames: usize, rate: f64, angle: impl Fn(usize, usize) -> f64) -> Clip {
    let joint = |(index, &(name, parent, offset)): (usize, &(&str, usize, [f64; 3]))| Joint {
        name: name.into(),
        kind: if index == 0 { JointKind::Root } else { JointKind::Joint },
        parent: (index > 0).then_some(parent),
        offset: Vector3::from(offset),
        channels: vec![Channel::Rotation(Axis::X)],
    };
    let values = (0..frames).flat_map(|frame| (0..joints).map(move |joint| (joint, frame)));
    let values = values.map(|(joint, frame)| angle(joint, frame)).collect();
    Clip::new(BODY[..joints].iter().enumerate().map(joint).collect(), 1.0 / rate, values)
}

/// Nodding until `cut`, then waving, for 16 s in all.
fn nod_then_wave(rate: f64, cut: f64) -> Clip {
    clip(BODY.len(), (16.0 * rate) as usize, rate, |joint, frame| {
        let time = frame as f64 / rate;
        let swing = 50.0 * (std::f64::consts::TAU * time / 1.3).sin();
        let sway = 8.0 * (time * 2.0 + joint as f64).sin();
        sway + match BODY[joint].0 {
            "Neck" | "Chest" if time < cut => swing,
            "LeftArm" | "LeftForeArm" if time >= cut => swing - 60.0,
            _ => 0.0,
        }
    })
}

fn cut(clip: &Clip, params: Params) -> Result<Segmentation, SegmentError> {
    segment(clip, &Skeleton::main(clip, &Overrides::default()), params.check().unwrap(), &mut |_| Ok(()))
}

fn all_params() -> impl Iterator<Item = Params> {
    Method::ALL
        .iter()
        .flat_map(|&method| [false, true].map(|published| Params { method, published, ..Params::default() }))
}

/// Checks properties of every result.
fn check(found: &Segmentation, frames: usize) {
    let ends: Vec<usize> = found.segments.iter().map(|segment| segment.frames.end).collect();
    let starts: Vec<usize> = found.segments.iter().map(|segment| segment.frames.start).collect();
    assert_eq!(starts[0], 0);
    assert_eq!(starts[1..], ends[..ends.len() - 1]);
    assert_eq!(ends.last(), Some(&frames));
    assert!(found.segments.iter().all(|segment| !segment.frames.is_empty()), "{:?}", found.segments);
    let Curve { frames: positions, values, threshold, extrema, .. } = &found.curve;
    assert_eq!(positions.len(), values.len());
    assert!(threshold.is_empty() || threshold.len() == values.len());
    assert!([positions, values, threshold].into_iter().flatten().all(|value| value.is_finite()));
    assert!(extrema.iter().all(|&index| index < values.len()));
}

#[test]
fn every_method_detects_a_change_of_action() {
    let clip = nod_then_wave(60.0, 8.0);
    for &method in Method::ALL {
        let found = cut(&clip, Params { method, ..Params::default() }).unwrap();
        check(&found, clip.frame_count());
        let cuts = found.cuts();
        assert!(cuts.iter().any(|cut| cut.abs_diff(480) < 60), "{method}: {cuts:?}");
    }
}

#[test]
fn cuts_are_invariant_to_the_frame_rate() {
    for &method in Method::ALL {
        let seconds = |rate: f64| {
            let clip = nod_then_wave(rate, 8.0);
            let cuts = cut(&clip, Params { method, ..Params::default() }).unwrap().cuts();
            cuts.iter().map(|&cut| cut as f64 / rate).collect::<Vec<_>>()
        };
        let at_120 = seconds(120.0);
        for rate in [24.0, 30.0, 60.0] {
            let other = seconds(rate);
            assert_eq!(at_120.len(), other.len(), "{method} at {rate}: {at_120:?} {other:?}");
            for (a, b) in at_120.iter().zip(&other) {
                assert!((a - b).abs() <= 0.2, "{method} at {rate}: {at_120:?} {other:?}");
            }
        }
    }
}

#[test]
fn short_clips_are_one_segment() {
    for params in all_params() {
        for frames in 1..=20 {
            let clip = clip(BODY.len(), frames, 30.0, |joint, frame| (joint * frame) as f64);
            let found = cut(&clip, params).unwrap();
            check(&found, frames);
            assert_eq!(found.segments.len(), 1, "{params:?}, {frames} frames");
        }
    }
}

#[test]
fn motionless_clips_are_not_cut() {
    for params in all_params() {
        let clip = clip(BODY.len(), 600, 60.0, |joint, _| joint as f64);
        let found = cut(&clip, params).unwrap();
        check(&found, 600);
        assert!(found.cuts().is_empty(), "{params:?}: {:?}", found.cuts());
    }
}

#[test]
fn an_added_first_pose_is_left_out() {
    let with = clip(BODY.len(), 600, 60.0, |joint, frame| {
        if frame == 0 { 0.0 } else { 40.0 + (frame as f64 / 20.0 + joint as f64).sin() }
    });
    let found = cut(&with, Params::default()).unwrap();
    assert!(found.notices.iter().any(|notice| notice.code == Code::Trimmed));
    assert_eq!(found.curve.frames[0], 1.0);
    assert_eq!(found.segments[0].frames.start, 0);
}

#[test]
fn missing_joints_have_a_notice() {
    let clip = clip(10, 300, 60.0, |joint, frame| (frame as f64 / 9.0 + joint as f64).sin() * 30.0);
    for params in all_params() {
        let found = cut(&clip, params).unwrap();
        check(&found, 300);
        let notice = found.notices.iter().find(|notice| notice.code == Code::MissingJoints);
        assert!(notice.is_some_and(|notice| notice.text.contains("right_thigh")), "{params:?}");
    }
}

#[test]
fn too_few_joints_are_an_error() {
    let clip = clip(3, 300, 60.0, |_, frame| frame as f64);
    for params in all_params() {
        let error = cut(&clip, params).unwrap_err();
        assert!(matches!(error, SegmentError::TooFewJoints { .. }), "{params:?}");
        assert!(error.to_string().contains("left_arm"), "{error}");
    }
}

#[test]
fn no_motion_is_an_error() {
    let clip = clip(BODY.len(), 0, 60.0, |_, _| 0.0);
    assert_eq!(cut(&clip, Params::default()), Err(SegmentError::NoMotion));
}

#[test]
fn every_method_can_be_cancelled() {
    let clip = nod_then_wave(60.0, 8.0);
    let skeleton = Skeleton::main(&clip, &Overrides::default());
    for &method in Method::ALL {
        let params = Params { method, ..Params::default() }.check().unwrap();
        let found = segment(&clip, &skeleton, params, &mut |_| Err(Cancelled));
        assert_eq!(found, Err(SegmentError::Cancelled), "{method}");
    }
}

#[test]
fn progress_is_ascending_between_0_and_1() {
    let clip = nod_then_wave(60.0, 8.0);
    let skeleton = Skeleton::main(&clip, &Overrides::default());
    for &method in Method::ALL {
        let mut fractions = Vec::new();
        let params = Params { method, ..Params::default() }.check().unwrap();
        segment(&clip, &skeleton, params, &mut |fraction| {
            fractions.push(fraction);
            Ok(())
        })
        .unwrap();
        assert!(fractions.iter().all(|fraction| (0.0..=1.0).contains(fraction)), "{method}");
        assert!(fractions.is_sorted(), "{method}");
    }
}

#[test]
fn violated_rules_are_stated() {
    let error = Params { dims: Some(0), ..Params::default() }.check().unwrap_err();
    assert_eq!(error.to_string(), "d must be from 1 to 56, not 0");
    assert!("best".parse::<Method>().is_err());
    for &method in Method::ALL {
        assert_eq!(method.name().parse(), Ok(method));
    }
}

/// Walking in place, bowing and walking again, 6 s each.
fn walk_bow_walk(rate: f64) -> Clip {
    clip(BODY.len(), (18.0 * rate) as usize, rate, |joint, frame| {
        let time = frame as f64 / rate;
        let swing = |amplitude: f64, period: f64| amplitude * (std::f64::consts::TAU * time / period).sin();
        let is_bowing = (6.0..12.0).contains(&time);
        match (BODY[joint].0, is_bowing) {
            ("LeftUpLeg", false) => swing(35.0, 1.2),
            ("RightUpLeg", false) => swing(-35.0, 1.2),
            ("LeftLeg" | "RightLeg", false) => 20.0 + swing(20.0, 1.2),
            ("Spine", true) => 30.0 + swing(30.0, 0.8),
            _ => 0.0,
        }
    })
}

fn actions_of(segmentation: &Segmentation) -> Vec<&str> {
    segmentation.segments.iter().map(|segment| segment.action.as_str()).collect()
}

#[test]
fn recurring_actions_have_one_name_and_a_period() {
    for method in [Method::Auto, Method::Lsd] {
        let found = cut(&walk_bow_walk(60.0), Params { method, ..Params::default() }).unwrap();
        assert_eq!(actions_of(&found), ["A", "B", "A"], "{method}");
        assert!(found.actions.iter().map(|action| action.name.as_str()).eq(["A", "B"]));
        for (segment, period) in found.segments.iter().zip([1.2, 0.8, 1.2]) {
            let cycles = segment.cycles.unwrap();
            assert!((cycles.period_s - period).abs() < 0.03, "{method}: {cycles:?}");
            assert!((cycles.count - 6.0 / period).abs() < 0.8, "{method}: {cycles:?}");
        }
    }
}

#[test]
fn actions_are_invariant_to_rate_unit_place_heading_and_up_axis() {
    let reference = cut(&walk_bow_walk(120.0), Params::default()).unwrap();
    for rate in [24.0, 25.0, 30.0, 60.0, 100.0] {
        let found = cut(&walk_bow_walk(rate), Params::default()).unwrap();
        assert_eq!(actions_of(&found), actions_of(&reference), "{rate} Hz");
        for (a, b) in found.segments.iter().zip(&reference.segments) {
            let [a, b] = [a, b].map(|segment| segment.cycles.unwrap());
            assert!((a.period_s - b.period_s).abs() < 0.02, "{rate} Hz: {a:?} {b:?}");
        }
        let names = common_names(&[&reference.actions, &found.actions]);
        assert_eq!(names, [["A", "B"], ["A", "B"]], "{rate} Hz");
    }
    let moved = placed(&walk_bow_walk(60.0), 0.01, |offset| offset, [3.0, -2.0, 40.0], 130.0, Axis::Y);
    let z_up = |offset: Vector3<f64>| Vector3::new(offset.x, -offset.z, offset.y);
    let rotated = placed(&walk_bow_walk(60.0), 2.54, z_up, [0.0, 0.0, 0.0], -75.0, Axis::Z);
    for clip in [moved, rotated] {
        let found = cut(&clip, Params::default()).unwrap();
        assert_eq!(found.cuts(), cut(&walk_bow_walk(60.0), Params::default()).unwrap().cuts());
        assert_eq!(common_names(&[&reference.actions, &found.actions]), [["A", "B"], ["A", "B"]]);
    }
}

/// Returns the clip in another unit and other axes, at a place and with a heading in degrees.
fn placed(
    clip: &Clip,
    unit: f64,
    axes: impl Fn(Vector3<f64>) -> Vector3<f64>,
    place: [f64; 3],
    heading: f64,
    up: Axis,
) -> Clip {
    let mut joints = clip.joints().to_vec();
    for joint in &mut joints {
        joint.offset = axes(joint.offset) * unit;
    }
    joints[0].channels = [Axis::X, Axis::Y, Axis::Z].map(Channel::Position).into();
    joints[0].channels.extend([Channel::Rotation(up), Channel::Rotation(Axis::X)]);
    let root = [axes(Vector3::new(0.0, 95.0, 0.0)) * unit + Vector3::from(place), Vector3::zeros()];
    let values = (0..clip.frame_count()).flat_map(|frame| {
        let first = [root[0].x, root[0].y, root[0].z, heading];
        first.into_iter().chain(clip.row(frame).iter().copied())
    });
    Clip::new(joints, clip.frame_time(), values.collect())
}

#[test]
fn actions_are_the_same_backwards() {
    let clip = walk_bow_walk(60.0);
    let backwards = (0..clip.frame_count()).rev().flat_map(|frame| clip.row(frame)).copied().collect();
    let backwards = Clip::new(clip.joints().to_vec(), clip.frame_time(), backwards);
    let found = [&clip, &backwards].map(|clip| cut(clip, Params::default()).unwrap());
    assert_eq!(actions_of(&found[0]), actions_of(&found[1]));
}

#[test]
fn common_names_are_in_order_of_the_clips() {
    let walk = cut(&walk_bow_walk(60.0), Params::default()).unwrap().actions;
    let bow = [walk[1].clone()];
    assert_eq!(common_names(&[&bow, &walk, &[]]), [vec!["A"], vec!["B", "A"], vec![]]);
    assert_eq!(common_names(&[]), Vec::<Vec<String>>::new());
}

#[test]
fn actions_are_read_as_they_were_written() {
    let mut actions = cut(&walk_bow_walk(60.0), Params::default()).unwrap().actions;
    let mut values = Vec::new();
    actions.iter().for_each(|action| action.write(&mut values));
    actions.iter_mut().for_each(|action| action.name.clear());
    assert_eq!(ActionMovements::read(&values), actions);
    // Damaged values are no reason to fail.
    for length in [0, 1, 2, 80, values.len() - 1] {
        assert!(ActionMovements::read(&values[..length]).len() <= actions.len());
    }
}

#[test]
fn actions_are_unknown_without_both_sides() {
    let clip = clip(10, 300, 60.0, |joint, frame| (frame as f64 / 9.0 + joint as f64).sin() * 30.0);
    let found = cut(&clip, Params::default()).unwrap();
    assert!(found.actions.is_empty() && actions_of(&found).iter().all(|action| action.is_empty()));
    assert!(found.notices.iter().any(|notice| notice.text.starts_with("The actions are unknown")));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    #[test]
    fn random_motion_has_a_result(
        seed in 0.0..9.0_f64,
        frames in 1_usize..400,
        rate in 10.0..250.0_f64,
        size in prop_oneof![Just(0.0), 0.0..400.0_f64],
    ) {
        let clip = clip(BODY.len(), frames, rate, |joint, frame| {
            size * (seed * frame as f64 / rate + joint as f64).sin().powi(3)
        });
        for params in all_params() {
            check(&cut(&clip, params).unwrap(), frames);
        }
    }
}
