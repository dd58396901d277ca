//! Generated motion with exact foot-plant truth.
//!
//! The way of the data goes one direction: a [`Recipe`] names a character and a motion;
//! the motion writes a [`plan`] of steps; [`feet`] turns it into foot paths, [`pelvis`]
//! balances the body over them, [`noise`] adds what recording does, [`pose`] solves the
//! joints, [`setting`] puts the whole in its place and [`bake`] writes it in the
//! character's conventions. The [`truth`] is read off the plan, before the noise.
//!
//! ```
//! use plantigrade_synth::{catalogue, generate};
//!
//! let recipe = &catalogue(1.0)[0];
//! let generated = generate(recipe, 0);
//! assert_eq!(generated.clip.frame_count(), generated.truth.frames);
//! ```
#![forbid(unsafe_code)]

pub mod act;
pub mod bake;
mod catalogue;
mod chain;
pub mod character;
pub mod curve;
mod decimate;
pub mod feet;
pub mod grid;
pub mod maths;
pub mod motion;
pub mod noise;
pub mod pelvis;
pub mod picture;
pub mod plan;
pub mod pose;
pub mod random;
mod recipe;
pub mod setting;
pub mod truth;

pub use catalogue::{catalogue, full_set, hard_cases, long};
pub use chain::{Chain, Cut, Sequence, chained, sequences};
pub use decimate::decimated;
pub use recipe::{Generated, Recipe, generate};

/// The files of one clip: name and text of BVH, truth and picture.
pub fn files(recipe: &Recipe, seed: u64) -> [(String, String); 3] {
    let Generated { clip, truth } = generate(recipe, seed);
    let name = |ending| format!("{}.{ending}", recipe.name);
    [
        (name("bvh"), plantigrade::bvh::write(&clip)),
        (name("json"), truth.to_json()),
        (name("svg"), picture::picture(&clip)),
    ]
}

/// The list of the clips for the app's gallery, as JSON: name, title and a note.
pub fn index(recipes: &[Recipe]) -> String {
    let entry = |recipe: &Recipe| {
        let words = recipe.name.replace('-', " ");
        let title = words[..1].to_uppercase() + &words[1..];
        let note = format!("{} frames, {} Hz", recipe.frames, recipe.rate);
        serde_json::json!({ "name": recipe.name, "title": title, "note": note })
    };
    let entries: Vec<_> = recipes.iter().map(entry).collect();
    format!("{:#}\n", serde_json::Value::from(entries))
}
