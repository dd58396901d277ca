//! Getting from place to place.

use super::{Actor, Carriage, STANCE, Style};
use crate::plan::{Gait, Landing, Lift};
use crate::random::Random;

/// Steps in which someone changes from walk to walk, from walk to run or back, and comes
/// to rest out of a run or a walk.
const INTO_SAME: [f64; 2] = [0.0, 0.7];
const INTO_OTHER: [f64; 4] = [0.15, 0.4, 0.65, 0.85];
const OUT_OF_RUN: [f64; 4] = [0.7, 0.4, 0.15, 0.0];
const OUT_OF_WALK: [f64; 1] = [0.3];

/// Steps in which a sprinter gets up to speed.
const SPRINT_OFF: u8 = 12;

impl Actor<'_> {
    /// Goes on in `style` until `until`, turning at each step by the degrees to the left
    /// that `turn` says. The actor is still on the way afterwards.
    pub fn go(&mut self, style: &Style, until: f64, mut turn: impl FnMut(&mut Random) -> f64) {
        self.fall_in(style);
        while self.now() < until {
            let turn = turn(self.random);
            self.stride(style, turn);
        }
    }

    /// Goes straight on in `style` until `until`.
    pub fn go_straight(&mut self, style: &Style, until: f64) {
        self.go(style, until, |random| random.between(-0.8, 0.8));
    }

    /// One step in `style`, turning `turn` degrees to the left.
    pub fn stride(&mut self, style: &Style, turn: f64) {
        let gait = &style.gait;
        let (time, length) = (self.random.vary(0.7 * style.vary), self.random.vary(style.vary));
        self.pace(&Gait { time: gait.time * time, length: gait.length * length, turn, ..gait.clone() });
    }

    /// Changes into `style` from whatever the actor does.
    pub fn fall_in(&mut self, style: &Style) {
        let first = style.first(self.scale);
        let (from, carriage) = match self.under_way.take() {
            Some(before) => (before.gait, before.carriage),
            None => (first, Carriage::default()),
        };
        self.carry(self.now(), &carriage);
        let same = style.gait.is_run() == from.is_run();
        let shares = if same { &INTO_SAME[..] } else { &INTO_OTHER[..] };
        for &share in shares {
            self.pace(&from.blend(&style.gait, share));
        }
        self.carry(self.now(), &style.carriage);
        self.under_way = Some(style.clone());
    }

    /// Comes to rest, if the actor is on the way, the feet side by side.
    pub fn stop(&mut self) {
        let Some(style) = self.under_way.take() else { return };
        self.carry(self.now(), &style.carriage);
        let last = style.first(self.scale);
        let shares = if style.gait.is_run() { &OUT_OF_RUN[..] } else { &OUT_OF_WALK[..] };
        for &share in shares {
            self.pace(&last.blend(&style.gait, share));
        }
        self.close(&last);
        self.carry(self.now() + 0.35, &Carriage::default());
        self.wait(0.5);
    }

    /// Puts the foot behind beside the other.
    pub(super) fn close(&mut self, gait: &Gait) {
        let close = Gait {
            time: gait.time.max(0.5),
            length: 0.02 * self.scale,
            width: STANCE * self.scale,
            toe_out: 8.0,
            swing: gait.swing.clamp(0.36, 0.6),
            landing: Landing { pitch: gait.landing.pitch.max(10.0), settle: 0.12, rest: 0.0 },
            ..gait.clone()
        };
        self.pace(&close);
    }

    /// Springs off from a stand into a sprint: one foot back, leaning far ahead, with
    /// quick steps that grow.
    pub fn sprint_off(&mut self) {
        self.stop();
        let (style, scale) = (Style::sprint(self.scale), self.scale);
        let begin = self.now();
        self.carry(begin, &Carriage::default());
        let back = Gait {
            swing: 0.4,
            landing: Landing { pitch: 34.0, settle: 0.1, rest: 24.0 },
            ..Gait::walk(scale)
        };
        let place = self.planner.place(self.side).moved(-0.36 * scale, 0.0);
        self.planner.put(self.side, begin + 0.55, place, &back);
        let set = style.carriage.bent(46.0).sunk(0.1);
        self.carry(begin + 0.9, &set);
        self.wait(1.2);
        let off = self.now();
        self.carry(off, &set);
        let first = Gait {
            time: 0.27,
            length: 0.6 * scale,
            swing: 0.29,
            lift: Lift { pitch: 54.0, lead: 0.12 },
            ..style.gait.clone()
        };
        for step in 0..SPRINT_OFF {
            self.pace(&first.blend(&style.gait, f64::from(step) / f64::from(SPRINT_OFF)));
        }
        self.carry(off + 0.8, &style.carriage.bent(36.0).sunk(0.03));
        self.carry(self.now(), &style.carriage);
        self.under_way = Some(style);
    }
}
