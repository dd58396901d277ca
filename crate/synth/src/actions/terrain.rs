//! Obstacles, stairs, stumbling and dragging a leg.

use super::{Actor, GaitStyle, Posture, opposite};
use crate::math::Track;
use crate::plan::{EndMotion, Gait, Landing, LegPoses, Lift, SwingPath};

/// Rise and tread of a stair, in metres.
const RISE: f64 = 0.17;
const TREAD: f64 = 0.29;

impl Actor<'_> {
    /// Steps over an obstacle of knee height while moving in `style`, one foot after the other.
    pub fn step_over(&mut self, style: &GaitStyle) {
        let gait = &style.gait;
        let scale = self.scale;
        let approach = self.now();
        self.set_posture(approach - 0.3, &style.posture);
        for (length, leg_pose) in [(0.74, [0.0, -0.5, 0.38, 4.0, 4.0]), (0.5, [0.03, -0.52, 0.1, 26.0, 14.0])]
        {
            let leg_poses = LegPoses { poses: Track::constant(leg_pose), ease_in: 0.32, ease_out: 0.34 };
            let over = Gait {
                time: 0.86,
                length: length * scale,
                swing: 0.72,
                swing_path: SwingPath {
                    clearance: 0.34 * scale,
                    peak: 0.5,
                    leg_poses: Some(leg_poses),
                    ..gait.swing_path.clone()
                },
                landing: Landing { pitch: -6.0, settle: 0.09, rest: 0.0 },
                ..gait.clone()
            };
            self.take_step(&over);
        }
        let over = Posture { gaze: [0.0, 34.0], ..style.posture.bent_forward(12.0) };
        let over = over.with_arms([10.0, 34.0, 14.0, 42.0, 0.0]);
        self.set_posture(approach + 0.4, &over);
        self.set_posture(self.now() - 0.3, &over);
        self.set_posture(self.now() + 0.5, &style.posture);
    }

    /// Stumbles while moving in `style`: falls forward and recovers with three quick steps.
    pub fn stumble(&mut self, style: &GaitStyle) {
        let (gait, scale) = (&style.gait, self.scale);
        let tripped = self.now() + 0.25;
        self.set_posture(tripped - 0.1, &style.posture);
        let low_swing =
            SwingPath { clearance: 0.03 * scale, peak: 0.6, ramps: (0.2, 0.2), ..gait.swing_path.clone() };
        let steps =
            [(0.7, 0.46, 0.5, 0.0), (0.34, 0.74, 0.36, 8.0), (0.33, 0.72, 0.36, 12.0), (0.4, 0.6, 0.38, 6.0)];
        for (n, (time, length, swing, pitch)) in steps.into_iter().enumerate() {
            let swing_path = if n == 0 {
                low_swing.clone()
            } else {
                SwingPath { clearance: 0.1 * scale, ..gait.swing_path.clone() }
            };
            self.take_step(&Gait {
                time,
                length: length * scale,
                swing,
                width: 0.09 * scale,
                swing_path,
                landing: Landing { pitch, settle: 0.07, rest: 0.0 },
                ..gait.clone()
            });
        }
        let falling = Posture { gaze: [0.0, 14.0], ..style.posture };
        let arms_forward =
            falling.with_arms([56.0, 44.0, 10.0, 40.0, -20.0]).bent_forward(44.0).lowered(0.05);
        self.set_posture(tripped + 0.35, &arms_forward);
        self.set_posture(
            tripped + 0.7,
            &falling.with_arms([20.0, 52.0, 6.0, 54.0, -10.0]).bent_forward(36.0).lowered(0.06),
        );
        self.set_posture(self.now() + 0.5, &style.posture);
    }

    /// Climbs `count` stairs.
    pub fn climb(&mut self, count: usize) {
        self.stop();
        self.set_posture(self.now(), &Posture::default());
        let walk = Gait::walk(self.scale);
        let climb = Gait {
            time: 0.62,
            length: TREAD,
            width: 0.08 * self.scale,
            swing: 0.46,
            lift: Lift { pitch: 36.0, lead: 0.2 },
            swing_path: SwingPath {
                clearance: 0.11,
                peak: 0.42,
                pitch: 12.0,
                pitch_at: 0.5,
                ramps: (0.4, 0.25),
                ..walk.swing_path
            },
            landing: Landing { pitch: 7.0, settle: 0.08, rest: 0.0 },
            ..walk
        };
        let climbing =
            Posture { gaze: [0.0, 22.0], arm_swing: 22.0, ..Posture::default() }.bent_forward(12.0);
        for n in 0..count {
            self.planner.climb(RISE);
            let time = climb.time * self.random.vary(0.03);
            self.take_step(&Gait { time, ..climb.clone() });
            if n == 1 {
                self.set_posture(self.now(), &climbing);
            }
        }
        self.set_posture(self.now(), &climbing);
        self.close_feet(&climb);
        self.set_posture(self.now() + 0.4, &Posture::default());
        self.wait(0.5);
    }

    /// Drags one leg without lifting it until time `until`; the other leg takes the steps.
    pub fn drag(&mut self, until: f64) {
        let (stepping, dragged) = (self.side, opposite(self.side));
        let walk = Gait::walk(self.scale);
        let length = 0.36 * self.scale;
        let step = Gait {
            time: 1.15,
            length: 0.0,
            swing: 0.42,
            lift: Lift { pitch: 34.0, lead: 0.2 },
            swing_path: SwingPath {
                take_off: EndMotion::SOFT,
                touch_down: EndMotion::SOFT,
                ..walk.swing_path.clone()
            },
            landing: Landing { pitch: -10.0, settle: 0.1, rest: 0.0 },
            ..walk.clone()
        };
        let dragging = SwingPath {
            clearance: 0.0,
            pitch: 26.0,
            ramps: (0.0, 0.0),
            detour: 0.0,
            grounded: true,
            load: 0.35,
            leg_poses: None,
            ..walk.swing_path
        };
        let limp = Posture { gaze: [0.0, 14.0], arm_swing: 20.0, ..Posture::default() }.bent_forward(10.0);
        self.set_posture(self.now(), &limp);
        // The dragged foot slides fast during the stance of the other leg and slowly during its
        // swing.
        let mut free = self.now() + 0.1;
        let mut dragged_placement = self.planner.placement(dragged);
        while self.now() < until {
            let vary = self.random.vary(0.06);
            self.side = stepping;
            self.planner.advance(length * vary, 0.0);
            self.take_step(&step);
            let strike = self.now();
            for (end, fraction) in [(strike, 0.22), (strike + step.time - step.swing, 0.78)] {
                dragged_placement = dragged_placement.translated_along(
                    self.planner.cursor().heading,
                    fraction * length * vary,
                    0.0,
                );
                let pitch = Landing { pitch: 26.0, settle: 0.0, rest: 26.0 };
                let drag = Gait {
                    swing: end - free,
                    lift: Lift { pitch: 26.0, lead: 0.0 },
                    swing_path: dragging.clone(),
                    landing: pitch,
                    ..walk.clone()
                };
                self.planner.place_foot(dragged, end, dragged_placement, &drag);
                free = end;
            }
            let dragging_posture =
                |pitch, lean| Posture { trunk: [pitch, 0.0, lean], pelvis: [4.0, 0.0, -0.7 * lean], ..limp };
            let lean = if stepping == plantigrade::foot::Side::Left { 8.0 } else { -8.0 };
            self.set_posture(strike - 0.1, &dragging_posture(8.0, -0.3 * lean));
            self.set_posture(strike + 0.4, &dragging_posture(14.0, lean));
        }
    }
}
