//! Walking with an impaired right leg: the left foot steps, the right one is dragged with its toes
//! on the floor.

use plantigrade::foot::Side;

use crate::character::Proportions;
use crate::math::Random;
use crate::plan::{ArmPose, EndMotion, Gait, Landing, Lift, Placement, Plan, Planner, SwingPath};

/// Plans a walk with a dragged right foot; the clip begins in mid-walk.
pub fn foot_drag_walk(proportions: &Proportions, seconds: f64, random: &mut Random) -> Plan {
    let scale = proportions.scale();
    let mut planner = Planner::standing(-4.0, Placement::ORIGIN, 0.09 * scale);
    planner.wait(0.8);
    let walk = Gait::walk(scale);
    let healthy = Gait {
        time: 0.55,
        length: 0.42 * scale,
        swing: 0.4,
        lift: Lift { pitch: 38.0, lead: 0.2 },
        landing: Landing { pitch: -14.0, settle: 0.1, rest: 0.0 },
        ..walk.clone()
    };
    let dragged = Gait {
        time: 0.8,
        length: 0.12 * scale,
        width: 0.1 * scale,
        toe_out: 16.0,
        swing: 0.62,
        lift: Lift { pitch: 30.0, lead: 0.3 },
        swing_path: SwingPath {
            clearance: 0.004,
            peak: 0.5,
            pitch: 34.0,
            pitch_at: 0.45,
            ramps: (0.3, 0.45),
            detour: 0.05 * scale,
            grounded: true,
            load: 0.0,
            take_off: EndMotion::SOFT,
            touch_down: EndMotion::SOFT,
            leg_poses: None,
        },
        landing: Landing { pitch: 18.0, settle: 0.16, rest: 0.0 },
        ..walk
    };
    let mut trunk = Vec::new();
    while planner.now() < seconds + 1.6 {
        planner.step(Side::Left, &Gait { length: healthy.length * random.vary(0.06), ..healthy.clone() });
        trunk.push((planner.now() + 0.4, [14.0, 4.0, 9.0]));
        let time = dragged.time * random.vary(0.04);
        planner
            .step(Side::Right, &Gait { time, length: dragged.length * random.vary(0.15), ..dragged.clone() });
        trunk.push((planner.now() + 0.22, [9.0, -2.0, -2.0]));
    }
    let body = planner.body();
    for (time, angles) in trunk {
        // Leg pulled forward: lean over the other leg and raise the hip.
        body.trunk.set_key(time, angles);
        let lean = if angles[2] > 0.0 { -7.0 } else { 2.0 };
        body.pelvis.set_key(time, [4.0, if lean < 0.0 { 8.0 } else { -2.0 }, lean]);
    }
    body.lowering.set_key(0.0, [0.015 * scale]);
    body.gaze.set_key(0.0, [0.0, 16.0]);
    body.arm_swing.set_key(0.0, [24.0]);
    body.arm(Side::Left, &[(0.0, ArmPose { abduction: 16.0, ..ArmPose::RELAXED }.angles())]);
    // The right hand supports the thigh.
    body.arm(Side::Right, &[(0.0, [14.0, 6.0, 30.0, 34.0, 12.0])]);
    planner.finish()
}
