//! How trunk, head and arms are carried.

use plantigrade::foot::Side;

use crate::curve::Track;

/// The carriage of the body over time. Angles in degrees, lengths in metres.
///
/// What follows from the feet by itself (the pelvis turning and dropping with the
/// steps, shoulders and arms against it) needs no keys here: only its strength.
#[derive(Clone, Debug)]
pub struct Body {
    /// How far the pelvis is lowered: knees bent.
    pub sink: Track<1>,
    /// The trunk relative to upright: forward, left turn, lean to the left.
    pub trunk: Track<3>,
    /// The pelvis: forward tilt, left turn, lean to the left, besides what follows
    /// from the feet.
    pub pelvis: Track<3>,
    /// Shift of the pelvis against the line of balance: left, forward.
    pub shift: Track<2>,
    /// Where the eyes go: left turn against the way ahead, down.
    pub look: Track<2>,
    /// The arms, left and right: [`ArmStyle`] as numbers.
    pub arms: [Track<5>; 2],
    /// Swing of the arms with the steps, in degrees per metre that the other foot is ahead.
    pub arm_swing: Track<1>,
    /// Turn of the pelvis with the steps, in degrees per metre.
    pub pelvis_turn: f64,
    /// Drop of the pelvis on the free side, in degrees.
    pub pelvis_drop: f64,
    /// Rise of the pelvis over a standing leg while walking, in metres.
    pub bob: f64,
    /// Restlessness of trunk, head and arms, in degrees.
    pub sway: f64,
}

/// The pose of one arm, in degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArmStyle {
    /// Upper arm forward of hanging.
    pub flex: f64,
    /// Upper arm out to its side.
    pub abduct: f64,
    /// Upper arm turned inward about its length.
    pub twist: f64,
    /// Bend of the elbow.
    pub elbow: f64,
    /// Bend of the wrist toward the palm.
    pub wrist: f64,
}

impl ArmStyle {
    /// Hanging loose.
    pub const LOOSE: ArmStyle = ArmStyle { flex: 2.0, abduct: 9.0, twist: 18.0, elbow: 16.0, wrist: 8.0 };
    /// Bent for running.
    pub const RUNNING: ArmStyle = ArmStyle { flex: -8.0, abduct: 14.0, twist: 22.0, elbow: 82.0, wrist: 4.0 };

    /// The angles in the order of [`Body::arms`].
    pub fn angles(self) -> [f64; 5] {
        [self.flex, self.abduct, self.twist, self.elbow, self.wrist]
    }
}

impl Default for Body {
    fn default() -> Body {
        Body {
            sink: Track::constant([0.0]),
            trunk: Track::constant([3.0, 0.0, 0.0]),
            pelvis: Track::constant([2.0, 0.0, 0.0]),
            shift: Track::constant([0.0, 0.0]),
            look: Track::constant([0.0, 4.0]),
            arms: [ArmStyle::LOOSE; 2].map(|arm| Track::constant(arm.angles())),
            arm_swing: Track::constant([30.0]),
            pelvis_turn: 10.0,
            pelvis_drop: 4.0,
            bob: 0.02,
            sway: 1.0,
        }
    }
}

impl Body {
    /// Keys for one arm.
    pub fn arm(&mut self, side: Side, keys: &[(f64, [f64; 5])]) {
        self.arms[side as usize] = Track::of(keys);
    }
}
