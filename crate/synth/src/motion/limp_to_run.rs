//! A limping walk that becomes a limping run.

use plantigrade::foot::Side;

use super::other;
use crate::character::Build;
use crate::curve::Track;
use crate::maths::lerp;
use crate::plan::{ArmStyle, Carry, Gait, Landing, Lift, Place, Plan, Planner};
use crate::random::Random;

/// Seconds at which the walk turns into a run.
const CHANGE: f64 = 15.5;

/// Limps on the left leg: walking at first, then running, then slowing to a stand.
pub fn limp_to_run(build: &Build, seconds: f64, random: &mut Random) -> Plan {
    let scale = build.scale();
    let mut planner = Planner::standing(-1.0, Place::ORIGIN, 0.085 * scale);
    planner.wait_until(0.6);
    let mut side = Side::Left;
    let mut strikes = Vec::new();
    let mut pace: f64 = 0.0;
    while planner.now() < seconds - 3.0 {
        let running = planner.now() > CHANGE;
        if running {
            pace = (pace + 0.12).min(1.0);
        }
        let mut gait = if running { run(scale, side, pace) } else { walk(scale, side) };
        gait.length *= random.vary(0.05);
        gait.time *= random.vary(0.02);
        gait.turn = random.between(-2.0, 2.0);
        planner.step(side, &gait);
        strikes.push((planner.now(), side));
        side = other(side);
    }
    let stop = planner.now();
    for length in [0.62, 0.5, 0.3, 0.04] {
        let mut gait = walk(scale, side);
        gait.length = length * scale;
        if length < 0.1 {
            gait.landing = Landing { pitch: 8.0, settle: 0.1, rest: 0.0 };
        }
        planner.step(side, &gait);
        side = other(side);
    }
    carry_body(&mut planner, &strikes, stop);
    planner.finish()
}

/// The bad left leg takes weight briefly and stiffly; the good one hurries through.
fn walk(scale: f64, side: Side) -> Gait {
    let walk = Gait::walk(scale);
    match side {
        Side::Left => Gait {
            time: 0.66,
            length: 0.56 * scale,
            swing: 0.5,
            landing: Landing { pitch: -9.0, settle: 0.08, rest: 0.0 },
            carry: Carry { clearance: 0.05 * scale, pitch: 4.0, detour: 0.05, ..walk.carry },
            ..walk
        },
        Side::Right => Gait {
            time: 0.45,
            length: 0.42 * scale,
            swing: 0.33,
            lift: Lift { pitch: 44.0, lead: 0.2 },
            ..walk
        },
    }
}

fn run(scale: f64, side: Side, pace: f64) -> Gait {
    let jog = Gait::jog(scale);
    let carry =
        Carry { clearance: lerp(0.1, 0.22, pace) * scale, pitch: lerp(25.0, 62.0, pace), ..jog.carry };
    match side {
        Side::Left => Gait {
            time: lerp(0.5, 0.42, pace),
            length: lerp(0.7, 1.0, pace) * scale,
            swing: lerp(0.45, 0.5, pace),
            lift: Lift { pitch: 44.0, lead: 0.12 },
            carry: Carry {
                clearance: 0.7 * carry.clearance,
                pitch: 0.7 * carry.pitch,
                detour: 0.04,
                ..carry
            },
            landing: Landing { pitch: 8.0, settle: 0.06, rest: 0.0 },
            ..jog
        },
        Side::Right => Gait {
            time: lerp(0.4, 0.31, pace),
            length: lerp(0.6, 0.72, pace) * scale,
            swing: lerp(0.34, 0.4, pace),
            carry,
            ..jog
        },
    }
}

/// A lurch over the bad leg in every stance of it.
fn carry_body(planner: &mut Planner, strikes: &[(f64, Side)], stop: f64) {
    let body = planner.body();
    for &(time, side) in strikes {
        let running = time > CHANGE + 1.0;
        let (after, pitch) = if running { (0.1, 9.0) } else { (0.2, 6.0) };
        let (lean, sink) = if side == Side::Left { (9.0, 0.035) } else { (-2.0, 0.0) };
        body.trunk.key(time + after, [pitch + 0.5 * lean, 0.0, lean]);
        body.sink.key(time + after, [if running { 0.4 * sink } else { sink }]);
    }
    body.trunk.key(stop + 1.6, [3.0, 0.0, 0.0]);
    body.sink.key(stop + 1.2, [0.0]);
    for arm in &mut body.arms {
        arm.key(CHANGE - 1.0, ArmStyle { abduct: 13.0, elbow: 28.0, ..ArmStyle::LOOSE }.angles());
        arm.key(CHANGE + 1.5, ArmStyle { elbow: 70.0, ..ArmStyle::RUNNING }.angles());
        arm.key(stop, ArmStyle { elbow: 70.0, ..ArmStyle::RUNNING }.angles());
        arm.key(stop + 1.8, ArmStyle::LOOSE.angles());
    }
    body.arm_swing = Track::of(&[(CHANGE, [30.0]), (CHANGE + 2.0, [42.0])]);
    body.look.key(0.0, [0.0, 9.0]);
}
