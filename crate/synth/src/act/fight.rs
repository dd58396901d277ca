//! Kicking, boxing.

use plantigrade::foot::Side::{self, Left, Right};

use super::{Actor, Carriage, STANCE, other};
use crate::curve::Track;
use crate::plan::{Carry, Gait, Held, Landing, Lift, beside};

/// Arms of the guard: fists before the chin.
const GUARD: [f64; 5] = [48.0, 10.0, 34.0, 122.0, 0.0];
/// An arm that has struck.
const STRUCK: [f64; 5] = [86.0, 6.0, 30.0, 8.0, 0.0];

impl Actor<'_> {
    /// A front kick with the leg of one side.
    pub fn kick(&mut self, side: Side) {
        self.stop();
        let begin = self.now();
        let tempo = self.random.vary(0.05);
        let at = |after: f64| begin + after * tempo;
        let place = beside(&self.planner.cursor(), side, STANCE * self.scale, 8.0);
        let walk = Gait::walk(self.scale);
        let step = self.planner.put(side, at(1.62), place, &walk);
        step.swing = 1.02 * tempo;
        step.lift = Lift { pitch: 44.0, lead: 0.22 };
        step.landing = Landing { pitch: 14.0, settle: 0.1, rest: 0.0 };
        let (chamber, struck) = ([0.02, -0.44, 0.36, 34.0, 4.0], [0.0, -0.2, 0.92, 58.0, 4.0]);
        step.carry.held = Some(Held {
            poses: Track::of(&[
                (at(0.9), chamber),
                (at(1.04), struck),
                (at(1.1), struck),
                (at(1.27), chamber),
            ]),
            ease_in: 0.3,
            ease_out: 0.34,
        });
        let guard = Carriage { arm_swing: 0.0, ..Carriage::default() }.with_arms(GUARD);
        let lean = if side == Left { -5.0 } else { 5.0 };
        let back = Carriage { trunk: [-12.0, 0.0, lean], pelvis: [-12.0, 0.0, lean], ..guard };
        let poses = [(0.45, guard), (0.88, guard), (1.06, back), (1.5, guard.bent(6.0))];
        self.go_through(&poses.map(|(after, pose)| (after * tempo, pose)), 2.2 * tempo);
        self.side = other(side);
    }

    /// Boxes for about `seconds`: from the guard, jabs and crosses, in and out.
    pub fn boxing(&mut self, seconds: f64) {
        self.stop();
        let (begin, scale) = (self.now(), self.scale);
        let cursor = self.planner.cursor();
        let shuffle = self.shuffle();
        self.carry(begin, &Carriage::default());
        // The guard: left foot ahead, right foot behind and turned out.
        let mut left = cursor.moved(0.15 * scale, 0.1 * scale).turned(-10.0);
        let mut right = cursor.moved(-0.2 * scale, -0.13 * scale).turned(-48.0);
        self.planner.put(Left, begin + 0.6, left, &shuffle);
        self.planner.put(Right, begin + 1.05, right, &shuffle);
        self.wait(1.2);
        let guard = self.guard(0.0, [GUARD; 2]);
        self.carry(begin + 0.9, &guard);
        let mut ahead: f64 = 0.0;
        while self.now() < begin + seconds - 1.8 {
            // In when too far, out when too near, and always both feet.
            let forth = if ahead > 0.1 { -1.0 } else { 1.0 };
            let reach = 0.17 * forth * scale * self.random.vary(0.15);
            ahead += reach;
            (left, right) =
                (left.moved_to(cursor.heading, reach, 0.0), right.moved_to(cursor.heading, reach, 0.0));
            let feet =
                if forth > 0.0 { [(Left, left), (Right, right)] } else { [(Right, right), (Left, left)] };
            for (side, place) in feet {
                let beat = 0.34 * self.random.vary(0.08);
                self.wait(beat);
                self.planner.put(side, self.now(), place, &shuffle);
            }
            let cross = self.random.between(0.0, 1.0) > 0.4;
            self.strikes(cross);
        }
        self.carry(self.now(), &guard);
        for (after, side) in [(0.6, Left), (1.05, Right)] {
            let place = beside(&cursor, side, STANCE * scale, 8.0);
            self.planner.put(side, self.now() + after, place, &shuffle);
        }
        self.wait(1.3);
        self.carry(self.now(), &Carriage::default());
        self.wait(0.1);
    }

    /// A jab, and perhaps a cross after it.
    fn strikes(&mut self, cross: bool) {
        let start = self.now();
        self.carry(start, &self.guard(0.0, [GUARD; 2]));
        self.carry(start + 0.17, &self.guard(-16.0, [STRUCK, GUARD]));
        self.wait(0.38);
        if cross {
            self.carry(self.now(), &self.guard(-4.0, [GUARD; 2]));
            self.carry(self.now() + 0.18, &self.guard(34.0, [GUARD, STRUCK]));
            self.wait(0.46);
        }
        self.carry(self.now(), &self.guard(0.0, [GUARD; 2]));
    }

    /// The carriage of the guard, the trunk turned by `turn` degrees from it.
    fn guard(&self, turn: f64, arms: [[f64; 5]; 2]) -> Carriage {
        Carriage {
            sink: 0.07,
            trunk: [12.0, turn - 14.0, 0.0],
            pelvis: [5.0, 0.4 * turn, 0.0],
            look: [20.0, 4.0],
            arms,
            arm_swing: 0.0,
            ..Carriage::default()
        }
    }

    /// A short flat step.
    fn shuffle(&self) -> Gait {
        let walk = Gait::walk(self.scale);
        Gait {
            swing: 0.24,
            lift: Lift { pitch: 18.0, lead: 0.1 },
            carry: Carry {
                clearance: 0.035 * self.scale,
                peak: 0.45,
                pitch: 10.0,
                detour: 0.0,
                ..walk.carry
            },
            landing: Landing { pitch: 9.0, settle: 0.06, rest: 0.0 },
            ..walk
        }
    }
}
