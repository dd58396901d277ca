//! Running and jumping out of rhythm: strides, a leap, a jump off both feet, on again.

use plantigrade::foot::Side;

use super::other;
use crate::character::Build;
use crate::plan::{ArmStyle, Carry, Gait, Hop, Landing, Lift, Place, Plan, Planner};
use crate::random::Random;

/// Runs through the clip: it begins in the run-up and ends in the run.
pub fn run_and_jump(build: &Build, seconds: f64, random: &mut Random) -> Plan {
    let scale = build.scale();
    let mut planner = Planner::standing(-4.2, Place::ORIGIN, 0.09 * scale);
    planner.wait(0.6);
    let mut side = Side::Left;
    planner.step(side, &Gait { time: 0.5, length: 0.5 * scale, swing: 0.36, ..Gait::walk(scale) });
    while planner.now() < 0.35 {
        side = other(side);
        planner.step(side, &stride(scale, random.vary(0.05), random.vary(0.08)));
    }
    // A leap from one foot to the other.
    side = other(side);
    let leap = planner.now();
    planner.step(side, &long_leap(scale));
    side = other(side);
    // Both feet together, the jump of the motion, both feet again.
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
    let place = planner.place(side);
    let beside = place.moved(-0.05, if side == Side::Left { -0.22 * scale } else { 0.22 * scale });
    planner.put(other(side), gather + 0.06, beside, &Gait { swing: 0.27, ..stride(scale, 1.0, 0.8) });
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
        side = other(side);
    }

    let body = planner.body();
    let running = ArmStyle::RUNNING.angles();
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
            arm.key(time, angles);
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
        body.trunk.key(time, [pitch, 0.0, 0.0]);
    }
    for (time, swing) in [(leap, 44.0), (leap + 0.4, 12.0), (high + 0.3, 8.0), (high + 0.9, 44.0)] {
        body.arm_swing.key(time, [swing]);
    }
    body.pelvis_turn = 7.0;
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
        carry: Carry { clearance: 0.34 * scale, pitch: 50.0, ..stride.carry.clone() },
        ..stride
    }
}

fn jump(scale: f64) -> Hop {
    Hop {
        ground: 0.34,
        flight: 0.46,
        length: 0.95 * scale,
        turn: 8.0,
        width: 0.12 * scale,
        lift: Lift { pitch: 60.0, lead: 0.2 },
        carry: Carry {
            clearance: 0.22 * scale,
            peak: 0.45,
            pitch: 30.0,
            pitch_at: 0.55,
            ramps: (0.25, 0.25),
            ..Gait::walk(scale).carry
        },
        landing: Landing { pitch: 16.0, settle: 0.08, rest: 0.0 },
    }
}
