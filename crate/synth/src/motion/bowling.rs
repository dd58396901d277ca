//! Bowling: four steps with the ball swinging, a slide on the left foot, the release.

use plantigrade::foot::Side;

use crate::character::Build;
use crate::plan::{ArmStyle, Carry, Gait, Landing, Lift, Place, Plan, Planner, beside};
use crate::random::Random;

/// Seconds after which the approach begins.
const START: f64 = 1.6;

/// Approach, slide, release, and back to a stand.
pub fn bowling(build: &Build, _seconds: f64, random: &mut Random) -> Plan {
    let scale = build.scale();
    let mut planner = Planner::standing(-1.0, Place::ORIGIN, 0.085 * scale);
    planner.wait_until(START);
    let walk = Gait::walk(scale);
    let steps = [(Side::Right, 0.62, 0.42), (Side::Left, 0.6, 0.56), (Side::Right, 0.5, 0.64)];
    for (side, time, length) in steps {
        let length = length * scale * random.vary(0.03);
        planner.step(side, &Gait { time: time * random.vary(0.02), length, ..walk.clone() });
    }
    let third = planner.now();
    let slid = slide(&mut planner, &walk, scale);
    let held = trail(&mut planner, &walk, slid, scale);
    recover(&mut planner, &walk, held, scale);
    carry_body(&mut planner, third, slid, held, scale);
    planner.finish()
}

/// The left foot lands on its ball and slides on to the line.
fn slide(planner: &mut Planner, walk: &Gait, scale: f64) -> f64 {
    let land = Gait {
        time: 0.42,
        length: 0.55 * scale,
        width: 0.02 * scale,
        toe_out: 2.0,
        swing: 0.38,
        carry: Carry { ramps: (0.3, 0.0), ..walk.carry.clone() },
        landing: Landing::FLAT,
        ..walk.clone()
    };
    planner.step(Side::Left, &land);
    // It does not stop when it touches down but slides on, ever slower.
    let slide = Gait {
        time: 0.42,
        length: 0.6 * scale,
        swing: 0.42,
        lift: Lift { pitch: 0.0, lead: 0.0 },
        carry: Carry {
            clearance: 0.0,
            pitch: 0.0,
            ramps: (0.0, 1.0),
            detour: 0.0,
            grounded: true,
            load: 1.0,
            ..walk.carry.clone()
        },
        landing: Landing::FLAT,
        ..land
    };
    planner.step(Side::Left, &slide);
    planner.now()
}

/// The right leg sweeps behind and across, its toes on the floor for balance.
fn trail(planner: &mut Planner, walk: &Gait, slid: f64, scale: f64) -> f64 {
    let strike = slid + 0.22;
    let place = planner.place(Side::Left).moved(-0.62 * scale, 0.30 * scale).turned(14.0);
    let sweep = Gait {
        swing: 0.56,
        lift: Lift { pitch: 54.0, lead: 0.26 },
        carry: Carry {
            clearance: 0.05 * scale,
            peak: 0.3,
            pitch: 48.0,
            pitch_at: 0.5,
            ramps: (0.3, 0.45),
            detour: 0.1,
            ..walk.carry.clone()
        },
        landing: Landing { pitch: 50.0, settle: 0.1, rest: 46.0 },
        ..walk.clone()
    };
    planner.put(Side::Right, strike, place, &sweep).weight = 0.22;
    strike + 1.5
}

