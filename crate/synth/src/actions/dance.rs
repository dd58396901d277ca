//! Salsa.

use plantigrade::foot::Side::{Left, Right};

use super::{Actor, HALF_STANCE_WIDTH, Posture};
use crate::plan::{Gait, Landing, Lift, SwingPath, foot_placement};

/// Duration of a beat, in seconds.
const BEAT: f64 = 0.36;

impl Actor<'_> {
    /// Dances the basic salsa step for `bars` bars of eight beats: forward and back in place, a
    /// pause, back and forward in place, a pause; turning slowly to the left.
    pub fn salsa(&mut self, bars: usize) {
        self.stop();
        let scale = self.scale;
        let walk = Gait::walk(scale);
        let step = Gait {
            swing: 0.25,
            lift: Lift { pitch: 34.0, lead: 0.14 },
            swing_path: SwingPath {
                clearance: 0.03 * scale,
                peak: 0.45,
                pitch: 20.0,
                detour: 0.0,
                ..walk.swing_path
            },
            landing: Landing { pitch: 18.0, settle: 0.08, rest: 0.0 },
            ..walk
        };
        let arms = [34.0, 16.0, 24.0, 88.0, 0.0];
        let swayed = |to: f64| Posture {
            lowering: 0.02,
            trunk: [4.0, 7.0 * to, -5.0 * to],
            pelvis: [3.0, -5.0 * to, 8.0 * to],
            arms: [[34.0 - 14.0 * to, 16.0, 24.0, 88.0, 0.0], [34.0 + 14.0 * to, 16.0, 24.0, 88.0, 0.0]],
            arm_swing: 0.0,
            ..Posture::default()
        };
        self.set_posture(self.now(), &Posture::default());
        self.wait(0.5);
        self.set_posture(self.now(), &Posture::default().with_arms(arms));
        for _ in 0..bars {
            let cursor = self.planner.cursor();
            let neutral = |side| foot_placement(&cursor, side, HALF_STANCE_WIDTH * scale, 8.0);
            // Beat, foot and distance ahead of each step.
            let forward_steps = [(1.0, Left, 0.26), (2.0, Right, 0.0), (3.0, Left, 0.0)];
            let back_steps = [(5.0, Right, -0.26), (6.0, Left, 0.0), (7.0, Right, 0.0)];
            let start = self.now();
            for (beat, side, ahead) in forward_steps.into_iter().chain(back_steps) {
                let placement = neutral(side).translated_along(cursor.heading, ahead * scale, 0.0);
                let strike = start + BEAT * beat + 0.012 * self.random.uniform(-1.0, 1.0);
                self.planner.place_foot(side, strike, placement, &step);
                self.set_posture(strike + 0.1, &swayed(if side == Left { 1.0 } else { -1.0 }));
            }
            self.wait(8.0 * BEAT);
            self.planner.advance(0.0, 12.0 * self.random.vary(0.3));
        }
        self.wait(0.6);
        self.set_posture(self.now(), &Posture::default());
        self.wait(0.1);
    }
}
