//! What people do, one thing after the other.
//!
//! An [`Actor`] writes a plan in the terms of actions: walking off in some style,
//! jumping, kicking. Each leaves the actor standing, or on the way where it can go on.

mod action;
mod carriage;
mod dance;
mod fight;
mod jump;
mod obstacle;
mod stand;
mod style;
mod travel;

pub use action::{Action, Performed};
pub use carriage::Carriage;
pub use style::Style;

use plantigrade::foot::Side;

use crate::character::Build;
use crate::plan::{Gait, Place, Plan, Planner};
use crate::random::Random;

/// Half the distance of the feet of someone who stands, in metres for an average body.
const STANCE: f64 = 0.085;

/// Someone who acts.
pub struct Actor<'a> {
    /// The plan so far.
    pub planner: Planner,
    /// The source of all variation.
    pub random: &'a mut Random,
    /// Lengths of movements relative to a person of average size.
    pub scale: f64,
    /// The foot that takes the next step.
    side: Side,
    /// The style in which the actor is on the way.
    under_way: Option<Style>,
}

impl Actor<'_> {
    /// Someone of that build who stands at the origin from `start` on.
    pub fn standing<'a>(build: &Build, random: &'a mut Random, start: f64) -> Actor<'a> {
        let scale = build.scale();
        let planner = Planner::standing(start, Place::ORIGIN, STANCE * scale);
        Actor { planner, random, scale, side: Side::Left, under_way: None }
    }

    /// Seconds of the clip up to which the plan is written.
    pub fn now(&self) -> f64 {
        self.planner.now()
    }

    /// Lets `seconds` pass.
    pub fn wait(&mut self, seconds: f64) {
        self.planner.wait(seconds);
    }

    /// The finished plan.
    pub fn finish(self) -> Plan {
        self.planner.finish()
    }

    /// Takes a step with the foot whose turn it is.
    fn pace(&mut self, gait: &Gait) {
        self.planner.step(self.side, gait);
        self.side = other(self.side);
    }
}

/// The other side.
pub fn other(side: Side) -> Side {
    match side {
        Side::Left => Side::Right,
        Side::Right => Side::Left,
    }
}
