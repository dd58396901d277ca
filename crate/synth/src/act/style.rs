//! Ways of getting about.

use super::Carriage;
use crate::curve::Track;
use crate::plan::{ArmStyle, Carry, Gait, Held, Landing, Lift};

/// A way of getting about: the steps and how the body is carried.
#[derive(Clone, Debug, PartialEq)]
pub struct Style {
    /// The steps.
    pub gait: Gait,
    /// The body.
    pub carriage: Carriage,
    /// Share by which lengths and times of steps vary.
    pub vary: f64,
}

impl Style {
    /// Walking; `pace` 1 is an easy one, `scale` the walker's size.
    pub fn walk(scale: f64, pace: f64) -> Style {
        let walk = Gait::walk(scale);
        // Those in a hurry take longer steps and more of them.
        let (length, time) = (walk.length * pace.sqrt(), walk.time / pace.sqrt());
        let swing = walk.swing * time / walk.time;
        let carriage = Carriage { trunk: [2.0 + 2.0 * pace, 0.0, 0.0], ..Carriage::default() };
        Style { gait: Gait { time, length, swing, ..walk }, carriage, vary: 0.02 }
    }

    /// Jogging; `pace` 1 is an easy one, 1.5 a run.
    pub fn jog(scale: f64, pace: f64) -> Style {
        let jog = Gait::jog(scale);
        let gait = Gait {
            time: jog.time / pace.sqrt().sqrt(),
            length: jog.length * pace * 0.96,
            swing: jog.swing,
            carry: Carry { clearance: jog.carry.clearance * pace, ..jog.carry },
            ..jog
        };
        let carriage = Carriage { trunk: [8.0, 0.0, 0.0], arm_swing: 42.0, ..Carriage::default() };
        Style { gait, carriage: carriage.with_arms(ArmStyle::RUNNING.angles()), vary: 0.015 }
    }

    /// Sprinting on the balls of the feet: contacts of a tenth of a second.
    pub fn sprint(scale: f64) -> Style {
        let jog = Gait::jog(scale);
        let gait = Gait {
            time: 0.228,
            length: 1.62 * scale,
            width: 0.04 * scale,
            swing: 0.355,
            lift: Lift { pitch: 56.0, lead: 0.06 },
            carry: Carry { clearance: 0.4 * scale, peak: 0.42, pitch: 78.0, ramps: (0.34, 0.2), ..jog.carry },
            landing: Landing { pitch: 20.0, settle: 0.03, rest: 12.0 },
            ..jog
        };
        let carriage = Carriage { trunk: [11.0, 0.0, 0.0], arm_swing: 46.0, ..Carriage::default() };
        let arms = ArmStyle { elbow: 92.0, ..ArmStyle::RUNNING };
        Style { gait, carriage: carriage.with_arms(arms.angles()), vary: 0.015 }
    }

    /// Marching: stiff arms, knees high.
    pub fn march(scale: f64) -> Style {
        let walk = Gait::walk(scale);
        let held =
            Held { poses: Track::constant([0.0, -0.6, 0.24, 18.0, 0.0]), ease_in: 0.22, ease_out: 0.22 };
        let gait = Gait {
            time: 0.5,
            length: 0.52 * scale,
            swing: 0.44,
            lift: Lift { pitch: 36.0, lead: 0.16 },
            carry: Carry { held: Some(held), pitch: 18.0, clearance: 0.12 * scale, ..walk.carry },
            landing: Landing { pitch: 10.0, settle: 0.07, rest: 0.0 },
            ..walk
        };
        let arms = ArmStyle { elbow: 6.0, abduct: 6.0, ..ArmStyle::LOOSE };
        let carriage = Carriage { trunk: [0.0; 3], arm_swing: 95.0, ..Carriage::default() };
        Style { gait, carriage: carriage.with_arms(arms.angles()), vary: 0.01 }
    }

