//! Kinds of steps and jumps.

use super::{Carry, Landing, Lift};
use crate::maths::lerp;

/// How to take a step of a gait.
#[derive(Clone, Debug, PartialEq)]
pub struct Gait {
    /// Seconds from the other foot's strike to this one's.
    pub time: f64,
    /// Metres the body moves on in that time.
    pub length: f64,
    /// Degrees it turns to the left.
    pub turn: f64,
    /// Metres from the body's way out to the ball of the foot.
    pub width: f64,
    /// Degrees the toes point outward.
    pub toe_out: f64,
    /// Seconds the foot is in the air.
    pub swing: f64,
    /// How it leaves the ground.
    pub lift: Lift,
    /// How it travels.
    pub carry: Carry,
    /// How it lands.
    pub landing: Landing,
}

impl Gait {
    /// Walking at an easy pace; lengths grow with `scale`.
    pub fn walk(scale: f64) -> Gait {
        Gait {
            time: 0.54,
            length: 0.66 * scale,
            turn: 0.0,
            width: 0.075 * scale,
            toe_out: 6.0,
            swing: 0.42,
            lift: Lift { pitch: 52.0, lead: 0.24 },
            carry: Carry {
                clearance: 0.075 * scale,
                peak: 0.34,
                pitch: 8.0,
                pitch_at: 0.62,
                ramps: (0.24, 0.24),
                detour: 0.012,
                grounded: false,
                load: 0.0,
                held: None,
            },
            landing: Landing::HEEL,
        }
    }

    /// Jogging; lengths grow with `scale`.
    pub fn jog(scale: f64) -> Gait {
        let walk = Gait::walk(scale);
        Gait {
            time: 0.365,
            length: 1.0 * scale,
            width: 0.05 * scale,
            swing: 0.47,
            lift: Lift { pitch: 58.0, lead: 0.15 },
            carry: Carry {
                clearance: 0.27 * scale,
                peak: 0.36,
                pitch: 72.0,
                pitch_at: 0.34,
                ramps: (0.4, 0.22),
                ..walk.carry
            },
            landing: Landing { pitch: -10.0, settle: 0.06, rest: 0.0 },
            ..walk
        }
    }

    /// The gait `share` of the way from this one to `other`.
    pub fn blend(&self, other: &Gait, share: f64) -> Gait {
        let mix = |a: f64, b: f64| lerp(a, b, share);
        let nearer = if share < 0.5 { self } else { other };
        let (from, to) = (&self.carry, &other.carry);
        Gait {
            time: mix(self.time, other.time),
            length: mix(self.length, other.length),
            turn: mix(self.turn, other.turn),
            width: mix(self.width, other.width),
            toe_out: mix(self.toe_out, other.toe_out),
            swing: mix(self.swing, other.swing),
            lift: Lift {
                pitch: mix(self.lift.pitch, other.lift.pitch),
                lead: mix(self.lift.lead, other.lift.lead),
            },
            carry: Carry {
                clearance: mix(from.clearance, to.clearance),
                peak: mix(from.peak, to.peak),
                pitch: mix(from.pitch, to.pitch),
                pitch_at: mix(from.pitch_at, to.pitch_at),
                ramps: (mix(from.ramps.0, to.ramps.0), mix(from.ramps.1, to.ramps.1)),
                detour: mix(from.detour, to.detour),
                ..nearer.carry.clone()
            },
            // Landing half on the heel and half on the ball is neither.
            landing: nearer.landing,
        }
    }

    /// Whether both feet are in the air between two steps.
    pub fn is_run(&self) -> bool {
        self.swing > self.time
    }
}

/// How to jump off and land.
#[derive(Clone, Debug, PartialEq)]
pub struct Hop {
    /// Seconds on the ground before the jump.
    pub ground: f64,
    /// Seconds in the air.
    pub flight: f64,
    /// Metres forward.
    pub length: f64,
    /// Degrees turned to the left.
    pub turn: f64,
    /// Metres from the way out to the ball of a foot.
    pub width: f64,
    /// How the feet leave the ground.
    pub lift: Lift,
    /// How they travel.
    pub carry: Carry,
    /// How they land.
    pub landing: Landing,
}
