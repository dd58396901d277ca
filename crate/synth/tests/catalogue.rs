//! The clips: what they promise, and what lies in `samples/`.

use std::collections::BTreeSet;
use std::path::Path;

use plantigrade::foot::{Part, Side};
use plantigrade::intervals::intervals;
use plantigrade_synth::{Recipe, catalogue, files, full_set, generate, hard_cases, index};

/// Frames and rates of the thirteen files, in the catalogue's order.
const TABLE: [(usize, usize); 13] = [
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

/// The feet that never stand.
const NEVER_PLANTED: [&str; 4] =
    ["one-foot-in-air right", "one-foot-dragged right", "afloat left", "afloat right"];

/// Every clip there is a recipe for.
fn all(noise_level: f64) -> Vec<Recipe> {
    [full_set(noise_level), hard_cases(noise_level)].concat()
}

#[test]
fn frames_and_rates_of_the_samples_are_those_of_the_table() {
    let recipes = catalogue(1.0);
    assert_eq!(recipes.len(), TABLE.len());
    for (recipe, (frames, rate)) in recipes.iter().zip(TABLE) {
        assert_eq!((recipe.frames, recipe.rate), (frames, rate), "{}", recipe.name);
    }
}

#[test]
fn clips_have_the_frames_of_their_recipes() {
    for recipe in all(1.0) {
        let generated = generate(&recipe, 0);
        assert_eq!(generated.clip.frame_count(), recipe.frames, "{}", recipe.name);
        assert!((generated.clip.rate() - recipe.rate as f64).abs() < 1e-3, "{}", recipe.name);
        assert_eq!(generated.truth.frames, recipe.frames, "{}", recipe.name);
        assert_eq!(generated.truth.rate, generated.clip.rate(), "{}", recipe.name);
    }
}

#[test]
fn the_full_set_is_of_the_papers_size() {
    let recipes = full_set(1.0);
    assert_eq!(recipes.len(), 35);
    assert_eq!(recipes.iter().map(|recipe| recipe.frames).sum::<usize>(), 16_613);
    let performers: BTreeSet<_> = recipes.iter().map(|recipe| recipe.character.name).collect();
    assert_eq!(performers.len(), 8);
    let rates: BTreeSet<_> = recipes.iter().map(|recipe| recipe.rate).collect();
    assert_eq!(rates, BTreeSet::from([24, 30, 60, 120]));
    let samples = catalogue(1.0).into_iter().map(|recipe| recipe.name);
    assert!(samples.eq(recipes[..13].iter().map(|recipe| recipe.name.clone())));
}

#[test]
fn names_are_different() {
    let names: BTreeSet<_> = all(1.0).into_iter().map(|recipe| recipe.name).collect();
    assert_eq!(names.len(), all(1.0).len());
}

#[test]
fn the_seed_decides_every_byte() {
    for recipe in all(1.0) {
        let [first, again, other] = [0, 0, 1].map(|seed| files(&recipe, seed));
        assert_eq!(first, again, "{}", recipe.name);
        assert_ne!(first[0], other[0], "{}", recipe.name);
    }
}

#[test]
fn the_noise_leaves_the_truth_alone() {
    for (quiet, loud) in all(0.0).iter().zip(&all(2.0)) {
        let (quiet, loud) = (generate(quiet, 0), generate(loud, 0));
        assert_eq!(quiet.truth, loud.truth);
        assert_ne!(quiet.clip, loud.clip);
    }
}

#[test]
fn labels_lie_within_the_clip_and_within_contact() {
    for recipe in all(1.0) {
        for seed in 0..3 {
            let truth = generate(&recipe, seed).truth;
            for side in Side::BOTH {
                let [contact, toe, heel] = Part::ALL.map(|part| truth.labels(side, part).unwrap());
                let spans = truth.foot(side).contact.as_deref().unwrap();
                assert!(spans.iter().all(|span| span.start < span.end && span.end <= truth.frames));
                let foot = format!("{} {}", recipe.name, side.name());
                assert_eq!(intervals(&toe).is_empty(), NEVER_PLANTED.contains(&foot.as_str()), "{foot}");
                for frame in 0..truth.frames {
                    assert_eq!(contact[frame], toe[frame] || heel[frame], "{} {frame}", recipe.name);
                }
            }
        }
    }
}

#[test]
fn joints_of_the_truth_are_in_the_clip() {
    for recipe in all(1.0) {
        let generated = generate(&recipe, 0);
        let joints = generated.truth.joints.unwrap();
        for name in [joints.left.heel, joints.left.toe, joints.right.heel, joints.right.toe] {
            assert!(generated.clip.joints().iter().any(|joint| joint.name == name), "{name}");
        }
    }
}

#[test]
fn samples_are_what_the_generator_writes() {
    let samples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../samples");
    let recipes = catalogue(1.0);
    let list = ("index.json".to_owned(), index(&recipes));
    for (name, text) in recipes.iter().flat_map(|recipe| files(recipe, 0)).chain([list]) {
        let found = std::fs::read_to_string(samples.join(&name)).unwrap_or_default();
        assert!(found == text, "samples/{name} is stale: run `cargo run -p plantigrade-synth`");
    }
}
