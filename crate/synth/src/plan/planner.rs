//! Step-by-step construction of a plan.

use plantigrade::foot::Side;

use super::{BodyTracks, FootPlan, Gait, Jump, Placement, Plan, Step};
use crate::character::lateral_sign;
use crate::math::Track;

/// Builds a plan along a path: a cursor moves forward and the feet step on either side of it.
pub struct Planner {
    plan: Plan,
    cursor: Placement,
    time: f64,
}

impl Planner {
    /// Creates a plan in which both feet stand on either side of `cursor`, `width` metres from it,
    /// from time `start`.
    pub fn standing(start: f64, cursor: Placement, width: f64) -> Planner {
        let foot = |side: Side| FootPlan {
            start: foot_placement(&cursor, side, width, 8.0),
            steps: Vec::new(),
            heel_raise: Track::constant([0.0]),
            pivot: Track::constant([0.0]),
        };
        let plan = Plan { start, feet: Side::BOTH.map(foot), body: BodyTracks::default() };
        Planner { plan, cursor, time: start }
    }

    /// Returns the time up to which the plan is written, in seconds.
    pub fn now(&self) -> f64 {
        self.time
    }

    /// Returns the placement of the body.
    pub fn cursor(&self) -> Placement {
        self.cursor
    }

    /// Waits for `seconds`.
    pub fn wait(&mut self, seconds: f64) {
        self.time += seconds;
    }

    /// Waits until `time`.
    pub fn wait_until(&mut self, time: f64) {
        self.time = self.time.max(time);
    }

    /// Moves the cursor `length` metres forward along an arc of `turn` degrees.
    pub fn advance(&mut self, length: f64, turn: f64) {
        self.cursor = self.cursor.rotated(turn / 2.0).translated(length, 0.0).rotated(turn / 2.0);
    }

    /// Raises the cursor by `rise` metres: the next step is on higher ground.
    pub fn climb(&mut self, rise: f64) {
        self.cursor = self.cursor.raised(rise);
    }

    /// Moves the cursor to `cursor` without changing the heading.
    pub fn move_to(&mut self, cursor: Placement) {
        self.cursor = Placement { heading: self.cursor.heading, ..cursor };
    }

    /// Takes one step: the body moves forward and the foot lands on its side of the path.
    pub fn step(&mut self, side: Side, gait: &Gait) {
        self.time += gait.time;
        self.advance(gait.length, gait.turn);
        let placement = foot_placement(&self.cursor, side, gait.width, gait.toe_out);
        self.place_foot(side, self.time, placement, gait);
    }

    /// Places a foot at `placement` at time `strike`, with the swing and landing of `gait`. The
    /// cursor does not move.
    pub fn place_foot(&mut self, side: Side, strike: f64, placement: Placement, gait: &Gait) -> &mut Step {
        let step = Step {
            strike,
            swing: gait.swing,
            placement,
            lift: gait.lift,
            swing_path: gait.swing_path.clone(),
            landing: gait.landing,
            weight: 1.0,
        };
        self.push(side, step)
    }

    /// Jumps with `feet` and lands on them.
    pub fn jump(&mut self, feet: &[Side], hop: &Jump) {
        self.time += hop.ground + hop.flight;
        self.advance(hop.length, hop.turn);
        for &side in feet {
            let placement = foot_placement(&self.cursor, side, hop.width, 8.0);
            let step = Step {
                strike: self.time,
                swing: hop.flight,
                placement,
                lift: hop.lift,
                swing_path: hop.swing_path.clone(),
                landing: hop.landing,
                weight: 1.0,
            };
            self.push(side, step);
        }
    }

    /// Appends a step.
    ///
    /// # Panics
    /// If the foot would leave the ground before it has landed.
    pub fn push(&mut self, side: Side, step: Step) -> &mut Step {
        let steps = &mut self.plan.feet[side as usize].steps;
        let free = steps.last().map_or(self.plan.start, |last| last.strike);
        assert!(
            step.toe_off() >= free - 1e-9,
            "the {} foot lifts at {:.2} s before landing at {free:.2} s",
            side.name(),
            step.toe_off()
        );
        steps.push(step);
        steps.last_mut().expect("a step was pushed")
    }

    /// Returns the last placement of a foot.
    pub fn placement(&self, side: Side) -> Placement {
        let foot = &self.plan.feet[side as usize];
        foot.steps.last().map_or(foot.start, |step| step.placement)
    }

    /// Returns the body tracks for editing.
    pub fn body(&mut self) -> &mut BodyTracks {
        &mut self.plan.body
    }

    /// Returns the plan of one foot for editing.
    pub fn foot(&mut self, side: Side) -> &mut FootPlan {
        &mut self.plan.feet[side as usize]
    }

    /// Returns the finished plan.
    pub fn finish(self) -> Plan {
        self.plan
    }
}

/// Returns the placement `width` metres outward of `cursor`, rotated outward by `toe_out` degrees.
pub fn foot_placement(cursor: &Placement, side: Side, width: f64, toe_out: f64) -> Placement {
    cursor.translated(0.0, lateral_sign(side) * width).rotated(lateral_sign(side) * toe_out)
}
