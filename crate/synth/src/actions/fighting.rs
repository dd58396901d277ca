//! Kicking and boxing.

use plantigrade::foot::Side::{self, Left, Right};

use super::{Actor, HALF_STANCE_WIDTH, Posture, opposite};
use crate::math::Track;
use crate::plan::{Gait, Landing, LegPoses, Lift, SwingPath, foot_placement};

/// Arm pose of the guard: fists in front of the chin.
const GUARD: [f64; 5] = [48.0, 10.0, 34.0, 122.0, 0.0];
/// Arm pose at the end of a punch.
const PUNCH: [f64; 5] = [86.0, 6.0, 30.0, 8.0, 0.0];

impl Actor<'_> {
    /// Performs a front kick.
    pub fn kick(&mut self, side: Side) {
        self.stop();
        let start = self.now();
        let tempo = self.random.vary(0.05);
        let at = |after: f64| start + after * tempo;
        let placement = foot_placement(&self.planner.cursor(), side, HALF_STANCE_WIDTH * self.scale, 8.0);
        let walk = Gait::walk(self.scale);
        let step = self.planner.place_foot(side, at(1.62), placement, &walk);
        step.swing = 1.02 * tempo;
        step.lift = Lift { pitch: 44.0, lead: 0.22 };
        step.landing = Landing { pitch: 14.0, settle: 0.1, rest: 0.0 };
        let (knee_raised, leg_extended) = ([0.02, -0.44, 0.36, 34.0, 4.0], [0.0, -0.2, 0.92, 58.0, 4.0]);
        step.swing_path.leg_poses = Some(LegPoses {
            poses: Track::from_keys(&[
                (at(0.9), knee_raised),
                (at(1.04), leg_extended),
                (at(1.1), leg_extended),
                (at(1.27), knee_raised),
            ]),
            ease_in: 0.3,
            ease_out: 0.34,
        });
        let guard = Posture { arm_swing: 0.0, ..Posture::default() }.with_arms(GUARD);
        let lean = if side == Left { -5.0 } else { 5.0 };
        let leaning_back = Posture { trunk: [-12.0, 0.0, lean], pelvis: [-12.0, 0.0, lean], ..guard };
        let poses = [(0.45, guard), (0.88, guard), (1.06, leaning_back), (1.5, guard.bent_forward(6.0))];
        self.play_postures(&poses.map(|(after, pose)| (after * tempo, pose)), 2.2 * tempo);
        self.side = opposite(side);
    }

    /// Boxes for about `seconds`: jabs and crosses from the guard, stepping in and out.
    pub fn boxing(&mut self, seconds: f64) {
        self.stop();
        let (start, scale) = (self.now(), self.scale);
        let cursor = self.planner.cursor();
        let shuffle = self.shuffle();
        self.set_posture(start, &Posture::default());
        // Guard: left foot in front, right foot behind and turned out.
        let mut left = cursor.translated(0.15 * scale, 0.1 * scale).rotated(-10.0);
        let mut right = cursor.translated(-0.2 * scale, -0.13 * scale).rotated(-48.0);
        self.planner.place_foot(Left, start + 0.6, left, &shuffle);
        self.planner.place_foot(Right, start + 1.05, right, &shuffle);
        self.wait(1.2);
        let guard = self.guard(0.0, [GUARD; 2]);
        self.set_posture(start + 0.9, &guard);
        let mut advance: f64 = 0.0;
        while self.now() < start + seconds - 1.8 {
            // Step in if the distance is large, out if it is small; both feet move.
            let direction = if advance > 0.1 { -1.0 } else { 1.0 };
            let step_length = 0.17 * direction * scale * self.random.vary(0.15);
            advance += step_length;
            (left, right) = (
                left.translated_along(cursor.heading, step_length, 0.0),
                right.translated_along(cursor.heading, step_length, 0.0),
            );
            let feet =
                if direction > 0.0 { [(Left, left), (Right, right)] } else { [(Right, right), (Left, left)] };
            for (side, placement) in feet {
                let interval = 0.34 * self.random.vary(0.08);
                self.wait(interval);
                self.planner.place_foot(side, self.now(), placement, &shuffle);
            }
            let cross = self.random.uniform(0.0, 1.0) > 0.4;
            self.punches(cross);
        }
        self.set_posture(self.now(), &guard);
        for (after, side) in [(0.6, Left), (1.05, Right)] {
            let placement = foot_placement(&cursor, side, HALF_STANCE_WIDTH * scale, 8.0);
            self.planner.place_foot(side, self.now() + after, placement, &shuffle);
        }
        self.wait(1.3);
        self.set_posture(self.now(), &Posture::default());
        self.wait(0.1);
    }

    /// Throws a jab, followed by a cross if `cross` is set.
    fn punches(&mut self, cross: bool) {
        let start = self.now();
        self.set_posture(start, &self.guard(0.0, [GUARD; 2]));
        self.set_posture(start + 0.17, &self.guard(-16.0, [PUNCH, GUARD]));
        self.wait(0.38);
        if cross {
            self.set_posture(self.now(), &self.guard(-4.0, [GUARD; 2]));
            self.set_posture(self.now() + 0.18, &self.guard(34.0, [GUARD, PUNCH]));
            self.wait(0.46);
        }
        self.set_posture(self.now(), &self.guard(0.0, [GUARD; 2]));
    }

    /// Returns the guard posture with the trunk rotated by `turn` degrees.
    fn guard(&self, turn: f64, arms: [[f64; 5]; 2]) -> Posture {
        Posture {
            lowering: 0.07,
            trunk: [12.0, turn - 14.0, 0.0],
            pelvis: [5.0, 0.4 * turn, 0.0],
            gaze: [20.0, 4.0],
            arms,
            arm_swing: 0.0,
            ..Posture::default()
        }
    }

    /// Returns the gait of a short flat step.
    fn shuffle(&self) -> Gait {
        let walk = Gait::walk(self.scale);
        Gait {
            swing: 0.24,
            lift: Lift { pitch: 18.0, lead: 0.1 },
            swing_path: SwingPath {
                clearance: 0.035 * self.scale,
                peak: 0.45,
                pitch: 10.0,
                detour: 0.0,
                ..walk.swing_path
            },
            landing: Landing { pitch: 9.0, settle: 0.06, rest: 0.0 },
            ..walk
        }
    }
}
