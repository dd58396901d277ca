//! Jumping, on both feet and on one.

use plantigrade::foot::Side::{self, Left};

use super::{Actor, Carriage, STANCE, Style, other};
use crate::curve::Track;
use crate::maths::GRAVITY;
use crate::plan::{Carry, Gait, Held, Hop, Landing, Lift, beside};

/// Arms before a jump, at its top, and after it.
const BACK: [f64; 5] = [-44.0, 16.0, 10.0, 14.0, 0.0];
const UP: [f64; 5] = [124.0, 14.0, 12.0, 26.0, -6.0];
const FRONT: [f64; 5] = [34.0, 14.0, 22.0, 36.0, 0.0];

/// The free leg while hopping on the other: shank behind, level with the knee.
const TUCKED: [f64; 5] = [0.02, -0.68, -0.34, 60.0, 0.0];

impl Actor<'_> {
    /// A jump of feet that spend `ground` seconds on the ground and `flight` in the air.
    fn spring(&self, ground: f64, flight: f64) -> Hop {
        let walk = Gait::walk(self.scale);
        Hop {
            ground,
            flight,
            length: 0.0,
            turn: 0.0,
            width: STANCE * self.scale,
            lift: Lift { pitch: 58.0, lead: 0.18_f64.min(0.5 * ground) },
            carry: Carry {
                // The feet rise about as far as the body does.
                clearance: 0.9 * GRAVITY * flight * flight / 8.0,
                peak: 0.5,
                pitch: 32.0,
                pitch_at: 0.5,
                ramps: (0.25, 0.25),
                detour: 0.0,
                ..walk.carry
            },
            landing: Landing { pitch: 18.0, settle: 0.09, rest: 0.0 },
        }
    }

    /// Jumps up `count` times with both feet.
    pub fn jump_up(&mut self, count: usize) {
        self.stop();
        self.carry(self.now(), &Carriage::default());
        for n in 0..count {
            let ground = if n == 0 { 0.85 } else { 0.62 * self.random.vary(0.05) };
            let flight = 0.42 * self.random.vary(0.06);
            let hop = self.spring(ground, flight);
            self.planner.jump(&Side::BOTH, &hop);
            self.throw_arms(self.now() - flight, self.now(), 36.0);
        }
        self.recover();
    }

    /// Crouch and swing of the arms for a jump from `off` to `land`; before it the trunk
    /// bends by `bend` degrees.
    fn throw_arms(&mut self, off: f64, land: f64, bend: f64) {
        let ease = Carriage { arm_swing: 0.0, ..Carriage::default() };
        self.carry(off - 0.3, &ease.with_arms(BACK).bent(bend));
        self.carry(off + 0.02, &ease.with_arms(UP).bent(4.0));
        self.carry(land + 0.12, &ease.with_arms(FRONT).bent(0.6 * bend));
    }

    /// Comes back to ease.
    fn recover(&mut self) {
        self.wait(0.75);
        self.carry(self.now(), &Carriage::default());
        self.wait(0.1);
    }

    /// Jumping jacks: `count` times out and in.
    pub fn jumping_jacks(&mut self, count: usize) {
        self.stop();
        let ease = Carriage { arm_swing: 0.0, ..Carriage::default() };
        self.carry(self.now(), &Carriage::default());
        for n in 0..2 * count {
            let out = n % 2 == 0;
            let ground = if n == 0 { 0.6 } else { 0.23 * self.random.vary(0.05) };
            let flight = 0.2 * self.random.vary(0.06);
            let width = if out { 0.27 } else { STANCE } * self.scale;
            let hop = Hop {
                width,
                lift: Lift { pitch: 34.0, lead: 0.12 },
                landing: Landing { pitch: 14.0, settle: 0.07, rest: 0.0 },
                ..self.spring(ground, flight)
            };
            self.planner.jump(&Side::BOTH, &hop);
            let arm = if out { [6.0, 158.0, 0.0, 14.0, 0.0] } else { [4.0, 12.0, 10.0, 14.0, 4.0] };
            if n == 0 {
                self.carry(self.now() - flight - 0.06, &ease.bent(8.0));
            }
            self.carry(self.now() + 0.06, &ease.with_arms(arm));
        }
        self.recover();
    }

    /// Hops on `foot`, `count` times, `length` metres each.
    pub fn hop_on(&mut self, foot: Side, count: usize, length: f64) {
        self.stop();
        let (begin, free) = (self.now(), other(foot));
        self.carry(begin, &Carriage::default());
        self.wait(0.85);
        let arms = [8.0, 40.0, 16.0, 56.0, 0.0];
        let ease = Carriage { arm_swing: 6.0, ..Carriage::default() };
        self.carry(begin + 0.7, &ease.with_arms(arms).bent(8.0));
        for _ in 0..count {
            let hop = self.hop(length);
            let flight = hop.flight;
            self.planner.jump(&[foot], &hop);
            let land = self.now();
            self.carry(land - flight - 0.1, &ease.with_arms([-8.0, 36.0, 14.0, 46.0, 0.0]).bent(10.0));
            self.carry(land - flight / 2.0, &ease.with_arms([24.0, 46.0, 18.0, 64.0, 0.0]).bent(7.0));
        }
        let strike = self.now() + 0.7;
        let cursor = self.planner.cursor();
        let place = beside(&cursor, free, STANCE * self.scale, 8.0);
        let walk = Gait::walk(self.scale);
        let step = self.planner.put(free, strike, place, &walk);
        step.swing = strike - begin - 0.35;
        step.lift = Lift { pitch: 36.0, lead: 0.2 };
        step.landing = Landing { pitch: 12.0, settle: 0.1, rest: 0.0 };
        step.carry.held = Some(Held { poses: Track::constant(TUCKED), ease_in: 0.4, ease_out: 0.45 });
        self.wait(0.7);
        self.recover();
    }

    /// One hop of one foot.
    fn hop(&mut self, length: f64) -> Hop {
        let (ground, flight) = (0.27 * self.random.vary(0.05), 0.25 * self.random.vary(0.06));
        let spring = self.spring(ground, flight);
        Hop {
            length: length * self.scale * self.random.vary(0.1),
            width: 0.035 * self.scale,
            lift: Lift { pitch: 42.0, lead: 0.13 },
            landing: Landing { pitch: 14.0, settle: 0.08, rest: 0.0 },
            carry: Carry { pitch: 16.0, ..spring.carry },
            ..spring
        }
    }

    /// Hopscotch: one foot, both, the other foot, both, `count` fields of each.
    pub fn hopscotch(&mut self, count: usize) {
        self.stop();
        let ease = Carriage { arm_swing: 0.0, look: [0.0, 26.0], ..Carriage::default() };
        self.carry(self.now(), &Carriage::default());
        let mut foot = Left;
        for n in 0..count {
            let mut hop = self.hop(0.46);
            hop.ground += if n == 0 { 0.5 } else { 0.06 };
            // One foot lands; the other stays behind in the air until both come down.
            self.planner.jump(&[foot], &hop);
            let (off, single) = (self.now() - hop.flight, self.now());
            self.carry(off - 0.06, &ease.with_arms([-14.0, 24.0, 12.0, 40.0, 0.0]).bent(14.0));
            self.carry(single, &ease.with_arms([18.0, 50.0, 16.0, 52.0, 0.0]).bent(9.0));
            let both = Hop { width: 0.17 * self.scale, ..self.hop(0.46) };
            self.planner.jump(&[foot], &both);
            let strike = self.now();
            let place = beside(&self.planner.cursor(), other(foot), both.width, 8.0);
            let walk = Gait::walk(self.scale);
            let step = self.planner.put(other(foot), strike, place, &walk);
            step.swing = strike - off;
            step.lift = hop.lift;
            step.landing = both.landing;
            step.carry.held = Some(Held { poses: Track::constant(TUCKED), ease_in: 0.26, ease_out: 0.3 });
            self.carry(strike, &ease.with_arms([6.0, 30.0, 14.0, 40.0, 0.0]).bent(12.0));
            foot = other(foot);
        }
        self.recover();
    }

    /// A long jump out of the run in `style`: off one foot, down on both, deep in the
    /// knees, and out of it in three slowing steps.
    pub fn long_jump(&mut self, style: &Style) {
        let (jumper, free) = (other(self.side), self.side);
        let (before, ground, flight) = (self.now(), 0.16, 0.44);
        let length = 0.9 * style.gait.length / style.gait.time * (ground + flight);
        let hop = Hop { length, width: 0.1 * self.scale, ..self.spring(ground, flight) };
        let landing = Landing { pitch: -12.0, settle: 0.07, rest: 0.0 };
        let carry = Carry { pitch: -4.0, clearance: 0.3 * self.scale, ..hop.carry.clone() };
        self.planner.jump(&[jumper], &Hop { landing, carry: carry.clone(), ..hop });
        let land = self.now();
        // The free leg has been in the air since before the last step, as in any run.
        let place = beside(&self.planner.cursor(), free, 0.1 * self.scale, 8.0);
        let knees = [(before + 0.2, [0.0, -0.6, 0.32, 20.0, 0.0]), (land - 0.2, [0.0, -0.6, 0.5, 0.0, 0.0])];
        let step = self.planner.put(free, land + 0.02, place, &style.gait);
        step.swing = land - before + 0.08;
        step.landing = landing;
        step.carry =
            Carry { held: Some(Held { poses: Track::of(&knees), ease_in: 0.24, ease_out: 0.2 }), ..carry };
        let ease = Carriage { arm_swing: 0.0, ..Carriage::default() };
        self.carry(before, &style.carriage);
        self.carry(land - 0.7 * flight, &ease.with_arms([140.0, 20.0, 10.0, 24.0, 0.0]).bent(2.0));
        self.carry(land - 0.04, &ease.with_arms([70.0, 16.0, 14.0, 16.0, 0.0]).bent(30.0));
        self.carry(land + 0.2, &ease.with_arms([10.0, 20.0, 14.0, 30.0, 0.0]).bent(40.0));
        let walk = Style::walk(self.scale, 1.0);
        for (share, time) in [(0.6, 0.5), (0.4, 0.44), (0.2, 0.48)] {
            self.pace(&Gait { time, swing: 0.38, ..walk.gait.blend(&style.gait, share) });
        }
        self.carry(self.now(), &walk.carriage);
        self.under_way = Some(walk);
    }
}
