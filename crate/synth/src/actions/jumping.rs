//! Jumping on both feet and on one.

use plantigrade::foot::Side::{self, Left};

use super::{Actor, GaitStyle, HALF_STANCE_WIDTH, Posture, opposite};
use crate::math::GRAVITY;
use crate::math::Track;
use crate::plan::{EndMotion, Gait, Jump, Landing, LegPoses, Lift, SwingPath, foot_placement};

/// Arm poses before a jump, at its apex and after it.
const BACK: [f64; 5] = [-44.0, 16.0, 10.0, 14.0, 0.0];
const UP: [f64; 5] = [124.0, 14.0, 12.0, 26.0, -6.0];
const FRONT: [f64; 5] = [34.0, 14.0, 22.0, 36.0, 0.0];

/// Free leg during hops: shank behind, level with the knee.
const TUCKED: [f64; 5] = [0.02, -0.68, -0.34, 60.0, 0.0];

impl Actor<'_> {
    /// Returns a jump with `ground` seconds on the ground and `flight` in the air.
    fn vertical_jump(&self, ground: f64, flight: f64) -> Jump {
        let walk = Gait::walk(self.scale);
        let (take_off, touch_down) = EndMotion::jump(flight);
        Jump {
            ground,
            flight,
            length: 0.0,
            turn: 0.0,
            width: HALF_STANCE_WIDTH * self.scale,
            lift: Lift { pitch: 58.0, lead: 0.18_f64.min(0.5 * ground) },
            swing_path: SwingPath {
                // The feet rise about as high as the body does.
                clearance: 0.9 * GRAVITY * flight * flight / 8.0,
                peak: 0.5,
                pitch: 32.0,
                pitch_at: 0.5,
                ramps: (0.25, 0.25),
                detour: 0.0,
                take_off,
                touch_down,
                ..walk.swing_path
            },
            landing: Landing { pitch: 18.0, settle: 0.09, rest: 0.0 },
        }
    }

    /// Jumps up `count` times with both feet.
    pub fn jump_up(&mut self, count: usize) {
        self.stop();
        self.set_posture(self.now(), &Posture::default());
        for n in 0..count {
            let ground = if n == 0 { 0.85 } else { 0.62 * self.random.vary(0.05) };
            let flight = 0.42 * self.random.vary(0.06);
            let hop = self.vertical_jump(ground, flight);
            self.planner.jump(&Side::BOTH, &hop);
            self.swing_arms_for_jump(self.now() - flight, self.now(), 36.0);
        }
        self.recover();
    }

    /// Adds the crouch and the arm swing of a jump from `off` to `land`; the trunk bends by `bend`
    /// degrees before it.
    fn swing_arms_for_jump(&mut self, off: f64, land: f64, bend: f64) {
        let ease = Posture { arm_swing: 0.0, ..Posture::default() };
        self.set_posture(off - 0.3, &ease.with_arms(BACK).bent_forward(bend));
        self.set_posture(off + 0.02, &ease.with_arms(UP).bent_forward(4.0));
        self.set_posture(land + 0.12, &ease.with_arms(FRONT).bent_forward(0.6 * bend));
    }

    /// Returns to relaxed standing.
    fn recover(&mut self) {
        self.wait(0.75);
        self.set_posture(self.now(), &Posture::default());
        self.wait(0.1);
    }

    /// Performs `count` jumping jacks.
    pub fn jumping_jacks(&mut self, count: usize) {
        self.stop();
        let ease = Posture { arm_swing: 0.0, ..Posture::default() };
        self.set_posture(self.now(), &Posture::default());
        for n in 0..2 * count {
            let out = n % 2 == 0;
            let ground = if n == 0 { 0.6 } else { 0.23 * self.random.vary(0.05) };
            let flight = 0.2 * self.random.vary(0.06);
            let width = if out { 0.27 } else { HALF_STANCE_WIDTH } * self.scale;
            let hop = Jump {
                width,
                lift: Lift { pitch: 34.0, lead: 0.12 },
                landing: Landing { pitch: 14.0, settle: 0.07, rest: 0.0 },
                ..self.vertical_jump(ground, flight)
            };
            self.planner.jump(&Side::BOTH, &hop);
            let arm = if out { [6.0, 158.0, 0.0, 14.0, 0.0] } else { [4.0, 12.0, 10.0, 14.0, 4.0] };
            if n == 0 {
                self.set_posture(self.now() - flight - 0.06, &ease.bent_forward(8.0));
            }
            self.set_posture(self.now() + 0.06, &ease.with_arms(arm));
        }
        self.recover();
    }

    /// Hops `count` times on `foot`, `length` metres each.
    pub fn hop_on(&mut self, foot: Side, count: usize, length: f64) {
        self.stop();
        let (start, free) = (self.now(), opposite(foot));
        self.set_posture(start, &Posture::default());
        self.wait(0.85);
        let arms = [8.0, 40.0, 16.0, 56.0, 0.0];
        let ease = Posture { arm_swing: 6.0, ..Posture::default() };
        self.set_posture(start + 0.7, &ease.with_arms(arms).bent_forward(8.0));
        for _ in 0..count {
            let hop = self.hop(length);
            let flight = hop.flight;
            self.planner.jump(&[foot], &hop);
            let land = self.now();
            self.set_posture(
                land - flight - 0.1,
                &ease.with_arms([-8.0, 36.0, 14.0, 46.0, 0.0]).bent_forward(10.0),
            );
            self.set_posture(
                land - flight / 2.0,
                &ease.with_arms([24.0, 46.0, 18.0, 64.0, 0.0]).bent_forward(7.0),
            );
        }
        let strike = self.now() + 0.7;
        let cursor = self.planner.cursor();
        let placement = foot_placement(&cursor, free, HALF_STANCE_WIDTH * self.scale, 8.0);
        let walk = Gait::walk(self.scale);
        let step = self.planner.place_foot(free, strike, placement, &walk);
        step.swing = strike - start - 0.35;
        step.lift = Lift { pitch: 36.0, lead: 0.2 };
        step.landing = Landing { pitch: 12.0, settle: 0.1, rest: 0.0 };
        step.swing_path.leg_poses =
            Some(LegPoses { poses: Track::constant(TUCKED), ease_in: 0.4, ease_out: 0.45 });
        self.wait(0.7);
        self.recover();
    }

    /// Returns one hop on one foot.
    fn hop(&mut self, length: f64) -> Jump {
        let (ground, flight) = (0.27 * self.random.vary(0.05), 0.25 * self.random.vary(0.06));
        let vertical_jump = self.vertical_jump(ground, flight);
        Jump {
            length: length * self.scale * self.random.vary(0.1),
            width: 0.035 * self.scale,
            lift: Lift { pitch: 42.0, lead: 0.13 },
            landing: Landing { pitch: 14.0, settle: 0.08, rest: 0.0 },
            swing_path: SwingPath { pitch: 16.0, ..vertical_jump.swing_path },
            ..vertical_jump
        }
    }

    /// Plays hopscotch: one foot, both feet, the other foot, both feet, for `count` pairs of
    /// fields.
    pub fn hopscotch(&mut self, count: usize) {
        self.stop();
        let ease = Posture { arm_swing: 0.0, gaze: [0.0, 26.0], ..Posture::default() };
        self.set_posture(self.now(), &Posture::default());
        let mut foot = Left;
        for n in 0..count {
            let mut hop = self.hop(0.46);
            hop.ground += if n == 0 { 0.5 } else { 0.06 };
            // One foot lands; the other stays in the air until both land.
            self.planner.jump(&[foot], &hop);
            let (off, single) = (self.now() - hop.flight, self.now());
            self.set_posture(off - 0.06, &ease.with_arms([-14.0, 24.0, 12.0, 40.0, 0.0]).bent_forward(14.0));
            self.set_posture(single, &ease.with_arms([18.0, 50.0, 16.0, 52.0, 0.0]).bent_forward(9.0));
            let both = Jump { width: 0.17 * self.scale, ..self.hop(0.46) };
            self.planner.jump(&[foot], &both);
            let strike = self.now();
            let placement = foot_placement(&self.planner.cursor(), opposite(foot), both.width, 8.0);
            let walk = Gait::walk(self.scale);
            let step = self.planner.place_foot(opposite(foot), strike, placement, &walk);
            step.swing = strike - off;
            step.lift = hop.lift;
            step.landing = both.landing;
            step.swing_path.leg_poses =
                Some(LegPoses { poses: Track::constant(TUCKED), ease_in: 0.26, ease_out: 0.3 });
            self.set_posture(strike, &ease.with_arms([6.0, 30.0, 14.0, 40.0, 0.0]).bent_forward(12.0));
            foot = opposite(foot);
        }
        self.recover();
    }

    /// Performs a long jump out of a run in `style`: take-off from one foot, landing on both with
    /// bent knees, and three slowing steps.
    pub fn long_jump(&mut self, style: &GaitStyle) {
        let (jumper, free) = (opposite(self.side), self.side);
        let (before, ground, flight) = (self.now(), 0.16, 0.44);
        let length = 0.9 * style.gait.length / style.gait.time * (ground + flight);
        let hop = Jump { length, width: 0.1 * self.scale, ..self.vertical_jump(ground, flight) };
        let landing = Landing { pitch: -12.0, settle: 0.07, rest: 0.0 };
        let touch_down = EndMotion { vertical: 1.0, ..hop.swing_path.touch_down };
        let swing_path =
            SwingPath { pitch: -4.0, clearance: 0.3 * self.scale, touch_down, ..hop.swing_path.clone() };
        self.planner.jump(&[jumper], &Jump { landing, swing_path: swing_path.clone(), ..hop });
        let land = self.now();
        // The free leg has been in the air since before the last step, as in any run.
        let placement = foot_placement(&self.planner.cursor(), free, 0.1 * self.scale, 8.0);
        let knees = [(before + 0.2, [0.0, -0.6, 0.32, 20.0, 0.0]), (land - 0.2, [0.0, -0.6, 0.5, 0.0, 0.0])];
        let step = self.planner.place_foot(free, land + 0.02, placement, &style.gait);
        step.swing = land - before + 0.08;
        step.landing = landing;
        step.swing_path = SwingPath {
            leg_poses: Some(LegPoses { poses: Track::from_keys(&knees), ease_in: 0.24, ease_out: 0.2 }),
            ..swing_path
        };
        let ease = Posture { arm_swing: 0.0, ..Posture::default() };
        self.set_posture(before, &style.posture);
        self.set_posture(
            land - 0.7 * flight,
            &ease.with_arms([140.0, 20.0, 10.0, 24.0, 0.0]).bent_forward(2.0),
        );
        self.set_posture(land - 0.04, &ease.with_arms([70.0, 16.0, 14.0, 16.0, 0.0]).bent_forward(30.0));
        self.set_posture(land + 0.2, &ease.with_arms([10.0, 20.0, 14.0, 30.0, 0.0]).bent_forward(40.0));
        let walk = GaitStyle::walk(self.scale, 1.0);
        for (fraction, time) in [(0.6, 0.5), (0.4, 0.44), (0.2, 0.48)] {
            self.take_step(&Gait { time, swing: 0.38, ..walk.gait.blend(&style.gait, fraction) });
        }
        self.set_posture(self.now(), &walk.posture);
        self.current_style = Some(walk);
    }
}
