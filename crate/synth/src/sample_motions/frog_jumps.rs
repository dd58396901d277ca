//! Frog jumps: repeated two-footed jumps from a deep crouch.

use plantigrade::foot::Side;

use crate::character::Proportions;
use crate::math::Random;
use crate::plan::{ArmPose, EndMotion, Gait, Jump, Landing, Lift, Placement, Plan, Planner, SwingPath};

/// Arms behind the body, hands low: crouch before a jump.
const BACK: [f64; 5] = [-48.0, 16.0, 10.0, 12.0, 0.0];
/// Arms swung forward and up: flight.
const UP: [f64; 5] = [128.0, 14.0, 12.0, 24.0, -8.0];
/// Arms in front of the knees: landing.
const FRONT: [f64; 5] = [52.0, 12.0, 24.0, 26.0, 0.0];

/// Plans repeated jumps that end in standing.
pub fn frog_jumps(proportions: &Proportions, seconds: f64, random: &mut Random) -> Plan {
    let scale = proportions.scale();
    let mut planner = Planner::standing(-1.0, Placement::ORIGIN, 0.13 * scale);
    planner.wait_until(0.35);
    let mut landed = None;
    while planner.now() < seconds - 2.4 {
        let ground = if landed.is_none() { 1.0 } else { 0.98 * random.vary(0.05) };
        let flight = 0.44 * random.vary(0.04);
        let hop = hop(scale, ground, flight, 1.2 * scale * random.vary(0.05));
        planner.jump(&Side::BOTH, &hop);
        let land = planner.now();
        key_jump(&mut planner, landed, land - flight, land);
        landed = Some(land);
    }
    let last_landing = landed.expect("there was a jump");
    let body = planner.body();
    body.lowering.set_key(last_landing + 0.3, [0.12 * scale]);
    body.lowering.set_key(last_landing + 1.1, [0.0]);
    body.trunk.set_key(last_landing + 0.3, [44.0, 0.0, 0.0]);
    body.trunk.set_key(last_landing + 1.2, [3.0, 0.0, 0.0]);
    body.pelvis.set_key(last_landing + 1.2, [2.0, 0.0, 0.0]);
    for arm in &mut body.arms {
        arm.set_key(last_landing + 1.25, ArmPose::RELAXED.angles());
    }
    body.arm_swing.set_key(0.0, [0.0]);
    // The feet close after the body has straightened up.
    let gait = Gait { swing: 0.34, ..Gait::walk(scale) };
    let settle = Gait {
        lift: Lift { pitch: 22.0, lead: 0.2 },
        landing: Landing { pitch: 8.0, settle: 0.1, rest: 0.0 },
        ..gait
    };
    let placement = planner.placement(Side::Right).translated(0.02, 0.06 * scale);
    planner.place_foot(Side::Right, last_landing + 1.75, placement, &settle);
    planner.finish()
}

fn hop(scale: f64, ground: f64, flight: f64, length: f64) -> Jump {
    let (take_off, touch_down) = EndMotion::jump(flight);
    Jump {
        ground,
        flight,
        length,
        turn: 0.0,
        width: 0.13 * scale,
        lift: Lift { pitch: 66.0, lead: 0.26 },
        swing_path: SwingPath {
            clearance: 0.16 * scale,
            peak: 0.45,
            pitch: 34.0,
            pitch_at: 0.55,
            ramps: (0.25, 0.25),
            take_off,
            touch_down,
            ..Gait::walk(scale).swing_path
        },
        landing: Landing { pitch: 16.0, settle: 0.1, rest: 0.0 },
    }
}

/// Adds the keyframes of one jump: crouch, arm swing, flight, landing.
fn key_jump(planner: &mut Planner, last_landing: Option<f64>, take_off: f64, land: f64) {
    let body = planner.body();
    match last_landing {
        None => {
            body.lowering.set_key(take_off - 1.05, [0.0]);
            body.pelvis.set_key(take_off - 1.05, [2.0, 0.0, 0.0]);
            body.trunk.set_key(take_off - 1.05, [3.0, 0.0, 0.0]);
            body.arms.iter_mut().for_each(|arm| arm.set_key(take_off - 1.1, ArmPose::RELAXED.angles()));
        }
        Some(last_landing) => {
            body.lowering.set_key(last_landing + 0.3, [0.12]);
            body.trunk.set_key(last_landing + 0.3, [50.0, 0.0, 0.0]);
        }
    }
    for (time, lowering) in [(take_off - 0.4, 0.11), (take_off, 0.0), (land, 0.0)] {
        body.lowering.set_key(time, [lowering]);
    }
    for (time, pitch) in
        [(take_off - 0.36, 54.0), (take_off, 16.0), (take_off + 0.5 * (land - take_off), 24.0), (land, 36.0)]
    {
        body.trunk.set_key(time, [pitch, 0.0, 0.0]);
    }
    for (time, tilt) in [(take_off - 0.36, 22.0), (take_off, 4.0), (land, 16.0), (land + 0.3, 20.0)] {
        body.pelvis.set_key(time, [tilt, 0.0, 0.0]);
    }
    for arm in &mut body.arms {
        arm.set_key(take_off - 0.42, BACK);
        arm.set_key(take_off + 0.04, UP);
        arm.set_key(land + 0.14, FRONT);
    }
}
