//! The motions of the clips, by what is done in them.

mod ballet;
mod bowling;
mod curved_walk;
mod drunken_stagger;
mod foot_drag_walk;
mod frog_jumps;
mod limp_to_run;
mod modern_dance;
mod one_leg_hop;
mod run_and_jump;
mod skipping;
mod straight_jog;
mod sword_and_shield;

pub use ballet::ballet;
pub use bowling::bowling;
pub use curved_walk::curved_walk;
pub use drunken_stagger::drunken_stagger;
pub use foot_drag_walk::foot_drag_walk;
pub use frog_jumps::frog_jumps;
pub use limp_to_run::limp_to_run;
pub use modern_dance::modern_dance;
pub use one_leg_hop::one_leg_hop;
pub use run_and_jump::run_and_jump;
pub use skipping::skipping;
pub use straight_jog::straight_jog;
pub use sword_and_shield::sword_and_shield;

pub(crate) use crate::act::other;

use std::fmt;
use std::sync::Arc;

use crate::act::Actor;
use crate::character::Build;
use crate::plan::Plan;
use crate::random::Random;

/// Writes the plan of a motion that lasts some seconds, for a body of a certain build.
pub type Written = fn(&Build, f64, &mut Random) -> Plan;

type Writer = dyn Fn(&Build, f64, &mut Random) -> Plan + Send + Sync;

/// What is done in a clip.
#[derive(Clone)]
pub struct Motion(Arc<Writer>);

impl Motion {
    /// The motion that `plan` writes.
    pub fn new(plan: impl Fn(&Build, f64, &mut Random) -> Plan + Send + Sync + 'static) -> Motion {
        Motion(Arc::new(plan))
    }

    /// What an actor does who stands `before` seconds before the clip begins; `act` is
    /// told the clip's length in seconds.
    pub fn acted(before: f64, act: impl Fn(&mut Actor, f64) + Send + Sync + 'static) -> Motion {
        Motion::new(move |build, seconds, random| {
            let mut actor = Actor::standing(build, random, -before);
            act(&mut actor, seconds);
            actor.finish()
        })
    }

    /// The plan for a clip of that length.
    pub fn plan(&self, build: &Build, seconds: f64, random: &mut Random) -> Plan {
        (self.0)(build, seconds, random)
    }
}

impl fmt::Debug for Motion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Motion")
    }
}
