//! Ballet: plié, relevé, tendu, a pirouette, two small jumps, an arabesque.

use plantigrade::foot::Side::{self, Left, Right};

use crate::character::{Proportions, lateral_sign};
use crate::math::{Random, Track};
use crate::plan::{EndMotion, Gait, Landing, LegPoses, Lift, Placement, Plan, Planner, SwingPath};

/// Outward rotation of the feet in first position, in degrees.
const TURNOUT: f64 = 42.0;

/// Plans a short ballet study on the spot.
pub fn ballet(proportions: &Proportions, _seconds: f64, random: &mut Random) -> Plan {
    let scale = proportions.scale();
    let mut planner = Planner::standing(-1.0, Placement::ORIGIN, 0.1 * scale);
    for side in Side::BOTH {
        planner.foot(side).start = first_position(&Placement::ORIGIN, side, scale);
    }
    let tempo = random.vary(0.01);
    tendu(&mut planner, scale, 3.1 * tempo);
    pirouette(&mut planner, scale, 4.9 * tempo);
    let landed = jumps(&mut planner, scale, 7.1 * tempo);
    arabesque(&mut planner, scale, landed);
    animate_body(&mut planner, scale, landed);
    planner.finish()
}

fn first_position(cursor: &Placement, side: Side, scale: f64) -> Placement {
    cursor.translated(0.0, lateral_sign(side) * 0.115 * scale).rotated(lateral_sign(side) * TURNOUT)
}

fn ballet_step(scale: f64) -> Gait {
    let walk = Gait::walk(scale);
    Gait {
        swing: 0.42,
        lift: Lift { pitch: 40.0, lead: 0.22 },
        swing_path: SwingPath {
            clearance: 0.03 * scale,
            peak: 0.5,
            pitch: 40.0,
            pitch_at: 0.5,
            detour: 0.0,
            ramps: (0.3, 0.3),
            grounded: false,
            load: 0.0,
            take_off: EndMotion::SOFT,
            touch_down: EndMotion::SOFT,
            leg_poses: None,
        },
        landing: Landing { pitch: 34.0, settle: 0.16, rest: 0.0 },
        ..walk
    }
}

/// Tendu: the right foot extends to the side, rests on its toes and closes.
fn tendu(planner: &mut Planner, scale: f64, time: f64) {
    let extended = planner.placement(Right).translated(0.24 * scale, -0.2 * scale).rotated(-8.0);
    let pointed = Landing { pitch: 58.0, settle: 0.1, rest: 56.0 };
    planner.place_foot(Right, time, extended, &Gait { landing: pointed, ..ballet_step(scale) }).weight = 0.04;
    let closed = first_position(&Placement::ORIGIN, Right, scale);
    let lift = Lift { pitch: 58.0, lead: 0.1 };
    planner.place_foot(Right, time + 1.05, closed, &Gait { lift, ..ballet_step(scale) });
}

/// Pirouette: one rotation on the left foot, the right foot at the knee.
fn pirouette(planner: &mut Planner, scale: f64, time: f64) {
    let end = Placement::ORIGIN.rotated(360.0);
    let step =
        planner.place_foot(Right, time + 1.25, first_position(&end, Right, scale), &ballet_step(scale));
    step.swing = 1.2;
    step.swing_path.leg_poses = Some(LegPoses {
        poses: Track::from_keys(&[
            (time + 0.25, [0.22, -0.58, 0.1, 62.0, 62.0]),
            (time + 0.9, [0.22, -0.58, 0.1, 62.0, 62.0]),
        ]),
        ease_in: 0.26,
        ease_out: 0.36,
    });
    let left = planner.foot(Left);
    left.pivot = Track::from_keys(&[(time + 0.12, [0.0]), (time + 0.6, [200.0]), (time + 1.16, [360.0])]);
    left.heel_raise = Track::from_keys(&[
        (0.0, [0.0]),
        (1.55, [0.0]),
        (1.95, [48.0]),
        (2.3, [48.0]),
        (2.65, [0.0]),
        (time - 0.12, [0.0]),
        (time + 0.16, [50.0]),
        (time + 1.0, [50.0]),
        (time + 1.3, [0.0]),
    ]);
    // Both heels rise in the first relevé.
    planner.foot(Right).heel_raise =
        Track::from_keys(&[(1.55, [0.0]), (1.95, [48.0]), (2.3, [48.0]), (2.62, [0.0])]);
}

/// Two vertical jumps. Returns the time of the second landing.
fn jumps(planner: &mut Planner, scale: f64, time: f64) -> f64 {
    let mut land = time;
    let cursor = Placement::ORIGIN.rotated(360.0);
    for ground in [0.0, 0.5] {
        land += ground + 0.4;
        for side in Side::BOTH {
            let placement = first_position(&cursor.translated(0.02, 0.0), side, scale);
            let gait = vertical_jump(scale);
            planner.place_foot(side, land, placement, &gait);
        }
    }
    land
}

