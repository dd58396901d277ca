//! Generated motion with exact foot-plant truth.
//!
//! The way of the data goes one direction: a [`Recipe`] names a character and a motion;
//! the motion writes a [`plan`] of steps; [`feet`] turns it into foot paths, [`pelvis`]
//! balances the body over them, [`noise`] adds what recording does, [`pose`] solves the
//! joints and [`bake`] writes them in the character's conventions. The [`truth`] is read
//! off the plan, before the noise.
//!
//! ```
//! use plantigrade_synth::{catalogue, generate};
//!
//! let recipe = &catalogue(1.0)[0];
//! let generated = generate(recipe, 0);
//! assert_eq!(generated.clip.frame_count(), generated.truth.frames);
//! ```
#![forbid(unsafe_code)]

pub mod bake;
mod catalogue;
pub mod character;
pub mod curve;
pub mod feet;
pub mod grid;
pub mod maths;
pub mod motion;
pub mod noise;
pub mod pelvis;
pub mod plan;
pub mod pose;
pub mod random;
mod recipe;
pub mod truth;

pub use catalogue::catalogue;
pub use recipe::{Generated, Motion, Recipe, generate};

/// The BVH and the JSON text of a generated clip, as they stand in files.
pub fn texts(generated: &Generated) -> (String, String) {
    let truth = serde_json::to_string_pretty(&generated.truth).expect("a document is plain data");
    (plantigrade::bvh::write(&generated.clip), truth + "\n")
}
