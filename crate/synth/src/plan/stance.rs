//! Stances and flights of a plan.

use super::{FootPlan, Landing, Lift, Placement, Plan};

/// Time interval, in seconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Start.
    pub start: f64,
    /// End.
    pub end: f64,
}

/// Stance of one foot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stance {
    /// Time of the foot strike; −∞ for the first stance.
    pub strike: f64,
    /// Time at which the foot is at rest.
    pub settled: f64,
    /// Time of heel-off.
    pub heel_off: f64,
    /// Time of toe-off; ∞ for the last stance.
    pub toe_off: f64,
    /// Placement of the ball of the foot.
    pub placement: Placement,
    /// Landing at the start.
    pub landing: Landing,
    /// Push-off at the end.
    pub lift: Lift,
    /// Fraction of the body weight that the foot bears.
    pub weight: f64,
}

/// Returns the stances of a foot in order of time.
pub fn stances(foot: &FootPlan) -> Vec<Stance> {
    let mut stances = Vec::with_capacity(foot.steps.len() + 1);
    for index in 0..=foot.steps.len() {
        let before = index.checked_sub(1).map(|index| &foot.steps[index]);
        let next = foot.steps.get(index);
        let strike = before.map_or(f64::NEG_INFINITY, |step| step.strike);
        let landing = before.map_or(Landing::FLAT, |step| step.landing);
        let toe_off = next.map_or(f64::INFINITY, |step| step.toe_off());
        let lift = next.map_or(Lift { pitch: 0.0, lead: 0.0 }, |step| step.lift);
        // A short stance has no rest phase: heel-off follows the landing immediately.
        let settled = strike + landing.settle.min(0.5 * (toe_off - strike));
        stances.push(Stance {
            strike,
            settled,
            heel_off: (toe_off - lift.lead).max(settled),
            toe_off,
            placement: before.map_or(foot.start, |step| step.placement),
            landing,
            lift,
            weight: before.map_or(1.0, |step| step.weight),
        });
    }
    stances
}

/// Returns the intervals in which neither foot touches the ground.
pub fn flights(plan: &Plan) -> Vec<Interval> {
    let airborne = plan.feet.each_ref().map(|foot| {
        foot.steps
            .iter()
            .filter(|step| !step.swing_path.grounded)
            .map(|step| Interval { start: step.toe_off(), end: step.strike })
    });
    let [left, right] = airborne.map(Iterator::collect::<Vec<_>>);
    let mut flights: Vec<Interval> = Vec::new();
    let mut first = 0;
    for a in &left {
        while first < right.len() && right[first].end <= a.start {
            first += 1;
        }
        flights.extend(right[first..].iter().take_while(|b| b.start < a.end).filter_map(|b| {
            let both = Interval { start: a.start.max(b.start), end: a.end.min(b.end) };
            (both.end - both.start > 1e-6).then_some(both)
        }));
    }
    flights
}
