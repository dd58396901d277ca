//! One step: push-off, swing and landing.

use crate::math::{GRAVITY, Track, lerp, smooth_rise};
use crate::math::{Vec3, forward, leftward};

/// Position and heading on the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// Distance to the left, in metres.
    pub x: f64,
    /// Height of the ground, in metres.
    pub y: f64,
    /// Distance forward, in metres.
    pub z: f64,
    /// Rotation to the left, in radians.
    pub heading: f64,
}

impl Placement {
    /// The origin, heading forward.
    pub const ORIGIN: Placement = Placement { x: 0.0, y: 0.0, z: 0.0, heading: 0.0 };

    /// Returns the point on the ground.
    pub fn point(&self) -> Vec3 {
        Vec3::new(self.x, self.y, self.z)
    }

    /// Returns the placement moved `ahead` metres forward and `left` metres to the left along its
    /// own heading.
    pub fn translated(&self, ahead: f64, left: f64) -> Placement {
        let point = self.point() + ahead * forward(self.heading) + left * leftward(self.heading);
        Placement { x: point.x, z: point.z, ..*self }
    }

    /// Returns the placement moved `ahead` metres along `heading` and `left` metres to the left of
    /// it; its own heading does not change.
    pub fn translated_along(&self, heading: f64, ahead: f64, left: f64) -> Placement {
        Placement { heading: self.heading, ..Placement { heading, ..*self }.translated(ahead, left) }
    }

    /// Returns the placement raised by `rise` metres.
    pub fn raised(&self, rise: f64) -> Placement {
        Placement { y: self.y + rise, ..*self }
    }

    /// Returns the placement rotated by `degrees` to the left.
    pub fn rotated(&self, degrees: f64) -> Placement {
        Placement { heading: self.heading + degrees.to_radians(), ..*self }
    }
}

/// One step of one foot.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// Time of the foot strike, in seconds.
    pub strike: f64,
    /// Duration of the swing phase before it, in seconds.
    pub swing: f64,
    /// Placement of the ball of the foot.
    pub placement: Placement,
    /// Push-off before the swing.
    pub lift: Lift,
    /// Path of the foot through the air.
    pub swing_path: SwingPath,
    /// Landing.
    pub landing: Landing,
    /// Fraction of the body weight that the foot bears when it stands alone: 1, or less for a foot
    /// that only rests on the ground.
    pub weight: f64,
}

impl Step {
    /// Returns the time of toe-off, in seconds.
    pub fn toe_off(&self) -> f64 {
        self.strike - self.swing
    }

    /// Returns the prescribed pose of the leg at `time` and its weight from 0 to 1.
    pub fn leg_pose(&self, time: f64) -> Option<([f64; 5], f64)> {
        let leg_poses = self.swing_path.leg_poses.as_ref()?;
        let weight = smooth_rise(time, self.toe_off(), self.toe_off() + leg_poses.ease_in)
            * (1.0 - smooth_rise(time, self.strike - leg_poses.ease_out, self.strike));
        Some((leg_poses.poses.at(time), weight))
    }
}

/// Push-off of a foot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lift {
    /// Pitch of the foot at toe-off, in degrees, heel up.
    pub pitch: f64,
    /// Time from heel-off to toe-off, in seconds.
    pub lead: f64,
}

/// Path of a foot during the swing phase.
#[derive(Clone, Debug, PartialEq)]
pub struct SwingPath {
    /// Maximum height above the line between the placements, in metres.
    pub clearance: f64,
    /// Fraction of the swing at which this is reached.
    pub peak: f64,
    /// Pitch of the foot in mid-swing, in degrees, heel up.
    pub pitch: f64,
    /// Fraction of the swing at which this is reached.
    pub pitch_at: f64,
    /// Fractions of the swing spent accelerating and decelerating.
    pub ramps: (f64, f64),
    /// Lateral detour outward, in metres.
    pub detour: f64,
    /// True if the foot stays on the ground: it is dragged or slides.
    pub grounded: bool,
    /// Fraction of the body weight that the foot bears during the swing: 0 except for slides.
    pub load: f64,
    /// Motion of the foot as it leaves the ground.
    pub take_off: EndMotion,
    /// Motion of the foot as it touches the ground.
    pub touch_down: EndMotion,
    /// Prescribed poses of the leg during the swing.
    pub leg_poses: Option<LegPoses>,
}

