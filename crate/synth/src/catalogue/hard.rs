//! Clips that plant detectors stumble over, kept apart from the full set.

use plantigrade::foot::Side::{self, Left};

use crate::act::{Actor, Carriage, Style};
use crate::curve::Track;
use crate::maths::Vec3;
use crate::motion::Motion;
use crate::plan::{Carry, Gait, Held, Landing, Lift};
use crate::recipe::Recipe;
use crate::setting::Setting;

/// The hard cases, their characters' noise `noise_level` times as strong.
///
/// In all of them a foot is planted when it is still against the ground that it stands on.
///
/// - `one-foot-in-air`: hopping on the left foot; the right one is never planted.
/// - `one-foot-dragged`: the right foot is dragged all the time, with some of the weight
///   on it, and is never planted.
/// - `standing-still`, `sit-and-stand`, `deep-squats`: both feet are flat on the ground in
///   every frame.
/// - `t-pose-and-ringing`: a walk after a T-pose, with two frames in which the recording's
///   filter rings; they bear the labels of the walk.
/// - `teleport`: a walk that goes on several metres away, from one frame to the next; the
///   feet are planted right through the jump if they are before and after it.
/// - `z-up-walk`: a walk in a file whose Z axis points up.
/// - `brisk-run-24`: a run at 24 Hz, four frames to a contact.
/// - `treadmill`: planted feet move back with the belt, at 1.2 m/s.
/// - `slope-2`, `slope-5`: walking up a slope of so many degrees.
/// - `moving-platform`: planted feet move with the platform, at up to 0.3 m/s.
/// - `afloat`: swimming in the air; nothing is ever planted.
/// - `stairs`: steps of 17 cm up; the ground is where each foot stands.
/// - `sprint-120`: contacts of 0.1 s on the balls of the feet; no heel is ever planted.
pub fn hard_cases(noise_level: f64) -> Vec<Recipe> {
    let level = |name, performer, frames, rate, motion| {
        Recipe::new(name, performer, motion, frames, rate, noise_level)
    };
    let walk = || walking(1.0, Carriage::default());
    let set = |recipe, setting| Recipe { setting, ..recipe };
    let ringing = level("t-pose-and-ringing", "chen", 480, 120, walk());
    let elsewhere = Setting::Teleport { by: Vec3::new(-2.6, 0.0, 1.9), turned: 70.0 };
    vec![
        level("one-foot-in-air", "fay", 420, 60, Motion::acted(2.0, hop_throughout)),
        level(
            "one-foot-dragged",
            "emil",
            600,
            60,
            Motion::acted(2.0, |actor, seconds| {
                actor.wait(0.4);
                actor.drag(seconds + 1.0);
            }),
        ),
        level("standing-still", "gus", 300, 30, Motion::acted(1.0, |actor, seconds| actor.stand(seconds))),
        level(
            "sit-and-stand",
            "ada",
            540,
            60,
            Motion::acted(1.0, |actor, seconds| {
                actor.wait(1.5);
                actor.sit(seconds - 4.5);
            }),
        ),
        level(
            "deep-squats",
            "chen",
            288,
            24,
            Motion::acted(1.0, |actor, seconds| {
                actor.wait(1.5);
                actor.squat(((seconds - 1.0) / 2.4) as usize, 0.44);
            }),
        ),
        Recipe { leading_t_pose: true, ..set(ringing, Setting::Ringing) },
        set(level("teleport", "ben", 600, 120, walk()), elsewhere),
        level("z-up-walk", "dora", 480, 120, walk()),
        level(
            "brisk-run-24",
            "hana",
            168,
            24,
            Motion::acted(4.0, |actor, seconds| {
                let run = Style::jog(actor.scale, 1.5);
                actor.wait(0.4);
                actor.go_straight(&run, seconds + 1.5);
            }),
        ),
        set(level("treadmill", "emil", 540, 60, Motion::acted(6.0, on_a_belt)), Setting::Belt(BELT)),
        set(level("slope-2", "gus", 420, 60, uphill(2.0)), Setting::Slope(2.0)),
        set(level("slope-5", "gus", 420, 60, uphill(5.0)), Setting::Slope(5.0)),
        set(level("moving-platform", "ada", 600, 60, Motion::acted(1.0, about)), Setting::Platform(0.3)),
        level("afloat", "fay", 300, 30, Motion::acted(2.0, afloat)),
        level(
            "stairs",
            "ben",
            480,
            60,
            Motion::acted(1.0, |actor, _| {
                actor.wait(1.4);
                actor.climb(9);
            }),
        ),
        level(
            "sprint-120",
            "hana",
            360,
            120,
            Motion::acted(6.0, |actor, seconds| {
                actor.sprint_off();
                actor.go_straight(&Style::sprint(actor.scale), seconds + 1.0);
            }),
        ),
    ]
}

