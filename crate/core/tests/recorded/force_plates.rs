//! Accuracy of detection against contact measured by force plates.

use std::fs;
use std::path::Path;

use nalgebra::Vector3;
use plantigrade::foot::{Part, Side};
use plantigrade::plants::{self, Feet, Method, Params};
use plantigrade::score::{self, Tally, Truth};
use plantigrade::skeleton::{Overrides, Skeleton};

use crate::support;

const FUZZY: [f64; 4] = [0.0, 0.1, 0.2, 0.3];

/// Returns the measured contact of one foot, with frames near unknown ones masked.
fn truth(path: &Path, side: Side, frame_time: f64) -> Truth {
    let text = fs::read_to_string(path.with_extension("json")).expect("measured contact");
    let json: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    let labels = json[side.name()].as_array().expect("labels").iter();
    let truth: Truth = labels
        .map(|label| match label.as_i64() {
            Some(-1) => None,
            label => Some(label == Some(1)),
        })
        .collect();
    score::mask_near_unknown(&truth, frame_time)
}

/// Returns the accuracy at each fuzzy period in percent, of all trials and of the worst trial. The feet are
/// changed before detection.
fn accuracy_with(corpus: &Path, method: Method, part: Part, change: fn(&mut Feet)) -> ([f64; 4], [f64; 4]) {
    let mut pooled = [Tally::default(); 4];
    let mut worst = [100.0_f64; 4];
    for path in support::bvh_files(&corpus.join("contact")) {
        let clip = support::read(&path).clip;
        let mut feet = Feet::new(&clip, &Skeleton::main(&clip, &Overrides::default())).expect("feet");
        change(&mut feet);
        let detection =
            plants::detect(&feet, Params { method, ..Params::default() }.check().expect("defaults"));
        let labels = detection.part(part).expect("labels of the part");
        for (index, fuzzy) in FUZZY.into_iter().enumerate() {
            let mut trial = Tally::default();
            for side in Side::BOTH {
                let truth = truth(&path, side, clip.frame_time());
                trial += score::lenient(&labels.foot(side).planted, &truth, clip.frame_time(), fuzzy);
            }
            println!("{} p = {fuzzy}: {:.1}", path.display(), 100.0 * trial.accuracy());
            pooled[index] += trial;
            worst[index] = worst[index].min(100.0 * trial.accuracy());
        }
    }
    assert_eq!(pooled[0].total, 8271, "number of known labels");
    let pooled = pooled.map(|tally| 100.0 * tally.accuracy());
    println!("{method} {}: {pooled:.2?}, worst {worst:.2?}", part.name());
    (pooled, worst)
}

/// Returns the accuracy of the unchanged trials.
fn accuracy(corpus: &Path, method: Method, part: Part) -> ([f64; 4], [f64; 4]) {
    accuracy_with(corpus, method, part, |_| {})
}

/// Moves all joints backward by a belt, so that the hips are where they were at the start in the end.
fn put_on_belt(feet: &mut Feet) {
    let count = feet.frame_count() - 1;
    let mut travel = feet.hips[count] - feet.hips[0];
    travel -= feet.up.vector() * feet.up.height(&travel);
    shift(feet, |frame| travel * (frame as f64 / count as f64));
}

/// Removes the motion of the root.
fn fix_hips(feet: &mut Feet) {
    let hips = feet.hips.clone();
    shift(feet, |frame| hips[frame] - hips[0]);
}

/// Subtracts a displacement from all tracks, by frame.
fn shift(feet: &mut Feet, displacement: impl Fn(usize) -> Vector3<f64>) {
    let parts = feet.tracks.iter_mut().flat_map(|foot| {
        [Some(&mut foot.ankle), Some(&mut foot.toe), foot.tip.as_mut()].into_iter().flatten()
    });
    for track in parts.chain([&mut feet.hips]) {
        for (frame, position) in track.iter_mut().enumerate() {
            *position -= displacement(frame);
        }
    }
}

pub fn robust_contact_agrees_with_force_plates_on_a_belt(corpus: &Path) {
    let (pooled, worst) = accuracy_with(corpus, Method::Robust, Part::Contact, put_on_belt);
    assert!(pooled[0] >= 98.8 && pooled[1] >= 99.9, "{pooled:?}");
    assert!(worst[2] >= 99.5, "{worst:?}");
}

pub fn robust_contact_agrees_with_force_plates_without_root_motion(corpus: &Path) {
    let (pooled, worst) = accuracy_with(corpus, Method::Robust, Part::Contact, fix_hips);
    assert!(pooled[0] >= 97.0 && pooled[2] >= 99.0, "{pooled:?}");
    // In flight, it is unknown what the hips did.
    assert!(worst[2] >= 85.0, "{worst:?}");
}

pub fn robust_contact_agrees_with_force_plates(corpus: &Path) {
    let (pooled, worst) = accuracy(corpus, Method::Robust, Part::Contact);
    assert!(pooled[0] >= 98.8 && pooled[1] >= 99.9 && pooled[3] >= 99.9, "{pooled:?}");
    assert!(worst[3] >= 99.5, "{worst:?}");
}

pub fn paper_method_has_its_reported_accuracy(corpus: &Path) {
    let (pooled, _) = accuracy(corpus, Method::Paper, Part::Toe);
    for (actual, expected) in pooled.into_iter().zip([77.6, 80.8, 81.9, 82.0]) {
        assert!((actual - expected).abs() <= 0.3, "{pooled:?}");
    }
}

pub fn robust_toe_plants_agree_with_contact(corpus: &Path) {
    let (pooled, _) = accuracy(corpus, Method::Robust, Part::Toe);
    assert!(pooled[0] >= 95.0 && pooled[3] >= 99.5, "{pooled:?}");
}
