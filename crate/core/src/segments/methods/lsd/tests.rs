//! Tests of the method on a generated character that waves and bows.

use nalgebra::Vector3;

use crate::bvh::{Axis, Channel, Clip, Joint, JointKind};
use crate::notice::Code;
use crate::segments::{Cancelled, Kind, Method, Params, SegmentError, Segmentation, Template, segment};
use crate::skeleton::{Overrides, Skeleton};

/// Name, index of the parent in this list, and offset in centimetres.
const BODY: [(&str, usize, [f64; 3]); 17] = [
    ("Hips", 0, [0.0, 95.0, 0.0]),
    ("Spine", 0, [0.0, 12.0, 0.0]),
    ("Spine1", 1, [0.0, 20.0, 0.0]),
    ("Neck", 2, [0.0, 22.0, 0.0]),
    ("Head", 3, [0.0, 10.0, 0.0]),
    ("LeftArm", 2, [18.0, 15.0, 0.0]),
    ("LeftForeArm", 5, [28.0, 0.0, 0.0]),
    ("LeftHand", 6, [26.0, 0.0, 0.0]),
    ("RightArm", 2, [-18.0, 15.0, 0.0]),
    ("RightForeArm", 8, [-28.0, 0.0, 0.0]),
    ("RightHand", 9, [-26.0, 0.0, 0.0]),
    ("LeftUpLeg", 0, [9.0, 0.0, 0.0]),
    ("LeftLeg", 11, [0.0, -45.0, 0.0]),
    ("LeftFoot", 12, [0.0, -43.0, 0.0]),
    ("RightUpLeg", 0, [-9.0, 0.0, 0.0]),
    ("RightLeg", 14, [0.0, -45.0, 0.0]),
    ("RightFoot", 15, [0.0, -43.0, 0.0]),
];

/// Returns a clip of the character without the joints whose names contain one of `missing`, with an
/// angle per joint and time.
fn character_clip(rate: f64, frames: usize, missing: &[&str], angle: impl Fn(&str, f64) -> f64) -> Clip {
    let is_present = |joint: &usize| !missing.iter().any(|part| BODY[*joint].0.contains(part));
    let present: Vec<usize> = (0..BODY.len()).filter(is_present).collect();
    let joint = |&index: &usize| {
        let (name, parent, offset) = BODY[index];
        let axis = if name.contains("Arm") { Axis::Z } else { Axis::X };
        Joint {
            name: name.into(),
            kind: if index == 0 { JointKind::Root } else { JointKind::Joint },
            parent: (index > 0).then(|| present.iter().position(|&k| k == parent).unwrap()),
            offset: Vector3::from(offset),
            channels: vec![Channel::Rotation(axis)],
        }
    };
    let values = (0..frames).flat_map(|frame| {
        let time = frame as f64 / rate;
        present.iter().map(|&joint| angle(BODY[joint].0, time)).collect::<Vec<_>>()
    });
    Clip::new(present.iter().map(joint).collect(), 1.0 / rate, values.collect())
}

/// Six seconds each of waving with both arms, bowing, and waving; angles in degrees.
fn wave_bow_wave(joint: &str, time: f64) -> f64 {
    let swing = (1.0 - (time * std::f64::consts::TAU / 1.5).cos()) / 2.0;
    match joint {
        "LeftArm" | "RightArm" if !(6.0..12.0).contains(&time) => {
            swing * if joint == "LeftArm" { 80.0 } else { -80.0 }
        }
        "Spine" if (6.0..12.0).contains(&time) => 70.0 * swing,
        _ => 0.0,
    }
}

fn cut(clip: &Clip, params: Params) -> Result<Segmentation, SegmentError> {
    let params = Params { method: Method::Lsd, ..params }.check().unwrap();
    segment(clip, &Skeleton::main(clip, &Overrides::default()), params, &mut |_| Ok(()))
}

/// Segments with default parameters and checks properties of every result.
fn segment_checked(clip: &Clip) -> Segmentation {
    let found = cut(clip, Params::default()).unwrap();
    let mut ends = found.segments.iter().map(|segment| segment.frames.end);
    let starts = found.segments.iter().map(|segment| segment.frames.start);
    assert!(starts.eq(std::iter::once(0).chain(ends.clone()).take(found.segments.len())));
    assert_eq!(ends.next_back(), Some(clip.frame_count()));
    assert!(found.segments.iter().all(|segment| !segment.frames.is_empty()));
    assert!(found.motifs.windows(2).all(|pair| pair[0].frames.end == pair[1].frames.start));
    assert!(found.motifs.iter().all(|motif| !motif.frames.is_empty() && motif.amplitude.is_finite()));
    assert_eq!(found.curve.frames.len(), found.curve.values.len());
    assert!(found.curve.values.iter().all(|value| value.is_finite()));
    assert!(found.curve.extrema.iter().all(|&index| index < found.curve.values.len()));
    found
}

