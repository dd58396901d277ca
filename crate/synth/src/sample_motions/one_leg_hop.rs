//! Hopping on the left leg with the right foot raised behind.

use plantigrade::foot::Side;

use crate::character::Proportions;
use crate::math::{Random, Track};
use crate::plan::{
    ArmPose, EndMotion, Gait, Jump, Landing, LegPoses, Lift, Placement, Plan, Planner, SwingPath,
};

/// Plans standing, raising the right foot, hopping and lowering the foot.
pub fn one_leg_hop(proportions: &Proportions, seconds: f64, random: &mut Random) -> Plan {
    let scale = proportions.scale();
    let mut planner = Planner::standing(-1.0, Placement::ORIGIN, 0.09 * scale);
    planner.wait_until(1.15);
    let walk = Gait::walk(scale);
    let swing_path = SwingPath {
        clearance: 0.06 * scale,
        peak: 0.45,
        pitch: 12.0,
        pitch_at: 0.6,
        ramps: (0.3, 0.3),
        detour: 0.0,
        ..walk.swing_path.clone()
    };
    let mut arms = Vec::new();
    while planner.now() < seconds - 1.9 {
        let ground = 0.27 * random.vary(0.06);
        let flight = 0.26 * random.vary(0.08);
        let (take_off, touch_down) = EndMotion::jump(flight);
        let hop = Jump {
            ground,
            flight,
            length: 0.42 * scale * random.vary(0.12),
            turn: random.uniform(-2.0, 2.0),
            width: 0.035 * scale,
            lift: Lift { pitch: 40.0, lead: 0.13 },
            swing_path: SwingPath { take_off, touch_down, ..swing_path.clone() },
            landing: Landing { pitch: 14.0, settle: 0.08, rest: 0.0 },
        };
        planner.jump(&[Side::Left], &hop);
        arms.push((planner.now() - flight, planner.now()));
    }
    let last = planner.now();
    raise_right_foot(&mut planner, &walk, last, scale);
    animate_body(&mut planner, &arms, last);
    planner.finish()
}

/// Raises the right foot at the beginning and lowers it at the end.
fn raise_right_foot(planner: &mut Planner, walk: &Gait, last: f64, scale: f64) {
    let strike = last + 0.85;
    let placement = planner.placement(Side::Left).translated(0.05, -0.16 * scale).rotated(-16.0);
    // Ankle behind the hip, shank level; the leg bends slightly with every hop.
    let raised_leg = [0.02, -0.68, -0.36, 62.0, 0.0];
    let mut keys = vec![(0.0, raised_leg)];
    let mut time = 1.3;
    while time < last {
        keys.push((time, [0.02, -0.66, -0.37, 64.0, 0.0]));
        keys.push((time + 0.26, [0.02, -0.70, -0.34, 58.0, 0.0]));
        time += 0.53;
    }
    let step = planner.place_foot(Side::Right, strike, placement, walk);
    step.swing = strike - 0.62;
    step.lift = Lift { pitch: 40.0, lead: 0.22 };
    step.landing = Landing { pitch: 14.0, settle: 0.1, rest: 0.0 };
    step.swing_path.leg_poses =
        Some(LegPoses { poses: Track::from_keys(&keys), ease_in: 0.45, ease_out: 0.5 });
}

/// Spreads the arms for balance and swings them up with each hop.
fn animate_body(planner: &mut Planner, hops: &[(f64, f64)], last: f64) {
    let body = planner.body();
    body.arm_swing.set_key(0.0, [6.0]);
    body.pelvic_rotation = 3.0;
    body.trunk.set_key(0.4, [2.0, 0.0, 0.0]);
    body.trunk.set_key(1.0, [8.0, 0.0, 4.0]);
    for (side, arm) in body.arms.iter_mut().enumerate() {
        let wide = if side == 0 { 34.0 } else { 44.0 };
        arm.set_key(0.3, ArmPose::RELAXED.angles());
        for &(take_off, land) in hops {
            arm.set_key(take_off - 0.12, [-12.0, wide, 14.0, 46.0, 0.0]);
            arm.set_key((take_off + land) / 2.0, [26.0, wide + 8.0, 18.0, 66.0, 0.0]);
        }
        arm.set_key(last + 1.2, ArmPose::RELAXED.angles());
    }
    for &(take_off, land) in hops {
        body.trunk.set_key(take_off, [6.0, 0.0, 4.0]);
        body.trunk.set_key(land + 0.1, [12.0, 0.0, 5.0]);
    }
    body.trunk.set_key(last + 1.2, [3.0, 0.0, 0.0]);
}
