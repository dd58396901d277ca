//! Writing a plan step by step, along a way.

use plantigrade::foot::Side;

use super::{Body, FootPlan, Gait, Hop, Place, Plan, Step};
use crate::character::outward;
use crate::curve::Track;

/// Writes a plan along a way: a cursor moves on and feet step beside it.
pub struct Planner {
    plan: Plan,
    cursor: Place,
    time: f64,
}

impl Planner {
    /// Both feet stand beside `cursor`, `width` metres from it, from `start` on.
    pub fn standing(start: f64, cursor: Place, width: f64) -> Planner {
        let foot = |side: Side| FootPlan {
            start: beside(&cursor, side, width, 8.0),
            steps: Vec::new(),
            raise: Track::constant([0.0]),
            pivot: Track::constant([0.0]),
        };
        let plan = Plan { start, feet: Side::BOTH.map(foot), body: Body::default() };
        Planner { plan, cursor, time: start }
    }

    /// Seconds of the clip up to which the plan is written.
    pub fn now(&self) -> f64 {
        self.time
    }

    /// Where the body is.
    pub fn cursor(&self) -> Place {
        self.cursor
    }

    /// Lets `seconds` pass.
    pub fn wait(&mut self, seconds: f64) {
        self.time += seconds;
    }

    /// Lets time pass until `time`.
    pub fn wait_until(&mut self, time: f64) {
        self.time = self.time.max(time);
    }

    /// Moves the cursor `length` metres on along an arc of `turn` degrees.
    pub fn advance(&mut self, length: f64, turn: f64) {
        self.cursor = self.cursor.turned(turn / 2.0).moved(length, 0.0).turned(turn / 2.0);
    }

    /// Moves the cursor up by `rise` metres: the next step is on higher ground.
    pub fn climb(&mut self, rise: f64) {
        self.cursor = self.cursor.raised(rise);
    }

    /// Moves the cursor to `cursor`, keeping the heading.
    pub fn move_to(&mut self, cursor: Place) {
        self.cursor = Place { heading: self.cursor.heading, ..cursor };
    }

    /// Takes one step: the body moves on and the foot lands beside it.
    pub fn step(&mut self, side: Side, gait: &Gait) {
        self.time += gait.time;
        self.advance(gait.length, gait.turn);
        let place = beside(&self.cursor, side, gait.width, gait.toe_out);
        self.put(side, self.time, place, gait);
    }

    /// Puts a foot down at `place` at the time `strike` in the manner of `gait`, the
    /// cursor staying where it is.
    pub fn put(&mut self, side: Side, strike: f64, place: Place, gait: &Gait) -> &mut Step {
        let step = Step {
            strike,
            swing: gait.swing,
            place,
            lift: gait.lift,
            carry: gait.carry.clone(),
            landing: gait.landing,
            weight: 1.0,
        };
        self.push(side, step)
    }

    /// Jumps with `feet` and lands on them.
    pub fn jump(&mut self, feet: &[Side], hop: &Hop) {
        self.time += hop.ground + hop.flight;
        self.advance(hop.length, hop.turn);
        for &side in feet {
            let place = beside(&self.cursor, side, hop.width, 8.0);
            let step = Step {
                strike: self.time,
                swing: hop.flight,
                place,
                lift: hop.lift,
                carry: hop.carry.clone(),
                landing: hop.landing,
                weight: 1.0,
            };
            self.push(side, step);
        }
    }

    /// Adds a step as it is.
    ///
    /// # Panics
    /// If the foot would lift off before it has landed.
    pub fn push(&mut self, side: Side, step: Step) -> &mut Step {
        let steps = &mut self.plan.feet[side as usize].steps;
        let free = steps.last().map_or(self.plan.start, |last| last.strike);
        assert!(
            step.off() >= free - 1e-9,
            "the {} foot lifts at {:.2} s before landing at {free:.2} s",
            side.name(),
            step.off()
        );
        steps.push(step);
        steps.last_mut().expect("a step was pushed")
    }

    /// The last place a foot was put.
    pub fn place(&self, side: Side) -> Place {
        let foot = &self.plan.feet[side as usize];
        foot.steps.last().map_or(foot.start, |step| step.place)
    }

    /// The carriage of the body, to be keyed.
    pub fn body(&mut self) -> &mut Body {
        &mut self.plan.body
    }

    /// The plan of one foot, to be changed.
    pub fn foot(&mut self, side: Side) -> &mut FootPlan {
        &mut self.plan.feet[side as usize]
    }

    /// The finished plan.
    pub fn finish(self) -> Plan {
        self.plan
    }
}

/// The place `width` metres outward of `cursor` with the toes turned out.
pub fn beside(cursor: &Place, side: Side, width: f64, toe_out: f64) -> Place {
    cursor.moved(0.0, outward(side) * width).turned(outward(side) * toe_out)
}
