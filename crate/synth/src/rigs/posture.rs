//! Postures of a body: angles of its joints over time.

use nalgebra::{Rotation3, Unit, Vector3};
use plantigrade::foot::Side;

use super::bone::Bone;

/// What a body does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Posture {
    /// Walks forward.
    Walks,
    /// Stands.
    Stands,
    /// Sits on a chair.
    SitsOnChair,
    /// Sits on the ground with stretched legs.
    SitsOnGround,
    /// Sits on the ground with crossed legs.
    SitsCrossLegged,
    /// Lies on the back and moves the legs.
    LiesOnBack,
    /// Lies on the front.
    LiesOnFront,
    /// Crawls on hands and knees.
    Crawls,
    /// Squats and rises.
    Squats,
}

impl Posture {
    /// All postures.
    pub const ALL: [Posture; 9] = [
        Posture::Walks,
        Posture::Stands,
        Posture::SitsOnChair,
        Posture::SitsOnGround,
        Posture::SitsCrossLegged,
        Posture::LiesOnBack,
        Posture::LiesOnFront,
        Posture::Crawls,
        Posture::Squats,
    ];

    /// True if trunk and legs point up.
    pub fn is_upright(self) -> bool {
        matches!(self, Posture::Walks | Posture::Stands | Posture::Squats)
    }
}

/// Angles of a pose, in radians about X; positive turns a hanging limb backwards.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Angles {
    root: f64,
    thighs: [f64; 2],
    /// Rotation of the thighs outwards.
    spread: f64,
    shanks: [f64; 2],
    feet: [f64; 2],
    /// Rotation of stretched arms downwards.
    lowered: f64,
    /// Rotation of stretched arms forwards.
    forward: [f64; 2],
}

impl Angles {
    /// Returns the pose of a posture at a phase of its cycle, in radians.
    pub fn of(posture: Posture, phase: f64) -> Angles {
        use std::f64::consts::{FRAC_PI_2, PI};
        let swing = [phase.sin(), (phase + PI).sin()];
        let lift = [phase.cos().max(0.0), (phase + PI).cos().max(0.0)];
        let stand = Angles { lowered: 1.2, ..Angles::default() };
        match posture {
            Posture::Walks => Angles {
                thighs: swing.map(|swing| -0.45 * swing),
                shanks: lift.map(|lift| 0.9 * lift),
                feet: [0, 1].map(|side| 0.45 * swing[side] - 0.9 * lift[side]),
                ..stand
            },
            Posture::Stands => stand,
            Posture::SitsOnChair => Angles { thighs: [-1.5; 2], shanks: [1.5; 2], ..stand },
            Posture::SitsOnGround => Angles { thighs: [-1.5; 2], ..stand },
            Posture::SitsCrossLegged => Angles { thighs: [-1.6; 2], spread: 0.9, shanks: [2.2; 2], ..stand },
            Posture::LiesOnBack => {
                Angles { root: -FRAC_PI_2, thighs: lift.map(|lift| -lift), shanks: lift, ..stand }
            }
            Posture::LiesOnFront => Angles { root: FRAC_PI_2, feet: [0.9; 2], ..stand },
            Posture::Crawls => Angles {
                root: FRAC_PI_2,
                thighs: swing.map(|swing| -FRAC_PI_2 - 0.25 * swing),
                shanks: [FRAC_PI_2; 2],
                feet: [0.9; 2],
                forward: [swing[1], swing[0]].map(|swing| FRAC_PI_2 + 0.2 * swing),
                ..Angles::default()
            },
            Posture::Squats => {
                let depth = 0.5 - 0.5 * phase.cos();
                Angles {
                    thighs: [-1.1 * depth; 2],
                    shanks: [1.7 * depth; 2],
                    feet: [-0.6 * depth; 2],
                    ..stand
                }
            }
        }
    }

    pub fn blend(self, other: Angles, part: f64) -> Angles {
        let mix = |a: f64, b: f64| a + (b - a) * part;
        let both = |a: [f64; 2], b: [f64; 2]| [mix(a[0], b[0]), mix(a[1], b[1])];
        Angles {
            root: mix(self.root, other.root),
            thighs: both(self.thighs, other.thighs),
            spread: mix(self.spread, other.spread),
            shanks: both(self.shanks, other.shanks),
            feet: both(self.feet, other.feet),
            lowered: mix(self.lowered, other.lowered),
            forward: both(self.forward, other.forward),
        }
    }

    /// Returns the rotation of a bone.
    pub fn rotation(&self, bone: Bone) -> Rotation3<f64> {
        let about = |axis: Vector3<f64>, angle| Rotation3::from_axis_angle(&Unit::new_normalize(axis), angle);
        let x = |angle| about(Vector3::x(), angle);
        let at = |side: Side| usize::from(side == Side::Right);
        let sign = |side: Side| if side == Side::Left { 1.0 } else { -1.0 };
        match bone {
            Bone::Hips => x(self.root),
            Bone::Thigh(side, 0) | Bone::Hind(side, 0) => {
                about(Vector3::y(), sign(side) * self.spread) * x(self.thighs[at(side)])
            }
            Bone::Shank(side, 0) | Bone::Hind(side, 1) => x(self.shanks[at(side)]),
            Bone::Ankle(side) => x(self.feet[at(side)]),
            Bone::Fore(side, 0) => x(-self.thighs[at(side)]),
            Bone::Arm(side, 1) => {
                about(Vector3::z(), -sign(side) * self.lowered)
                    * about(Vector3::y(), -sign(side) * self.forward[at(side)])
            }
            _ => Rotation3::identity(),
        }
    }
}
