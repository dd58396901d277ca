//! Motion plans: times and placements of foot contacts, and tracks of the body.
//!
//! The plan is the source of the ground truth. All later stages (foot paths, balance, pose) realise
//! it and never change it.

mod body_tracks;
mod gait;
mod planner;
mod stance;
mod step;

pub use body_tracks::{ArmPose, BodyTracks};
pub use gait::{Gait, Jump};
pub use planner::{Planner, foot_placement};
pub use stance::{Interval, Stance, flights, stances};
pub use step::{EndMotion, Landing, LegPoses, Lift, Placement, Step, SwingPath};

use crate::math::Track;

/// Plan of a motion: steps of both feet and tracks of the body.
///
/// Times are in seconds; the clip begins at 0. A plan begins earlier, so that a clip can start in
/// the middle of a movement.
#[derive(Clone, Debug)]
pub struct Plan {
    /// Start of the plan: at most −1.
    pub start: f64,
    /// Left and right foot.
    pub feet: [FootPlan; 2],
    /// Pelvis, trunk, head and arms.
    pub body: BodyTracks,
}

/// Plan of one foot: its first placement and its steps.
#[derive(Clone, Debug)]
pub struct FootPlan {
    /// Initial placement.
    pub start: Placement,
    /// Steps in order of time.
    pub steps: Vec<Step>,
    /// Raised heel during stances, as a pitch in degrees (0: flat; positive for dancers on the
    /// balls of their feet).
    pub heel_raise: Track<1>,
    /// Rotation of the standing foot about its ball, in degrees to the left.
    pub pivot: Track<1>,
}
