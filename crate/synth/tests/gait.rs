//! Gait measures of generated clips, compared with their plans.

use plantigrade::bvh::Clip;
use plantigrade::foot::{Part, Side};
use plantigrade::gait::{CYCLE_POINTS, Contact, Curve, Gait, GaitAnalysis, Legs, PerSide, Spread};
use plantigrade::kinematics::Kinematics;
use plantigrade::plants::{self, Edge, Feet, Params};
use plantigrade::skeleton::{LegRoles, Overrides, Skeleton};
use plantigrade_synth::foot_path::FootPath;
use plantigrade_synth::math::{Vec3, forward, leftward};
use plantigrade_synth::plan::{Plan, Stance, stances};
use plantigrade_synth::{ClipSpec, full_set, generate};

fn spec(name: &str) -> ClipSpec {
    full_set(1.0).into_iter().find(|spec| spec.name == name).expect(name)
}

/// Returns the measures from truth labels and from detected labels.
fn measured(name: &str) -> [Gait; 2] {
    let generated = generate(&spec(name), 0);
    let overrides = Overrides::default();
    let feet = Feet::new(&generated.clip, &Skeleton::main(&generated.clip, &overrides)).expect("feet");
    let truth = Side::BOTH.map(|side| generated.truth.labels(side, Part::Contact).expect("contact"));
    let by_truth = Gait::measure(&feet, truth.each_ref().map(Vec::as_slice));
    let detection = plants::detect(&feet, Params::default().check().expect("defaults"));
    [by_truth, Gait::from_detection(&feet, &detection)]
}

/// Gait measures of a plan, from all strides whose strikes are within the clip.
#[derive(Debug, Default)]
struct Planned {
    stance: [Vec<f64>; 2],
    swing: [Vec<f64>; 2],
    stride: Vec<f64>,
    double_support: Vec<f64>,
    step_length: [Vec<f64>; 2],
    step_width: [Vec<f64>; 2],
}

