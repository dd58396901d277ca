//! Walking on a curve to the left, caught in mid-stride.

use plantigrade::foot::Side;

use super::other;
use crate::character::Build;
use crate::plan::{Gait, Place, Plan, Planner};
use crate::random::Random;

/// Metres from the middle of the curve.
const RADIUS: f64 = 2.4;

/// Walks on a circle; the clip begins some steps after the start.
pub fn curved_walk(build: &Build, seconds: f64, random: &mut Random) -> Plan {
    let scale = build.scale();
    let mut planner = Planner::standing(-4.0, Place::ORIGIN, 0.09 * scale);
    planner.wait(0.6);
    let mut side = Side::Right;
    while planner.now() < seconds + 2.0 {
        let mut gait = Gait::walk(scale);
        gait.length *= random.vary(0.03);
        gait.time *= random.vary(0.015);
        gait.turn = (gait.length / RADIUS).to_degrees();
        planner.step(side, &gait);
        side = other(side);
    }
    let body = planner.body();
    // Into the curve with the eyes and a little with the whole body.
    body.look.key(0.0, [10.0, 5.0]);
    body.trunk.key(0.0, [4.0, 3.0, 3.0]);
    planner.finish()
}
