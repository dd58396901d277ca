//! The hard cases have the properties that their names promise.

mod kinematics;

use kinematics::{Positions, positions};
use plantigrade::foot::{Part, Side};
use plantigrade_synth::character::Bone;
use plantigrade_synth::{Generated, generate, hard_cases};

fn case(name: &str) -> (Positions, Generated) {
    let spec = hard_cases(0.0).into_iter().find(|spec| spec.name == name).expect("a hard case");
    let generated = generate(&spec, 0);
    (positions(&generated.clip, &spec.character), generated)
}

fn labels(generated: &Generated, side: Side, part: Part) -> Vec<bool> {
    generated.truth.labels(side, part).unwrap()
}

/// Returns toe speeds in m/s between consecutive planted frames.
fn planted_speeds((positions, generated): &(Positions, Generated), side: Side) -> Vec<f64> {
    let toe = positions.track(Bone::Toe(side));
    let planted = labels(generated, side, Part::Toe);
    (1..planted.len())
        .filter(|&frame| planted[frame - 1] && planted[frame])
        .map(|frame| (toe[frame] - toe[frame - 1]).norm() / generated.clip.frame_time())
        .collect()
}

#[test]
fn feet_are_flat_throughout_actions_in_place() {
    for name in ["standing-still", "sit-and-stand", "deep-squats"] {
        let (positions, generated) = case(name);
        for (side, part) in Side::BOTH.into_iter().flat_map(|side| Part::ALL.map(|part| (side, part))) {
            assert!(labels(&generated, side, part).iter().all(|&planted| planted), "{name}");
        }
        let heights = positions.track(Bone::Hips).iter().map(|hips| hips.y);
        let range = heights.clone().fold(0.0, f64::max) - heights.fold(f64::INFINITY, f64::min);
        assert_eq!(range > 0.3, name != "standing-still", "{name}: {range:.2} m");
    }
}

#[test]
fn dragged_foot_stays_on_the_ground_and_always_moves() {
    let (positions, generated) = case("one-foot-dragged");
    let ball = hard_cases(0.0)[1].character.proportions.ball;
    for pair in positions.track(Bone::Toe(Side::Right)).windows(2) {
        let speed = (pair[1] - pair[0]).norm() / generated.clip.frame_time();
        assert!(speed > 0.05 && (pair[0].y - ball).abs() < 0.01, "{speed:.2} m/s, {:.3} m", pair[0].y);
    }
}

#[test]
fn planted_feet_move_with_belt_and_platform() {
    let treadmill = case("treadmill");
    assert!(
        Side::BOTH
            .iter()
            .all(|&side| { planted_speeds(&treadmill, side).iter().all(|speed| (speed - 1.2).abs() < 0.1) })
    );
    let start = treadmill.0.track(Bone::Hips)[0].z;
    let far = treadmill.0.track(Bone::Hips).iter().map(|hips| (hips.z - start).abs()).fold(0.0, f64::max);
    assert!(far < 0.6, "the walker moves {far:.2} m from the start");

    let speeds = planted_speeds(&case("moving-platform"), Side::Left);
    assert!(speeds.iter().all(|&speed| speed < 0.42));
    assert!(speeds.iter().filter(|&&speed| speed > 0.2).count() > 100);
}

#[test]
fn planted_feet_are_on_the_slope_and_on_the_stairs() {
    for (name, degrees) in [("slope-2", 2.0_f64), ("slope-5", 5.0)] {
        let (positions, generated) = case(name);
        let toe = positions.track(Bone::Toe(Side::Left));
        let planted = labels(&generated, Side::Left, Part::Toe);
        let (sin, cos) = degrees.to_radians().sin_cos();
        let above = (0..planted.len()).filter(|&n| planted[n]).map(|n| cos * toe[n].y - sin * toe[n].z);
        let (least, most) = above.fold((f64::INFINITY, 0.0_f64), |(a, b), y| (a.min(y), b.max(y)));
        assert!(most - least < 0.01, "{name}: {least:.3} to {most:.3} m");
    }
    let (positions, generated) = case("stairs");
    let ball = hard_cases(0.0).iter().find(|spec| spec.name == "stairs").unwrap().character.proportions.ball;
    for side in Side::BOTH {
        let planted = labels(&generated, side, Part::Toe);
        for frame in (0..planted.len()).filter(|&frame| planted[frame]) {
            let stair = (positions.track(Bone::Toe(side))[frame].y - ball) / 0.17;
            assert!((stair - stair.round()).abs() < 0.05, "frame {frame} is on stair {stair:.2}");
        }
    }
}

#[test]
fn teleport_jumps_once_and_ringing_lasts_two_frames() {
    let jumps = |positions: &Positions, least: f64| -> Vec<usize> {
        let hips = positions.track(Bone::Hips);
        (1..hips.len()).filter(|&frame| (hips[frame] - hips[frame - 1]).norm() > least).collect()
    };
    assert_eq!(jumps(&case("teleport").0, 0.5), [300]);
    let (ringing, generated) = case("t-pose-and-ringing");
    assert_eq!(jumps(&ringing, 0.1), [1, 2, 3]);
    let toe = ringing.track(Bone::Toe(Side::Right));
    assert!((0..toe.len()).all(|frame| frame == 1 || toe[frame].y > toe[1].y));
    for side in Side::BOTH {
        let contact = labels(&generated, side, Part::Contact);
        assert_eq!(contact[0], contact[1]);
    }
}

#[test]
fn sprint_has_short_contacts_without_heels() {
    let (_, generated) = case("sprint-120");
    for side in Side::BOTH {
        assert!(labels(&generated, side, Part::Heel).iter().all(|&planted| !planted));
        let plants = generated.truth.foot(side).contact.as_deref().unwrap();
        let inside = plants
            .iter()
            .filter(|plant| plant.frames.start > 0 && plant.frames.end < generated.truth.header.frames);
        let lengths: Vec<f64> = inside.map(|plant| plant.frames.end_s - plant.frames.start_s).collect();
        assert!(lengths.len() > 4 && lengths.iter().all(|length| (0.08..0.13).contains(length)));
    }
}