/// Measures the plan of a walk. `direction_at` returns the direction of travel, in radians, from
/// the position between two feet and their mean heading.
fn planned(name: &str, direction_at: impl Fn(Vec3, f64) -> f64) -> Planned {
    let spec = spec(name);
    let plan: Plan = spec.plan(0);
    let proportions = &spec.character.proportions;
    // The plan places the ball of the foot; the ankle is behind it.
    let ankle = |stance: &Stance| stance.placement.translated(-proportions.instep, 0.0).point();
    let feet = plan.feet.each_ref().map(stances);
    let within = |time: f64| time > 0.0 && time < spec.seconds();
    let down = |side: usize, time: f64| feet[side].iter().any(|s| (s.strike..s.toe_off).contains(&time));
    let mut result = Planned::default();
    for side in 0..2 {
        for pair in feet[side].windows(2).filter(|pair| within(pair[0].strike) && within(pair[1].strike)) {
            let (from, to) = (pair[0].strike, pair[1].strike);
            result.stance[side].push(pair[0].toe_off - from);
            result.swing[side].push(to - pair[0].toe_off);
            result.stride.push(to - from);
            let times = (0..).map(|n| from + f64::from(n) * 1e-4).take_while(|&time| time < to);
            let both = times.filter(|&time| down(0, time) && down(1, time)).count();
            result.double_support.push(both as f64 * 1e-4 / (to - from));
        }
        for to in feet[side].iter().filter(|stance| within(stance.strike)) {
            // A step is measured if the footfalls before and after it are within the clip.
            let Some(from) = feet[1 - side].iter().rev().find(|from| from.strike < to.strike) else {
                continue;
            };
            let earlier = feet[side].iter().rev().find(|before| before.strike < from.strike);
            let later = feet[1 - side].iter().find(|after| after.strike > to.strike);
            if !(earlier.is_some_and(|before| before.toe_off > 0.0)
                && later.is_some_and(|after| within(after.strike)))
            {
                continue;
            }
            let step = ankle(to) - ankle(from);
            let heading = (to.placement.heading + from.placement.heading) / 2.0;
            let direction = direction_at((ankle(to) + ankle(from)) / 2.0, heading);
            result.step_length[side].push(step.dot(&forward(direction)));
            let lateral_sign = if side == 0 { 1.0 } else { -1.0 };
            result.step_width[side].push(lateral_sign * step.dot(&leftward(direction)));
        }
    }
    result
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

fn assert_near(what: &str, result: Option<f64>, expected: f64, within: f64) {
    println!("{what}: {result:.4?}, planned {expected:.4}");
    assert!(
        result.is_some_and(|result| (result - expected).abs() <= within),
        "{what}: {result:?} instead of {expected}"
    );
}

fn assert_sides_near(what: &str, result: PerSide, expected: &[Vec<f64>; 2], within: f64) {
    for (side, result) in [result.left, result.right].into_iter().enumerate() {
        let what = format!("{what} {}", Side::BOTH[side].name());
        assert_near(&what, result.map(|spread| spread.mean), mean(&expected[side]), within);
    }
}

/// Tolerances, in steps per minute, seconds, metres and fractions of a stride.
struct Tolerances {
    cadence: f64,
    time: f64,
    length: f64,
    fraction: f64,
}

fn compare(gait: &Gait, plan: &Planned, within: &Tolerances) {
    assert_near("cadence", gait.cadence_steps_per_min, 120.0 / mean(&plan.stride), within.cadence);
    assert_sides_near("stance", gait.stance_s, &plan.stance, within.time);
    assert_sides_near("swing", gait.swing_s, &plan.swing, within.time);
    assert_sides_near("step length", gait.step_length_m, &plan.step_length, within.length);
    assert_sides_near("step width", gait.step_width_m, &plan.step_width, within.length);
    let fraction = gait.double_support_share.map(|spread| spread.mean);
    assert_near("double support", fraction, mean(&plan.double_support), within.fraction);
}

/// Truth labels are exact to the frame; recorded feet are still within millimetres.
const TRUTH_TOLERANCES: Tolerances = Tolerances { cadence: 0.5, time: 0.01, length: 0.01, fraction: 0.01 };

const DETECTION_TOLERANCES: Tolerances =
    Tolerances { cadence: 1.0, time: 0.03, length: 0.01, fraction: 0.04 };

#[test]
fn straight_walk_measures_match_the_plan() {
    // Both feet are turned out equally, so their mean heading is the direction of travel.
    let plan = planned("straight-walk", |_, heading| heading);
    let [by_truth, detected] = measured("straight-walk");
    compare(&by_truth, &plan, &TRUTH_TOLERANCES);
    compare(&detected, &plan, &DETECTION_TOLERANCES);
}

#[test]
fn curved_walk_measures_match_the_plan() {
    // The centre of the curve is 2.4 m to the left of the origin.
    let plan = planned("curved-walk", |placement, _| libm::atan2(placement.z, 2.4 - placement.x));
    let [by_truth, detected] = measured("curved-walk");
    compare(&by_truth, &plan, &TRUTH_TOLERANCES);
    // The clip has two complete strides, so errors of 10 ms at each foot strike change the cadence by 1.4. The
    // last strike is 40 ms before the end, where the detection has no cues for the instant.
    compare(&detected, &plan, &Tolerances { cadence: 2.0, ..DETECTION_TOLERANCES });
}

#[test]
fn limp_is_asymmetric_on_the_correct_side() {
    for gait in measured("limp-to-run") {
        println!("{:.1?}", gait.symmetry);
        // The impaired left leg has shorter stances and longer swings.
        assert!(gait.symmetry.stance_percent.is_some_and(|percent| percent > 5.0));
        assert!(gait.symmetry.swing_percent.is_some_and(|percent| percent < -5.0));
        // The steps of the other leg are shorter in time and length.
        assert!(gait.symmetry.step_time_percent.is_some_and(|percent| percent < -5.0));
        assert!(gait.symmetry.step_length_percent.is_some_and(|percent| percent < -5.0));
    }
}

#[test]
fn jog_has_flight_and_little_double_support() {
    let fraction = |spread: Option<Spread>| spread.map_or(0.0, |spread| spread.mean);
    for (gait, least) in measured("straight-jog").into_iter().zip([0.2, 0.05]) {
        let (flight, double) = (fraction(gait.flight_share), fraction(gait.double_support_share));
        println!("flight {flight:.3}, double support {double:.3}, {:.1?}", gait.cadence_steps_per_min);
        // The clip begins and ends with walking.
        assert!(flight > least && double < 0.06, "{gait:?}");
        assert!(gait.speed_m_per_s.is_some_and(|speed| speed > 2.0));
    }
}

#[test]
fn jumps_and_stands_have_at_most_two_strides() {
    for name in ["frog-jumps", "one-leg-hop", "boxing", "kick", "jumping-jacks"] {
        for gait in measured(name) {
            println!("{name}: {} strides", gait.strides);
            assert!(gait.strides <= 2, "{name}: {gait:?}");
        }
    }
}

/// Returns the analyses of a clip from the exact instants of its plan and from its detection.
fn analysed(spec: &ClipSpec) -> (Clip, [GaitAnalysis; 2]) {
    let generated = generate(spec, 0);
    let skeleton = Skeleton::main(&generated.clip, &Overrides::default());
    let feet = Feet::new(&generated.clip, &skeleton).expect("feet");
    let legs = Legs::new(&generated.clip, &skeleton).expect("legs");
    let planted = Side::BOTH.map(|side| generated.truth.labels(side, Part::Contact).expect("contact"));
    let plan = spec.plan(0);
    let edges = plan.feet.each_ref().map(|foot| {
        let instants = stances(foot).into_iter().flat_map(|stance| [stance.strike, stance.toe_off]);
        let within = instants.filter(|time| *time > 0.0 && *time < spec.seconds());
        let edge = |time: f64| Edge {
            frame: (time * spec.rate as f64).ceil() as usize,
            time,
            uncertainty: f64::EPSILON,
        };
        within.map(edge).collect::<Vec<_>>()
    });
    let contacts = [0, 1].map(|index| Contact { planted: &planted[index], edges: &edges[index] });
    let by_truth = GaitAnalysis::new(&feet, Some(&legs), contacts, None);
    let detection = plants::detect(&feet, Params::default().check().expect("defaults"));
    let detected = GaitAnalysis::from_detection(&feet, Some(&legs), &detection, None);
    (generated.clip, [by_truth, detected])
}

/// Returns hip, knee and ankle per frame of one leg, in degrees: from the rotations of the joints and the
/// pitch of the foot in the plan, for a person who walks along Z with Y up.
fn exact_angles(clip: &Clip, spec: &ClipSpec, side: Side) -> Vec<[f64; 3]> {
    let skeleton = Skeleton::main(clip, &Overrides::default());
    let roles = LegRoles::for_side(side);
    let [thigh, shank, ankle] =
        [roles.thigh, roles.shank, roles.ankle].map(|role| skeleton.roles.get(role).expect("leg"));
    let bone = |joint: usize| clip.joints()[joint].offset.normalize();
    let plan = spec.plan(0);
    let path = FootPath::new(side, &plan.feet[side as usize], &spec.character.proportions);
    let mut kinematics = Kinematics::new(clip);
    let pitch_from_vertical = |line: Vec3| f64::atan2(line.z, -line.y).to_degrees();
    (0..clip.frame_count())
        .map(|frame| {
            kinematics.pose(frame);
            let [thigh, shank_rotation] = [thigh, shank].map(|joint| kinematics.rotations()[joint]);
            let hip = pitch_from_vertical(thigh * bone(shank));
            let trace = (thigh.transpose() * shank_rotation).trace();
            let knee = ((trace - 1.0) / 2.0).clamp(-1.0, 1.0).acos().to_degrees();
            let shank = pitch_from_vertical(shank_rotation * bone(ankle));
            // The pitch of a foot is positive with the heel raised.
            let toes_up = -path.at(frame as f64 / spec.rate as f64).pitch.to_degrees();
            [hip, knee, toes_up - shank]
        })
        .collect()
}

/// Differences between curves and exact angles over the gait cycle, in degrees.
#[derive(Debug)]
struct AngleErrors {
    /// The largest ones, of hip, knee and ankle.
    largest: [f64; 3],
    /// Root mean squares of hip, knee and ankle.
    rms: [f64; 3],
}

fn angle_errors(clip: &Clip, spec: &ClipSpec, analysis: &GaitAnalysis) -> AngleErrors {
    let curves = analysis.curves.as_ref().expect("curves");
    let plan = spec.plan(0);
    let mut errors: [Vec<f64>; 3] = Default::default();
    for side in Side::BOTH {
        let exact = exact_angles(clip, spec, side);
        let strikes: Vec<f64> = stances(&plan.feet[side as usize])
            .iter()
            .map(|stance| stance.strike)
            .filter(|&strike| strike > 0.0 && strike < spec.seconds())
            .collect();
        for (joint, (name, sides)) in curves.by_joint().into_iter().enumerate() {
            let curve: &Option<Curve> = if side == Side::Left { &sides.left } else { &sides.right };
            let curve = curve.as_ref().expect("strides");
            assert_eq!(curve.strides, strikes.len() - 1, "{name}");
            for percent in 0..CYCLE_POINTS {
                let at = |pair: &[f64]| {
                    let time = pair[0] + (pair[1] - pair[0]) * percent as f64 / 100.0;
                    let frame = (time * spec.rate as f64).min(exact.len() as f64 - 1.001);
                    let (before, fraction) = (frame as usize, frame.fract());
                    exact[before][joint] * (1.0 - fraction) + exact[before + 1][joint] * fraction
                };
                let expected = mean(&strikes.windows(2).map(at).collect::<Vec<_>>());
                errors[joint].push((curve.mean[percent] - expected).abs());
            }
        }
    }
    AngleErrors {
        largest: errors.each_ref().map(|errors| errors.iter().copied().fold(0.0, f64::max)),
        rms: errors.map(|errors| mean(&errors.iter().map(|error| error * error).collect::<Vec<_>>()).sqrt()),
    }
}

#[test]
fn joint_angles_match_the_plan() {
    for name in ["straight-walk", "brisk-walk"] {
        let exact = ClipSpec { noise_level: 0.0, ..spec(name) };
        let (clip, [by_truth, detected]) = analysed(&exact);
        let errors = [by_truth, detected].map(|analysis| angle_errors(&clip, &exact, &analysis));
        println!("{name}: hip, knee, ankle in degrees: {:.2?}, detected {:.2?}", errors[0], errors[1]);
        let [by_truth, detected] = &errors;
        assert!(by_truth.largest.iter().all(|error| *error <= 1.0), "{name}: {errors:?}");
        assert!(detected.rms.iter().all(|error| *error <= 1.0), "{name}: {errors:?}");
    }
}

#[test]
fn walks_are_measured_within_half_a_percent_ten_milliseconds_and_a_centimetre() {
    let straight = |_: Vec3, heading: f64| heading;
    let around = |position: Vec3, _: f64| libm::atan2(position.z, 2.4 - position.x);
    for (name, plan) in [
        ("straight-walk", planned("straight-walk", straight)),
        ("brisk-walk", planned("brisk-walk", straight)),
        ("curved-walk", planned("curved-walk", around)),
    ] {
        let (_, analyses) = analysed(&spec(name));
        for (source, GaitAnalysis { gait, .. }) in ["truth", "detection"].into_iter().zip(&analyses) {
            let cadence = 120.0 / mean(&plan.stride);
            let cadence_error = (gait.cadence_steps_per_min.expect("strides") / cadence - 1.0).abs();
            let error = |measure: PerSide, expected: &[Vec<f64>; 2]| {
                let means = [measure.left, measure.right].map(|spread| spread.expect("steps").mean);
                (0..2).map(|side| (means[side] - mean(&expected[side])).abs()).fold(0.0, f64::max)
            };
            let times = error(gait.stance_s, &plan.stance).max(error(gait.swing_s, &plan.swing));
            let lengths =
                error(gait.step_length_m, &plan.step_length).max(error(gait.step_width_m, &plan.step_width));
            println!(
                "{name}, {source}: cadence {:.2} %, times {:.1} ms, lengths {:.1} mm",
                100.0 * cadence_error,
                1e3 * times,
                1e3 * lengths
            );
            // The curved walk has two complete strides, so that each of its events counts.
            if source == "truth" || name != "curved-walk" {
                assert!(cadence_error <= 0.005 && times <= 0.010 && lengths <= 0.010, "{name}: {gait:?}");
            }
        }
    }
}
