//! Gait measures of generated clips against the plans that they realise.

use plantigrade::foot::{Part, Side};
use plantigrade::gait::{Gait, PerSide, Spread};
use plantigrade::plants::{self, Feet, Params};
use plantigrade::skeleton::{Overrides, Skeleton};
use plantigrade_synth::maths::{Vec3, forward, leftward};
use plantigrade_synth::plan::{Plan, Stance, stances};
use plantigrade_synth::{Recipe, full_set, generate};

fn recipe(name: &str) -> Recipe {
    full_set(1.0).into_iter().find(|recipe| recipe.name == name).expect(name)
}

/// The measures by the truth's labels, and by those that are detected.
fn measured(name: &str) -> [Gait; 2] {
    let generated = generate(&recipe(name), 0);
    let overrides = Overrides::default();
    let feet = Feet::new(&generated.clip, &Skeleton::main(&generated.clip, &overrides)).expect("feet");
    let truth = Side::BOTH.map(|side| generated.truth.labels(side, Part::Contact).expect("contact"));
    let by_truth = Gait::measure(&feet, truth.each_ref().map(Vec::as_slice));
    let detection = plants::detect(&feet, Params::default().check().expect("defaults"));
    [by_truth, Gait::from_detection(&feet, &detection)]
}

/// What the plan of a walk says, from all strides whose strikes are within the clip.
#[derive(Debug, Default)]
struct Planned {
    stance: [Vec<f64>; 2],
    swing: [Vec<f64>; 2],
    stride: Vec<f64>,
    double_support: Vec<f64>,
    step_length: [Vec<f64>; 2],
    step_width: [Vec<f64>; 2],
}