/// Motion of a foot relative to the ground at one end of a swing.
///
/// Recorded feet do not come to rest before they touch the ground, and do not start from rest when
/// they leave it. At foot strike the foot moves down and forward; the ground stops it within some 20
/// to 40 ms, while heel pad or toes yield. Before foot off, the foot accelerates from rest while its
/// load decreases: the ball leaves the ground first, the tip of the toes last. The constants are
/// rounded means of recorded force-plate strikes and offs.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct EndMotion {
    /// Vertical speed at the end of the swing, in m/s: downward at foot strike, upward at foot off.
    pub vertical: f64,
    /// Horizontal velocity, as a fraction of the mean velocity of the swing.
    pub along: f64,
    /// Time from foot strike until the foot is at rest, or from rest until foot off, in seconds. Before
    /// foot off, the ball rises in the last 60 % of it.
    pub time: f64,
}

impl EndMotion {
    /// The foot is at rest at the end of the swing: a careful step, or a foot that slides.
    pub const SOFT: EndMotion = EndMotion { vertical: 0.0, along: 0.0, time: 0.0 };
    /// Heel strike of a walk.
    pub const WALK_STRIKE: EndMotion = EndMotion { vertical: 0.45, along: 0.12, time: 0.025 };
    /// Foot off of a walk.
    pub const WALK_OFF: EndMotion = EndMotion { vertical: 0.6, along: 0.28, time: 0.08 };
    /// Foot strike of a run.
    pub const RUN_STRIKE: EndMotion = EndMotion { vertical: 0.5, along: 0.2, time: 0.03 };
    /// Foot off of a run.
    pub const RUN_OFF: EndMotion = EndMotion { vertical: 0.55, along: 0.14, time: 0.08 };

    /// Returns take-off and touch-down of a jump with a flight of `flight` seconds: the feet have the
    /// vertical speed of the body.
    pub fn jump(flight: f64) -> (EndMotion, EndMotion) {
        let vertical = 0.9 * GRAVITY * flight / 2.0;
        let take_off = EndMotion { vertical, along: 0.3, time: 0.08 };
        (take_off, EndMotion { time: 0.02, ..take_off })
    }

    /// Interpolates between this motion and `other` by the fraction `t`.
    pub fn blend(&self, other: &EndMotion, t: f64) -> EndMotion {
        EndMotion {
            vertical: lerp(self.vertical, other.vertical, t),
            along: lerp(self.along, other.along, t),
            time: lerp(self.time, other.time, t),
        }
    }
}

/// Prescribed poses of a leg relative to the body.
#[derive(Clone, Debug, PartialEq)]
pub struct LegPoses {
    /// Poses: position of the ankle outward of, above and ahead of the hip in leg lengths; pitch of
    /// the foot and outward rotation of the knee in degrees.
    pub poses: Track<5>,
    /// Time from toe-off until the leg reaches the poses, in seconds.
    pub ease_in: f64,
    /// Time before foot strike in which the leg leaves the poses, in seconds.
    pub ease_out: f64,
}

/// Landing of a foot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Landing {
    /// Pitch of the foot at the strike, in degrees: negative on the heel, positive on the ball.
    pub pitch: f64,
    /// Time from foot strike until the foot is at rest, in seconds.
    pub settle: f64,
    /// Pitch at rest, in degrees: 0 is flat, positive has the heel raised.
    pub rest: f64,
}

impl Landing {
    /// Heel strike, rolling to flat.
    pub const HEEL: Landing = Landing { pitch: -16.0, settle: 0.085, rest: 0.0 };
    /// Landing on the ball; the heel follows.
    pub const BALL: Landing = Landing { pitch: 22.0, settle: 0.11, rest: 0.0 };
    /// Landing on the whole sole.
    pub const FLAT: Landing = Landing { pitch: 0.0, settle: 0.0, rest: 0.0 };
}
