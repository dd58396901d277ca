//! Actions that write a plan.
//!
//! An [`Actor`] appends actions to a plan: travelling in a style, jumping, kicking. Each action
//! leaves the actor standing or travelling, so that the next can follow.

mod action;
mod dance;
mod fighting;
mod gait_style;
mod in_place;
mod jumping;
mod locomotion;
mod posture;
mod terrain;

pub use action::{Action, ActionInterval};
pub use gait_style::GaitStyle;
pub use posture::Posture;

use plantigrade::foot::Side;

use crate::character::Proportions;
use crate::math::Random;
use crate::plan::{Gait, Placement, Plan, Planner};

/// Half the distance between the feet while standing, in metres for an average body.
const HALF_STANCE_WIDTH: f64 = 0.085;

/// Performs actions and records them in a plan.
pub struct Actor<'a> {
    /// Planner that holds the plan so far.
    pub planner: Planner,
    /// Source of all variation.
    pub random: &'a mut Random,
    /// Scale of movements relative to a person of average size.
    pub scale: f64,
    /// Foot that takes the next step.
    side: Side,
    /// Style of the current locomotion; `None` while standing.
    current_style: Option<GaitStyle>,
}

impl Actor<'_> {
    /// Creates an actor that stands at the origin from time `start`.
    pub fn standing<'a>(proportions: &Proportions, random: &'a mut Random, start: f64) -> Actor<'a> {
        let scale = proportions.scale();
        let planner = Planner::standing(start, Placement::ORIGIN, HALF_STANCE_WIDTH * scale);
        Actor { planner, random, scale, side: Side::Left, current_style: None }
    }

    /// Returns the time up to which the plan is written, in seconds.
    pub fn now(&self) -> f64 {
        self.planner.now()
    }

    /// Waits for `seconds`.
    pub fn wait(&mut self, seconds: f64) {
        self.planner.wait(seconds);
    }

    /// Returns the finished plan.
    pub fn finish(self) -> Plan {
        self.planner.finish()
    }

    /// Takes the next step, with the foot `self.side`.
    fn take_step(&mut self, gait: &Gait) {
        self.planner.step(self.side, gait);
        self.side = opposite(self.side);
    }
}

/// Returns the opposite side.
pub fn opposite(side: Side) -> Side {
    match side {
        Side::Left => Side::Right,
        Side::Right => Side::Left,
    }
}
