//! The catalogue: frames, rates, names, labels, and the files in `samples/`.

use std::collections::BTreeSet;
use std::ops::Range;
use std::path::Path;

use plantigrade::foot::{Part, Side};
use plantigrade::intervals::intervals;
use plantigrade_synth::{ClipSpec, clip_files, full_set, gallery_index, generate, hard_cases, samples};

/// Frames and frame rates of the thirteen samples, in catalogue order.
const FRAMES_AND_RATES: [(usize, usize); 13] = [
    (500, 30),
    (245, 120),
    (370, 120),
    (791, 24),
    (361, 24),
    (1000, 120),
    (300, 60),
    (316, 30),
    (298, 24),
    (744, 24),
    (336, 24),
    (462, 24),
    (171, 30),
];

/// Feet that are never planted.
const NEVER_PLANTED: [&str; 4] =
    ["one-foot-in-air right", "one-foot-dragged right", "afloat left", "afloat right"];

/// Returns the full set and the hard cases.
fn all(noise_level: f64) -> Vec<ClipSpec> {
    [full_set(noise_level), hard_cases(noise_level)].concat()
}

#[test]
fn samples_have_the_frames_and_rates_of_the_paper() {
    let specs = samples(1.0);
    assert_eq!(specs.len(), FRAMES_AND_RATES.len());
    for (spec, (frames, rate)) in specs.iter().zip(FRAMES_AND_RATES) {
        assert_eq!((spec.frames, spec.rate), (frames, rate), "{}", spec.name);
    }
}

#[test]
fn clips_have_the_frames_and_rate_of_their_specification() {
    for spec in all(1.0) {
        let generated = generate(&spec, 0);
        assert_eq!(generated.clip.frame_count(), spec.frames, "{}", spec.name);
        assert!((generated.clip.rate() - spec.rate as f64).abs() < 1e-3, "{}", spec.name);
        assert_eq!(generated.truth.header.frames, spec.frames, "{}", spec.name);
        assert_eq!(generated.truth.header.rate, generated.clip.rate(), "{}", spec.name);
    }
}

#[test]
fn full_set_has_the_size_of_the_papers_set() {
    let specs = full_set(1.0);
    assert_eq!(specs.len(), 35);
    assert_eq!(specs.iter().map(|spec| spec.frames).sum::<usize>(), 16_613);
    let performers: BTreeSet<_> = specs.iter().map(|spec| spec.character.name).collect();
    assert_eq!(performers.len(), 8);
    let rates: BTreeSet<_> = specs.iter().map(|spec| spec.rate).collect();
    assert_eq!(rates, BTreeSet::from([24, 30, 60, 120]));
    let samples = samples(1.0).into_iter().map(|spec| spec.name);
    assert!(samples.eq(specs[..13].iter().map(|spec| spec.name.clone())));
}

#[test]
fn clip_names_are_unique() {
    let names: BTreeSet<_> = all(1.0).into_iter().map(|spec| spec.name).collect();
    assert_eq!(names.len(), all(1.0).len());
}

#[test]
fn files_are_reproducible_and_depend_on_the_seed() {
    for spec in all(1.0) {
        let [first, again, other] = [0, 0, 1].map(|seed| clip_files(&spec, seed));
        assert_eq!(first, again, "{}", spec.name);
        assert_ne!(first[0], other[0], "{}", spec.name);
    }
}

#[test]
fn noise_does_not_change_the_truth() {
    for (quiet, loud) in all(0.0).iter().zip(&all(2.0)) {
        let (quiet, loud) = (generate(quiet, 0), generate(loud, 0));
        assert_eq!(quiet.truth, loud.truth);
        assert_ne!(quiet.clip, loud.clip);
    }
}

#[test]
fn labels_are_within_the_clip_and_contact_covers_heel_and_toe() {
    for spec in all(1.0) {
        for seed in 0..3 {
            let truth = generate(&spec, seed).truth;
            for side in Side::BOTH {
                let [contact, toe, heel] = Part::ALL.map(|part| truth.labels(side, part).unwrap());
                let plants = truth.foot(side).contact.as_deref().unwrap();
                assert!(
                    plants.iter().all(|plant| plant.frames.start < plant.frames.end
                        && plant.frames.end <= truth.header.frames)
                );
                let foot = format!("{} {}", spec.name, side.name());
                assert_eq!(intervals(&toe).is_empty(), NEVER_PLANTED.contains(&foot.as_str()), "{foot}");
                // Heel and toe are planted while the foot is at rest: after impact, before push-off.
                let planted = |frame: usize| toe[frame] || heel[frame];
                for frame in (0..truth.header.frames).filter(|&frame| planted(frame)) {
                    assert!(contact[frame], "{} {frame}", spec.name);
                }
                let moving = |frames: Range<usize>| frames.filter(|&frame| !planted(frame)).count();
                for plant in intervals(&contact) {
                    let frames = moving(plant) as f64 / truth.header.rate;
                    assert!(frames < 0.1 + 2.0 / truth.header.rate, "{} {frames}", spec.name);
                }
            }
        }
    }
}

#[test]
fn joints_named_in_the_truth_exist_in_the_clip() {
    for spec in all(1.0) {
        let generated = generate(&spec, 0);
        let joints = generated.truth.joints.unwrap();
        for name in [joints.left.heel, joints.left.toe, joints.right.heel, joints.right.toe] {
            assert!(generated.clip.joints().iter().any(|joint| joint.name == name), "{name}");
        }
    }
}

#[test]
fn samples_folder_is_up_to_date() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../samples");
    let specs = samples(1.0);
    let list = ("index.json".to_owned(), gallery_index(&specs));
    for (name, text) in specs.iter().flat_map(|spec| clip_files(spec, 0)).chain([list]) {
        let written = std::fs::read_to_string(folder.join(&name)).unwrap_or_default();
        assert!(written == text, "samples/{name} is out of date: run `cargo run -p plantigrade-synth`");
    }
}
