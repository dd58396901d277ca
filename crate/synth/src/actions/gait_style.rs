//! Styles of locomotion.

use super::Posture;
use crate::math::Track;
use crate::plan::{ArmPose, EndMotion, Gait, Landing, LegPoses, Lift, SwingPath};

/// Style of locomotion: steps and posture.
#[derive(Clone, Debug, PartialEq)]
pub struct GaitStyle {
    /// Parameters of a step.
    pub gait: Gait,
    /// Posture of the body.
    pub posture: Posture,
    /// Relative standard deviation of step lengths; step times vary by 0.7 of it.
    pub variation: f64,
}

impl GaitStyle {
    /// Returns walking; `pace` 1 is comfortable, `scale` is the size of the walker.
    pub fn walk(scale: f64, pace: f64) -> GaitStyle {
        let walk = Gait::walk(scale);
        // Both step length and cadence grow with speed.
        let (length, time) = (walk.length * pace.sqrt(), walk.time / pace.sqrt());
        let swing = walk.swing * time / walk.time;
        let posture = Posture { trunk: [2.0 + 2.0 * pace, 0.0, 0.0], ..Posture::default() };
        GaitStyle { gait: Gait { time, length, swing, ..walk }, posture, variation: 0.02 }
    }

    /// Returns jogging; `pace` 1 is comfortable, 1.5 a run.
    pub fn jog(scale: f64, pace: f64) -> GaitStyle {
        let jog = Gait::jog(scale);
        let gait = Gait {
            time: jog.time / pace.sqrt().sqrt(),
            length: jog.length * pace * 0.96,
            swing: jog.swing,
            swing_path: SwingPath { clearance: jog.swing_path.clearance * pace, ..jog.swing_path },
            ..jog
        };
        let posture = Posture { trunk: [8.0, 0.0, 0.0], arm_swing: 42.0, ..Posture::default() };
        GaitStyle { gait, posture: posture.with_arms(ArmPose::RUNNING.angles()), variation: 0.015 }
    }

    /// Returns sprinting on the balls of the feet, with contacts of 0.1 s.
    pub fn sprint(scale: f64) -> GaitStyle {
        let jog = Gait::jog(scale);
        let gait = Gait {
            time: 0.228,
            length: 1.62 * scale,
            width: 0.04 * scale,
            swing: 0.355,
            lift: Lift { pitch: 56.0, lead: 0.06 },
            swing_path: SwingPath {
                clearance: 0.4 * scale,
                peak: 0.42,
                pitch: 78.0,
                ramps: (0.34, 0.2),
                ..jog.swing_path
            },
            landing: Landing { pitch: 20.0, settle: 0.03, rest: 12.0 },
            ..jog
        };
        let posture = Posture { trunk: [11.0, 0.0, 0.0], arm_swing: 46.0, ..Posture::default() };
        let arms = ArmPose { elbow: 92.0, ..ArmPose::RUNNING };
        GaitStyle { gait, posture: posture.with_arms(arms.angles()), variation: 0.015 }
    }

    /// Returns marching: stiff arms, high knees.
    pub fn march(scale: f64) -> GaitStyle {
        let walk = Gait::walk(scale);
        let leg_poses =
            LegPoses { poses: Track::constant([0.0, -0.6, 0.24, 18.0, 0.0]), ease_in: 0.22, ease_out: 0.22 };
        let gait = Gait {
            time: 0.5,
            length: 0.52 * scale,
            swing: 0.44,
            lift: Lift { pitch: 36.0, lead: 0.16 },
            swing_path: SwingPath {
                leg_poses: Some(leg_poses),
                pitch: 18.0,
                clearance: 0.12 * scale,
                ..walk.swing_path
            },
            landing: Landing { pitch: 10.0, settle: 0.07, rest: 0.0 },
            ..walk
        };
        let arms = ArmPose { elbow: 6.0, abduction: 6.0, ..ArmPose::RELAXED };
        let posture = Posture { trunk: [0.0; 3], arm_swing: 95.0, ..Posture::default() };
        GaitStyle { gait, posture: posture.with_arms(arms.angles()), variation: 0.01 }
    }

