//! Salsa.

use plantigrade::foot::Side::{Left, Right};

use super::{Actor, Carriage, STANCE};
use crate::plan::{Carry, Gait, Landing, Lift, beside};

/// Seconds from beat to beat.
const BEAT: f64 = 0.36;

impl Actor<'_> {
    /// Salsa, the basic step, `bars` times eight beats: forward and back in place, a
    /// pause, back and forward in place, a pause; turning slowly to the left.
    pub fn salsa(&mut self, bars: usize) {
        self.stop();
        let scale = self.scale;
        let walk = Gait::walk(scale);
        let step = Gait {
            swing: 0.25,
            lift: Lift { pitch: 34.0, lead: 0.14 },
            carry: Carry { clearance: 0.03 * scale, peak: 0.45, pitch: 20.0, detour: 0.0, ..walk.carry },
            landing: Landing { pitch: 18.0, settle: 0.08, rest: 0.0 },
            ..walk
        };
        let arms = [34.0, 16.0, 24.0, 88.0, 0.0];
        let swayed = |to: f64| Carriage {
            sink: 0.02,
            trunk: [4.0, 7.0 * to, -5.0 * to],
            pelvis: [3.0, -5.0 * to, 8.0 * to],
            arms: [[34.0 - 14.0 * to, 16.0, 24.0, 88.0, 0.0], [34.0 + 14.0 * to, 16.0, 24.0, 88.0, 0.0]],
            arm_swing: 0.0,
            ..Carriage::default()
        };
        self.carry(self.now(), &Carriage::default());
        self.wait(0.5);
        self.carry(self.now(), &Carriage::default().with_arms(arms));
        for _ in 0..bars {
            let cursor = self.planner.cursor();
            let home = |side| beside(&cursor, side, STANCE * scale, 8.0);
            // Which foot on which beat, how far ahead.
            let steps = [(1.0, Left, 0.26), (2.0, Right, 0.0), (3.0, Left, 0.0)];
            let answers = [(5.0, Right, -0.26), (6.0, Left, 0.0), (7.0, Right, 0.0)];
            let start = self.now();
            for (beat, side, ahead) in steps.into_iter().chain(answers) {
                let place = home(side).moved_to(cursor.heading, ahead * scale, 0.0);
                let strike = start + BEAT * beat + 0.012 * self.random.between(-1.0, 1.0);
                self.planner.put(side, strike, place, &step);
                self.carry(strike + 0.1, &swayed(if side == Left { 1.0 } else { -1.0 }));
            }
            self.wait(8.0 * BEAT);
            self.planner.advance(0.0, 12.0 * self.random.vary(0.3));
        }
        self.wait(0.6);
        self.carry(self.now(), &Carriage::default());
        self.wait(0.1);
    }
}
