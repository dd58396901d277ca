//! Bowling: four steps with a swinging ball, a slide on the left foot, the release.

use plantigrade::foot::Side;

use crate::character::Proportions;
use crate::math::Random;
use crate::plan::{ArmPose, Gait, Landing, Lift, Placement, Plan, Planner, SwingPath, foot_placement};

/// Start of the approach, in seconds.
const START: f64 = 1.6;

/// Plans approach, slide, release and return to standing.
pub fn bowling(proportions: &Proportions, _seconds: f64, random: &mut Random) -> Plan {
    let scale = proportions.scale();
    let mut planner = Planner::standing(-1.0, Placement::ORIGIN, 0.085 * scale);
    planner.wait_until(START);
    let walk = Gait::walk(scale);
    let steps = [(Side::Right, 0.62, 0.42), (Side::Left, 0.6, 0.56), (Side::Right, 0.5, 0.64)];
    for (side, time, length) in steps {
        let length = length * scale * random.vary(0.03);
        planner.step(side, &Gait { time: time * random.vary(0.02), length, ..walk.clone() });
    }
    let third_strike = planner.now();
    let slide_end = slide(&mut planner, &walk, scale);
    let crossing_end = cross_behind(&mut planner, &walk, slide_end, scale);
    recover(&mut planner, &walk, crossing_end, scale);
    animate_body(&mut planner, third_strike, slide_end, crossing_end, scale);
    planner.finish()
}

/// Lands the left foot and slides it to the line. Returns the time at which it stops.
fn slide(planner: &mut Planner, walk: &Gait, scale: f64) -> f64 {
    let land = Gait {
        time: 0.42,
        length: 0.55 * scale,
        width: 0.02 * scale,
        toe_out: 2.0,
        swing: 0.38,
        swing_path: SwingPath { ramps: (0.3, 0.0), ..walk.swing_path.clone() },
        landing: Landing::FLAT,
        ..walk.clone()
    };
    planner.step(Side::Left, &land);
    // After touch-down the foot slides on and decelerates.
    let slide = Gait {
        time: 0.42,
        length: 0.6 * scale,
        swing: 0.42,
        lift: Lift { pitch: 0.0, lead: 0.0 },
        swing_path: SwingPath {
            clearance: 0.0,
            pitch: 0.0,
            ramps: (0.0, 1.0),
            detour: 0.0,
            grounded: true,
            load: 1.0,
            ..walk.swing_path.clone()
        },
        landing: Landing::FLAT,
        ..land
    };
    planner.step(Side::Left, &slide);
    planner.now()
}

/// Moves the right leg behind and across; its toes touch the floor for balance. Returns the time at
/// which it moves on.
fn cross_behind(planner: &mut Planner, walk: &Gait, slide_end: f64, scale: f64) -> f64 {
    let strike = slide_end + 0.22;
    let placement = planner.placement(Side::Left).translated(-0.62 * scale, 0.30 * scale).rotated(14.0);
    let crossing = Gait {
        swing: 0.56,
        lift: Lift { pitch: 54.0, lead: 0.26 },
        swing_path: SwingPath {
            clearance: 0.05 * scale,
            peak: 0.3,
            pitch: 48.0,
            pitch_at: 0.5,
            ramps: (0.3, 0.45),
            detour: 0.1,
            ..walk.swing_path.clone()
        },
        landing: Landing { pitch: 50.0, settle: 0.1, rest: 46.0 },
        ..walk.clone()
    };
    planner.place_foot(Side::Right, strike, placement, &crossing).weight = 0.22;
    strike + 1.5
}

