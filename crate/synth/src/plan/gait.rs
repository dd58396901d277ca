//! Parameters of steps and jumps.

use super::{EndMotion, Landing, Lift, SwingPath};
use crate::math::lerp;

/// Parameters of a step.
#[derive(Clone, Debug, PartialEq)]
pub struct Gait {
    /// Time from the other foot's strike to this foot's strike (step time), in seconds.
    pub time: f64,
    /// Distance that the body moves in that time (step length), in metres.
    pub length: f64,
    /// Rotation of the body to the left, in degrees.
    pub turn: f64,
    /// Distance of the ball of the foot from the path of the body, in metres.
    pub width: f64,
    /// Outward rotation of the foot, in degrees.
    pub toe_out: f64,
    /// Duration of the swing phase, in seconds.
    pub swing: f64,
    /// Push-off of the foot.
    pub lift: Lift,
    /// Path of the foot through the air.
    pub swing_path: SwingPath,
    /// Landing of the foot.
    pub landing: Landing,
}

impl Gait {
    /// Returns comfortable walking; lengths are proportional to `scale`.
    pub fn walk(scale: f64) -> Gait {
        Gait {
            time: 0.54,
            length: 0.66 * scale,
            turn: 0.0,
            width: 0.075 * scale,
            toe_out: 6.0,
            swing: 0.42,
            lift: Lift { pitch: 52.0, lead: 0.24 },
            swing_path: SwingPath {
                clearance: 0.06 * scale,
                peak: 0.34,
                pitch: 8.0,
                pitch_at: 0.62,
                ramps: (0.18, 0.31),
                detour: 0.012,
                grounded: false,
                load: 0.0,
                take_off: EndMotion::WALK_OFF,
                touch_down: EndMotion::WALK_STRIKE,
                leg_poses: None,
            },
            landing: Landing::HEEL,
        }
    }

    /// Returns jogging; lengths are proportional to `scale`.
    pub fn jog(scale: f64) -> Gait {
        let walk = Gait::walk(scale);
        Gait {
            time: 0.365,
            length: 1.0 * scale,
            width: 0.05 * scale,
            swing: 0.47,
            lift: Lift { pitch: 58.0, lead: 0.15 },
            swing_path: SwingPath {
                clearance: 0.22 * scale,
                peak: 0.4,
                pitch: 72.0,
                pitch_at: 0.34,
                ramps: (0.4, 0.22),
                take_off: EndMotion::RUN_OFF,
                touch_down: EndMotion::RUN_STRIKE,
                ..walk.swing_path
            },
            landing: Landing { pitch: -14.0, settle: 0.06, rest: 0.0 },
            ..walk
        }
    }

    /// Interpolates between this gait and `other` by the fraction `t`.
    pub fn blend(&self, other: &Gait, t: f64) -> Gait {
        let mix = |a: f64, b: f64| lerp(a, b, t);
        let nearer = if t < 0.5 { self } else { other };
        let (from, to) = (&self.swing_path, &other.swing_path);
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
            swing_path: SwingPath {
                clearance: mix(from.clearance, to.clearance),
                peak: mix(from.peak, to.peak),
                pitch: mix(from.pitch, to.pitch),
                pitch_at: mix(from.pitch_at, to.pitch_at),
                ramps: (mix(from.ramps.0, to.ramps.0), mix(from.ramps.1, to.ramps.1)),
                detour: mix(from.detour, to.detour),
                take_off: from.take_off.blend(&to.take_off, t),
                touch_down: from.touch_down.blend(&to.touch_down, t),
                ..nearer.swing_path.clone()
            },
            // Landings are not interpolated: a mix of heel and ball landing does not exist.
            landing: nearer.landing,
        }
    }

    /// True if both feet are in the air between two steps.
    pub fn is_run(&self) -> bool {
        self.swing > self.time
    }
}

/// Parameters of a jump.
#[derive(Clone, Debug, PartialEq)]
pub struct Jump {
    /// Time on the ground before take-off, in seconds.
    pub ground: f64,
    /// Flight time, in seconds.
    pub flight: f64,
    /// Distance forward, in metres.
    pub length: f64,
    /// Rotation to the left, in degrees.
    pub turn: f64,
    /// Distance of the ball of a foot from the path of the body, in metres.
    pub width: f64,
    /// Push-off of the feet.
    pub lift: Lift,
    /// Path of the feet through the air.
    pub swing_path: SwingPath,
    /// Landing of the feet.
    pub landing: Landing,
}