/// Out of the lunge: the right foot comes up beside the left, a step back each.
fn recover(planner: &mut Planner, walk: &Gait, held: f64, scale: f64) {
    let cursor = planner.place(Side::Left).moved(-0.02, -0.1 * scale);
    let up = Gait {
        swing: 0.55,
        lift: Lift { pitch: 54.0, lead: 0.25 },
        landing: Landing { pitch: 10.0, settle: 0.1, rest: 0.0 },
        carry: Carry { clearance: 0.06, pitch: 24.0, detour: 0.06, ..walk.carry.clone() },
        ..walk.clone()
    };
    planner.put(Side::Right, held + 0.6, beside(&cursor, Side::Right, 0.1 * scale, 8.0), &up);
    let back = Gait {
        swing: 0.46,
        lift: Lift { pitch: 10.0, lead: 0.14 },
        landing: Landing { pitch: 24.0, settle: 0.14, rest: 0.0 },
        carry: Carry { clearance: 0.06, peak: 0.5, pitch: 16.0, ..walk.carry.clone() },
        ..walk.clone()
    };
    let behind = cursor.moved(-0.42 * scale, 0.0);
    planner.put(Side::Left, held + 1.75, beside(&behind, Side::Left, 0.09 * scale, 8.0), &back);
    planner.put(Side::Right, held + 2.5, beside(&behind, Side::Right, 0.09 * scale, 8.0), &back);
}

fn carry_body(planner: &mut Planner, third: f64, slid: f64, held: f64, scale: f64) {
    let release = slid - 0.16;
    let body = planner.body();
    // The ball: held before the chest, pushed away, back, forward, up.
    let chest = [16.0, 8.0, 34.0, 104.0, -20.0];
    body.arm(
        Side::Right,
        &[
            (START - 0.1, chest),
            (START + 0.62, [52.0, 6.0, 10.0, 40.0, -20.0]),
            (third - 0.34, [2.0, 8.0, 4.0, 8.0, -12.0]),
            (third + 0.3, [-66.0, 10.0, 2.0, 8.0, 0.0]),
            (release - 0.02, [12.0, 6.0, 0.0, 6.0, 10.0]),
            (release + 0.34, [112.0, 4.0, 16.0, 34.0, 16.0]),
            (release + 0.8, [122.0, 4.0, 20.0, 58.0, 20.0]),
            (held, [100.0, 6.0, 20.0, 54.0, 14.0]),
            (held + 0.9, ArmStyle::LOOSE.angles()),
        ],
    );
    body.arm(
        Side::Left,
        &[
            (START - 0.1, [18.0, 6.0, 40.0, 100.0, -10.0]),
            (START + 0.62, [46.0, 8.0, 30.0, 48.0, 0.0]),
            (third - 0.2, [16.0, 48.0, 8.0, 18.0, 0.0]),
            (third + 0.3, [10.0, 74.0, 0.0, 14.0, 0.0]),
            (release + 0.3, [-18.0, 70.0, 0.0, 16.0, 0.0]),
            (held, [-8.0, 58.0, 0.0, 18.0, 0.0]),
            (held + 0.9, ArmStyle::LOOSE.angles()),
        ],
    );
    for (time, trunk) in [
        (START - 0.3, [5.0, 0.0, 0.0]),
        (START + 0.9, [12.0, 0.0, 0.0]),
        (third, [22.0, -8.0, 3.0]),
        (third + 0.34, [34.0, -20.0, 6.0]),
        (release, [42.0, 4.0, -7.0]),
        (release + 0.45, [32.0, 14.0, -5.0]),
        (held, [24.0, 10.0, -4.0]),
        (held + 1.0, [3.0, 0.0, 0.0]),
    ] {
        body.trunk.key(time, trunk);
        body.pelvis.key(time, [0.35 * trunk[0], 0.3 * trunk[1], 0.0]);
    }
    for (time, sink) in [
        (START + 0.4, 0.01),
        (third, 0.05),
        (release, 0.2),
        (slid + 0.4, 0.22),
        (held, 0.17),
        (held + 0.8, 0.0),
    ] {
        body.sink.key(time, [sink * scale]);
    }
    for (time, swing) in [(0.0, 0.0), (held, 0.0), (held + 0.6, 16.0)] {
        body.arm_swing.key(time, [swing]);
    }
    body.look.key(0.0, [0.0, 8.0]);
    body.look.key(slid, [0.0, -4.0]);
}
