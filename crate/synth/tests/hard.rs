//! The hard cases: each is what it says, and its truth keeps its ground rule.

mod kinematics;

use kinematics::{Positions, positions};
use plantigrade::foot::{Part, Side};
use plantigrade_synth::character::Bone;
use plantigrade_synth::{Generated, generate, hard_cases};

fn case(name: &str) -> (Positions, Generated) {
    let recipe = hard_cases(0.0).into_iter().find(|recipe| recipe.name == name).expect("a hard case");
    let generated = generate(&recipe, 0);
    (positions(&generated.clip, &recipe.character), generated)
}

fn labels(generated: &Generated, side: Side, part: Part) -> Vec<bool> {
    generated.truth.labels(side, part).unwrap()
}

/// Speeds of the toe in frames that are planted like the one before, in m/s.
fn planted_speeds((positions, generated): &(Positions, Generated), side: Side) -> Vec<f64> {
    let toe = positions.of(Bone::Toe(side));
    let planted = labels(generated, side, Part::Toe);
    (1..planted.len())
        .filter(|&frame| planted[frame - 1] && planted[frame])
        .map(|frame| (toe[frame] - toe[frame - 1]).norm() / generated.clip.frame_time())
        .collect()
}

#[test]
fn feet_of_those_who_stay_where_they_are_are_flat_throughout() {
    for name in ["standing-still", "sit-and-stand", "deep-squats"] {
        let (positions, generated) = case(name);
        for (side, part) in Side::BOTH.into_iter().flat_map(|side| Part::ALL.map(|part| (side, part))) {
            assert!(labels(&generated, side, part).iter().all(|&planted| planted), "{name}");
        }
        let heights = positions.of(Bone::Hips).iter().map(|hips| hips.y);
        let range = heights.clone().fold(0.0, f64::max) - heights.fold(f64::INFINITY, f64::min);
        assert_eq!(range > 0.3, name != "standing-still", "{name}: {range:.2} m");
    }
}

#[test]
fn a_dragged_foot_is_on_the_ground_and_never_still() {
    let (positions, generated) = case("one-foot-dragged");
    let ball = hard_cases(0.0)[1].character.build.ball;
    for pair in positions.of(Bone::Toe(Side::Right)).windows(2) {
        let speed = (pair[1] - pair[0]).norm() / generated.clip.frame_time();
        assert!(speed > 0.05 && (pair[0].y - ball).abs() < 0.01, "{speed:.2} m/s, {:.3} m", pair[0].y);
    }
}

#[test]
fn the_belt_and_the_platform_carry_planted_feet() {
    let treadmill = case("treadmill");
    assert!(
        Side::BOTH
            .iter()
            .all(|&side| { planted_speeds(&treadmill, side).iter().all(|speed| (speed - 1.2).abs() < 0.1) })
    );
    let start = treadmill.0.of(Bone::Hips)[0].z;
    let far = treadmill.0.of(Bone::Hips).iter().map(|hips| (hips.z - start).abs()).fold(0.0, f64::max);
    assert!(far < 0.6, "the walker strays {far:.2} m");

    let speeds = planted_speeds(&case("moving-platform"), Side::Left);
    assert!(speeds.iter().all(|&speed| speed < 0.42));
    assert!(speeds.iter().filter(|&&speed| speed > 0.2).count() > 100);
}

#[test]
fn planted_feet_stand_on_the_slope_and_on_the_stairs() {
    for (name, degrees) in [("slope-2", 2.0_f64), ("slope-5", 5.0)] {
        let (positions, generated) = case(name);
        let toe = positions.of(Bone::Toe(Side::Left));
        let planted = labels(&generated, Side::Left, Part::Toe);
        let (sin, cos) = degrees.to_radians().sin_cos();
        let above = (0..planted.len()).filter(|&n| planted[n]).map(|n| cos * toe[n].y - sin * toe[n].z);
        let (least, most) = above.fold((f64::INFINITY, 0.0_f64), |(a, b), y| (a.min(y), b.max(y)));
        assert!(most - least < 0.01, "{name}: {least:.3} to {most:.3} m");
    }
    let (positions, generated) = case("stairs");
    let ball = hard_cases(0.0).iter().find(|recipe| recipe.name == "stairs").unwrap().character.build.ball;
    for side in Side::BOTH {
        let planted = labels(&generated, side, Part::Toe);
        for frame in (0..planted.len()).filter(|&frame| planted[frame]) {
            let stair = (positions.of(Bone::Toe(side))[frame].y - ball) / 0.17;
            assert!((stair - stair.round()).abs() < 0.05, "frame {frame} stands on stair {stair:.2}");
        }
    }
}

#[test]
fn a_teleport_takes_one_frame_and_ringing_two() {
    let hops = |positions: &Positions, least: f64| -> Vec<usize> {
        let hips = positions.of(Bone::Hips);
        (1..hips.len()).filter(|&frame| (hips[frame] - hips[frame - 1]).norm() > least).collect()
    };
    assert_eq!(hops(&case("teleport").0, 0.5), [300]);
    let (ringing, generated) = case("t-pose-and-ringing");
    assert_eq!(hops(&ringing, 0.1), [1, 2, 3]);
    let toe = ringing.of(Bone::Toe(Side::Right));
    assert!((0..toe.len()).all(|frame| frame == 1 || toe[frame].y > toe[1].y));
    for side in Side::BOTH {
        let contact = labels(&generated, side, Part::Contact);
        assert_eq!(contact[0], contact[1]);
    }
}

#[test]
fn a_sprint_has_short_contacts_and_no_heel() {
    let (_, generated) = case("sprint-120");
    for side in Side::BOTH {
        assert!(labels(&generated, side, Part::Heel).iter().all(|&planted| !planted));
        let spans = generated.truth.foot(side).contact.as_deref().unwrap();
        let inside = spans.iter().filter(|span| span.start > 0 && span.end < generated.truth.frames);
        let lengths: Vec<f64> = inside.map(|span| span.end_s - span.start_s).collect();
        assert!(lengths.len() > 4 && lengths.iter().all(|length| (0.08..0.13).contains(length)));
    }
}
