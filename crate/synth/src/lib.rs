//! Generated motion with exact ground truth of foot plants.
//!
//! Data flows in one direction. A [`ClipSpec`] names a character and a motion. The motion
//! writes a [`plan`] of steps; [`foot_path`] computes the paths of the feet, [`pelvis`]
//! balances the body over them, [`noise`] adds capture noise and [`pose`] solves the joints.
//! The [`environment`] transforms whole poses, and [`export`] writes them in the file
//! conventions of the character. The [`truth`] is derived from the plan, before the noise.
//!
//! ```
//! use plantigrade_synth::{generate, samples};
//!
//! let spec = &samples(1.0)[0];
//! let generated = generate(spec, 0);
//! assert_eq!(generated.clip.frame_count(), generated.truth.header.frames);
//! ```
#![forbid(unsafe_code)]

mod action_clip;
pub mod actions;
mod catalogue;
pub mod character;
mod decimate;
pub mod environment;
pub mod export;
pub mod foot_path;
mod generate;
pub mod math;
pub mod motion;
pub mod noise;
pub mod pelvis;
pub mod plan;
pub mod pose;
pub mod rigs;
pub mod sample_motions;
pub mod thumbnail;
pub mod truth;

pub use action_clip::{ActionClip, ActionSequence, Cut, action_sequences, generate_sequence};
pub use catalogue::{full_set, hard_cases, long_mix, samples};
pub use decimate::decimate;
pub use generate::{ClipSpec, Generated, generate};
use plantigrade::formats::to_json;

/// Returns the files of one clip as pairs of name and text: BVH, truth and thumbnail.
pub fn clip_files(spec: &ClipSpec, seed: u64) -> [(String, String); 3] {
    let Generated { clip, truth } = generate(spec, seed);
    let name = |extension| format!("{}.{extension}", spec.name);
    [
        (name("bvh"), plantigrade::bvh::write(&clip)),
        (name("json"), to_json(&truth)),
        (name("svg"), thumbnail::svg(&clip)),
    ]
}

/// Returns the list of clips for the gallery of the app, as JSON: name, title and a note.
pub fn gallery_index(specs: &[ClipSpec]) -> String {
    let entry = |spec: &ClipSpec| {
        let words = spec.name.replace('-', " ");
        let title = words[..1].to_uppercase() + &words[1..];
        let note = format!("{} frames, {} Hz", spec.frames, spec.rate);
        serde_json::json!({ "name": spec.name, "title": title, "note": note })
    };
    let entries: Vec<_> = specs.iter().map(entry).collect();
    format!("{:#}\n", serde_json::Value::from(entries))
}
