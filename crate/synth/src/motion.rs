//! Motions of clips.

use std::fmt;
use std::sync::Arc;

use crate::actions::Actor;
use crate::character::Proportions;
use crate::math::Random;
use crate::plan::Plan;

/// Function that plans a motion from body proportions, duration in seconds and random numbers.
pub type PlanFn = fn(&Proportions, f64, &mut Random) -> Plan;

type DynPlanFn = dyn Fn(&Proportions, f64, &mut Random) -> Plan + Send + Sync;

/// Motion of a clip.
#[derive(Clone)]
pub struct Motion(Arc<DynPlanFn>);

impl Motion {
    /// Creates a motion from a planning function.
    pub fn from_plan(
        plan: impl Fn(&Proportions, f64, &mut Random) -> Plan + Send + Sync + 'static,
    ) -> Motion {
        Motion(Arc::new(plan))
    }

    /// Creates a motion from actions of an actor that stands from `lead_in` seconds before the
    /// clip. `act` receives the duration of the clip, in seconds.
    pub fn from_actions(lead_in: f64, act: impl Fn(&mut Actor, f64) + Send + Sync + 'static) -> Motion {
        Motion::from_plan(move |proportions, seconds, random| {
            let mut actor = Actor::standing(proportions, random, -lead_in);
            act(&mut actor, seconds);
            actor.finish()
        })
    }

    /// Plans the motion for a clip of `seconds`.
    pub fn plan(&self, proportions: &Proportions, seconds: f64, random: &mut Random) -> Plan {
        (self.0)(proportions, seconds, random)
    }
}

impl fmt::Debug for Motion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Motion")
    }
}