    /// Returns walking on the balls of the feet; the heels never touch the ground.
    pub fn tiptoe(scale: f64) -> GaitStyle {
        let walk = Gait::walk(scale);
        let gait = Gait {
            time: 0.5,
            length: 0.42 * scale,
            width: 0.05 * scale,
            swing: 0.38,
            lift: Lift { pitch: 46.0, lead: 0.18 },
            swing_path: SwingPath {
                pitch: 34.0,
                clearance: 0.06 * scale,
                touch_down: EndMotion::SOFT,
                ..walk.swing_path
            },
            landing: Landing { pitch: 36.0, settle: 0.09, rest: 29.0 },
            ..walk
        };
        let posture = Posture { trunk: [1.0, 0.0, 0.0], arm_swing: 14.0, ..Posture::default() };
        let arms = ArmPose { abduction: 26.0, elbow: 34.0, ..ArmPose::RELAXED };
        GaitStyle { gait, posture: posture.with_arms(arms.angles()).lowered(-0.05), variation: 0.04 }
    }

    /// Returns backward walking.
    pub fn backward(scale: f64) -> GaitStyle {
        let walk = Gait::walk(scale);
        let gait = Gait {
            time: 0.58,
            length: -0.46 * scale,
            width: 0.09 * scale,
            swing: 0.42,
            lift: Lift { pitch: 8.0, lead: 0.1 },
            swing_path: SwingPath { clearance: 0.07 * scale, peak: 0.5, pitch: 18.0, ..walk.swing_path },
            landing: Landing { pitch: 24.0, settle: 0.16, rest: 0.0 },
            ..walk
        };
        let posture =
            Posture { trunk: [6.0, 0.0, 0.0], gaze: [0.0, 8.0], arm_swing: 16.0, ..Posture::default() };
        GaitStyle { gait, posture, variation: 0.05 }
    }

    /// Returns walking with bent knees and a bent back, as under a low ceiling.
    pub fn crouch(scale: f64) -> GaitStyle {
        let walk = Gait::walk(scale);
        let gait = Gait {
            time: 0.56,
            length: 0.5 * scale,
            width: 0.1 * scale,
            lift: Lift { pitch: 44.0, lead: 0.26 },
            swing_path: SwingPath { clearance: 0.06 * scale, pitch: 14.0, ..walk.swing_path },
            landing: Landing { pitch: -8.0, settle: 0.09, rest: 0.0 },
            ..walk
        };
        let posture = Posture { gaze: [0.0, -16.0], arm_swing: 20.0, ..Posture::default() };
        let arms = ArmPose { flexion: 26.0, elbow: 44.0, ..ArmPose::RELAXED };
        GaitStyle {
            gait,
            posture: posture.with_arms(arms.angles()).bent_forward(42.0).lowered(0.2),
            variation: 0.03,
        }
    }

    /// Returns sneaking: slow high steps that land on the ball of the foot.
    pub fn sneak(scale: f64) -> GaitStyle {
        let walk = Gait::walk(scale);
        let leg_poses =
            LegPoses { poses: Track::constant([0.02, -0.6, 0.3, 12.0, 6.0]), ease_in: 0.4, ease_out: 0.42 };
        let gait = Gait {
            time: 1.1,
            length: 0.5 * scale,
            width: 0.08 * scale,
            swing: 0.84,
            lift: Lift { pitch: 40.0, lead: 0.3 },
            swing_path: SwingPath {
                leg_poses: Some(leg_poses),
                pitch: 22.0,
                clearance: 0.14 * scale,
                take_off: EndMotion::SOFT,
                touch_down: EndMotion::SOFT,
                ..walk.swing_path
            },
            landing: Landing { pitch: 22.0, settle: 0.3, rest: 0.0 },
            ..walk
        };
        let posture = Posture { gaze: [0.0, 2.0], arm_swing: 10.0, ..Posture::default() };
        let arms = ArmPose { flexion: 34.0, abduction: 22.0, elbow: 86.0, wrist: 30.0, ..ArmPose::RELAXED };
        GaitStyle {
            gait,
            posture: posture.with_arms(arms.angles()).bent_forward(26.0).lowered(0.09),
            variation: 0.08,
        }
    }

    /// Returns the first step from standing, which is also the last before stopping.
    pub fn first_step(&self, scale: f64) -> Gait {
        if self.gait.is_run() {
            let walk = Gait::walk(scale);
            Gait { length: 0.75 * walk.length, time: 0.5, ..walk }
        } else {
            Gait { length: 0.6 * self.gait.length, time: self.gait.time.max(0.52), ..self.gait.clone() }
        }
    }
}
