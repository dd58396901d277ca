//! The full set: the samples and the everyday range of motion libraries.

use plantigrade::foot::Side::{Left, Right};

use super::catalogue;
use crate::act::{Actor, Carriage, Style};
use crate::motion::Motion;
use crate::recipe::Recipe;

/// The thirteen samples and twenty-two others, their characters' noise `noise_level`
/// times as strong.
///
/// As in the detector's paper, they are 35 files of 8 characters with 16,613 frames in all.
pub fn full_set(noise_level: f64) -> Vec<Recipe> {
    let others = everyday().into_iter().map(|(name, performer, frames, rate, motion)| {
        let recipe = Recipe::new(name, performer, motion, frames, rate, noise_level);
        // Chen's are conversions of the kind that puts a T-pose before the motion.
        Recipe { leading_t_pose: performer == "chen", ..recipe }
    });
    catalogue(noise_level).into_iter().chain(others).collect()
}

/// Name, performer, frames, rate and motion of each.
fn everyday() -> Vec<(&'static str, &'static str, usize, usize, Motion)> {
    vec![
        ("straight-walk", "ben", 480, 120, on_the_way(|scale| Style::walk(scale, 1.05))),
        ("brisk-walk", "ada", 420, 120, on_the_way(|scale| Style::walk(scale, 1.45))),
        ("march", "hana", 300, 30, there(Style::march)),
        ("tiptoe-walk", "emil", 480, 60, there(Style::tiptoe)),
        ("backward-walk", "gus", 300, 30, there(Style::backward)),
        ("side-steps", "ada", 330, 30, Motion::acted(1.0, side_steps)),
        ("turns-in-place", "chen", 288, 24, Motion::acted(1.0, turns)),
        ("walk-stop-walk", "ben", 960, 120, Motion::acted(1.0, walk_stop_walk)),
        ("walk-to-run", "gus", 510, 60, Motion::acted(1.0, walk_to_run)),
        ("jog-with-turns", "hana", 540, 60, Motion::acted(4.0, jog_with_turns)),
        ("sprint-start", "emil", 420, 120, Motion::acted(1.0, sprint_start)),
        ("hopscotch", "ada", 480, 60, Motion::acted(1.0, hopscotch)),
        ("jumping-jacks", "chen", 390, 30, Motion::acted(1.0, jumping_jacks)),
        ("long-jump", "ben", 720, 120, Motion::acted(4.0, long_jump)),
        ("step-over", "dora", 540, 60, Motion::acted(1.0, step_over)),
        ("kick", "emil", 780, 120, Motion::acted(1.0, kick)),
        (
            "boxing",
            "gus",
            600,
            60,
            Motion::acted(1.0, |actor, seconds| {
                actor.wait(1.2);
                actor.boxing(seconds - 0.8);
            }),
        ),
        (
            "salsa",
            "hana",
            390,
            30,
            Motion::acted(1.0, |actor, seconds| {
                actor.wait(1.2);
                actor.salsa((seconds / 2.88) as usize);
            }),
        ),
        ("sneaking", "dora", 336, 24, there(Style::sneak)),
        ("stumble", "fay", 420, 60, Motion::acted(3.0, stumble)),
        ("crouch-walk", "chen", 264, 24, there(Style::crouch)),
        ("pick-up", "dora", 771, 60, Motion::acted(2.5, pick_up)),
    ]
}

/// Walking from before the clip begins until after it ends.
fn on_the_way(style: fn(f64) -> Style) -> Motion {
    Motion::acted(4.0, move |actor, seconds| {
        let style = style(actor.scale);
        actor.wait(0.5);
        actor.go_straight(&style, seconds + 2.0);
    })
}

/// From a stand to a stand in one style.
fn there(style: fn(f64) -> Style) -> Motion {
    Motion::acted(1.0, move |actor, seconds| {
        let style = style(actor.scale);
        actor.wait(1.6);
        actor.go_straight(&style, seconds - 2.4 * style.gait.time - 0.9);
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
    let walk = Style::walk(actor.scale, 1.0);
    actor.wait(1.3);
    actor.go_straight(&walk, 0.36 * seconds);
    actor.stop();
    actor.stand(0.9);
    actor.go_straight(&walk, seconds + 1.0);
}

fn walk_to_run(actor: &mut Actor, seconds: f64) {
    let scale = actor.scale;
    actor.wait(1.2);
    actor.go_straight(&Style::walk(scale, 1.1), 0.4 * seconds);
    actor.go_straight(&Style::jog(scale, 1.0), 0.6 * seconds);
    actor.go_straight(&Style::jog(scale, 1.4), seconds + 1.5);
}

fn jog_with_turns(actor: &mut Actor, seconds: f64) {
    let jog = Style::jog(actor.scale, 0.95);
    actor.wait(0.6);
    let leaning =
        |to: f64| Style { carriage: Carriage { trunk: [8.0, 0.0, to], ..jog.carriage }, ..jog.clone() };
    for (until, turn) in [(0.24, 0.0), (0.42, 22.0), (0.58, 0.0), (0.8, -24.0), (1.2, 0.0)] {
        actor.go(&leaning(0.3 * turn), until * seconds, |random| turn + random.between(-2.0, 2.0));
    }
}

fn sprint_start(actor: &mut Actor, seconds: f64) {
    let scale = actor.scale;
    actor.wait(0.9);
    actor.sprint_off();
    actor.go_straight(&Style::sprint(scale), seconds + 1.5);
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
    let run = Style::jog(actor.scale, 1.1);
    actor.wait(0.4);
    actor.go_straight(&run, 0.28 * seconds);
    actor.long_jump(&run);
    actor.go_straight(&Style::walk(actor.scale, 0.9), seconds + 1.0);
}

fn step_over(actor: &mut Actor, seconds: f64) {
    let walk = Style::walk(actor.scale, 0.9);
    actor.wait(1.3);
    for share in [0.22, 0.56] {
        actor.go_straight(&walk, share * seconds);
        actor.step_over(&walk);
    }
    actor.go_straight(&walk, seconds + 1.0);
}

fn kick(actor: &mut Actor, _seconds: f64) {
    actor.wait(1.1);
    for side in [Right, Left, Right] {
        actor.kick(side);
    }
}

fn stumble(actor: &mut Actor, seconds: f64) {
    let walk = Style::walk(actor.scale, 1.1);
    actor.wait(0.4);
    actor.go_straight(&walk, 0.3 * seconds);
    actor.stumble(&walk);
    actor.go_straight(&walk, seconds + 1.0);
}

fn pick_up(actor: &mut Actor, seconds: f64) {
    let walk = Style::walk(actor.scale, 0.9);
    actor.wait(0.5);
    actor.go_straight(&walk, 0.12 * seconds);
    actor.pick_up();
    actor.turn(150.0);
    actor.go_straight(&walk, seconds + 1.0);
}
