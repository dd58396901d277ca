//! Hopping on the left leg, the right foot held up behind.

use plantigrade::foot::Side;

use crate::character::Build;
use crate::curve::Track;
use crate::plan::{ArmStyle, Carry, Gait, Held, Hop, Landing, Lift, Place, Plan, Planner};
use crate::random::Random;

/// Stands, lifts the right foot, hops on, puts it down again.
pub fn one_leg_hop(build: &Build, seconds: f64, random: &mut Random) -> Plan {
    let scale = build.scale();
    let mut planner = Planner::standing(-1.0, Place::ORIGIN, 0.09 * scale);
    planner.wait_until(1.15);
    let walk = Gait::walk(scale);
    let carry = Carry {
        clearance: 0.06 * scale,
        peak: 0.45,
        pitch: 12.0,
        pitch_at: 0.6,
        ramps: (0.3, 0.3),
        detour: 0.0,
        ..walk.carry.clone()
    };
    let mut arms = Vec::new();
    while planner.now() < seconds - 1.9 {
        let ground = 0.27 * random.vary(0.06);
        let flight = 0.26 * random.vary(0.08);
        let hop = Hop {
            ground,
            flight,
            length: 0.42 * scale * random.vary(0.12),
            turn: random.between(-2.0, 2.0),
            width: 0.035 * scale,
            lift: Lift { pitch: 40.0, lead: 0.13 },
            carry: carry.clone(),
            landing: Landing { pitch: 14.0, settle: 0.08, rest: 0.0 },
        };
        planner.jump(&[Side::Left], &hop);
        arms.push((planner.now() - flight, planner.now()));
    }
    let last = planner.now();
    put_down(&mut planner, &walk, last, scale);
    carry_body(&mut planner, &arms, last);
    planner.finish()
}

/// The right foot leaves the ground at the beginning and comes down at the end.
fn put_down(planner: &mut Planner, walk: &Gait, last: f64, scale: f64) {
    let strike = last + 0.85;
    let place = planner.place(Side::Left).moved(0.05, -0.16 * scale).turned(-16.0);
    // Ankle behind the hip, shank level; it gives a little with every hop.
    let tucked = [0.02, -0.68, -0.36, 62.0, 0.0];
    let mut keys = vec![(0.0, tucked)];
    let mut time = 1.3;
    while time < last {
        keys.push((time, [0.02, -0.66, -0.37, 64.0, 0.0]));
        keys.push((time + 0.26, [0.02, -0.70, -0.34, 58.0, 0.0]));
        time += 0.53;
    }
    let step = planner.put(Side::Right, strike, place, walk);
    step.swing = strike - 0.62;
    step.lift = Lift { pitch: 40.0, lead: 0.22 };
    step.landing = Landing { pitch: 14.0, settle: 0.1, rest: 0.0 };
    step.carry.held = Some(Held { poses: Track::of(&keys), ease_in: 0.45, ease_out: 0.5 });
}

/// Arms out for balance, thrown up with each hop.
fn carry_body(planner: &mut Planner, hops: &[(f64, f64)], last: f64) {
    let body = planner.body();
    body.arm_swing.key(0.0, [6.0]);
    body.pelvis_turn = 3.0;
    body.trunk.key(0.4, [2.0, 0.0, 0.0]);
    body.trunk.key(1.0, [8.0, 0.0, 4.0]);
    for (side, arm) in body.arms.iter_mut().enumerate() {
        let wide = if side == 0 { 34.0 } else { 44.0 };
        arm.key(0.3, ArmStyle::LOOSE.angles());
        for &(off, land) in hops {
            arm.key(off - 0.12, [-12.0, wide, 14.0, 46.0, 0.0]);
            arm.key((off + land) / 2.0, [26.0, wide + 8.0, 18.0, 66.0, 0.0]);
        }
        arm.key(last + 1.2, ArmStyle::LOOSE.angles());
    }
    for &(off, land) in hops {
        body.trunk.key(off, [6.0, 0.0, 4.0]);
        body.trunk.key(land + 0.1, [12.0, 0.0, 5.0]);
    }
    body.trunk.key(last + 1.2, [3.0, 0.0, 0.0]);
}
