//! Skipping along: step and hop on one foot, step and hop on the other.

use plantigrade::foot::Side;

use super::other;
use crate::character::Build;
use crate::curve::Track;
use crate::plan::{ArmStyle, Carry, Gait, Held, Landing, Lift, Place, Plan, Planner, Step, beside};
use crate::random::Random;

/// Seconds of the parts of a skip: landed on the step, in the air, landed on the hop.
const STEP: f64 = 0.25;
const FLIGHT: f64 = 0.23;
const HOP: f64 = 0.25;

/// Skips from a stand to a stand.
pub fn skipping(build: &Build, seconds: f64, random: &mut Random) -> Plan {
    let scale = build.scale();
    let mut planner = Planner::standing(-1.0, Place::ORIGIN, 0.085 * scale);
    planner.wait_until(0.75);
    let walk = Gait::walk(scale);
    let mut side = Side::Right;
    planner.step(side, &Gait { time: 0.45, length: 0.4 * scale, swing: 0.36, ..walk.clone() });
    let mut arms = Vec::new();
    let mut swing_from = None;
    while planner.now() < seconds - 2.0 {
        let tempo = random.vary(0.03);
        let (step, flight, hop) = (STEP * tempo, FLIGHT * tempo, HOP * tempo);
        let length = scale * random.vary(0.05);
        // Hop on the standing foot.
        let struck = planner.now();
        planner.wait(step + flight);
        planner.advance(0.52 * length, 0.0);
        let landed = planner.now();
        let place = beside(&planner.cursor(), side, 0.05 * scale, 6.0);
        planner.push(side, hop_step(&walk, landed, flight, place));
        arms.push((struck + step + flight / 2.0, side));
        // The free leg, knee high during the hop, comes through to the next step.
        side = other(side);
        let strike = landed + hop;
        let off = swing_from.unwrap_or(struck + 0.06);
        planner.wait(hop);
        planner.advance(0.5 * length, 0.0);
        let place = beside(&planner.cursor(), side, 0.05 * scale, 6.0);
        planner.push(side, free_step(&walk, strike, strike - off, place, struck + step + flight * 0.5));
        swing_from = Some(strike + 0.04);
    }
    let last = planner.now();
    side = other(side);
    planner.step(side, &Gait { time: 0.52, length: 0.42 * scale, swing: 0.52 - 0.04, ..walk.clone() });
    side = other(side);
    let close = Landing { pitch: 10.0, ..Landing::BALL };
    planner.step(side, &Gait { time: 0.52, length: 0.05 * scale, swing: 0.4, landing: close, ..walk });
    carry_body(&mut planner, &arms, last);
    planner.finish()
}

fn hop_step(walk: &Gait, strike: f64, swing: f64, place: Place) -> Step {
    let carry = Carry {
        clearance: 0.05,
        peak: 0.45,
        pitch: 22.0,
        pitch_at: 0.55,
        ramps: (0.3, 0.3),
        ..walk.carry.clone()
    };
    let (lift, landing) =
        (Lift { pitch: 52.0, lead: 0.15 }, Landing { pitch: 15.0, settle: 0.07, rest: 0.0 });
    Step { strike, swing, place, lift, carry, landing, weight: 1.0 }
}

fn free_step(walk: &Gait, strike: f64, swing: f64, place: Place, high: f64) -> Step {
    // Thigh nearly level, shank hanging, toes a little down.
    let knee_high = [0.01, -0.55, 0.26, 16.0, 0.0];
    let held = Held {
        poses: Track::of(&[
            (high - 0.1, [0.0, -0.6, 0.08, 30.0, 0.0]),
            (high, knee_high),
            (high + 0.06, knee_high),
        ]),
        ease_in: (high - (strike - swing) - 0.02).max(0.15),
        ease_out: (strike - high - 0.05).max(0.2),
    };
    let carry =
        Carry { clearance: 0.12, pitch: 20.0, pitch_at: 0.45, held: Some(held), ..walk.carry.clone() };
    let landing = Landing { pitch: 8.0, settle: 0.07, rest: 0.0 };
    Step { strike, swing, place, lift: Lift { pitch: 46.0, lead: 0.14 }, carry, landing, weight: 1.0 }
}

/// Arms swing high against the legs; the trunk bounces along.
fn carry_body(planner: &mut Planner, hops: &[(f64, Side)], last: f64) {
    let body = planner.body();
    body.arm_swing.key(0.0, [8.0]);
    for (time, pitch) in [(0.4, 3.0), (1.4, 7.0), (last, 6.0), (last + 1.0, 2.0)] {
        body.trunk.key(time, [pitch, 0.0, 0.0]);
    }
    body.arms.iter_mut().for_each(|arm| arm.key(0.5, ArmStyle::LOOSE.angles()));
    for &(time, standing) in hops {
        // The arm of the standing side goes up with the other knee.
        body.arms[standing as usize].key(time, [62.0, 14.0, 16.0, 58.0, 0.0]);
        body.arms[other(standing) as usize].key(time, [-38.0, 20.0, 8.0, 28.0, 0.0]);
        let turn = if standing == Side::Left { -9.0 } else { 9.0 };
        body.trunk.key(time, [5.0, turn, 0.0]);
    }
    body.arms.iter_mut().for_each(|arm| arm.key(last + 1.1, ArmStyle::LOOSE.angles()));
}
