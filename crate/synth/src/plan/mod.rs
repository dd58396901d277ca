//! The plan of a motion: when and where each foot stands, and how the rest of the
//! body is carried.
//!
//! The plan is the source of the truth: all that follows (foot paths, balance,
//! pose) may only realise it.

mod body;
mod gait;
mod planner;
mod step;
mod support;

pub use body::{ArmStyle, Body};
pub use gait::{Gait, Hop};
pub use planner::{Planner, beside};
pub use step::{Carry, Held, Landing, Lift, Place, Step};
pub use support::{Interval, Stance, flights, stances};

use crate::curve::Track;

/// A motion of both feet, with the carriage of the body.
///
/// Time runs in seconds; the clip begins at 0. A plan may begin before that, so
/// that the clip catches a motion under way.
#[derive(Clone, Debug)]
pub struct Plan {
    /// When the plan begins: at most −1.
    pub start: f64,
    /// Left foot, right foot.
    pub feet: [FootPlan; 2],
    /// Trunk, head and arms.
    pub body: Body,
}

/// The way of one foot: it stands somewhere and then takes steps.
#[derive(Clone, Debug)]
pub struct FootPlan {
    /// Where the foot stands first.
    pub start: Place,
    /// The steps in order of time.
    pub steps: Vec<Step>,
    /// How far the heel is raised while the foot stands, as a pitch in degrees
    /// (0: flat; dancers on the balls of their feet).
    pub raise: Track<1>,
    /// How far the standing foot has turned about its ball, in degrees to the left.
    pub pivot: Track<1>,
}
