//! What is in the way: obstacles, stairs, something to stumble over.

use super::{Actor, Carriage, Style, other};
use crate::curve::Track;
use crate::plan::{Carry, Gait, Held, Landing, Lift};

/// Rise and depth of a stair, in metres.
const RISE: f64 = 0.17;
const TREAD: f64 = 0.29;

impl Actor<'_> {
    /// Steps over an obstacle of knee height on the way in `style`, one foot after the
    /// other.
    pub fn step_over(&mut self, style: &Style) {
        let gait = &style.gait;
        let scale = self.scale;
        let near = self.now();
        self.carry(near - 0.3, &style.carriage);
        for (length, high) in [(0.74, [0.0, -0.5, 0.38, 4.0, 4.0]), (0.5, [0.03, -0.52, 0.1, 26.0, 14.0])] {
            let held = Held { poses: Track::constant(high), ease_in: 0.32, ease_out: 0.34 };
            let over = Gait {
                time: 0.86,
                length: length * scale,
                swing: 0.72,
                carry: Carry { clearance: 0.34 * scale, peak: 0.5, held: Some(held), ..gait.carry.clone() },
                landing: Landing { pitch: -6.0, settle: 0.09, rest: 0.0 },
                ..gait.clone()
            };
            self.pace(&over);
        }
        let over = Carriage { look: [0.0, 34.0], ..style.carriage.bent(12.0) };
        let over = over.with_arms([10.0, 34.0, 14.0, 42.0, 0.0]);
        self.carry(near + 0.4, &over);
        self.carry(self.now() - 0.3, &over);
        self.carry(self.now() + 0.5, &style.carriage);
    }

    /// Catches a toe on the way in `style`: falls forward into three quick steps.
    pub fn stumble(&mut self, style: &Style) {
        let (gait, scale) = (&style.gait, self.scale);
        let caught = self.now() + 0.25;
        self.carry(caught - 0.1, &style.carriage);
        let low = Carry { clearance: 0.03 * scale, peak: 0.6, ramps: (0.2, 0.2), ..gait.carry.clone() };
        let steps =
            [(0.7, 0.46, 0.5, 0.0), (0.34, 0.74, 0.36, 8.0), (0.33, 0.72, 0.36, 12.0), (0.4, 0.6, 0.38, 6.0)];
        for (n, (time, length, swing, pitch)) in steps.into_iter().enumerate() {
            let carry =
                if n == 0 { low.clone() } else { Carry { clearance: 0.1 * scale, ..gait.carry.clone() } };
            self.pace(&Gait {
                time,
                length: length * scale,
                swing,
                width: 0.09 * scale,
                carry,
                landing: Landing { pitch, settle: 0.07, rest: 0.0 },
                ..gait.clone()
            });
        }
        let flung = Carriage { look: [0.0, 14.0], ..style.carriage };
        let thrown = flung.with_arms([56.0, 44.0, 10.0, 40.0, -20.0]).bent(44.0).sunk(0.05);
        self.carry(caught + 0.35, &thrown);
        self.carry(caught + 0.7, &flung.with_arms([20.0, 52.0, 6.0, 54.0, -10.0]).bent(36.0).sunk(0.06));
        self.carry(self.now() + 0.5, &style.carriage);
    }

    /// Climbs `count` stairs.
    pub fn climb(&mut self, count: usize) {
        self.stop();
        self.carry(self.now(), &Carriage::default());
        let walk = Gait::walk(self.scale);
        let climb = Gait {
            time: 0.62,
            length: TREAD,
            width: 0.08 * self.scale,
            swing: 0.46,
            lift: Lift { pitch: 36.0, lead: 0.2 },
            carry: Carry {
                clearance: 0.11,
                peak: 0.42,
                pitch: 12.0,
                pitch_at: 0.5,
                ramps: (0.4, 0.25),
                ..walk.carry
            },
            landing: Landing { pitch: 7.0, settle: 0.08, rest: 0.0 },
            ..walk
        };
        let climbing = Carriage { look: [0.0, 22.0], arm_swing: 22.0, ..Carriage::default() }.bent(12.0);
        for n in 0..count {
            self.planner.climb(RISE);
            let time = climb.time * self.random.vary(0.03);
            self.pace(&Gait { time, ..climb.clone() });
            if n == 1 {
                self.carry(self.now(), &climbing);
            }
        }
        self.carry(self.now(), &climbing);
        self.close(&climb);
        self.carry(self.now() + 0.4, &Carriage::default());
        self.wait(0.5);
    }

    /// Drags one leg along without ever setting it down, until `until`: the other takes
    /// the steps.
    pub fn drag(&mut self, until: f64) {
        let (good, lame) = (self.side, other(self.side));
        let walk = Gait::walk(self.scale);
        let length = 0.36 * self.scale;
        let step = Gait {
            time: 1.15,
            length: 0.0,
            swing: 0.42,
            lift: Lift { pitch: 34.0, lead: 0.2 },
            landing: Landing { pitch: -10.0, settle: 0.1, rest: 0.0 },
            ..walk.clone()
        };
        let dragging = Carry {
            clearance: 0.0,
            pitch: 26.0,
            ramps: (0.0, 0.0),
            detour: 0.0,
            grounded: true,
            load: 0.35,
            held: None,
            ..walk.carry
        };
        let limp = Carriage { look: [0.0, 14.0], arm_swing: 20.0, ..Carriage::default() }.bent(10.0);
        self.carry(self.now(), &limp);
        // It slips ahead while the good leg stands and creeps while that one swings.
        let mut free = self.now() + 0.1;
        let mut behind = self.planner.place(lame);
        while self.now() < until {
            let vary = self.random.vary(0.06);
            self.side = good;
            self.planner.advance(length * vary, 0.0);
            self.pace(&step);
            let strike = self.now();
            for (end, share) in [(strike, 0.22), (strike + step.time - step.swing, 0.78)] {
                behind = behind.moved_to(self.planner.cursor().heading, share * length * vary, 0.0);
                let pitch = Landing { pitch: 26.0, settle: 0.0, rest: 26.0 };
                let drag = Gait {
                    swing: end - free,
                    lift: Lift { pitch: 26.0, lead: 0.0 },
                    carry: dragging.clone(),
                    landing: pitch,
                    ..walk.clone()
                };
                self.planner.put(lame, end, behind, &drag);
                free = end;
            }
            let heave =
                |pitch, lean| Carriage { trunk: [pitch, 0.0, lean], pelvis: [4.0, 0.0, -0.7 * lean], ..limp };
            let lean = if good == plantigrade::foot::Side::Left { 8.0 } else { -8.0 };
            self.carry(strike - 0.1, &heave(8.0, -0.3 * lean));
            self.carry(strike + 0.4, &heave(14.0, lean));
        }
    }
}
