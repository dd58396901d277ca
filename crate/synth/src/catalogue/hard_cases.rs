//! Clips that are difficult for plant detectors, separate from the full set.

use plantigrade::foot::Side::{self, Left};

use crate::actions::{Actor, GaitStyle, Posture};
use crate::environment::Environment;
use crate::generate::ClipSpec;
use crate::math::Track;
use crate::math::Vec3;
use crate::motion::Motion;
use crate::plan::{Gait, Landing, LegPoses, Lift, SwingPath};

/// Returns the hard cases. `noise_level` is the factor on the characters' foot noise.
///
/// In all clips, a foot is planted while it is still relative to the ground under it.
///
/// - `one-foot-in-air`: hopping on the left foot; the right foot is never planted.
/// - `one-foot-dragged`: the right foot is dragged throughout, bearing part of the weight, and is
///   never planted.
/// - `standing-still`, `sit-and-stand`, `deep-squats`: both feet are flat on the ground in every
///   frame.
/// - `t-pose-and-ringing`: a walk after a T-pose, with two frames of filter ringing; they have the
///   labels of the walk.
/// - `teleport`: a walk that jumps several metres between two frames; a foot that is planted before
///   and after the jump is planted throughout.
/// - `z-up-walk`: a walk in a file with the Z axis up.
/// - `brisk-run-24`: a run at 24 Hz, four frames per contact.
/// - `treadmill`, `slow-treadmill`, `treadmill-run`: planted feet move backward with the belt, at 1.2, 0.5 and
///   3 m/s.
/// - `slope-2`, `slope-5`, `slope-12`: walking up a slope of 2°, 5° and 12°.
/// - `tilt-5`, `tilt-15`, `tilt-25`: walking on level ground that is tilted in the file, as in
///   camera coordinates.
/// - `moving-platform`: planted feet move with the platform, at up to 0.3 m/s.
/// - `afloat`: swimming in the air; no foot is ever planted.
/// - `stairs`: climbing steps of 17 cm; ground height is that of each step.
/// - `sprint-120`: contacts of 0.1 s on the balls of the feet; no heel is ever planted.
pub fn hard_cases(noise_level: f64) -> Vec<ClipSpec> {
    let level = |name, character_name, frames, rate, motion| {
        ClipSpec::new(name, character_name, motion, frames, rate, noise_level)
    };
    let walk = || walking(1.0, Posture::default());
    let set = |spec, environment| ClipSpec { environment, ..spec };
    let ringing = level("t-pose-and-ringing", "chen", 480, 120, walk());
    let teleport = Environment::Teleport { translation: Vec3::new(-2.6, 0.0, 1.9), rotation: 70.0 };
    vec![
        level("one-foot-in-air", "fay", 420, 60, Motion::from_actions(2.0, hop_throughout)),
        level(
            "one-foot-dragged",
            "emil",
            600,
            60,
            Motion::from_actions(2.0, |actor, seconds| {
                actor.wait(0.4);
                actor.drag(seconds + 1.0);
            }),
        ),
        level(
            "standing-still",
            "gus",
            300,
            30,
            Motion::from_actions(1.0, |actor, seconds| actor.stand(seconds)),
        ),
        level(
            "sit-and-stand",
            "ada",
            540,
            60,
            Motion::from_actions(1.0, |actor, seconds| {
                actor.wait(1.5);
                actor.sit(seconds - 4.5);
            }),
        ),
        level(
            "deep-squats",
            "chen",
            288,
            24,
            Motion::from_actions(1.0, |actor, seconds| {
                actor.wait(1.5);
                actor.squat(((seconds - 1.0) / 2.4) as usize, 0.44);
            }),
        ),
        ClipSpec { leading_t_pose: true, ..set(ringing, Environment::Ringing) },
        set(level("teleport", "ben", 600, 120, walk()), teleport),
        level("z-up-walk", "dora", 480, 120, walk()),
        level(
            "brisk-run-24",
            "hana",
            168,
            24,
            Motion::from_actions(4.0, |actor, seconds| {
                let run = GaitStyle::jog(actor.scale, 1.5);
                actor.wait(0.4);
                actor.travel_straight(&run, seconds + 1.5);
            }),
        ),
        set(
            level("treadmill", "emil", 540, 60, treadmill_walk(FAST_BELT)),
            Environment::Treadmill(FAST_BELT),
        ),
        set(
            level("slow-treadmill", "emil", 540, 60, treadmill_walk(SLOW_BELT)),
            Environment::Treadmill(SLOW_BELT),
        ),
        set(level("slope-2", "gus", 420, 60, uphill(2.0)), Environment::Slope(2.0)),
        set(level("slope-5", "gus", 420, 60, uphill(5.0)), Environment::Slope(5.0)),
        set(level("slope-12", "gus", 420, 60, uphill(12.0)), Environment::Slope(12.0)),
        set(level("tilt-5", "ben", 480, 120, walk()), Environment::Slope(5.0)),
        set(level("tilt-15", "ben", 480, 120, walk()), Environment::Slope(15.0)),
        set(level("tilt-25", "ben", 480, 120, walk()), Environment::Slope(25.0)),
        set(
            level("moving-platform", "ada", 600, 60, Motion::from_actions(1.0, stand_and_walk)),
            Environment::Platform(0.3),
        ),
        level("afloat", "fay", 300, 30, Motion::from_actions(2.0, afloat)),
        level(
            "stairs",
            "ben",
            480,
            60,
            Motion::from_actions(1.0, |actor, _| {
                actor.wait(1.4);
                actor.climb(9);
            }),
        ),
        level(
            "sprint-120",
            "hana",
            360,
            120,
            Motion::from_actions(6.0, |actor, seconds| {
                actor.start_sprint();
                actor.travel_straight(&GaitStyle::sprint(actor.scale), seconds + 1.0);
            }),
        ),
        set(
            level("treadmill-run", "hana", 600, 60, Motion::from_actions(6.0, treadmill_run)),
            Environment::Treadmill(RUNNING_BELT),
        ),
    ]
}

