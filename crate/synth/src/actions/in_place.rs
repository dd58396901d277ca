//! Actions on the spot: turning, side steps, bending, stretching, sitting.

use plantigrade::foot::Side;

use super::{Actor, HALF_STANCE_WIDTH, Posture, opposite};
use crate::plan::{ArmPose, EndMotion, Gait, Landing, Lift, SwingPath};

impl Actor<'_> {
    /// Returns the gait of a small step on the spot.
    fn small_step(&self) -> Gait {
        let walk = Gait::walk(self.scale);
        Gait {
            time: 0.46,
            length: 0.0,
            width: HALF_STANCE_WIDTH * self.scale,
            toe_out: 8.0,
            swing: 0.35,
            lift: Lift { pitch: 24.0, lead: 0.17 },
            swing_path: SwingPath {
                clearance: 0.05 * self.scale,
                peak: 0.45,
                pitch: 14.0,
                touch_down: EndMotion { vertical: 0.25, ..EndMotion::WALK_STRIKE },
                ..walk.swing_path.clone()
            },
            landing: Landing { pitch: 8.0, settle: 0.08, rest: 0.0 },
            ..walk
        }
    }

    /// Stands relaxed for `seconds`.
    pub fn stand(&mut self, seconds: f64) {
        self.stop();
        self.play_postures(&[], seconds);
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
            self.take_step(&Gait { turn: degrees / pairs, time, ..step.clone() });
            self.take_step(&Gait { time, ..step.clone() });
        }
        self.wait(0.3);
    }

    /// Takes `count` side steps; the other foot follows each.
    pub fn side_steps(&mut self, side: Side, count: usize) {
        self.stop();
        let step = self.small_step();
        let step = Gait { time: 0.5, swing: 0.38, ..step };
        let direction = if side == Side::Left { 1.0 } else { -1.0 };
        self.wait(0.1);
        for _ in 0..count {
            let length = 0.34 * self.scale * self.random.vary(0.06);
            let next = self.planner.cursor().translated(0.0, direction * length);
            self.planner.move_to(next);
            self.side = side;
            self.take_step(&step);
            self.side = opposite(side);
            self.take_step(&step);
        }
        self.wait(0.3);
    }

    /// Squats `count` times with flat feet; `depth` is the lowering of the pelvis, in metres.
    pub fn squat(&mut self, count: usize, depth: f64) {
        self.stop();
        let reach = ArmPose { flexion: 82.0, elbow: 8.0, ..ArmPose::RELAXED };
        let low =
            Posture::default().with_arms(reach.angles()).bent_forward(46.0 * depth / 0.4).lowered(depth);
        for _ in 0..count {
            let slow = self.random.vary(0.08);
            self.play_postures(&[(1.0 * slow, low), (1.25 * slow, low)], 2.3 * slow);
        }
    }

    /// Stretches arms and trunk: up, to either side, rotation; `seconds` in total.
    pub fn stretch(&mut self, seconds: f64) {
        self.stop();
        let ease = Posture { arm_swing: 0.0, ..Posture::default() };
        let up = ease.with_arms([164.0, 16.0, 10.0, 16.0, 0.0]);
        let lean = |to: f64| Posture { trunk: [2.0, 0.0, 22.0 * to], pelvis: [0.0, 0.0, 4.0 * to], ..up };
        let wide = ease.with_arms([0.0, 92.0, -10.0, 8.0, 0.0]);
        let twist = |to: f64| Posture { trunk: [2.0, 38.0 * to, 0.0], gaze: [24.0 * to, 0.0], ..wide };
        let poses =
            [up, lean(1.0), lean(1.0), lean(-1.0), lean(-1.0), up, wide, twist(1.0), twist(-1.0), wide];
        let beat = seconds / (poses.len() + 1) as f64;
        let timed: Vec<_> = (1..).map(|n| f64::from(n) * beat).zip(poses).collect();
        self.play_postures(&timed, seconds);
    }

    /// Swings the arms forward and back for `seconds`.
    pub fn swing_arms(&mut self, seconds: f64) {
        self.stop();
        let ease = Posture { arm_swing: 0.0, ..Posture::default() };
        let beats = (seconds / 0.6).floor().max(2.0);
        let mut poses = Vec::new();
        for n in 1..beats as usize {
            let arms =
                if n % 2 == 1 { [112.0, 12.0, 10.0, 10.0, 0.0] } else { [-42.0, 16.0, 10.0, 8.0, 0.0] };
            let bend = if n % 2 == 1 { 0.0 } else { 12.0 };
            let lowering = if n % 2 == 1 { 0.0 } else { 0.05 };
            poses.push((
                n as f64 * seconds / beats,
                ease.with_arms(arms).bent_forward(bend).lowered(lowering),
            ));
        }
        self.play_postures(&poses, seconds);
    }

    /// Picks up an object in front of the feet and holds it.
    pub fn pick_up(&mut self) {
        self.stop();
        let ease = Posture { arm_swing: 0.0, gaze: [0.0, 34.0], ..Posture::default() };
        let down = ease.with_arms([74.0, 4.0, 26.0, 14.0, 0.0]).bent_forward(72.0).lowered(0.34);
        let holding = Posture { gaze: [0.0, 16.0], ..ease }.with_arms([26.0, 8.0, 44.0, 84.0, 0.0]);
        let looking = ease.bent_forward(12.0);
        self.play_postures(
            &[(0.4, looking), (1.45, down), (1.9, down), (2.9, holding.bent_forward(6.0)), (4.2, holding)],
            5.1,
        );
    }

    /// Sits down on a chair, stays for `seconds` and stands up.
    pub fn sit(&mut self, seconds: f64) {
        self.stop();
        let ease = Posture { arm_swing: 0.0, ..Posture::default() };
        let thighs = [34.0, 6.0, 24.0, 46.0, 0.0];
        let seated = Posture { shift: [0.0, -0.34], ..ease.with_arms(thighs) }.lowered(0.39);
        let in_motion =
            Posture { shift: [0.0, -0.1], ..ease.with_arms(thighs) }.bent_forward(40.0).lowered(0.24);
        let leaning = Posture { trunk: [36.0, 0.0, 0.0], shift: [0.0, -0.2], ..seated };
        self.play_postures(
            &[
                (0.75, in_motion),
                (1.5, seated),
                (1.5 + seconds, seated),
                (2.05 + seconds, leaning),
                (2.6 + seconds, in_motion),
            ],
            3.5 + seconds,
        );
    }
}
