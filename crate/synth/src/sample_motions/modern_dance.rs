//! Modern dance: a side lunge, a turn on the ball of the foot, a split leap, a fall into a low
//! lunge.

use plantigrade::foot::Side::{Left, Right};

use crate::character::Proportions;
use crate::math::Random;
use crate::math::Track;
use crate::plan::{EndMotion, Gait, Landing, LegPoses, Lift, Placement, Plan, Planner, SwingPath};

/// Plans a phrase of five seconds that is in progress when the clip begins.
pub fn modern_dance(proportions: &Proportions, _seconds: f64, random: &mut Random) -> Plan {
    let scale = proportions.scale();
    let mut planner = Planner::standing(-1.5, Placement::ORIGIN, 0.1 * scale);
    let step = step(scale);
    let mut placement = |x: f64, z: f64, degrees: f64| Placement {
        x: x * scale * random.vary(0.02),
        z: z * scale * random.vary(0.02),
        heading: degrees.to_radians(),
        ..Placement::ORIGIN
    };
    // Into the side lunge and back onto the right foot.
    planner.place_foot(Left, 0.42, placement(0.62, 0.18, 34.0), &step);
    // The right foot closes and passes the knee while the left foot pivots by 140°.
    let turn = Gait { swing: 0.98, lift: Lift { pitch: 36.0, lead: 0.2 }, ..step.clone() };
    let right = planner.place_foot(Right, 2.02, placement(0.55, -0.28, 172.0), &turn);
    right.landing = Landing { pitch: 20.0, settle: 0.12, rest: 0.0 };
    right.swing_path.leg_poses = Some(LegPoses {
        poses: Track::from_keys(&[
            (1.2, [0.1, -0.62, 0.2, 46.0, 42.0]),
            (1.62, [0.1, -0.6, 0.2, 48.0, 46.0]),
        ]),
        ease_in: 0.3,
        ease_out: 0.36,
    });
    let left = planner.foot(Left);
    left.pivot = Track::from_keys(&[(1.06, [0.0]), (1.74, [140.0])]);
    left.heel_raise = Track::from_keys(&[(0.86, [0.0]), (1.14, [32.0]), (1.66, [32.0]), (1.92, [0.0])]);
    // Two running steps and the leap, right leg first.
    let run = Gait { swing: 0.34, ..step.clone() };
    planner.place_foot(Left, 2.44, placement(0.44, -0.86, 178.0), &run);
    let leap = Gait {
        swing: 0.74,
        lift: Lift { pitch: 58.0, lead: 0.18 },
        landing: Landing { pitch: 18.0, settle: 0.09, rest: 0.0 },
        ..step.clone()
    };
    let right = planner.place_foot(Right, 3.1, placement(0.56, -2.34, 182.0), &leap);
    right.swing_path.leg_poses = Some(LegPoses {
        poses: Track::from_keys(&[
            (2.62, [0.0, -0.7, 0.3, 40.0, 4.0]),
            (2.82, [0.0, -0.32, 0.9, 44.0, 6.0]),
            (2.93, [0.0, -0.44, 0.84, 36.0, 6.0]),
        ]),
        ease_in: 0.24,
        ease_out: 0.26,
    });
    let left = planner.place_foot(Left, 3.72, placement(0.3, -2.86, 196.0), &Gait { swing: 1.04, ..leap });
    left.swing_path.leg_poses = Some(LegPoses {
        poses: Track::from_keys(&[
            (2.82, [0.0, -0.5, -0.78, 80.0, 8.0]),
            (3.0, [0.0, -0.4, -0.86, 92.0, 10.0]),
            (3.3, [0.02, -0.42, -0.66, 84.0, 14.0]),
        ]),
        ease_in: 0.16,
        ease_out: 0.46,
    });
    // Into the low lunge, and a closing step.
    planner.place_foot(Right, 4.42, placement(0.78, -2.96, 168.0), &Gait { swing: 0.42, ..step.clone() });
    planner.place_foot(Left, 5.3, placement(0.5, -3.1, 184.0), &step);
    animate_body(&mut planner, scale);
    planner.finish()
}

fn step(scale: f64) -> Gait {
    let walk = Gait::walk(scale);
    Gait {
        swing: 0.44,
        lift: Lift { pitch: 46.0, lead: 0.2 },
        swing_path: SwingPath {
            clearance: 0.08 * scale,
            peak: 0.45,
            pitch: 34.0,
            pitch_at: 0.5,
            take_off: EndMotion::SOFT,
            touch_down: EndMotion::SOFT,
            ..walk.swing_path.clone()
        },
        landing: Landing { pitch: 18.0, settle: 0.11, rest: 0.0 },
        ..walk
    }
}

fn animate_body(planner: &mut Planner, scale: f64) {
    let body = planner.body();
    body.arm_swing.set_key(0.0, [4.0]);
    body.pelvic_rotation = 5.0;
    body.sway = 1.2;
    let (wide, high, round) =
        ([8.0, 88.0, -20.0, 18.0, -8.0], [150.0, 30.0, -10.0, 26.0, 0.0], [58.0, 30.0, 40.0, 58.0, 10.0]);
    let low = [14.0, 24.0, 20.0, 30.0, 6.0];
    body.arm(
        Left,
        &[
            (-0.4, low),
            (0.5, wide),
            (0.95, [36.0, 76.0, 0.0, 30.0, 0.0]),
            (1.3, round),
            (1.7, round),
            (2.15, wide),
            (2.55, low),
            (2.88, [76.0, 40.0, -10.0, 12.0, -6.0]),
            (3.3, wide),
            (3.9, [120.0, 66.0, -10.0, 20.0, 0.0]),
            (4.5, round),
            (5.0, low),
        ],
    );
    body.arm(
        Right,
        &[
            (-0.4, low),
            (0.5, high),
            (0.95, [70.0, 60.0, 0.0, 36.0, 0.0]),
            (1.3, round),
            (1.7, round),
            (2.15, wide),
            (2.55, low),
            (2.88, [-10.0, 92.0, -20.0, 12.0, -6.0]),
            (3.3, wide),
            (3.9, [-20.0, 58.0, 0.0, 24.0, 0.0]),
            (4.5, high),
            (5.0, wide),
        ],
    );
    for (time, trunk) in [
        (-0.5, [4.0, 0.0, 0.0]),
        (0.52, [10.0, -8.0, 22.0]),
        (1.0, [2.0, -10.0, 2.0]),
        (1.3, [0.0, 8.0, 0.0]),
        (1.8, [2.0, 4.0, 0.0]),
        (2.45, [16.0, 0.0, 0.0]),
        (2.86, [-4.0, 0.0, 0.0]),
        (3.24, [12.0, 4.0, 0.0]),
        (3.86, [34.0, 12.0, 8.0]),
        (4.3, [20.0, 0.0, -10.0]),
        (4.9, [-4.0, -8.0, -6.0]),
    ] {
        body.trunk.set_key(time, trunk);
    }
    for (time, lowering) in [
        (-0.4, 0.0),
        (0.55, 0.13),
        (0.95, 0.02),
        (1.2, -0.05),
        (1.7, -0.05),
        (2.0, 0.03),
        (2.3, 0.0),
        (3.2, 0.0),
        (3.86, 0.07),
        (4.4, 0.06),
        (4.9, 0.0),
    ] {
        body.lowering.set_key(time, [lowering * scale]);
    }
    body.gaze.set_key(0.0, [0.0, 0.0]);
}
