//! Gait measures: how a person walks or runs, from the times and locations of the plants.
//!
//! Definitions follow clinical gait analysis (Perry and Burnfield, *Gait Analysis: Normal and
//! Pathological Function*, 2nd edition, 2010). A *stride* (gait cycle) lasts from one foot strike
//! to the next of the same foot, a *step* from the strike of one foot to the strike of the other; a
//! step is named after the foot that takes it. *Stance* lasts from foot strike to foot off, *swing*
//! from foot off to the next strike. Foot strike and foot off are the ends of contact rather than
//! extremes of a marker's track (Zeni, Richards and Higginson, Gait & Posture 27(4), 2008); times are
//! those of the instants of the detection, between frames, where it has them.
//!
//! Only complete strides count; the others are left out and counted ([`LeftOut`]). A stride counts if
//! the other foot steps once in between, if it takes at most [`MAX_STRIDE_TIME`] and if it moves
//! the foot by at least [`MIN_STRIDE_LENGTH`]. Standing, turning on the spot, hopping and jumping
//! contain no such stride. Lengths are measured along the plane of the ground, and on a treadmill relative
//! to its belt ([`Ground`](crate::plants::Ground)).
//!
//! Data flow: labels ([`Contact`]) → footfalls → [`Step`] per foot strike → [`Gait`], the means, and
//! [`Curves`], the joint angles over the gait cycle. [`GaitAnalysis`] contains all of them.

mod action;
mod analysis;
mod contact;
mod curves;
mod footfall;
mod legs;
mod measures;
mod spread;
mod step;
mod symmetry;
mod table;
#[cfg(test)]
mod tests;

pub use action::{ActionGait, ActionRanges, action_ranges};
pub use analysis::GaitAnalysis;
pub use contact::Contact;
pub use curves::{CYCLE_POINTS, Curve, Curves, SideCurves};
pub use legs::Legs;
pub use measures::{Gait, LeftOut};
pub use spread::{PerSide, Spread};
pub use step::{Omission, Step, Stride};
pub use symmetry::Symmetry;

/// Maximum stride time, in seconds. At 48 steps per minute, less than half of the usual cadence
/// (100 to 120), a person stands between steps.
pub const MAX_STRIDE_TIME: f64 = 2.5;

/// Minimum stride length, in leg lengths: about 36 cm for an adult, or two steps shorter than a
/// foot each. Feet that shift weight, turn or box on the spot move less.
pub const MIN_STRIDE_LENGTH: f64 = 0.4;
