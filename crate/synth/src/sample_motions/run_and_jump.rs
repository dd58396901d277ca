//! Running and jumping in irregular rhythm: strides, a leap, a two-footed jump, running.

use plantigrade::foot::Side;

use crate::actions::opposite;
use crate::character::Proportions;
use crate::math::Random;
use crate::plan::{ArmPose, EndMotion, Gait, Jump, Landing, Lift, Placement, Plan, Planner, SwingPath};

/// Plans a run that begins before the clip and continues after it.
pub fn run_and_jump(proportions: &Proportions, seconds: f64, random: &mut Random) -> Plan {
    let scale = proportions.scale();
    let mut planner = Planner::standing(-4.2, Placement::ORIGIN, 0.09 * scale);
    planner.wait(0.6);
    let mut side = Side::Left;
    planner.step(side, &Gait { time: 0.5, length: 0.5 * scale, swing: 0.36, ..Gait::walk(scale) });
    while planner.now() < 0.35 {
        side = opposite(side);
        planner.step(side, &stride(scale, random.vary(0.05), random.vary(0.08)));
    }
    // Leap from one foot to the other.
    side = opposite(side);
    let leap = planner.now();
    planner.step(side, &long_leap(scale));
    side = opposite(side);
    // Both feet together, the main jump, both feet again.
    let gather = planner.now() + 0.45;
    planner.step(
        side,
        &Gait {
            time: 0.45,
            length: 0.8 * scale,
            swing: 0.86,
            width: 0.11 * scale,
            ..stride(scale, 1.0, 0.8)
        },
    );
    let placement = planner.placement(side);
    let adjacent = placement.translated(-0.05, if side == Side::Left { -0.22 * scale } else { 0.22 * scale });
    planner.place_foot(
        opposite(side),
        gather + 0.06,
        adjacent,
        &Gait { swing: 0.27, ..stride(scale, 1.0, 0.8) },
    );
    planner.jump(&Side::BOTH, &jump(scale));
    let high = planner.now() - jump(scale).flight / 2.0;
    while planner.now() < seconds + 1.5 {
        let first = planner.now() < high + 0.4;
        let gait = stride(scale, random.vary(0.05), random.vary(0.08));
        let gait = if first {
            Gait {
                time: 0.58,
                swing: 0.35,
                length: 0.78 * scale,
                lift: Lift { pitch: 46.0, lead: 0.16 },
                ..gait
            }
        } else {
            gait
        };
        planner.step(side, &gait);
        side = opposite(side);
    }

    let body = planner.body();
    let running = ArmPose::RUNNING.angles();
    for (n, arm) in body.arms.iter_mut().enumerate() {
        let spread = if n == 0 { [40.0, 52.0, 0.0, 40.0, 0.0] } else { [-10.0, 62.0, 0.0, 30.0, 0.0] };
        for (time, angles) in [
            (leap - 0.1, running),
            (leap + 0.45, spread),
            (leap + 0.85, running),
            (high - 0.5, [-42.0, 18.0, 10.0, 36.0, 0.0]),
            (high - 0.08, [118.0, 24.0, 10.0, 50.0, 0.0]),
            (high + 0.35, [24.0, 22.0, 18.0, 60.0, 0.0]),
            (high + 0.8, running),
        ] {
            arm.set_key(time, angles);
        }
    }
    for (time, pitch) in [
        (leap, 11.0),
        (leap + 0.5, 4.0),
        (leap + 0.95, 10.0),
        (high - 0.45, 26.0),
        (high, 3.0),
        (high + 0.4, 20.0),
        (high + 0.9, 10.0),
    ] {
        body.trunk.set_key(time, [pitch, 0.0, 0.0]);
    }
    for (time, swing) in [(leap, 44.0), (leap + 0.4, 12.0), (high + 0.3, 8.0), (high + 0.9, 44.0)] {
        body.arm_swing.set_key(time, [swing]);
    }
    body.pelvic_rotation = 7.0;
    planner.finish()
}

fn stride(scale: f64, time: f64, length: f64) -> Gait {
    let jog = Gait::jog(scale);
    Gait {
        time: 0.35 * time,
        length: 1.18 * scale * length,
        swing: 0.46 * time,
        landing: Landing { pitch: 8.0, settle: 0.05, rest: 0.0 },
        ..jog
    }
}

fn long_leap(scale: f64) -> Gait {
    let stride = stride(scale, 1.0, 1.0);
    Gait {
        time: 0.62,
        length: 1.9 * scale,
        swing: 0.74,
        landing: Landing { pitch: 12.0, settle: 0.06, rest: 0.0 },
        swing_path: SwingPath { clearance: 0.34 * scale, pitch: 50.0, ..stride.swing_path.clone() },
        ..stride
    }
}

fn jump(scale: f64) -> Jump {
    let flight = 0.46;
    let (take_off, touch_down) = EndMotion::jump(flight);
    Jump {
        ground: 0.34,
        flight,
        length: 0.95 * scale,
        turn: 8.0,
        width: 0.12 * scale,
        lift: Lift { pitch: 60.0, lead: 0.2 },
        swing_path: SwingPath {
            clearance: 0.22 * scale,
            peak: 0.45,
            pitch: 30.0,
            pitch_at: 0.55,
            ramps: (0.25, 0.25),
            take_off,
            touch_down,
            ..Gait::walk(scale).swing_path
        },
        landing: Landing { pitch: 16.0, settle: 0.08, rest: 0.0 },
    }
}
