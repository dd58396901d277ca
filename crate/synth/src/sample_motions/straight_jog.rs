//! Straight jogging: standing, starting, steady jog, stopping.

use plantigrade::foot::Side;

use crate::actions::opposite;
use crate::character::Proportions;
use crate::math::Random;
use crate::math::lerp;
use crate::plan::{ArmPose, Gait, Landing, Lift, Placement, Plan, Planner, SwingPath};

/// Plans standing, jogging and standing again.
pub fn straight_jog(proportions: &Proportions, seconds: f64, random: &mut Random) -> Plan {
    let scale = proportions.scale();
    let origin = Placement { x: 1.4 * scale, z: -3.0 * scale, ..Placement::ORIGIN };
    let mut planner = Planner::standing(-1.0, origin, 0.09 * scale);
    planner.wait_until(0.55);
    let (walk, jog) = (Gait::walk(scale), Gait::jog(scale));
    let mut side = Side::Left;
    let start = planner.now();
    // A walking step that initiates the jog.
    let first =
        Gait { time: 0.62, length: 0.42 * scale, lift: Lift { pitch: 44.0, lead: 0.3 }, ..walk.clone() };
    planner.step(side, &first);
    side = opposite(side);
    planner.step(
        side,
        &Gait { time: 0.48, length: 0.62 * scale, lift: Lift { pitch: 56.0, lead: 0.34 }, ..walk.clone() },
    );
    let mut pace: f64 = 0.0;
    while planner.now() < seconds - 2.9 {
        side = opposite(side);
        pace = (pace + 0.25).min(1.0);
        let gait = Gait {
            time: jog.time * random.vary(0.012),
            length: lerp(0.72, 1.0, pace) * jog.length * random.vary(0.025),
            ..paced(&jog, pace)
        };
        planner.step(side, &gait);
    }
    let stop = planner.now();
    for (length, time, swing) in
        [(0.88, 0.37, 0.44), (0.72, 0.42, 0.4), (0.55, 0.48, 0.4), (0.3, 0.52, 0.4), (0.03, 0.54, 0.38)]
    {
        side = opposite(side);
        let landing = if length < 0.1 { Landing { pitch: 10.0, ..Landing::BALL } } else { Landing::HEEL };
        planner.step(side, &Gait { time, length: length * scale, swing, landing, ..walk.clone() });
    }
    let end = planner.now();

    let body = planner.body();
    for arm in &mut body.arms {
        arm.set_key(start - 0.3, ArmPose::RELAXED.angles());
        arm.set_key(start + 0.9, ArmPose::RUNNING.angles());
        arm.set_key(stop, ArmPose::RUNNING.angles());
        arm.set_key(end + 0.5, ArmPose::RELAXED.angles());
    }
    for (time, pitch, swing) in
        [(start, 4.0, 30.0), (start + 1.2, 9.0, 42.0), (stop - 0.3, 8.0, 42.0), (end, 0.0, 25.0)]
    {
        body.trunk.set_key(time, [pitch, 0.0, 0.0]);
        body.arm_swing.set_key(time, [swing]);
    }
    body.trunk.set_key(end + 0.7, [3.0, 0.0, 0.0]);
    body.pelvic_rotation = 7.0;
    planner.finish()
}

/// Returns the jog at a fraction of its full pace, with flatter swings at the start.
fn paced(jog: &Gait, pace: f64) -> Gait {
    Gait {
        swing: lerp(0.40, jog.swing, pace),
        lift: Lift { pitch: lerp(50.0, jog.lift.pitch, pace), ..jog.lift },
        swing_path: SwingPath {
            clearance: lerp(0.5, 1.0, pace) * jog.swing_path.clearance,
            pitch: lerp(45.0, jog.swing_path.pitch, pace),
            ..jog.swing_path.clone()
        },
        ..jog.clone()
    }
}
