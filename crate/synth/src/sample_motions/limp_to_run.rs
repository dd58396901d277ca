//! A limping walk that becomes a limping run.

use plantigrade::foot::Side;

use crate::actions::opposite;
use crate::character::Proportions;
use crate::math::Random;
use crate::math::Track;
use crate::math::lerp;
use crate::plan::{ArmPose, Gait, Landing, Lift, Placement, Plan, Planner, SwingPath};

/// Time of the change from walking to running, in seconds.
const CHANGE: f64 = 15.5;

/// Plans limping on the left leg: walking, running, slowing to a stop.
pub fn limp_to_run(proportions: &Proportions, seconds: f64, random: &mut Random) -> Plan {
    let scale = proportions.scale();
    let mut planner = Planner::standing(-1.0, Placement::ORIGIN, 0.085 * scale);
    planner.wait_until(0.6);
    let mut side = Side::Left;
    let mut punches = Vec::new();
    let mut pace: f64 = 0.0;
    while planner.now() < seconds - 3.0 {
        let running = planner.now() > CHANGE;
        if running {
            pace = (pace + 0.12).min(1.0);
        }
        let mut gait = if running { run(scale, side, pace) } else { walk(scale, side) };
        gait.length *= random.vary(0.05);
        gait.time *= random.vary(0.02);
        gait.turn = random.uniform(-2.0, 2.0);
        planner.step(side, &gait);
        punches.push((planner.now(), side));
        side = opposite(side);
    }
    let stop = planner.now();
    for length in [0.62, 0.5, 0.3, 0.04] {
        let mut gait = walk(scale, side);
        gait.length = length * scale;
        if length < 0.1 {
            gait.landing = Landing { pitch: 8.0, settle: 0.1, rest: 0.0 };
        }
        planner.step(side, &gait);
        side = opposite(side);
    }
    animate_body(&mut planner, &punches, stop);
    planner.finish()
}

/// The left leg bears weight briefly and stiffly; the right leg swings quickly.
fn walk(scale: f64, side: Side) -> Gait {
    let walk = Gait::walk(scale);
    match side {
        Side::Left => Gait {
            time: 0.66,
            length: 0.56 * scale,
            swing: 0.5,
            landing: Landing { pitch: -9.0, settle: 0.08, rest: 0.0 },
            swing_path: SwingPath { clearance: 0.05 * scale, pitch: 4.0, detour: 0.05, ..walk.swing_path },
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
    let swing_path = SwingPath {
        clearance: lerp(0.1, 0.22, pace) * scale,
        pitch: lerp(25.0, 62.0, pace),
        ..jog.swing_path
    };
    match side {
        Side::Left => Gait {
            time: lerp(0.5, 0.42, pace),
            length: lerp(0.7, 1.0, pace) * scale,
            swing: lerp(0.45, 0.5, pace),
            lift: Lift { pitch: 44.0, lead: 0.12 },
            swing_path: SwingPath {
                clearance: 0.7 * swing_path.clearance,
                pitch: 0.7 * swing_path.pitch,
                detour: 0.04,
                ..swing_path
            },
            landing: Landing { pitch: 8.0, settle: 0.06, rest: 0.0 },
            ..jog
        },
        Side::Right => Gait {
            time: lerp(0.4, 0.31, pace),
            length: lerp(0.6, 0.72, pace) * scale,
            swing: lerp(0.34, 0.4, pace),
            swing_path,
            ..jog
        },
    }
}

/// A lurch over the left leg in each of its stances.
fn animate_body(planner: &mut Planner, punches: &[(f64, Side)], stop: f64) {
    let body = planner.body();
    for &(time, side) in punches {
        let running = time > CHANGE + 1.0;
        let (after, pitch) = if running { (0.1, 9.0) } else { (0.2, 6.0) };
        let (lean, lowering) = if side == Side::Left { (9.0, 0.035) } else { (-2.0, 0.0) };
        body.trunk.set_key(time + after, [pitch + 0.5 * lean, 0.0, lean]);
        body.lowering.set_key(time + after, [if running { 0.4 * lowering } else { lowering }]);
    }
    body.trunk.set_key(stop + 1.6, [3.0, 0.0, 0.0]);
    body.lowering.set_key(stop + 1.2, [0.0]);
    for arm in &mut body.arms {
        arm.set_key(CHANGE - 1.0, ArmPose { abduction: 13.0, elbow: 28.0, ..ArmPose::RELAXED }.angles());
        arm.set_key(CHANGE + 1.5, ArmPose { elbow: 70.0, ..ArmPose::RUNNING }.angles());
        arm.set_key(stop, ArmPose { elbow: 70.0, ..ArmPose::RUNNING }.angles());
        arm.set_key(stop + 1.8, ArmPose::RELAXED.angles());
    }
    body.arm_swing = Track::from_keys(&[(CHANGE, [30.0]), (CHANGE + 2.0, [42.0])]);
    body.gaze.set_key(0.0, [0.0, 9.0]);
}