    /// Walking on the balls of the feet, the heels never down.
    pub fn tiptoe(scale: f64) -> Style {
        let walk = Gait::walk(scale);
        let gait = Gait {
            time: 0.5,
            length: 0.42 * scale,
            width: 0.05 * scale,
            swing: 0.38,
            lift: Lift { pitch: 46.0, lead: 0.18 },
            carry: Carry { pitch: 34.0, clearance: 0.06 * scale, ..walk.carry },
            landing: Landing { pitch: 36.0, settle: 0.09, rest: 29.0 },
            ..walk
        };
        let carriage = Carriage { trunk: [1.0, 0.0, 0.0], arm_swing: 14.0, ..Carriage::default() };
        let arms = ArmStyle { abduct: 26.0, elbow: 34.0, ..ArmStyle::LOOSE };
        Style { gait, carriage: carriage.with_arms(arms.angles()).sunk(-0.05), vary: 0.04 }
    }

    /// Walking backward.
    pub fn backward(scale: f64) -> Style {
        let walk = Gait::walk(scale);
        let gait = Gait {
            time: 0.58,
            length: -0.46 * scale,
            width: 0.09 * scale,
            swing: 0.42,
            lift: Lift { pitch: 8.0, lead: 0.1 },
            carry: Carry { clearance: 0.07 * scale, peak: 0.5, pitch: 18.0, ..walk.carry },
            landing: Landing { pitch: 24.0, settle: 0.16, rest: 0.0 },
            ..walk
        };
        let carriage =
            Carriage { trunk: [6.0, 0.0, 0.0], look: [0.0, 8.0], arm_swing: 16.0, ..Carriage::default() };
        Style { gait, carriage, vary: 0.05 }
    }

    /// Walking with bent knees and a bent back, as under a low ceiling.
    pub fn crouch(scale: f64) -> Style {
        let walk = Gait::walk(scale);
        let gait = Gait {
            time: 0.56,
            length: 0.5 * scale,
            width: 0.1 * scale,
            lift: Lift { pitch: 44.0, lead: 0.26 },
            carry: Carry { clearance: 0.06 * scale, pitch: 14.0, ..walk.carry },
            landing: Landing { pitch: -8.0, settle: 0.09, rest: 0.0 },
            ..walk
        };
        let carriage = Carriage { look: [0.0, -16.0], arm_swing: 20.0, ..Carriage::default() };
        let arms = ArmStyle { flex: 26.0, elbow: 44.0, ..ArmStyle::LOOSE };
        Style { gait, carriage: carriage.with_arms(arms.angles()).bent(42.0).sunk(0.2), vary: 0.03 }
    }

    /// Sneaking: slow high steps that feel for the ground with the ball of the foot.
    pub fn sneak(scale: f64) -> Style {
        let walk = Gait::walk(scale);
        let held =
            Held { poses: Track::constant([0.02, -0.6, 0.3, 12.0, 6.0]), ease_in: 0.4, ease_out: 0.42 };
        let gait = Gait {
            time: 1.1,
            length: 0.5 * scale,
            width: 0.08 * scale,
            swing: 0.84,
            lift: Lift { pitch: 40.0, lead: 0.3 },
            carry: Carry { held: Some(held), pitch: 22.0, clearance: 0.14 * scale, ..walk.carry },
            landing: Landing { pitch: 22.0, settle: 0.3, rest: 0.0 },
            ..walk
        };
        let carriage = Carriage { look: [0.0, 2.0], arm_swing: 10.0, ..Carriage::default() };
        let arms = ArmStyle { flex: 34.0, abduct: 22.0, elbow: 86.0, wrist: 30.0, ..ArmStyle::LOOSE };
        Style { gait, carriage: carriage.with_arms(arms.angles()).bent(26.0).sunk(0.09), vary: 0.08 }
    }

    /// The step with which someone sets off in this style, or comes to rest.
    pub fn first(&self, scale: f64) -> Gait {
        if self.gait.is_run() {
            let walk = Gait::walk(scale);
            Gait { length: 0.75 * walk.length, time: 0.5, ..walk }
        } else {
            Gait { length: 0.6 * self.gait.length, time: self.gait.time.max(0.52), ..self.gait.clone() }
        }
    }
}