/// Speed of the treadmill, in metres per second.
const BELT: f64 = 1.2;

/// Walking straight on all the time, the body carried in a certain way.
fn walking(pace: f64, carriage: Carriage) -> Motion {
    Motion::acted(4.0, move |actor, seconds| {
        let style = Style { carriage, ..Style::walk(actor.scale, pace) };
        actor.wait(0.4);
        actor.go_straight(&style, seconds + 1.5);
    })
}

/// Walking up a slope: upright against the plumb line, so bent against the ground, and
/// the weight further ahead over the feet.
fn uphill(degrees: f64) -> Motion {
    let ahead = 0.9 * libm::sin(degrees.to_radians());
    let carriage = Carriage {
        trunk: [5.0 + 1.4 * degrees, 0.0, 0.0],
        pelvis: [2.0 + degrees, 0.0, 0.0],
        shift: [0.0, ahead],
        ..Carriage::default()
    };
    walking(0.9, carriage)
}

/// Walking at the speed of the belt.
fn on_a_belt(actor: &mut Actor, seconds: f64) {
    let walk = Style::walk(actor.scale, 1.0);
    let time = walk.gait.length / BELT;
    let gait = Gait { time, swing: walk.gait.swing * time / walk.gait.time, ..walk.gait };
    actor.wait(0.4);
    actor.go(&Style { gait, ..walk }, seconds + 1.5, |_| 0.0);
}

fn about(actor: &mut Actor, seconds: f64) {
    actor.wait(2.2);
    actor.turn(80.0);
    actor.go_straight(&Style::walk(actor.scale, 0.8), 0.62 * seconds);
    actor.stop();
    actor.stand(seconds);
}

/// Hops on the left foot with the right one up from before the clip until after it.
fn hop_throughout(actor: &mut Actor, seconds: f64) {
    let count = (seconds / 0.52) as usize + 5;
    actor.hop_on(Left, count, 0.36);
}

/// Swims in the air: a crawl of arms and legs, the body lying.
fn afloat(actor: &mut Actor, seconds: f64) {
    let (begin, scale) = (actor.now(), actor.scale);
    let end = seconds + 3.0;
    let walk = Gait::walk(scale);
    for side in Side::BOTH {
        let phase = if side == Left { 0.0 } else { 0.5 };
        let beat = |n: usize| {
            let up = if (n + usize::from(side == Left)).is_multiple_of(2) { 0.2 } else { -0.16 };
            (begin + 0.4 * n as f64, [0.02, up, -0.93, 110.0, 4.0])
        };
        let beats = ((end - begin) / 0.4) as usize;
        let held =
            Held { poses: Track::of(&(2..beats).map(beat).collect::<Vec<_>>()), ease_in: 0.7, ease_out: 0.7 };
        let place = actor.planner.place(side);
        let step = actor.planner.put(side, end, place, &walk);
        step.swing = end - begin - 0.1;
        step.lift = Lift { pitch: 0.0, lead: 0.0 };
        step.landing = Landing::FLAT;
        // The weight rests on nothing; for the balance it stays over where the feet were.
        step.carry =
            Carry { grounded: true, load: 0.5, held: Some(held), ramps: (0.3, 0.3), ..walk.carry.clone() };
        let arm = &mut actor.planner.body().arms[side as usize];
        let reach = [
            [168.0, 10.0, 10.0, 8.0, 0.0],
            [84.0, 16.0, 20.0, 30.0, 0.0],
            [-14.0, 10.0, 10.0, 16.0, 0.0],
            [30.0, 60.0, 30.0, 92.0, 0.0],
        ];
        for n in 2..(2.5 * (end - begin)) as usize {
            arm.key(begin + 0.4 * (n as f64 + 2.0 * phase * 2.0), reach[n % 4]);
        }
    }
    let body = actor.planner.body();
    for (time, sink, pitch) in
        [(begin, 0.0, 3.0), (begin + 1.3, -0.5, 74.0), (end - 1.3, -0.5, 74.0), (end, 0.0, 3.0)]
    {
        body.sink.key(time, [sink * scale]);
        body.trunk.key(time, [pitch, 0.0, 0.0]);
        body.pelvis.key(time, [0.95 * pitch, 0.0, 0.0]);
    }
    body.arm_swing.key(begin, [0.0]);
    body.pelvis_turn = 0.0;
    body.look.key(begin + 1.3, [0.0, -10.0]);
}
