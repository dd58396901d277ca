//! Fencing with a shield on the left arm and a sword in the right hand.

use plantigrade::foot::Side::{self, Left, Right};

use crate::character::Proportions;
use crate::math::Random;
use crate::plan::{Gait, Landing, Lift, Placement, Plan, Planner, SwingPath};

/// Plans an advance with a slash, a thrust, a retreat behind the shield and the guard.
pub fn sword_and_shield(proportions: &Proportions, _seconds: f64, random: &mut Random) -> Plan {
    let scale = proportions.scale();
    let mut planner = Planner::standing(-1.0, Placement::ORIGIN, 0.14 * scale);
    // Guard: left foot and shield in front, right foot behind and turned out.
    planner.foot(Left).start = Placement { x: 0.1 * scale, z: 0.2 * scale, ..Placement::ORIGIN };
    planner.foot(Right).start =
        Placement { x: -0.13 * scale, z: -0.22 * scale, heading: -0.75, ..Placement::ORIGIN };

    let shuffle = shuffle(scale);
    let mut at = |side: Side, time: f64, ahead: f64, left: f64, turn: f64, gait: &Gait| {
        let ahead = ahead * scale * random.vary(0.04);
        let placement = planner.placement(side).translated_along(0.0, ahead, left * scale).rotated(turn);
        planner.place_foot(side, time, placement, gait);
    };
    // Two shuffle steps forward.
    at(Left, 0.62, 0.26, 0.0, 0.0, &shuffle);
    at(Right, 0.95, 0.26, 0.0, 0.0, &shuffle);
    // The right foot passes forward with the slash.
    at(Right, 1.66, 0.72, 0.02, 26.0, &passing(scale));
    at(Left, 2.18, 0.12, 0.03, 18.0, &shuffle);
    // Lunge and thrust.
    at(Right, 2.72, 0.4, 0.0, 12.0, &lunge(scale));
    // Retreat, shield up.
    at(Right, 3.52, -0.66, -0.02, -32.0, &retreat(scale));
    at(Left, 3.98, -0.22, 0.0, -18.0, &retreat(scale));
    at(Right, 4.32, -0.24, 0.0, 0.0, &retreat(scale));
    // Sidestep to the left and settle.
    at(Left, 4.86, 0.1, 0.22, -8.0, &shuffle);
    at(Right, 5.22, 0.08, 0.24, -6.0, &shuffle);

    animate_body(&mut planner, scale);
    planner.finish()
}

fn shuffle(scale: f64) -> Gait {
    let walk = Gait::walk(scale);
    Gait {
        swing: 0.27,
        lift: Lift { pitch: 18.0, lead: 0.12 },
        swing_path: SwingPath {
            clearance: 0.045 * scale,
            peak: 0.45,
            pitch: 8.0,
            pitch_at: 0.55,
            detour: 0.01,
            ..walk.swing_path.clone()
        },
        landing: Landing { pitch: 8.0, settle: 0.06, rest: 0.0 },
        ..walk
    }
}

fn passing(scale: f64) -> Gait {
    Gait {
        swing: 0.38,
        lift: Lift { pitch: 44.0, lead: 0.2 },
        landing: Landing { pitch: -8.0, settle: 0.07, rest: 0.0 },
        ..shuffle(scale)
    }
}

fn lunge(scale: f64) -> Gait {
    let shuffle = shuffle(scale);
    let swing_path = SwingPath { clearance: 0.1 * scale, pitch: -6.0, ..shuffle.swing_path.clone() };
    Gait { swing: 0.32, swing_path, landing: Landing { pitch: -14.0, settle: 0.08, rest: 0.0 }, ..shuffle }
}

fn retreat(scale: f64) -> Gait {
    Gait {
        swing: 0.32,
        lift: Lift { pitch: 6.0, lead: 0.08 },
        landing: Landing { pitch: 20.0, settle: 0.1, rest: 0.0 },
        ..shuffle(scale)
    }
}

fn animate_body(planner: &mut Planner, scale: f64) {
    let body = planner.body();
    body.pelvic_rotation = 4.0;
    body.arm_swing.set_key(0.0, [0.0]);
    body.sway = 1.4;
    // Sword: raised by the ear, cut down across, drawn back, thrust, low guard.
    let raised = [96.0, 34.0, -40.0, 98.0, 0.0];
    body.arm(
        Right,
        &[
            (0.0, [30.0, 34.0, -10.0, 88.0, 0.0]),
            (0.7, [34.0, 36.0, -14.0, 92.0, 0.0]),
            (1.28, raised),
            (1.42, raised),
            (1.72, [62.0, 4.0, 40.0, 20.0, 8.0]),
            (1.95, [18.0, 0.0, 66.0, 34.0, 12.0]),
            (2.42, [-34.0, 22.0, 8.0, 100.0, 0.0]),
            (2.76, [82.0, 4.0, 8.0, 8.0, 4.0]),
            (2.98, [80.0, 4.0, 8.0, 10.0, 4.0]),
            (3.5, [10.0, 38.0, -20.0, 96.0, 0.0]),
            (4.4, [24.0, 40.0, -14.0, 84.0, 0.0]),
            (5.3, [30.0, 34.0, -10.0, 90.0, 0.0]),
        ],
    );
    // Shield: in front of the body, opened for the cut, raised against the counter-attack.
    let guard = [46.0, 20.0, 46.0, 88.0, 0.0];
    body.arm(
        Left,
        &[
            (0.0, guard),
            (1.2, [54.0, 22.0, 46.0, 84.0, 0.0]),
            (1.75, [14.0, 36.0, 30.0, 84.0, 0.0]),
            (2.3, [40.0, 20.0, 46.0, 90.0, 0.0]),
            (2.8, [4.0, 40.0, 20.0, 74.0, 0.0]),
            (3.35, [88.0, 26.0, 50.0, 92.0, 0.0]),
            (4.0, [80.0, 24.0, 50.0, 88.0, 0.0]),
            (4.7, guard),
        ],
    );
    for (time, trunk) in [
        (0.0, [12.0, -16.0, 0.0]),
        (0.95, [12.0, -14.0, 0.0]),
        (1.36, [6.0, -34.0, -4.0]),
        (1.78, [24.0, 24.0, 6.0]),
        (2.02, [20.0, 30.0, 4.0]),
        (2.44, [10.0, -22.0, -2.0]),
        (2.8, [26.0, 26.0, 0.0]),
        (3.0, [25.0, 24.0, 0.0]),
        (3.55, [4.0, -14.0, 4.0]),
        (4.1, [10.0, -12.0, 0.0]),
        (5.4, [12.0, -16.0, 0.0]),
    ] {
        body.trunk.set_key(time, trunk);
        body.pelvis.set_key(time, [0.3 * trunk[0], 0.35 * trunk[1], 0.0]);
        // The gaze stays on the opponent.
        body.gaze.set_key(time, [0.0, 2.0]);
    }
    for (time, lowering) in [
        (0.0, 0.07),
        (0.6, 0.09),
        (1.3, 0.06),
        (1.8, 0.12),
        (2.3, 0.09),
        (2.85, 0.17),
        (3.05, 0.17),
        (3.6, 0.1),
        (4.6, 0.07),
        (5.5, 0.08),
    ] {
        body.lowering.set_key(time, [lowering * scale]);
    }
}
