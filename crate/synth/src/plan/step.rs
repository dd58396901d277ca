//! A step: lift the foot from where it stands, carry it, put it down.

use crate::curve::{Track, rise};
use crate::maths::{Vec3, forward, leftward};

/// A place on the ground with a heading.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Metres to the left.
    pub x: f64,
    /// Metres up: where the ground is there.
    pub y: f64,
    /// Metres forward.
    pub z: f64,
    /// Radians turned to the left.
    pub heading: f64,
}

impl Place {
    /// The origin, heading forward.
    pub const ORIGIN: Place = Place { x: 0.0, y: 0.0, z: 0.0, heading: 0.0 };

    /// The place as a point on the ground.
    pub fn point(&self) -> Vec3 {
        Vec3::new(self.x, self.y, self.z)
    }

    /// The place `ahead` metres ahead and `left` metres to the left of this one,
    /// with the same heading.
    pub fn moved(&self, ahead: f64, left: f64) -> Place {
        let point = self.point() + ahead * forward(self.heading) + left * leftward(self.heading);
        Place { x: point.x, z: point.z, ..*self }
    }

    /// The place `ahead` metres along `heading` and `left` metres to the left of that,
    /// with the heading of this one.
    pub fn moved_to(&self, heading: f64, ahead: f64, left: f64) -> Place {
        Place { heading: self.heading, ..Place { heading, ..*self }.moved(ahead, left) }
    }

    /// The same place, `rise` metres higher.
    pub fn raised(&self, rise: f64) -> Place {
        Place { y: self.y + rise, ..*self }
    }

    /// The same place, turned `degrees` to the left.
    pub fn turned(&self, degrees: f64) -> Place {
        Place { heading: self.heading + degrees.to_radians(), ..*self }
    }
}

/// One step of one foot. The place is that of the ball of the foot.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// When the foot touches the ground, in seconds.
    pub strike: f64,
    /// How long it was in the air before, in seconds.
    pub swing: f64,
    /// Where it lands.
    pub place: Place,
    /// How it left the ground.
    pub lift: Lift,
    /// How it travels.
    pub carry: Carry,
    /// How it lands.
    pub landing: Landing,
    /// The share of the body's weight the foot takes when it stands alone: 1, or less
    /// for a foot that only rests on the ground.
    pub weight: f64,
}

impl Step {
    /// When the foot left the ground, in seconds.
    pub fn off(&self) -> f64 {
        self.strike - self.swing
    }

    /// The pose that the leg is held in at `time` and how far it is in it, 0 to 1.
    pub fn held(&self, time: f64) -> Option<([f64; 5], f64)> {
        let held = self.carry.held.as_ref()?;
        let share = rise(time, self.off(), self.off() + held.ease_in)
            * (1.0 - rise(time, self.strike - held.ease_out, self.strike));
        Some((held.poses.at(time), share))
    }
}

/// How a foot leaves the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lift {
    /// Pitch of the foot when the toe leaves, in degrees, heel up.
    pub pitch: f64,
    /// How long before that the heel begins to rise, in seconds.
    pub lead: f64,
}

/// How a foot travels through the air.
#[derive(Clone, Debug, PartialEq)]
pub struct Carry {
    /// Greatest extra height on the way, in metres.
    pub clearance: f64,
    /// Where on the way that is, 0 to 1.
    pub peak: f64,
    /// Pitch of the foot in mid-swing, in degrees, heel up.
    pub pitch: f64,
    /// Where on the way that is, 0 to 1.
    pub pitch_at: f64,
    /// Shares of the way spent on speeding up and on slowing down.
    pub ramps: (f64, f64),
    /// Detour to the outside, in metres (the left foot's left).
    pub detour: f64,
    /// The foot stays on the ground on its way: it is dragged or it slides.
    pub grounded: bool,
    /// The share of the body's weight it bears on its way: 0 but for a slide.
    pub load: f64,
    /// A pose of the leg that the swing passes through.
    pub held: Option<Held>,
}

/// A leg posed relative to the body while its foot is in the air.
#[derive(Clone, Debug, PartialEq)]
pub struct Held {
    /// The poses: the ankle outward of, above and ahead of the hip in leg lengths, pitch
    /// of the foot and outward turn of the knee in degrees.
    pub poses: Track<5>,
    /// Seconds from the lift until the leg is in the first pose.
    pub ease_in: f64,
    /// Seconds from the last pose's end until the landing.
    pub ease_out: f64,
}

/// How a foot lands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Landing {
    /// Pitch of the foot at the strike, in degrees: negative on the heel, positive on
    /// the ball.
    pub pitch: f64,
    /// How long the foot takes to come to rest, in seconds.
    pub settle: f64,
    /// The pitch at rest, in degrees: 0 is flat, positive keeps the heel up.
    pub rest: f64,
}

impl Landing {
    /// On the heel, rolling flat.
    pub const HEEL: Landing = Landing { pitch: -18.0, settle: 0.11, rest: 0.0 };
    /// On the ball, the heel following.
    pub const BALL: Landing = Landing { pitch: 22.0, settle: 0.11, rest: 0.0 };
    /// On the whole sole at once.
    pub const FLAT: Landing = Landing { pitch: 0.0, settle: 0.0, rest: 0.0 };
}