/// Returns a vertical jump with pointed feet.
fn vertical_jump(scale: f64) -> Gait {
    let ballet_step = ballet_step(scale);
    Gait {
        swing: 0.4,
        lift: Lift { pitch: 64.0, lead: 0.18 },
        swing_path: SwingPath { clearance: 0.13 * scale, pitch: 66.0, ..ballet_step.swing_path.clone() },
        landing: Landing { pitch: 44.0, settle: 0.16, rest: 0.0 },
        ..ballet_step
    }
}

/// Arabesque: a step onto the right foot, the left leg extended behind, then closed.
fn arabesque(planner: &mut Planner, scale: f64, landed: f64) {
    let front = Placement::ORIGIN.rotated(360.0).translated(0.46 * scale, -0.05 * scale).rotated(-14.0);
    let step = ballet_step(scale);
    planner.place_foot(Right, landed + 1.2, front, &step);
    let closed = front.rotated(14.0).translated(-0.06 * scale, 0.2 * scale).rotated(30.0);
    let left = planner.place_foot(Left, landed + 3.55, closed, &step);
    left.swing = 2.05;
    left.lift = Lift { pitch: 50.0, lead: 0.24 };
    left.swing_path.leg_poses = Some(LegPoses {
        poses: Track::from_keys(&[
            (landed + 1.75, [0.04, -0.8, -0.5, 80.0, 18.0]),
            (landed + 2.2, [0.06, -0.3, -0.93, 100.0, 24.0]),
            (landed + 2.7, [0.06, -0.27, -0.94, 102.0, 24.0]),
            (landed + 3.15, [0.06, -0.85, -0.4, 78.0, 18.0]),
        ]),
        ease_in: 0.3,
        ease_out: 0.5,
    });
}

fn animate_body(planner: &mut Planner, scale: f64, landed: f64) {
    let body = planner.body();
    body.arm_swing.set_key(0.0, [0.0]);
    body.pelvic_rotation = 0.0;
    body.pelvic_drop = 1.5;
    body.sway = 0.6;
    let low = [20.0, 16.0, 34.0, 34.0, 8.0];
    let first = [62.0, 26.0, 44.0, 62.0, 6.0];
    let second = [16.0, 80.0, -10.0, 24.0, -4.0];
    let fifth = [160.0, 24.0, 20.0, 44.0, 8.0];
    let shared = [
        (0.4, low),
        (1.1, first),
        (1.9, fifth),
        (2.35, fifth),
        (2.9, second),
        (4.4, second),
        (4.85, first),
        (5.6, first),
        (6.3, second),
        (7.0, low),
        (landed, low),
        (landed + 0.6, first),
    ];
    for (side, arm) in body.arms.iter_mut().enumerate() {
        for (time, angles) in shared {
            arm.set_key(time, angles);
        }
        let reach = if side == 1 { [92.0, 8.0, 0.0, 6.0, -6.0] } else { [-6.0, 86.0, -10.0, 10.0, -8.0] };
        arm.set_key(landed + 1.9, reach);
        arm.set_key(landed + 2.8, reach);
        arm.set_key(landed + 3.7, low);
    }
    for (time, trunk) in [
        (0.0, [1.0, 0.0, 0.0]),
        (3.2, [0.0, 0.0, 3.0]),
        (4.6, [0.0, 0.0, 0.0]),
        (landed + 1.2, [2.0, 0.0, 0.0]),
        (landed + 2.2, [16.0, 0.0, 0.0]),
        (landed + 2.75, [17.0, 0.0, 0.0]),
        (landed + 3.6, [1.0, 0.0, 0.0]),
    ] {
        body.trunk.set_key(time, trunk);
        body.pelvis.set_key(time, [1.4 * trunk[0], 0.0, 0.0]);
    }
    // Plié, relevé, plié before the turn, up on the ball, down.
    for (time, lowering) in [
        (0.35, 0.0),
        (0.95, 0.13),
        (1.5, 0.0),
        (1.95, -0.1),
        (2.3, -0.1),
        (2.7, 0.0),
        (4.25, 0.0),
        (4.62, 0.1),
        (5.08, -0.1),
        (5.85, -0.1),
        (6.25, 0.06),
        (6.6, 0.0),
        (landed + 0.9, 0.03),
        (landed + 1.7, 0.0),
        (landed + 3.6, 0.02),
        (landed + 4.2, 0.0),
    ] {
        body.lowering.set_key(time, [lowering * scale]);
    }
    body.gaze.set_key(0.0, [0.0, 0.0]);
}
