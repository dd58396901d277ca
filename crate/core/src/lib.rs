//! Foot plants in motion capture: a BVH reader and writer, kinematics, a detector by spectral
//! clustering with nothing to tune, six methods that cut motion into actions, foot-skate clean-up
//! and gait measures. No I/O, no `unsafe`, and it compiles to WebAssembly.
//!
//! ```rust
//! use plantigrade::{bvh, foot::Side, gait::Gait, intervals::intervals, plants, skate, skeleton};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! # let bytes = include_bytes!("../../../samples/curved-walk.bvh");
//! let parsed = bvh::parse(&bytes[..], bvh::Options::default())?;
//! let clip = &parsed.clip;
//! let skeleton = skeleton::Skeleton::main(clip, &skeleton::Overrides::default());
//!
//! // When each foot is planted.
//! let feet = plants::Feet::new(clip, &skeleton)?;
//! let detection = plants::detect(&feet, plants::ValidParams::default());
//! let left = &detection.principal().foot(Side::Left);
//! for plant in intervals(&left.planted) {
//!     println!("left foot down in frames {} to {}", plant.start, plant.end);
//! }
//!
//! // How the person walks, and the clip with its planted feet held still.
//! let gait = Gait::from_detection(&feet, &detection);
//! println!("{:.0} steps a minute", gait.cadence_steps_per_min.unwrap_or(0.0));
//! let contacts = skate::Contacts::from(&detection);
//! let cleaned = skate::clean(clip, &skeleton, &contacts, &skate::Options::default())?;
//! let text = bvh::write(&cleaned.clip);
//! # assert_eq!(intervals(&left.planted).len(), 3);
//! # assert!(cleaned.plants.iter().all(|plant| plant.after < 1e-3) && text.starts_with("HIERARCHY"));
//! # Ok(())
//! # }
//! ```
//!
//! The detector follows Liu, Lu and Xie, *Foot plant detection based on spectral clustering algorithm
//! for motion capture data* (2014) and mends what recorded motion breaks; the published method and
//! fourteen others stand beside it. How well each does is measured in the project's `RESULTS.md`.
//!
//! Licensed under MIT or Apache-2.0, at your choice.
#![forbid(unsafe_code)]

pub mod bvh;
pub mod foot;
pub mod formats;
pub mod gait;
pub mod intervals;
pub mod kinematics;
pub mod notice;
mod numeric;
pub mod plants;
pub mod registry;
pub mod score;
pub mod segments;
pub mod skate;
pub mod skeleton;
