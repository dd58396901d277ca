//! The full set: the samples and the common motions of mocap libraries.

use plantigrade::foot::Side::{Left, Right};

use super::samples;
use crate::actions::{Actor, GaitStyle, Posture};
use crate::generate::ClipSpec;
use crate::motion::Motion;

/// Returns the thirteen samples and 22 further clips. `noise_level` is the factor on the
/// characters' foot noise.
///
/// As in the detector's paper, the set has 35 files of 8 characters with 16,613 frames in total.
pub fn full_set(noise_level: f64) -> Vec<ClipSpec> {
    let others = everyday().into_iter().map(|(name, character_name, frames, rate, motion)| {
        let spec = ClipSpec::new(name, character_name, motion, frames, rate, noise_level);
        // Chen's files imitate converters that insert a T-pose before the motion.
        ClipSpec { leading_t_pose: character_name == "chen", ..spec }
    });
    samples(noise_level).into_iter().chain(others).collect()
}

/// Returns name, character, number of frames, frame rate and motion of each clip.
fn everyday() -> Vec<(&'static str, &'static str, usize, usize, Motion)> {
    vec![
        ("straight-walk", "ben", 480, 120, in_motion(|scale| GaitStyle::walk(scale, 1.05))),
        ("brisk-walk", "ada", 420, 120, in_motion(|scale| GaitStyle::walk(scale, 1.45))),
        ("march", "hana", 300, 30, start_to_stop(GaitStyle::march)),
        ("tiptoe-walk", "emil", 480, 60, start_to_stop(GaitStyle::tiptoe)),
        ("backward-walk", "gus", 300, 30, start_to_stop(GaitStyle::backward)),
        ("side-steps", "ada", 330, 30, Motion::from_actions(1.0, side_steps)),
        ("turns-in-place", "chen", 288, 24, Motion::from_actions(1.0, turns)),
        ("walk-stop-walk", "ben", 960, 120, Motion::from_actions(1.0, walk_stop_walk)),
        ("walk-to-run", "gus", 510, 60, Motion::from_actions(1.0, walk_to_run)),
        ("jog-with-turns", "hana", 540, 60, Motion::from_actions(4.0, jog_with_turns)),
        ("sprint-start", "emil", 420, 120, Motion::from_actions(1.0, sprint_start)),
        ("hopscotch", "ada", 480, 60, Motion::from_actions(1.0, hopscotch)),
        ("jumping-jacks", "chen", 390, 30, Motion::from_actions(1.0, jumping_jacks)),
        ("long-jump", "ben", 720, 120, Motion::from_actions(4.0, long_jump)),
        ("step-over", "dora", 540, 60, Motion::from_actions(1.0, step_over)),
        ("kick", "emil", 780, 120, Motion::from_actions(1.0, kick)),
        (
            "boxing",
            "gus",
            600,
            60,
            Motion::from_actions(1.0, |actor, seconds| {
                actor.wait(1.2);
                actor.boxing(seconds - 0.8);
            }),
        ),
        (
            "salsa",
            "hana",
            390,
            30,
            Motion::from_actions(1.0, |actor, seconds| {
                actor.wait(1.2);
                actor.salsa((seconds / 2.88) as usize);
            }),
        ),
        ("sneaking", "dora", 336, 24, start_to_stop(GaitStyle::sneak)),
        ("stumble", "fay", 420, 60, Motion::from_actions(3.0, stumble)),
        ("crouch-walk", "chen", 264, 24, start_to_stop(GaitStyle::crouch)),
        ("pick-up", "dora", 771, 60, Motion::from_actions(2.5, pick_up)),
    ]
}

/// Locomotion that begins before the clip and continues after its end.
fn in_motion(style: fn(f64) -> GaitStyle) -> Motion {
    Motion::from_actions(4.0, move |actor, seconds| {
        let style = style(actor.scale);
        actor.wait(0.5);
        actor.travel_straight(&style, seconds + 2.0);
    })
}

/// Locomotion in one style from standing to standing.
fn start_to_stop(style: fn(f64) -> GaitStyle) -> Motion {
    Motion::from_actions(1.0, move |actor, seconds| {
        let style = style(actor.scale);
        actor.wait(1.6);
        actor.travel_straight(&style, seconds - 2.4 * style.gait.time - 0.9);
        actor.stop();
    })
}

