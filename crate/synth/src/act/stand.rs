//! What people do on the spot: turning, stepping aside, bending, stretching, sitting.

use plantigrade::foot::Side;

use super::{Actor, Carriage, STANCE, other};
use crate::plan::{ArmStyle, Carry, Gait, Landing, Lift};

impl Actor<'_> {
    /// A small step on the spot.
    fn small_step(&self) -> Gait {
        let walk = Gait::walk(self.scale);
        Gait {
            time: 0.46,
            length: 0.0,
            width: STANCE * self.scale,
            toe_out: 8.0,
            swing: 0.35,
            lift: Lift { pitch: 24.0, lead: 0.17 },
            carry: Carry { clearance: 0.05 * self.scale, peak: 0.45, pitch: 14.0, ..walk.carry.clone() },
            landing: Landing { pitch: 8.0, settle: 0.08, rest: 0.0 },
            ..walk
        }
    }

    /// Stands at ease for `seconds`.
    pub fn stand(&mut self, seconds: f64) {
        self.stop();
        self.go_through(&[], seconds);
    }

    /// Turns on the spot by `degrees` to the left, step by step.
    pub fn turn(&mut self, degrees: f64) {
        self.stop();
        let pairs = (degrees.abs() / 55.0).ceil();
        let step = self.small_step();
        self.wait(0.2);
        for _ in 0..pairs as usize {
            self.side = if degrees > 0.0 { Side::Left } else { Side::Right };
            let time = step.time * self.random.vary(0.06);
            self.pace(&Gait { turn: degrees / pairs, time, ..step.clone() });
            self.pace(&Gait { time, ..step.clone() });
        }
        self.wait(0.3);
    }

    /// Takes `count` steps to `side`, the other foot following each.
    pub fn side_steps(&mut self, side: Side, count: usize) {
        self.stop();
        let step = self.small_step();
        let step = Gait { time: 0.5, swing: 0.38, ..step };
        let out = if side == Side::Left { 1.0 } else { -1.0 };
        self.wait(0.1);
        for _ in 0..count {
            let length = 0.34 * self.scale * self.random.vary(0.06);
            let aside = self.planner.cursor().moved(0.0, out * length);
            self.planner.move_to(aside);
            self.side = side;
            self.pace(&step);
            self.side = other(side);
            self.pace(&step);
        }
        self.wait(0.3);
    }

    /// Squats `count` times, feet flat; `depth` is how far the pelvis sinks, in metres.
    pub fn squat(&mut self, count: usize, depth: f64) {
        self.stop();
        let reach = ArmStyle { flex: 82.0, elbow: 8.0, ..ArmStyle::LOOSE };
        let low = Carriage::default().with_arms(reach.angles()).bent(46.0 * depth / 0.4).sunk(depth);
        for _ in 0..count {
            let slow = self.random.vary(0.08);
            self.go_through(&[(1.0 * slow, low), (1.25 * slow, low)], 2.3 * slow);
        }
    }

    /// Stretches: arms up, over to either side, round and down; `seconds` in all.
    pub fn stretch(&mut self, seconds: f64) {
        self.stop();
        let ease = Carriage { arm_swing: 0.0, ..Carriage::default() };
        let up = ease.with_arms([164.0, 16.0, 10.0, 16.0, 0.0]);
        let lean = |to: f64| Carriage { trunk: [2.0, 0.0, 22.0 * to], pelvis: [0.0, 0.0, 4.0 * to], ..up };
        let wide = ease.with_arms([0.0, 92.0, -10.0, 8.0, 0.0]);
        let twist = |to: f64| Carriage { trunk: [2.0, 38.0 * to, 0.0], look: [24.0 * to, 0.0], ..wide };
        let poses =
            [up, lean(1.0), lean(1.0), lean(-1.0), lean(-1.0), up, wide, twist(1.0), twist(-1.0), wide];
        let beat = seconds / (poses.len() + 1) as f64;
        let timed: Vec<_> = (1..).map(|n| f64::from(n) * beat).zip(poses).collect();
        self.go_through(&timed, seconds);
    }

    /// Swings the arms round, forward and back, for `seconds`.
    pub fn swing_arms(&mut self, seconds: f64) {
        self.stop();
        let ease = Carriage { arm_swing: 0.0, ..Carriage::default() };
        let beats = (seconds / 0.6).floor().max(2.0);
        let mut poses = Vec::new();
        for n in 1..beats as usize {
            let arms =
                if n % 2 == 1 { [112.0, 12.0, 10.0, 10.0, 0.0] } else { [-42.0, 16.0, 10.0, 8.0, 0.0] };
            let bend = if n % 2 == 1 { 0.0 } else { 12.0 };
            let sink = if n % 2 == 1 { 0.0 } else { 0.05 };
            poses.push((n as f64 * seconds / beats, ease.with_arms(arms).bent(bend).sunk(sink)));
        }
        self.go_through(&poses, seconds);
    }

    /// Picks something up from the floor before the feet and holds it.
    pub fn pick_up(&mut self) {
        self.stop();
        let ease = Carriage { arm_swing: 0.0, look: [0.0, 34.0], ..Carriage::default() };
        let down = ease.with_arms([74.0, 4.0, 26.0, 14.0, 0.0]).bent(72.0).sunk(0.34);
        let hold = Carriage { look: [0.0, 16.0], ..ease }.with_arms([26.0, 8.0, 44.0, 84.0, 0.0]);
        let looking = ease.bent(12.0);
        self.go_through(
            &[(0.4, looking), (1.45, down), (1.9, down), (2.9, hold.bent(6.0)), (4.2, hold)],
            5.1,
        );
    }

    /// Sits down on a chair behind the feet, stays for `seconds` and gets up again.
    pub fn sit(&mut self, seconds: f64) {
        self.stop();
        let ease = Carriage { arm_swing: 0.0, ..Carriage::default() };
        let thighs = [34.0, 6.0, 24.0, 46.0, 0.0];
        let seated = Carriage { shift: [0.0, -0.34], ..ease.with_arms(thighs) }.sunk(0.39);
        let on_the_way = Carriage { shift: [0.0, -0.1], ..ease.with_arms(thighs) }.bent(40.0).sunk(0.24);
        let leaning = Carriage { trunk: [36.0, 0.0, 0.0], shift: [0.0, -0.2], ..seated };
        self.go_through(
            &[
                (0.75, on_the_way),
                (1.5, seated),
                (1.5 + seconds, seated),
                (2.05 + seconds, leaning),
                (2.6 + seconds, on_the_way),
            ],
            3.5 + seconds,
        );
    }
}
