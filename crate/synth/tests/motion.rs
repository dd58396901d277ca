//! The motions as motions: planted feet stand, legs are not stretched, nothing jumps.

mod kinematics;

use kinematics::{Positions, positions};
use plantigrade::foot::{Part, Side};
use plantigrade_synth::character::Bone;
use plantigrade_synth::pose::STRETCH_LIMIT;
use plantigrade_synth::setting::Setting;
use plantigrade_synth::{Recipe, catalogue, full_set, generate, hard_cases};

/// The full set and the hard cases on level ground.
fn on_level_ground(noise_level: f64) -> Vec<Recipe> {
    let mut recipes = [full_set(noise_level), hard_cases(noise_level)].concat();
    recipes.retain(|recipe| recipe.setting == Setting::Level && recipe.name != "stairs");
    recipes
}

/// Frames at the start that are not motion.
fn skipped(recipe: &Recipe) -> usize {
    usize::from(recipe.leading_t_pose)
}

fn walked(recipe: &Recipe, seed: u64) -> (Positions, plantigrade_synth::Generated) {
    let generated = generate(recipe, seed);
    (positions(&generated.clip, &recipe.character), generated)
}

#[test]
fn without_noise_planted_toes_are_still_and_on_the_ground() {
    for recipe in on_level_ground(0.0) {
        let (positions, generated) = walked(&recipe, 0);
        for side in Side::BOTH {
            let toe = positions.of(Bone::Toe(side));
            let planted = generated.truth.labels(side, Part::Toe).unwrap();
            for frame in skipped(&recipe) + 1..planted.len() {
                if planted[frame - 1] && planted[frame] {
                    let speed = (toe[frame] - toe[frame - 1]).norm() / generated.clip.frame_time();
                    assert!(speed < 0.18, "{} {} {frame}: {speed:.3} m/s", recipe.name, side.name());
                    let above = toe[frame].y - recipe.character.build.ball;
                    assert!(above.abs() < 0.006, "{} {} {frame}: {above:.4} m", recipe.name, side.name());
                }
            }
        }
    }
}

#[test]
fn legs_are_never_stretched() {
    for recipe in on_level_ground(2.0) {
        for seed in 0..3 {
            let (positions, generated) = walked(&recipe, seed);
            let leg = recipe.character.build.leg();
            for side in Side::BOTH {
                let (hip, ankle) = (positions.of(Bone::Thigh(side)), positions.of(Bone::Foot(side)));
                for frame in skipped(&recipe)..generated.clip.frame_count() {
                    let stretch = (hip[frame] - ankle[frame]).norm() / leg;
                    assert!(stretch < STRETCH_LIMIT + 1e-3, "{} {frame}: {stretch:.4}", recipe.name);
                }
            }
        }
    }
}

#[test]
fn feet_stay_out_of_the_floor() {
    for recipe in on_level_ground(1.0) {
        let (positions, _) = walked(&recipe, 0);
        for side in Side::BOTH {
            for bone in [Bone::Foot(side), Bone::Toe(side)] {
                let lowest = positions.of(bone).iter().map(|p| p.y).fold(f64::INFINITY, f64::min);
                assert!(lowest > -0.03, "{} {bone:?}: {lowest:.3} m", recipe.name);
            }
        }
    }
}

#[test]
fn noisy_plants_move_as_recorded_ones_do() {
    for recipe in on_level_ground(1.0) {
        let (positions, generated) = walked(&recipe, 0);
        for side in Side::BOTH {
            let toe = positions.of(Bone::Toe(side));
            let planted = generated.truth.labels(side, Part::Toe).unwrap();
            let mut speeds: Vec<f64> = (skipped(&recipe) + 1..planted.len())
                .filter(|&frame| planted[frame] && planted[frame - 1])
                .map(|frame| (toe[frame] - toe[frame - 1]).norm() / generated.clip.frame_time())
                .collect();
            speeds.sort_by(f64::total_cmp);
            if speeds.is_empty() {
                continue; // A foot that never stands.
            }
            let median = speeds[speeds.len() / 2];
            assert!((0.03..0.5).contains(&median), "{}: {median:.3} m/s", recipe.name);
        }
    }
}

#[test]
fn joints_do_not_jump() {
    for recipe in on_level_ground(1.0) {
        let (positions, generated) = walked(&recipe, 0);
        for bone in [Bone::Hips, Bone::Head, Bone::Shank(Side::Left), Bone::Hand(Side::Right)] {
            let track = &positions.of(bone)[skipped(&recipe)..];
            for (frame, pair) in track.windows(2).enumerate() {
                let speed = (pair[1] - pair[0]).norm() / generated.clip.frame_time();
                assert!(speed < 16.0, "{} {bone:?} {frame}: {speed:.1} m/s", recipe.name);
            }
        }
    }
}

#[test]
fn the_pelvis_moves_smoothly() {
    for recipe in on_level_ground(0.0) {
        for seed in 0..4 {
            let (positions, generated) = walked(&recipe, seed);
            let step = generated.clip.frame_time();
            let track = &positions.of(Bone::Hips)[skipped(&recipe)..];
            for (frame, three) in track.windows(3).enumerate() {
                let push = (three[0] - 2.0 * three[1] + three[2]).norm() / (step * step);
                assert!(push < 60.0, "{} seed {seed} frame {frame}: {push:.0} m/s²", recipe.name);
            }
        }
    }
}

#[test]
fn flight_is_free_fall() {
    // The frog jumps' flights are long enough to fit a parabola.
    let recipe = &catalogue(0.0)[0];
    let (positions, generated) = walked(recipe, 0);
    let contact = Side::BOTH.map(|side| generated.truth.labels(side, Part::Contact).unwrap());
    let hips = positions.of(Bone::Hips);
    let step = generated.clip.frame_time();
    let mut checked = 0;
    for frame in 4..contact[0].len() - 4 {
        if (frame - 4..=frame + 4).all(|n| !contact[0][n] && !contact[1][n]) {
            let fall = (hips[frame - 1].y - 2.0 * hips[frame].y + hips[frame + 1].y) / (step * step);
            assert!((fall + 9.81).abs() < 0.6, "{frame}: {fall:.2} m/s²");
            checked += 1;
        }
    }
    assert!(checked > 20, "only {checked} frames of flight");
}
