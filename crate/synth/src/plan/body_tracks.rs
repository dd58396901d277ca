//! Animation tracks of pelvis, trunk, head and arms.

use plantigrade::foot::Side;

use crate::math::Track;

/// Posture of the body over time. Angles in degrees, lengths in metres.
///
/// Movements that follow from the feet (rotation and drop of the pelvis with the steps,
/// counter-rotation of shoulders and arms) need no keyframes; only their amplitudes are given here.
#[derive(Clone, Debug)]
pub struct BodyTracks {
    /// Lowering of the pelvis; bends the knees.
    pub lowering: Track<1>,
    /// Trunk relative to upright: forward pitch, left rotation, left lean.
    pub trunk: Track<3>,
    /// Pelvis: forward tilt, left rotation, left lean, added to the movements that follow from the
    /// feet.
    pub pelvis: Track<3>,
    /// Horizontal shift of the pelvis relative to the balance: left, forward.
    pub shift: Track<2>,
    /// Gaze direction relative to the heading: left, down.
    pub gaze: Track<2>,
    /// Left and right arm, as [`ArmPose::angles`].
    pub arms: [Track<5>; 2],
    /// Arm swing with the steps, in degrees per metre that the other foot is ahead.
    pub arm_swing: Track<1>,
    /// Pelvic rotation with the steps, in degrees per metre.
    pub pelvic_rotation: f64,
    /// Drop of the pelvis on the unloaded side, in degrees.
    pub pelvic_drop: f64,
    /// Rise of the pelvis over a standing leg during walking, in metres.
    pub vertical_excursion: f64,
    /// Amplitude of the idle noise of trunk, head and arms, in degrees.
    pub sway: f64,
}

/// Pose of one arm, in degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArmPose {
    /// Forward flexion of the upper arm from hanging.
    pub flexion: f64,
    /// Abduction of the upper arm.
    pub abduction: f64,
    /// Internal rotation of the upper arm about its axis.
    pub twist: f64,
    /// Flexion of the elbow.
    pub elbow: f64,
    /// Flexion of the wrist.
    pub wrist: f64,
}

impl ArmPose {
    /// Relaxed, hanging.
    pub const RELAXED: ArmPose =
        ArmPose { flexion: 2.0, abduction: 9.0, twist: 18.0, elbow: 16.0, wrist: 8.0 };
    /// Bent for running.
    pub const RUNNING: ArmPose =
        ArmPose { flexion: -8.0, abduction: 14.0, twist: 22.0, elbow: 82.0, wrist: 4.0 };

    /// Returns the angles in the order of [`BodyTracks::arms`].
    pub fn angles(self) -> [f64; 5] {
        [self.flexion, self.abduction, self.twist, self.elbow, self.wrist]
    }
}

impl Default for BodyTracks {
    fn default() -> BodyTracks {
        BodyTracks {
            lowering: Track::constant([0.0]),
            trunk: Track::constant([3.0, 0.0, 0.0]),
            pelvis: Track::constant([2.0, 0.0, 0.0]),
            shift: Track::constant([0.0, 0.0]),
            gaze: Track::constant([0.0, 4.0]),
            arms: [ArmPose::RELAXED; 2].map(|arm| Track::constant(arm.angles())),
            arm_swing: Track::constant([30.0]),
            pelvic_rotation: 10.0,
            pelvic_drop: 4.0,
            vertical_excursion: 0.02,
            sway: 1.0,
        }
    }
}

impl BodyTracks {
    /// Replaces the track of one arm.
    pub fn arm(&mut self, side: Side, keys: &[(f64, [f64; 5])]) {
        self.arms[side as usize] = Track::from_keys(keys);
    }
}