/// Speeds of the treadmills, in m/s.
const FAST_BELT: f64 = 1.2;
const SLOW_BELT: f64 = 0.5;
const RUNNING_BELT: f64 = 3.0;

/// Straight walking throughout the clip, with a given posture.
fn walking(pace: f64, posture: Posture) -> Motion {
    Motion::from_actions(4.0, move |actor, seconds| {
        let style = GaitStyle { posture, ..GaitStyle::walk(actor.scale, pace) };
        actor.wait(0.4);
        actor.travel_straight(&style, seconds + 1.5);
    })
}

/// Walking up a slope: the trunk is vertical, so it leans forward relative to the ground, and the
/// weight is further forward over the feet.
fn uphill(degrees: f64) -> Motion {
    let ahead = 0.9 * libm::sin(degrees.to_radians());
    let posture = Posture {
        trunk: [5.0 + 1.4 * degrees, 0.0, 0.0],
        pelvis: [2.0 + degrees, 0.0, 0.0],
        shift: [0.0, ahead],
        ..Posture::default()
    };
    walking(0.9, posture)
}

/// Walking at the speed of the belt, in m/s.
fn treadmill_walk(belt: f64) -> Motion {
    Motion::from_actions(6.0, move |actor, seconds| {
        let walk = GaitStyle::walk(actor.scale, 1.0);
        let time = walk.gait.length / belt;
        let gait = Gait { time, swing: walk.gait.swing * time / walk.gait.time, ..walk.gait };
        actor.wait(0.4);
        actor.travel(&GaitStyle { gait, ..walk }, seconds + 1.5, |_| 0.0);
    })
}

/// Running at the speed of the fastest belt.
fn treadmill_run(actor: &mut Actor, seconds: f64) {
    let jog = GaitStyle::jog(actor.scale, 1.0);
    let gait = Gait { length: RUNNING_BELT * jog.gait.time, ..jog.gait };
    actor.wait(0.4);
    actor.travel(&GaitStyle { gait, ..jog }, seconds + 1.5, |_| 0.0);
}

fn stand_and_walk(actor: &mut Actor, seconds: f64) {
    actor.wait(2.2);
    actor.turn(80.0);
    actor.travel_straight(&GaitStyle::walk(actor.scale, 0.8), 0.62 * seconds);
    actor.stop();
    actor.stand(seconds);
}

/// Hops on the left foot, the right one raised, from before the clip until after it.
fn hop_throughout(actor: &mut Actor, seconds: f64) {
    let count = (seconds / 0.52) as usize + 5;
    actor.hop_on(Left, count, 0.36);
}

/// Swims in the air: swimming movements of arms and legs with the body horizontal.
fn afloat(actor: &mut Actor, seconds: f64) {
    let (start, scale) = (actor.now(), actor.scale);
    let end = seconds + 3.0;
    let walk = Gait::walk(scale);
    for side in Side::BOTH {
        let phase = if side == Left { 0.0 } else { 0.5 };
        let beat = |n: usize| {
            let up = if (n + usize::from(side == Left)).is_multiple_of(2) { 0.2 } else { -0.16 };
            (start + 0.4 * n as f64, [0.02, up, -0.93, 110.0, 4.0])
        };
        let beats = ((end - start) / 0.4) as usize;
        let leg_poses = LegPoses {
            poses: Track::from_keys(&(2..beats).map(beat).collect::<Vec<_>>()),
            ease_in: 0.7,
            ease_out: 0.7,
        };
        let placement = actor.planner.placement(side);
        let step = actor.planner.place_foot(side, end, placement, &walk);
        step.swing = end - start - 0.1;
        step.lift = Lift { pitch: 0.0, lead: 0.0 };
        step.landing = Landing::FLAT;
        // No foot is on the ground; the load holds the balance model over the initial foot
        // positions.
        step.swing_path = SwingPath {
            grounded: true,
            load: 0.5,
            leg_poses: Some(leg_poses),
            ramps: (0.3, 0.3),
            ..walk.swing_path.clone()
        };
        let arm = &mut actor.planner.body().arms[side as usize];
        let reach = [
            [168.0, 10.0, 10.0, 8.0, 0.0],
            [84.0, 16.0, 20.0, 30.0, 0.0],
            [-14.0, 10.0, 10.0, 16.0, 0.0],
            [30.0, 60.0, 30.0, 92.0, 0.0],
        ];
        for n in 2..(2.5 * (end - start)) as usize {
            arm.set_key(start + 0.4 * (n as f64 + 2.0 * phase * 2.0), reach[n % 4]);
        }
    }
    let body = actor.planner.body();
    for (time, lowering, pitch) in
        [(start, 0.0, 3.0), (start + 1.3, -0.5, 74.0), (end - 1.3, -0.5, 74.0), (end, 0.0, 3.0)]
    {
        body.lowering.set_key(time, [lowering * scale]);
        body.trunk.set_key(time, [pitch, 0.0, 0.0]);
        body.pelvis.set_key(time, [0.95 * pitch, 0.0, 0.0]);
    }
    body.arm_swing.set_key(start, [0.0]);
    body.pelvic_rotation = 0.0;
    body.gaze.set_key(start + 1.3, [0.0, -10.0]);
}