fn side_steps(actor: &mut Actor, seconds: f64) {
    actor.wait(1.6);
    let count = ((seconds - 2.4) / 2.0 - 0.4) as usize;
    actor.side_steps(Left, count);
    actor.side_steps(Right, count);
}

fn turns(actor: &mut Actor, seconds: f64) {
    actor.wait(1.4);
    for degrees in [90.0, 180.0, -90.0, -200.0] {
        if actor.now() < seconds - 3.0 {
            actor.turn(degrees);
            actor.stand(0.3);
        }
    }
}

fn walk_stop_walk(actor: &mut Actor, seconds: f64) {
    let walk = GaitStyle::walk(actor.scale, 1.0);
    actor.wait(1.3);
    actor.travel_straight(&walk, 0.36 * seconds);
    actor.stop();
    actor.stand(0.9);
    actor.travel_straight(&walk, seconds + 1.0);
}

fn walk_to_run(actor: &mut Actor, seconds: f64) {
    let scale = actor.scale;
    actor.wait(1.2);
    actor.travel_straight(&GaitStyle::walk(scale, 1.1), 0.4 * seconds);
    actor.travel_straight(&GaitStyle::jog(scale, 1.0), 0.6 * seconds);
    actor.travel_straight(&GaitStyle::jog(scale, 1.4), seconds + 1.5);
}

fn jog_with_turns(actor: &mut Actor, seconds: f64) {
    let jog = GaitStyle::jog(actor.scale, 0.95);
    actor.wait(0.6);
    let leaning =
        |to: f64| GaitStyle { posture: Posture { trunk: [8.0, 0.0, to], ..jog.posture }, ..jog.clone() };
    for (until, turn) in [(0.24, 0.0), (0.42, 22.0), (0.58, 0.0), (0.8, -24.0), (1.2, 0.0)] {
        actor.travel(&leaning(0.3 * turn), until * seconds, |random| turn + random.uniform(-2.0, 2.0));
    }
}

fn sprint_start(actor: &mut Actor, seconds: f64) {
    let scale = actor.scale;
    actor.wait(0.9);
    actor.start_sprint();
    actor.travel_straight(&GaitStyle::sprint(scale), seconds + 1.5);
}

fn hopscotch(actor: &mut Actor, seconds: f64) {
    actor.wait(1.3);
    actor.hopscotch(((seconds - 2.2) / 1.08) as usize);
}

fn jumping_jacks(actor: &mut Actor, seconds: f64) {
    actor.wait(1.3);
    actor.jumping_jacks(((seconds - 2.2) / 0.86) as usize);
}

fn long_jump(actor: &mut Actor, seconds: f64) {
    let run = GaitStyle::jog(actor.scale, 1.1);
    actor.wait(0.4);
    actor.travel_straight(&run, 0.28 * seconds);
    actor.long_jump(&run);
    actor.travel_straight(&GaitStyle::walk(actor.scale, 0.9), seconds + 1.0);
}

fn step_over(actor: &mut Actor, seconds: f64) {
    let walk = GaitStyle::walk(actor.scale, 0.9);
    actor.wait(1.3);
    for fraction in [0.22, 0.56] {
        actor.travel_straight(&walk, fraction * seconds);
        actor.step_over(&walk);
    }
    actor.travel_straight(&walk, seconds + 1.0);
}

fn kick(actor: &mut Actor, _seconds: f64) {
    actor.wait(1.1);
    for side in [Right, Left, Right] {
        actor.kick(side);
    }
}

fn stumble(actor: &mut Actor, seconds: f64) {
    let walk = GaitStyle::walk(actor.scale, 1.1);
    actor.wait(0.4);
    actor.travel_straight(&walk, 0.3 * seconds);
    actor.stumble(&walk);
    actor.travel_straight(&walk, seconds + 1.0);
}

fn pick_up(actor: &mut Actor, seconds: f64) {
    let walk = GaitStyle::walk(actor.scale, 0.9);
    actor.wait(0.5);
    actor.travel_straight(&walk, 0.12 * seconds);
    actor.pick_up();
    actor.turn(150.0);
    actor.travel_straight(&walk, seconds + 1.0);
}
