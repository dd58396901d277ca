//! A drunk on the way home: lurching, catching the balance, stopping, giving ground.

use plantigrade::foot::Side;

use super::other;
use crate::character::{Build, outward};
use crate::plan::{ArmStyle, Carry, Gait, Landing, Lift, Place, Plan, Planner, beside};
use crate::random::Random;

/// Staggers on until the clip ends.
pub fn drunken_stagger(build: &Build, seconds: f64, random: &mut Random) -> Plan {
    let scale = build.scale();
    let mut planner = Planner::standing(-1.0, Place::ORIGIN, 0.13 * scale);
    planner.wait_until(0.9);
    let mut side = Side::Left;
    while planner.now() < seconds + 1.0 {
        // Some steps ahead, then something happens.
        for _ in 0..3 + (random.between(0.0, 4.0) as usize) {
            let heading = planner.cursor().heading;
            let mut gait = lurch(scale, random);
            gait.turn = random.between(-24.0, 24.0) - 0.4 * heading.to_degrees();
            planner.step(side, &gait);
            side = other(side);
        }
        match random.between(0.0, 4.0) as usize {
            0 => planner.wait(random.between(0.9, 1.6)),
            1 => {
                for _ in 0..2 {
                    give_ground(&mut planner, side, scale, random);
                    side = other(side);
                }
            }
            2 => sideways(&mut planner, side, scale, random),
            _ => {}
        }
    }
    carry_body(&mut planner, seconds, random);
    planner.finish()
}

fn lurch(scale: f64, random: &mut Random) -> Gait {
    let walk = Gait::walk(scale);
    Gait {
        time: random.between(0.55, 0.85),
        length: random.between(0.18, 0.58) * scale,
        width: random.between(0.05, 0.19) * scale,
        toe_out: random.between(-4.0, 22.0),
        swing: random.between(0.34, 0.46),
        lift: Lift { pitch: random.between(26.0, 48.0), lead: 0.2 },
        carry: Carry {
            clearance: random.between(0.04, 0.11) * scale,
            detour: random.between(0.0, 0.07),
            ..walk.carry.clone()
        },
        landing: Landing { pitch: random.between(-14.0, -4.0), settle: 0.1, rest: 0.0 },
        ..walk
    }
}

/// A catching step backwards.
fn give_ground(planner: &mut Planner, side: Side, scale: f64, random: &mut Random) {
    let back = Gait {
        time: random.between(0.5, 0.65),
        length: -random.between(0.16, 0.3) * scale,
        lift: Lift { pitch: 12.0, lead: 0.12 },
        carry: Carry { clearance: 0.07 * scale, peak: 0.5, pitch: 16.0, ..lurch(scale, random).carry },
        landing: Landing { pitch: 20.0, settle: 0.14, rest: 0.0 },
        swing: 0.36,
        ..lurch(scale, random)
    };
    planner.step(side, &back);
}

/// A step to the side, and the other foot after it.
fn sideways(planner: &mut Planner, side: Side, scale: f64, random: &mut Random) {
    let gait = Gait {
        lift: Lift { pitch: 14.0, lead: 0.14 },
        landing: Landing { pitch: 10.0, settle: 0.1, rest: 0.0 },
        ..lurch(scale, random)
    };
    let place = planner.place(side).moved(0.05 * scale, outward(side) * 0.26 * scale);
    planner.wait(0.62);
    planner.put(side, planner.now(), place, &gait);
    planner.wait(0.66);
    let cursor = place.moved(0.1 * scale, -outward(side) * 0.1 * scale);
    let close = beside(&Place { heading: planner.cursor().heading, ..cursor }, other(side), 0.1 * scale, 8.0);
    planner.put(other(side), planner.now(), close, &gait);
    // The way goes on from between the feet.
    planner.move_to(cursor);
}

/// The trunk reels, the arms trail after it, the head hangs.
fn carry_body(planner: &mut Planner, seconds: f64, random: &mut Random) {
    let body = planner.body();
    let mut time = -1.0;
    while time < seconds + 1.0 {
        body.trunk
            .key(time, [random.between(2.0, 24.0), random.between(-14.0, 14.0), random.between(-13.0, 13.0)]);
        body.look.key(time + 0.3, [random.between(-25.0, 25.0), random.between(5.0, 34.0)]);
        body.shift.key(time + 0.2, [random.between(-0.05, 0.05), random.between(-0.04, 0.05)]);
        body.sink.key(time, [random.between(0.0, 0.055)]);
        for arm in &mut body.arms {
            let flung = random.between(0.0, 1.0) > 0.7;
            let abduct = if flung { random.between(35.0, 62.0) } else { random.between(8.0, 24.0) };
            let loose = ArmStyle {
                abduct,
                flex: random.between(-12.0, 26.0),
                elbow: random.between(10.0, 55.0),
                ..ArmStyle::LOOSE
            };
            arm.key(time + 0.2, loose.angles());
        }
        time += random.between(0.7, 1.3);
    }
    body.arm_swing.key(0.0, [22.0]);
    body.sway = 2.0;
}