/// Recovery from the lunge: the right foot closes to the left, then each foot steps back.
fn recover(planner: &mut Planner, walk: &Gait, crossing_end: f64, scale: f64) {
    let cursor = planner.placement(Side::Left).translated(-0.02, -0.1 * scale);
    let closing = Gait {
        swing: 0.55,
        lift: Lift { pitch: 54.0, lead: 0.25 },
        landing: Landing { pitch: 10.0, settle: 0.1, rest: 0.0 },
        swing_path: SwingPath { clearance: 0.06, pitch: 24.0, detour: 0.06, ..walk.swing_path.clone() },
        ..walk.clone()
    };
    planner.place_foot(
        Side::Right,
        crossing_end + 0.6,
        foot_placement(&cursor, Side::Right, 0.1 * scale, 8.0),
        &closing,
    );
    let back = Gait {
        swing: 0.46,
        lift: Lift { pitch: 10.0, lead: 0.14 },
        landing: Landing { pitch: 24.0, settle: 0.14, rest: 0.0 },
        swing_path: SwingPath { clearance: 0.06, peak: 0.5, pitch: 16.0, ..walk.swing_path.clone() },
        ..walk.clone()
    };
    let behind = cursor.translated(-0.42 * scale, 0.0);
    planner.place_foot(
        Side::Left,
        crossing_end + 1.75,
        foot_placement(&behind, Side::Left, 0.09 * scale, 8.0),
        &back,
    );
    planner.place_foot(
        Side::Right,
        crossing_end + 2.5,
        foot_placement(&behind, Side::Right, 0.09 * scale, 8.0),
        &back,
    );
}

fn animate_body(planner: &mut Planner, third_strike: f64, slide_end: f64, crossing_end: f64, scale: f64) {
    let release = slide_end - 0.16;
    let body = planner.body();
    // Ball arm: in front of the chest, pushed away, back, forward, up.
    let chest = [16.0, 8.0, 34.0, 104.0, -20.0];
    body.arm(
        Side::Right,
        &[
            (START - 0.1, chest),
            (START + 0.62, [52.0, 6.0, 10.0, 40.0, -20.0]),
            (third_strike - 0.34, [2.0, 8.0, 4.0, 8.0, -12.0]),
            (third_strike + 0.3, [-66.0, 10.0, 2.0, 8.0, 0.0]),
            (release - 0.02, [12.0, 6.0, 0.0, 6.0, 10.0]),
            (release + 0.34, [112.0, 4.0, 16.0, 34.0, 16.0]),
            (release + 0.8, [122.0, 4.0, 20.0, 58.0, 20.0]),
            (crossing_end, [100.0, 6.0, 20.0, 54.0, 14.0]),
            (crossing_end + 0.9, ArmPose::RELAXED.angles()),
        ],
    );
    body.arm(
        Side::Left,
        &[
            (START - 0.1, [18.0, 6.0, 40.0, 100.0, -10.0]),
            (START + 0.62, [46.0, 8.0, 30.0, 48.0, 0.0]),
            (third_strike - 0.2, [16.0, 48.0, 8.0, 18.0, 0.0]),
            (third_strike + 0.3, [10.0, 74.0, 0.0, 14.0, 0.0]),
            (release + 0.3, [-18.0, 70.0, 0.0, 16.0, 0.0]),
            (crossing_end, [-8.0, 58.0, 0.0, 18.0, 0.0]),
            (crossing_end + 0.9, ArmPose::RELAXED.angles()),
        ],
    );
    for (time, trunk) in [
        (START - 0.3, [5.0, 0.0, 0.0]),
        (START + 0.9, [12.0, 0.0, 0.0]),
        (third_strike, [22.0, -8.0, 3.0]),
        (third_strike + 0.34, [34.0, -20.0, 6.0]),
        (release, [42.0, 4.0, -7.0]),
        (release + 0.45, [32.0, 14.0, -5.0]),
        (crossing_end, [24.0, 10.0, -4.0]),
        (crossing_end + 1.0, [3.0, 0.0, 0.0]),
    ] {
        body.trunk.set_key(time, trunk);
        body.pelvis.set_key(time, [0.35 * trunk[0], 0.3 * trunk[1], 0.0]);
    }
    for (time, lowering) in [
        (START + 0.4, 0.01),
        (third_strike, 0.05),
        (release, 0.2),
        (slide_end + 0.4, 0.22),
        (crossing_end, 0.17),
        (crossing_end + 0.8, 0.0),
    ] {
        body.lowering.set_key(time, [lowering * scale]);
    }
    for (time, swing) in [(0.0, 0.0), (crossing_end, 0.0), (crossing_end + 0.6, 16.0)] {
        body.arm_swing.set_key(time, [swing]);
    }
    body.gaze.set_key(0.0, [0.0, 8.0]);
    body.gaze.set_key(slide_end, [0.0, -4.0]);
}