/// Reads the plan of a walk, whose way leads to `ahead` at a place between two feet that point to
/// a mean heading.
fn planned(name: &str, ahead: impl Fn(Vec3, f64) -> f64) -> Planned {
    let recipe = recipe(name);
    let plan: Plan = recipe.plan(0);
    let build = &recipe.character.build;
    // The plan places the ball of the foot; the ankle is behind it.
    let ankle = |stance: &Stance| stance.place.moved(-build.instep, 0.0).point();
    let feet = plan.feet.each_ref().map(stances);
    let within = |time: f64| time > 0.0 && time < recipe.seconds();
    let down = |side: usize, time: f64| feet[side].iter().any(|s| (s.strike..s.off).contains(&time));
    let mut found = Planned::default();
    for side in 0..2 {
        for pair in feet[side].windows(2).filter(|pair| within(pair[0].strike) && within(pair[1].strike)) {
            let (from, to) = (pair[0].strike, pair[1].strike);
            found.stance[side].push(pair[0].off - from);
            found.swing[side].push(to - pair[0].off);
            found.stride.push(to - from);
            let times = (0..).map(|n| from + f64::from(n) * 1e-4).take_while(|&time| time < to);
            let both = times.filter(|&time| down(0, time) && down(1, time)).count();
            found.double_support.push(both as f64 * 1e-4 / (to - from));
        }
        for to in feet[side].iter().filter(|stance| within(stance.strike)) {
            // A step is measured where the footfalls before and after it are seen.
            let Some(from) = feet[1 - side].iter().rev().find(|from| from.strike < to.strike) else {
                continue;
            };
            let earlier = feet[side].iter().rev().find(|before| before.strike < from.strike);
            let later = feet[1 - side].iter().find(|after| after.strike > to.strike);
            if !(earlier.is_some_and(|before| before.off > 0.0)
                && later.is_some_and(|after| within(after.strike)))
            {
                continue;
            }
            let step = ankle(to) - ankle(from);
            let heading = (to.place.heading + from.place.heading) / 2.0;
            let way = ahead((ankle(to) + ankle(from)) / 2.0, heading);
            found.step_length[side].push(step.dot(&forward(way)));
            let outward = if side == 0 { 1.0 } else { -1.0 };
            found.step_width[side].push(outward * step.dot(&leftward(way)));
        }
    }
    found
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

fn near(what: &str, found: Option<f64>, expected: f64, within: f64) {
    println!("{what}: {found:.4?}, planned {expected:.4}");
    assert!(
        found.is_some_and(|found| (found - expected).abs() <= within),
        "{what}: {found:?}, not {expected}"
    );
}

fn sides(what: &str, found: PerSide, expected: &[Vec<f64>; 2], within: f64) {
    for (side, found) in [found.left, found.right].into_iter().enumerate() {
        let what = format!("{what} {}", Side::BOTH[side].name());
        near(&what, found.map(|spread| spread.mean), mean(&expected[side]), within);
    }
}

/// Tolerances: steps per minute, seconds, metres and shares of a stride.
struct Within {
    cadence: f64,
    time: f64,
    length: f64,
    share: f64,
}

fn compare(gait: &Gait, plan: &Planned, within: &Within) {
    near("cadence", gait.cadence_steps_per_min, 120.0 / mean(&plan.stride), within.cadence);
    sides("stance", gait.stance_s, &plan.stance, within.time);
    sides("swing", gait.swing_s, &plan.swing, within.time);
    sides("step length", gait.step_length_m, &plan.step_length, within.length);
    sides("step width", gait.step_width_m, &plan.step_width, within.length);
    let share = gait.double_support_share.map(|spread| spread.mean);
    near("double support", share, mean(&plan.double_support), within.share);
}

/// Truth labels are the plan's to the frame; recorded feet keep still to some millimetres.
const BY_TRUTH: Within = Within { cadence: 0.5, time: 0.01, length: 0.01, share: 0.01 };

/// The detector's contact begins and ends some 40 ms outside of the plan's.
const DETECTED: Within = Within { cadence: 1.0, time: 0.1, length: 0.01, share: 0.16 };

#[test]
fn a_straight_walk_is_measured_as_planned() {
    // Both feet's toes point out alike, so that between them is the way.
    let plan = planned("straight-walk", |_, heading| heading);
    let [by_truth, detected] = measured("straight-walk");
    compare(&by_truth, &plan, &BY_TRUTH);
    compare(&detected, &plan, &DETECTED);
}

#[test]
fn a_curved_walk_is_measured_along_its_curve() {
    // The middle of the curve is 2.4 m to the left of where the way begins.
    let plan = planned("curved-walk", |place, _| libm::atan2(place.z, 2.4 - place.x));
    let [by_truth, detected] = measured("curved-walk");
    compare(&by_truth, &plan, &BY_TRUTH);
    compare(&detected, &plan, &DETECTED);
}

#[test]
fn a_limp_shows_on_its_side() {
    for gait in measured("limp-to-run") {
        println!("{:.1?}", gait.symmetry);
        // The bad left leg bears weight for less, and swings for longer.
        assert!(gait.symmetry.stance_percent.is_some_and(|percent| percent > 5.0));
        assert!(gait.symmetry.swing_percent.is_some_and(|percent| percent < -5.0));
        // The good one hurries through: its steps are shorter in time and length.
        assert!(gait.symmetry.step_time_percent.is_some_and(|percent| percent < -5.0));
        assert!(gait.symmetry.step_length_percent.is_some_and(|percent| percent < -5.0));
    }
}

#[test]
fn a_jog_has_flight() {
    let share = |spread: Option<Spread>| spread.map_or(0.0, |spread| spread.mean);
    for (gait, least) in measured("straight-jog").into_iter().zip([0.2, 0.05]) {
        let (flight, double) = (share(gait.flight_share), share(gait.double_support_share));
        println!("flight {flight:.3}, double support {double:.3}, {:.1?}", gait.cadence_steps_per_min);
        // It is walked into and out of.
        assert!(flight > least && double < 0.06, "{gait:?}");
        assert!(gait.speed_m_per_s.is_some_and(|speed| speed > 2.0));
    }
}

#[test]
fn jumps_and_stands_are_no_gait() {
    for name in ["frog-jumps", "one-leg-hop", "boxing", "kick", "jumping-jacks"] {
        for gait in measured(name) {
            println!("{name}: {} strides", gait.strides);
            assert!(gait.strides <= 2, "{name}: {gait:?}");
        }
    }
}