/// True if there is a cut near both changes of action. The character is at rest when it changes, and
/// the curve turns at a nearby pose.
fn has_expected_cuts(found: &Segmentation, rate: f64) -> bool {
    let cuts: Vec<f64> = found.cuts().iter().map(|&cut| cut as f64 / rate).collect();
    [6.0, 12.0].iter().all(|&time: &f64| cuts.iter().any(|cut| (cut - time).abs() < 0.4))
}

#[test]
fn periodic_actions_are_separated_at_any_rate() {
    let mut expected: Option<Vec<f64>> = None;
    for rate in [24.0, 30.0, 60.0, 120.0, 250.0] {
        let found = segment_checked(&character_clip(rate, (18.0 * rate) as usize, &[], wave_bow_wave));
        assert!(found.cuts().len() == 2 && has_expected_cuts(&found, rate), "{rate} Hz: {:?}", found.cuts());
        let seconds: Vec<f64> = found.cuts().iter().map(|&cut| cut as f64 / rate).collect();
        let expected = expected.get_or_insert(seconds.clone());
        assert!(seconds.iter().zip(expected).all(|(a, b)| (a - *b).abs() < 0.05), "{rate} Hz: {seconds:?}");

        assert!(found.segments.iter().all(|segment| segment.kind == Kind::Periodic));
        let labels: Vec<&str> = found.segments.iter().map(|segment| &segment.label[..]).collect();
        assert_eq!(labels[0], labels[2]);
        assert_ne!(labels[0], labels[1]);
    }
}

#[test]
fn templates_can_be_chosen() {
    let clip = character_clip(30.0, 540, &[], wave_bow_wave);
    for template in [Template::TPose, Template::Frame(0), Template::Frame(539)] {
        for published in [false, true] {
            let found = cut(&clip, Params { template, published, ..Params::default() }).unwrap();
            assert!(has_expected_cuts(&found, 30.0), "{template:?} {:?}", found.cuts());
        }
    }
    let beyond = Params { template: Template::Frame(540), ..Params::default() };
    let error = cut(&clip, beyond).unwrap_err();
    assert_eq!(error, SegmentError::NoFrame { frame: 540, frames: 540 });
}

#[test]
fn clips_of_few_frames_are_one_action() {
    for frames in 1..=20 {
        let found = segment_checked(&character_clip(120.0, frames, &[], wave_bow_wave));
        assert_eq!((found.segments.len(), found.segments[0].kind), (1, Kind::Aperiodic));
    }
}

#[test]
fn standing_still_is_one_action() {
    let found = segment_checked(&character_clip(60.0, 600, &[], |_, _| 10.0));
    assert_eq!((found.segments.len(), found.motifs.len()), (1, 1));
}

#[test]
fn duplicate_frames_are_accepted() {
    let found = segment_checked(&character_clip(60.0, 1080, &[], |joint, time| {
        wave_bow_wave(joint, (time * 12.0).floor() / 12.0)
    }));
    assert_eq!(found.cuts().len(), 2);
}

#[test]
fn missing_limbs_have_a_notice() {
    for missing in [["Arm", "Hand"], ["Leg", "Foot"]] {
        let found = segment_checked(&character_clip(60.0, 1080, &missing, wave_bow_wave));
        assert!(found.notices.iter().any(|notice| notice.code == Code::MissingJoints), "{missing:?}");
    }
}

#[test]
fn can_be_cancelled() {
    let clip = character_clip(30.0, 540, &[], wave_bow_wave);
    let params = Params { method: Method::Lsd, ..Params::default() }.check().unwrap();
    let skeleton = Skeleton::main(&clip, &Overrides::default());
    let cancelled = segment(&clip, &skeleton, params, &mut |_| Err(Cancelled));
    assert_eq!(cancelled, Err(SegmentError::Cancelled));
    let mut last = 0.0;
    let mut is_ascending = true;
    let result = segment(&clip, &skeleton, params, &mut |fraction| {
        is_ascending &= (last..=1.0).contains(&fraction);
        last = fraction;
        Ok(())
    });
    assert!(result.is_ok() && is_ascending && last > 0.5);
}

#[test]
fn extreme_values_and_rates_have_a_result() {
    for size in [1e6, 1e300, f64::MAX] {
        let clip = character_clip(30.0, 90, &[], |_, time| size * time.fract());
        for frame_time in [1.0 / 30.0, 0.0, 1e-300, 1e9, f64::MAX] {
            let mut clip = clip.clone();
            clip.set_frame_time(frame_time);
            segment_checked(&clip);
        }
    }
}
