//! Plausibility of motions: planted feet are still, legs are not overextended, motion is
//! continuous.

mod kinematics;

use kinematics::{Positions, positions};
use plantigrade::foot::{Part, Side};
use plantigrade_synth::character::Bone;
use plantigrade_synth::environment::Environment;
use plantigrade_synth::pose::MAX_LEG_EXTENSION;
use plantigrade_synth::{ClipSpec, full_set, generate, hard_cases, samples};

/// Returns the full set and the hard cases on level ground.
fn level_ground_specs(noise_level: f64) -> Vec<ClipSpec> {
    let mut specs = [full_set(noise_level), hard_cases(noise_level)].concat();
    specs.retain(|spec| spec.environment == Environment::Level && spec.name != "stairs");
    specs
}

/// Number of frames before the motion.
fn lead_in_frames(spec: &ClipSpec) -> usize {
    usize::from(spec.leading_t_pose)
}

fn generated_with_positions(spec: &ClipSpec, seed: u64) -> (Positions, plantigrade_synth::Generated) {
    let generated = generate(spec, seed);
    (positions(&generated.clip, &spec.character), generated)
}

#[test]
fn planted_toes_are_still_and_on_the_ground_without_noise() {
    for spec in level_ground_specs(0.0) {
        let (positions, generated) = generated_with_positions(&spec, 0);
        for side in Side::BOTH {
            let toe = positions.track(Bone::Toe(side));
            let planted = generated.truth.labels(side, Part::Toe).unwrap();
            for frame in lead_in_frames(&spec) + 1..planted.len() {
                if planted[frame - 1] && planted[frame] {
                    let speed = (toe[frame] - toe[frame - 1]).norm() / generated.clip.frame_time();
                    assert!(speed < 0.18, "{} {} {frame}: {speed:.3} m/s", spec.name, side.name());
                    let above = toe[frame].y - spec.character.proportions.ball;
                    assert!(above.abs() < 0.006, "{} {} {frame}: {above:.4} m", spec.name, side.name());
                }
            }
        }
    }
}

#[test]
fn legs_are_never_overextended() {
    for spec in level_ground_specs(2.0) {
        for seed in 0..3 {
            let (positions, generated) = generated_with_positions(&spec, seed);
            let leg = spec.character.proportions.leg_length();
            for side in Side::BOTH {
                let (hip, ankle) = (positions.track(Bone::Thigh(side)), positions.track(Bone::Foot(side)));
                for frame in lead_in_frames(&spec)..generated.clip.frame_count() {
                    let extension = (hip[frame] - ankle[frame]).norm() / leg;
                    assert!(extension < MAX_LEG_EXTENSION + 1e-3, "{} {frame}: {extension:.4}", spec.name);
                }
            }
        }
    }
}

#[test]
fn feet_do_not_penetrate_the_floor() {
    for spec in level_ground_specs(1.0) {
        let (positions, _) = generated_with_positions(&spec, 0);
        for side in Side::BOTH {
            for bone in [Bone::Foot(side), Bone::Toe(side)] {
                let lowest = positions.track(bone).iter().map(|p| p.y).fold(f64::INFINITY, f64::min);
                assert!(lowest > -0.03, "{} {bone:?}: {lowest:.3} m", spec.name);
            }
        }
    }
}

#[test]
fn noisy_plants_move_at_recorded_speeds() {
    for spec in level_ground_specs(1.0) {
        let (positions, generated) = generated_with_positions(&spec, 0);
        for side in Side::BOTH {
            let toe = positions.track(Bone::Toe(side));
            let planted = generated.truth.labels(side, Part::Toe).unwrap();
            let mut speeds: Vec<f64> = (lead_in_frames(&spec) + 1..planted.len())
                .filter(|&frame| planted[frame] && planted[frame - 1])
                .map(|frame| (toe[frame] - toe[frame - 1]).norm() / generated.clip.frame_time())
                .collect();
            speeds.sort_by(f64::total_cmp);
            if speeds.is_empty() {
                continue; // A foot that is never planted.
            }
            let median = speeds[speeds.len() / 2];
            assert!((0.03..0.5).contains(&median), "{}: {median:.3} m/s", spec.name);
        }
    }
}

#[test]
fn joint_speeds_are_bounded() {
    for spec in level_ground_specs(1.0) {
        let (positions, generated) = generated_with_positions(&spec, 0);
        for bone in [Bone::Hips, Bone::Head, Bone::Shank(Side::Left), Bone::Hand(Side::Right)] {
            let track = &positions.track(bone)[lead_in_frames(&spec)..];
            for (frame, pair) in track.windows(2).enumerate() {
                let speed = (pair[1] - pair[0]).norm() / generated.clip.frame_time();
                assert!(speed < 16.0, "{} {bone:?} {frame}: {speed:.1} m/s", spec.name);
            }
        }
    }
}

#[test]
fn pelvis_acceleration_is_bounded() {
    for spec in level_ground_specs(0.0) {
        for seed in 0..4 {
            let (positions, generated) = generated_with_positions(&spec, seed);
            let step = generated.clip.frame_time();
            let track = &positions.track(Bone::Hips)[lead_in_frames(&spec)..];
            for (frame, triple) in track.windows(3).enumerate() {
                let acceleration = (triple[0] - 2.0 * triple[1] + triple[2]).norm() / (step * step);
                assert!(
                    acceleration < 60.0,
                    "{} seed {seed} frame {frame}: {acceleration:.0} m/s²",
                    spec.name
                );
            }
        }
    }
}

#[test]
fn pelvis_is_in_free_fall_during_flight() {
    // Flights of the frog jumps are long enough to fit a parabola.
    let spec = &samples(0.0)[0];
    let (positions, generated) = generated_with_positions(spec, 0);
    let contact = Side::BOTH.map(|side| generated.truth.labels(side, Part::Contact).unwrap());
    let hips = positions.track(Bone::Hips);
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
