//! Accuracy of detection on the samples, against their generated truth.

#[path = "support/files.rs"]
mod support;

use std::fs;
use std::path::{Path, PathBuf};

use plantigrade::bvh::{Clip, Joint, JointKind};
use plantigrade::foot::{Part, Side};
use plantigrade::formats::PlantsDocument;
use plantigrade::plants::{self, Feet, Method, Params};
use plantigrade::score::{self, Tally, Truth};
use plantigrade::skeleton::{Overrides, Skeleton};

const FUZZY: f64 = 0.3;

fn samples() -> Vec<PathBuf> {
    let files = support::bvh_files(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../samples"));
    assert_eq!(files.len(), 13);
    files
}

/// Returns the accuracy in percent, of all samples and of the worst sample.
fn accuracy(method: Method, part: Part) -> (f64, f64) {
    let mut pooled = Tally::default();
    let mut lowest = 100.0_f64;
    for path in samples() {
        let clip = support::read(&path).clip;
        let text = fs::read_to_string(path.with_extension("json")).expect("truth");
        let document: PlantsDocument = serde_json::from_str(&text).expect("a plants document");
        let feet = Feet::new(&clip, &Skeleton::main(&clip, &Overrides::default())).expect("feet");
        let params = Params { method, ..Params::default() }.check().expect("defaults");
        let detection = plants::detect(&feet, params);
        let mut sample = Tally::default();
        for side in Side::BOTH {
            let truth: Truth = document.labels(side, part).expect("truth").into_iter().map(Some).collect();
            let labels = &detection.part(part).expect("labels").foot(side).planted;
            sample += score::lenient(labels, &truth, clip.frame_time(), FUZZY);
        }
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        println!("{method} {} {name}: {:.2} %", part.name(), 100.0 * sample.accuracy());
        pooled += sample;
        lowest = lowest.min(100.0 * sample.accuracy());
    }
    let pooled = 100.0 * pooled.accuracy();
    println!("{method} {} pooled: {pooled:.2} %, lowest {lowest:.2} %", part.name());
    (pooled, lowest)
}

#[test]
fn robust_contact_and_toe_plants_agree_with_truth() {
    for part in [Part::Contact, Part::Toe] {
        let (pooled, lowest) = accuracy(Method::Robust, part);
        assert!(pooled >= 99.5 && lowest >= 98.0, "{}: {pooled}, {lowest}", part.name());
    }
}

#[test]
fn paper_toe_plants_agree_with_truth() {
    let (pooled, lowest) = accuracy(Method::Paper, Part::Toe);
    assert!(pooled >= 99.5 && lowest >= 98.5, "{pooled}, {lowest}");
}

#[test]
fn foot_flat_and_heel_off_agree_with_truth() {
    let mut errors: [Vec<f64>; 2] = Default::default();
    for path in samples() {
        let clip = support::read(&path).clip;
        // Slower clips have no exact truth.
        if clip.rate() < 59.0 {
            continue;
        }
        let text = fs::read_to_string(path.with_extension("json")).expect("truth");
        let truth: PlantsDocument = serde_json::from_str(&text).expect("a plants document");
        let feet = Feet::new(&clip, &Skeleton::main(&clip, &Overrides::default())).expect("feet");
        let detection = plants::detect(&feet, Params::default().check().expect("defaults"));
        for side in Side::BOTH {
            let [heel, toe] =
                [Part::Heel, Part::Toe].map(|part| truth.labels(side, part).expect("truth of the part"));
            let of_part = |part| detection.part(part).expect("labels").foot(side);
            // The true toe lands while the heel is down, and the true heel lifts while the toe is down.
            for frame in 1..heel.len() {
                let time = (frame as f64 - 0.5) * clip.frame_time();
                let (events, edges) = if heel[frame - 1] && heel[frame] && !toe[frame - 1] && toe[frame] {
                    (&mut errors[0], &of_part(Part::Toe).edges)
                } else if toe[frame - 1] && toe[frame] && heel[frame - 1] && !heel[frame] {
                    (&mut errors[1], &of_part(Part::Heel).edges)
                } else {
                    continue;
                };
                let nearest = edges.iter().map(|edge| (edge.time - time).abs()).fold(0.15, f64::min);
                events.push(nearest);
            }
        }
    }
    for mut errors in errors {
        errors.sort_by(f64::total_cmp);
        assert!(errors.len() >= 8 && errors[errors.len() / 2] < 0.012, "{errors:?}");
    }
}

#[test]
fn legs_are_identified_by_shape_without_names() {
    for path in samples() {
        let clip = support::read(&path).clip;
        let named = Skeleton::main(&clip, &Overrides::default());
        let joints = clip.joints().iter().enumerate().map(|(index, joint)| Joint {
            name: if joint.kind == JointKind::EndSite { joint.name.clone() } else { format!("q{index}") },
            ..joint.clone()
        });
        let unnamed = Clip::new(joints.collect(), clip.frame_time(), clip.values().to_vec());
        let by_shape = Skeleton::main(&unnamed, &Overrides::default());
        for side in Side::BOTH {
            let name = path.display();
            assert_eq!(by_shape.heel(side), named.heel(side), "{name}: {} ankle", side.name());
            assert_eq!(by_shape.toe(side), named.toe(side), "{name}: {} toe", side.name());
        }
        assert_eq!(by_shape.up, named.up);
    }
}
