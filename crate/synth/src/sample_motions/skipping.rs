//! Skipping: step and hop on one foot, step and hop on the other.

use plantigrade::foot::Side;

use crate::actions::opposite;
use crate::character::Proportions;
use crate::math::{Random, Track};
use crate::plan::{
    ArmPose, EndMotion, Gait, Landing, LegPoses, Lift, Placement, Plan, Planner, Step, SwingPath,
    foot_placement,
};

/// Durations of the phases of a skip, in seconds: stance after the step, flight, stance after the
/// hop.
const STEP: f64 = 0.25;
const FLIGHT: f64 = 0.23;
const HOP: f64 = 0.25;

/// Plans skipping from standing to standing.
pub fn skipping(proportions: &Proportions, seconds: f64, random: &mut Random) -> Plan {
    let scale = proportions.scale();
    let mut planner = Planner::standing(-1.0, Placement::ORIGIN, 0.085 * scale);
    planner.wait_until(0.75);
    let walk = Gait::walk(scale);
    let mut side = Side::Right;
    planner.step(side, &Gait { time: 0.45, length: 0.4 * scale, swing: 0.36, ..walk.clone() });
    let mut arms = Vec::new();
    let mut next_toe_off = None;
    while planner.now() < seconds - 2.0 {
        let tempo = random.vary(0.03);
        let (step, flight, hop) = (STEP * tempo, FLIGHT * tempo, HOP * tempo);
        let length = scale * random.vary(0.05);
        // Hop on the standing foot.
        let step_strike = planner.now();
        planner.wait(step + flight);
        planner.advance(0.52 * length, 0.0);
        let landed = planner.now();
        let placement = foot_placement(&planner.cursor(), side, 0.05 * scale, 6.0);
        planner.push(side, hop_step(&walk, landed, flight, placement));
        arms.push((step_strike + step + flight / 2.0, side));
        // The free leg, knee raised during the hop, swings to the next step.
        side = opposite(side);
        let strike = landed + hop;
        let toe_off = next_toe_off.unwrap_or(step_strike + 0.06);
        planner.wait(hop);
        planner.advance(0.5 * length, 0.0);
        let placement = foot_placement(&planner.cursor(), side, 0.05 * scale, 6.0);
        planner.push(
            side,
            free_step(&walk, strike, strike - toe_off, placement, step_strike + step + flight * 0.5),
        );
        next_toe_off = Some(strike + 0.04);
    }
    let last = planner.now();
    side = opposite(side);
    planner.step(side, &Gait { time: 0.52, length: 0.42 * scale, swing: 0.52 - 0.04, ..walk.clone() });
    side = opposite(side);
    let close = Landing { pitch: 10.0, ..Landing::BALL };
    planner.step(side, &Gait { time: 0.52, length: 0.05 * scale, swing: 0.4, landing: close, ..walk });
    animate_body(&mut planner, &arms, last);
    planner.finish()
}

fn hop_step(walk: &Gait, strike: f64, swing: f64, placement: Placement) -> Step {
    let (take_off, touch_down) = EndMotion::jump(swing);
    let swing_path = SwingPath {
        clearance: 0.05,
        peak: 0.45,
        pitch: 22.0,
        pitch_at: 0.55,
        ramps: (0.3, 0.3),
        take_off,
        touch_down,
        ..walk.swing_path.clone()
    };
    let (lift, landing) =
        (Lift { pitch: 52.0, lead: 0.15 }, Landing { pitch: 15.0, settle: 0.07, rest: 0.0 });
    Step { strike, swing, placement, lift, swing_path, landing, weight: 1.0 }
}

fn free_step(walk: &Gait, strike: f64, swing: f64, placement: Placement, knee_raised: f64) -> Step {
    // Thigh almost horizontal, shank vertical, toes slightly down.
    let knee_high = [0.01, -0.55, 0.26, 16.0, 0.0];
    let leg_poses = LegPoses {
        poses: Track::from_keys(&[
            (knee_raised - 0.1, [0.0, -0.6, 0.08, 30.0, 0.0]),
            (knee_raised, knee_high),
            (knee_raised + 0.06, knee_high),
        ]),
        ease_in: (knee_raised - (strike - swing) - 0.02).max(0.15),
        ease_out: (strike - knee_raised - 0.05).max(0.2),
    };
    let swing_path = SwingPath {
        clearance: 0.12,
        pitch: 20.0,
        pitch_at: 0.45,
        leg_poses: Some(leg_poses),
        ..walk.swing_path.clone()
    };
    let landing = Landing { pitch: 8.0, settle: 0.07, rest: 0.0 };
    Step {
        strike,
        swing,
        placement,
        lift: Lift { pitch: 46.0, lead: 0.14 },
        swing_path,
        landing,
        weight: 1.0,
    }
}

/// Swings the arms opposite to the legs; the trunk rotates with them.
fn animate_body(planner: &mut Planner, hops: &[(f64, Side)], last: f64) {
    let body = planner.body();
    body.arm_swing.set_key(0.0, [8.0]);
    for (time, pitch) in [(0.4, 3.0), (1.4, 7.0), (last, 6.0), (last + 1.0, 2.0)] {
        body.trunk.set_key(time, [pitch, 0.0, 0.0]);
    }
    body.arms.iter_mut().for_each(|arm| arm.set_key(0.5, ArmPose::RELAXED.angles()));
    for &(time, standing) in hops {
        // The arm on the standing side rises with the opposite knee.
        body.arms[standing as usize].set_key(time, [62.0, 14.0, 16.0, 58.0, 0.0]);
        body.arms[opposite(standing) as usize].set_key(time, [-38.0, 20.0, 8.0, 28.0, 0.0]);
        let turn = if standing == Side::Left { -9.0 } else { 9.0 };
        body.trunk.set_key(time, [5.0, turn, 0.0]);
    }
    body.arms.iter_mut().for_each(|arm| arm.set_key(last + 1.1, ArmPose::RELAXED.angles()));
}
