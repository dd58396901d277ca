//! Drunken staggering: irregular steps, recovering balance, stopping, stepping back.

use plantigrade::foot::Side;

use crate::actions::opposite;
use crate::character::{Proportions, lateral_sign};
use crate::math::Random;
use crate::plan::{ArmPose, Gait, Landing, Lift, Placement, Plan, Planner, SwingPath, foot_placement};

/// Plans staggering until the end of the clip.
pub fn drunken_stagger(proportions: &Proportions, seconds: f64, random: &mut Random) -> Plan {
    let scale = proportions.scale();
    let mut planner = Planner::standing(-1.0, Placement::ORIGIN, 0.13 * scale);
    planner.wait_until(0.9);
    let mut side = Side::Left;
    while planner.now() < seconds + 1.0 {
        // Several steps forward, then an interruption.
        for _ in 0..3 + (random.uniform(0.0, 4.0) as usize) {
            let heading = planner.cursor().heading;
            let mut gait = random_gait(scale, random);
            gait.turn = random.uniform(-24.0, 24.0) - 0.4 * heading.to_degrees();
            planner.step(side, &gait);
            side = opposite(side);
        }
        match random.uniform(0.0, 4.0) as usize {
            0 => planner.wait(random.uniform(0.9, 1.6)),
            1 => {
                for _ in 0..2 {
                    step_back(&mut planner, side, scale, random);
                    side = opposite(side);
                }
            }
            2 => step_aside(&mut planner, side, scale, random),
            _ => {}
        }
    }
    animate_body(&mut planner, seconds, random);
    planner.finish()
}

fn random_gait(scale: f64, random: &mut Random) -> Gait {
    let walk = Gait::walk(scale);
    Gait {
        time: random.uniform(0.55, 0.85),
        length: random.uniform(0.18, 0.58) * scale,
        width: random.uniform(0.05, 0.19) * scale,
        toe_out: random.uniform(-4.0, 22.0),
        swing: random.uniform(0.34, 0.46),
        lift: Lift { pitch: random.uniform(26.0, 48.0), lead: 0.2 },
        swing_path: SwingPath {
            clearance: random.uniform(0.04, 0.11) * scale,
            detour: random.uniform(0.0, 0.07),
            ..walk.swing_path.clone()
        },
        landing: Landing { pitch: random.uniform(-14.0, -4.0), settle: 0.1, rest: 0.0 },
        ..walk
    }
}

/// Takes a step backward to recover balance.
fn step_back(planner: &mut Planner, side: Side, scale: f64, random: &mut Random) {
    let back = Gait {
        time: random.uniform(0.5, 0.65),
        length: -random.uniform(0.16, 0.3) * scale,
        lift: Lift { pitch: 12.0, lead: 0.12 },
        swing_path: SwingPath {
            clearance: 0.07 * scale,
            peak: 0.5,
            pitch: 16.0,
            ..random_gait(scale, random).swing_path
        },
        landing: Landing { pitch: 20.0, settle: 0.14, rest: 0.0 },
        swing: 0.36,
        ..random_gait(scale, random)
    };
    planner.step(side, &back);
}

/// Takes a step to the side; the other foot follows.
fn step_aside(planner: &mut Planner, side: Side, scale: f64, random: &mut Random) {
    let gait = Gait {
        lift: Lift { pitch: 14.0, lead: 0.14 },
        landing: Landing { pitch: 10.0, settle: 0.1, rest: 0.0 },
        ..random_gait(scale, random)
    };
    let placement = planner.placement(side).translated(0.05 * scale, lateral_sign(side) * 0.26 * scale);
    planner.wait(0.62);
    planner.place_foot(side, planner.now(), placement, &gait);
    planner.wait(0.66);
    let cursor = placement.translated(0.1 * scale, -lateral_sign(side) * 0.1 * scale);
    let close = foot_placement(
        &Placement { heading: planner.cursor().heading, ..cursor },
        opposite(side),
        0.1 * scale,
        8.0,
    );
    planner.place_foot(opposite(side), planner.now(), close, &gait);
    // The path continues from between the feet.
    planner.move_to(cursor);
}

/// Adds random movements of trunk, arms and head.
fn animate_body(planner: &mut Planner, seconds: f64, random: &mut Random) {
    let body = planner.body();
    let mut time = -1.0;
    while time < seconds + 1.0 {
        body.trunk.set_key(
            time,
            [random.uniform(2.0, 24.0), random.uniform(-14.0, 14.0), random.uniform(-13.0, 13.0)],
        );
        body.gaze.set_key(time + 0.3, [random.uniform(-25.0, 25.0), random.uniform(5.0, 34.0)]);
        body.shift.set_key(time + 0.2, [random.uniform(-0.05, 0.05), random.uniform(-0.04, 0.05)]);
        body.lowering.set_key(time, [random.uniform(0.0, 0.055)]);
        for arm in &mut body.arms {
            let raises_arm = random.uniform(0.0, 1.0) > 0.7;
            let abduction = if raises_arm { random.uniform(35.0, 62.0) } else { random.uniform(8.0, 24.0) };
            let pose = ArmPose {
                abduction,
                flexion: random.uniform(-12.0, 26.0),
                elbow: random.uniform(10.0, 55.0),
                ..ArmPose::RELAXED
            };
            arm.set_key(time + 0.2, pose.angles());
        }
        time += random.uniform(0.7, 1.3);
    }
    body.arm_swing.set_key(0.0, [22.0]);
    body.sway = 2.0;
}
