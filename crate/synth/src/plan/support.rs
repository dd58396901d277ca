//! When the feet stand, and when neither does.

use super::{FootPlan, Landing, Lift, Place, Plan};

/// A stretch of time, in seconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Where it starts.
    pub start: f64,
    /// Where it ends.
    pub end: f64,
}

/// A foot standing in one place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stance {
    /// When the foot strikes; −∞ for the first stance.
    pub strike: f64,
    /// When it comes to rest.
    pub settled: f64,
    /// When the heel begins to rise.
    pub heel_off: f64,
    /// When the toe leaves; ∞ for the last stance.
    pub off: f64,
    /// Where the ball of the foot stands.
    pub place: Place,
    /// How the foot landed.
    pub landing: Landing,
    /// How it will leave.
    pub lift: Lift,
    /// The weight it takes.
    pub weight: f64,
}

/// The stances of a foot in order of time.
pub fn stances(foot: &FootPlan) -> Vec<Stance> {
    let mut found = Vec::with_capacity(foot.steps.len() + 1);
    for index in 0..=foot.steps.len() {
        let before = index.checked_sub(1).map(|index| &foot.steps[index]);
        let next = foot.steps.get(index);
        let strike = before.map_or(f64::NEG_INFINITY, |step| step.strike);
        let landing = before.map_or(Landing::FLAT, |step| step.landing);
        let off = next.map_or(f64::INFINITY, |step| step.off());
        let lift = next.map_or(Lift { pitch: 0.0, lead: 0.0 }, |step| step.lift);
        // A short stance has no time to rest: the roll begins where the landing ends.
        let settled = strike + landing.settle.min(0.5 * (off - strike));
        found.push(Stance {
            strike,
            settled,
            heel_off: (off - lift.lead).max(settled),
            off,
            place: before.map_or(foot.start, |step| step.place),
            landing,
            lift,
            weight: before.map_or(1.0, |step| step.weight),
        });
    }
    found
}

/// The times in which neither foot stands.
pub fn flights(plan: &Plan) -> Vec<Interval> {
    let airborne = plan.feet.each_ref().map(|foot| {
        foot.steps
            .iter()
            .filter(|step| !step.carry.grounded)
            .map(|step| Interval { start: step.off(), end: step.strike })
    });
    let [left, right] = airborne.map(Iterator::collect::<Vec<_>>);
    let mut found: Vec<Interval> = Vec::new();
    let mut begin = 0;
    for a in &left {
        while begin < right.len() && right[begin].end <= a.start {
            begin += 1;
        }
        found.extend(right[begin..].iter().take_while(|b| b.start < a.end).filter_map(|b| {
            let both = Interval { start: a.start.max(b.start), end: a.end.min(b.end) };
            (both.end - both.start > 1e-6).then_some(both)
        }));
    }
    found
}
