//! Walking on a curve to the left, starting in mid-stride.

use plantigrade::foot::Side;

use crate::actions::opposite;
use crate::character::Proportions;
use crate::math::Random;
use crate::plan::{Gait, Placement, Plan, Planner};

/// Radius of the curve, in metres.
const RADIUS: f64 = 2.4;

/// Plans a walk on a circle; the clip begins several steps after the start.
pub fn curved_walk(proportions: &Proportions, seconds: f64, random: &mut Random) -> Plan {
    let scale = proportions.scale();
    let mut planner = Planner::standing(-4.0, Placement::ORIGIN, 0.09 * scale);
    planner.wait(0.6);
    let mut side = Side::Right;
    while planner.now() < seconds + 2.0 {
        let mut gait = Gait::walk(scale);
        gait.length *= random.vary(0.03);
        gait.time *= random.vary(0.015);
        gait.turn = (gait.length / RADIUS).to_degrees();
        planner.step(side, &gait);
        side = opposite(side);
    }
    let body = planner.body();
    // Gaze and trunk turn into the curve.
    body.gaze.set_key(0.0, [10.0, 5.0]);
    body.trunk.set_key(0.0, [4.0, 3.0, 3.0]);
    planner.finish()
}
