//! Clean-up of foot skate: on generated clips, where the true places are known, and on recorded ones.

mod support;

use nalgebra::Vector3;
use plantigrade::bvh::Clip;
use plantigrade::foot::Side;
use plantigrade::kinematics::{self, Track};
use plantigrade::notice::Code;
use plantigrade::plants::{self, Feet, ValidParams};
use plantigrade::skate::{self, Cleaned, CleanedPlant, Contacts, Options, SkipReason};
use plantigrade::skeleton::{LegRoles, Overrides, Skeleton};
use plantigrade_synth::noise::Noise;
use plantigrade_synth::{ClipSpec, Generated, full_set, generate, hard_cases};

/// Seconds around a moment in which the original may be as rough.
const AROUND: f64 = 0.1;

/// Greatest share of `found` in what the original has: its most within [`AROUND`], or its 99th percentile.
fn excess(found: &[f64], original: &[f64], half: usize) -> (f64, usize) {
    let mut sorted = original.to_vec();
    sorted.sort_by(f64::total_cmp);
    let Some(last) = sorted.len().checked_sub(1) else { return (0.0, 0) };
    let high = sorted[last * 99 / 100];
    let share = |frame: usize| {
        let window = frame.saturating_sub(half)..(frame + half + 1).min(original.len());
        found[frame] / original[window].iter().copied().fold(high, f64::max).max(1e-9)
    };
    (0..found.len()).map(|frame| (share(frame), frame)).fold((0.0, 0), |a, b| if b.0 > a.0 { b } else { a })
}

/// Sizes of second differences.
fn accelerations(track: &Track) -> Vec<f64> {
    track.windows(3).map(|w| (w[0] - 2.0 * w[1] + w[2]).norm()).collect()
}

/// Sizes of the changes of the knee's angle.
fn knee_rates(clip: &Clip, skeleton: &Skeleton, side: Side) -> Vec<f64> {
    let roles = LegRoles::of(side);
    let joints = [roles.thigh, roles.shank, roles.ankle].map(|role| skeleton.roles.get(role).expect("a leg"));
    let [hip, knee, ankle] = <[Track; 3]>::try_from(kinematics::tracks(clip, &joints)).expect("three");
    let bend = |n: usize| (knee[n] - hip[n]).angle(&(ankle[n] - knee[n]));
    (1..hip.len()).map(|n| (bend(n) - bend(n - 1)).abs()).collect()
}

/// What clean-up did to the smoothness: shares of accelerations and of knee rates.
fn roughness(before: &Clip, after: &Clip, skeleton: &Skeleton) -> (f64, f64, String) {
    let half = (AROUND / before.frame_time()).round() as usize;
    let joints: Vec<usize> = (0..before.joints().len()).collect();
    let [from, to] = [before, after].map(|clip| kinematics::tracks(clip, &joints));
    let mut worst = (0.0, String::new());
    for joint in joints {
        let (share, frame) = excess(&accelerations(&to[joint]), &accelerations(&from[joint]), half);
        if share > worst.0 {
            worst = (share, format!("{}@{}", before.joints()[joint].name, frame + 1));
        }
    }
    let knees = Side::BOTH
        .map(|side| excess(&knee_rates(after, skeleton, side), &knee_rates(before, skeleton, side), half).0);
    (worst.0, knees[0].max(knees[1]), worst.1)
}

/// Generated motion with that noise, and the same motion without.
fn pair(recipe: &ClipSpec, noise: Noise) -> [Generated; 2] {
    let mut recipe = ClipSpec { noise_level: 1.0, ..recipe.clone() };
    recipe.character.noise = noise;
    let clean = ClipSpec { noise_level: 0.0, ..recipe.clone() };
    let pair = [generate(&recipe, 0), generate(&clean, 0)];
    assert_eq!(pair[0].truth, pair[1].truth, "noise changes no step");
    pair
}

/// The part of a foot that is down in each frame: the toe, or the ankle while heel and toe both are.
fn parts(skeleton: &Skeleton, contacts: &Contacts, side: Side) -> [(usize, Vec<bool>); 2] {
    let foot = contacts.foot(side);
    let (heel, toe) = (foot.heel.clone().expect("truth"), foot.toe.clone().expect("truth"));
    let both = heel.iter().zip(&toe).map(|(heel, toe)| *heel && *toe).collect();
    [(skeleton.toe(side).expect("a toe"), toe), (skeleton.heel(side).expect("an ankle"), both)]
}

/// For each plant and part: how far its joint gets from its mean position (measured here by other
/// means than in the library), and its mean distance from where it truly is, in metres.
fn stands(cleaned: &Cleaned, truth: &Clip, skeleton: &Skeleton, contacts: &Contacts) -> (Vec<f64>, Vec<f64>) {
    let (mut slides, mut errors) = (Vec::new(), Vec::new());
    for plant in &cleaned.plants {
        for (joint, down) in parts(skeleton, contacts, plant.side) {
            for run in plantigrade::intervals::intervals(&down[plant.frames.clone()]) {
                let frames = run.start + plant.frames.start..run.end + plant.frames.start;
                let [found, truth] = [&cleaned.clip, truth]
                    .map(|clip| kinematics::tracks_at(clip, &[joint], frames.clone()).remove(0));
                let share = skeleton.metres_per_unit / found.len() as f64;
                let mean = found.iter().sum::<Vector3<f64>>() / found.len() as f64;
                let farthest = found.iter().map(|position| (position - mean).norm()).fold(0.0, f64::max);
                slides.push(skeleton.metres_per_unit * farthest);
                errors.push(share * found.iter().zip(&truth).map(|(a, b)| (a - b).norm()).sum::<f64>());
            }
        }
    }
    (slides, errors)
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len().max(1) as f64
}

fn most(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(0.0, f64::max)
}

/// Cleans the full set up, with noise as given for each of its recipes.
fn clean_generated(noise: impl Fn(usize, &ClipSpec) -> Noise) -> Figures {
    let mut figures = Figures::default();
    for (n, recipe) in full_set(1.0).iter().enumerate() {
        let [noisy, truth] = pair(recipe, noise(n, recipe));
        let contacts = Contacts::from(&noisy.truth);
        let skeleton = Skeleton::main(&noisy.clip, &Overrides::default());
        let cleaned = skate::clean(&noisy.clip, &skeleton, &contacts, &Options::default()).expect("feet");
        // A T-pose is no part of the motion, nor is the jump from it.
        let from = if recipe.leading_t_pose { 2 } else { 0 };
        let [before, after] = [&noisy.clip, &cleaned.clip].map(|clip| clip.slice(from..clip.frame_count()));
        let (acceleration, knee, place) = roughness(&before, &after, &skeleton);
        let (slides, errors) = stands(&cleaned, &truth.clip, &skeleton, &contacts);
        println!(
            "{}: {} of {} held, worst slide {:.2} -> {:.3} mm, error {:.1} mm, acceleration x {acceleration:.2} ({place}), knee x {knee:.2}",
            recipe.name,
            cleaned.held_count(),
            cleaned.plants.len(),
            1e3 * most(cleaned.plants.iter().map(|plant| plant.before)),
            1e3 * most(slides.clone()),
            1e3 * mean(&errors),
        );
        figures.before.extend(cleaned.plants.iter().map(|plant| plant.before));
        figures.constrained += cleaned.held_count();
        figures.slides.extend(slides);
        figures.errors.extend(errors);
        figures.acceleration = figures.acceleration.max(acceleration);
        figures.knee = figures.knee.max(knee);
    }
    println!(
        "{} of {} held, slide {:.2} (worst {:.2}) -> worst {:.3} mm, error {:.2} mm, acceleration x {:.2}, knee x {:.2}",
        figures.constrained,
        figures.before.len(),
        1e3 * mean(&figures.before),
        1e3 * most(figures.before.clone()),
        1e3 * most(figures.slides.clone()),
        1e3 * mean(&figures.errors),
        figures.acceleration,
        figures.knee,
    );
    figures
}

/// What was measured over many clips; metres.
#[derive(Default)]
struct Figures {
    before: Vec<f64>,
    constrained: usize,
    slides: Vec<f64>,
    errors: Vec<f64>,
    acceleration: f64,
    knee: f64,
}

#[test]
fn generated_feet_stand_where_they_truly_stand() {
    // Standard deviations; plants slide and float up to about twice as far.
    let level = |n: usize, _: &ClipSpec| {
        let metres = 0.001 * (1 + n % 6) as f64;
        Noise { jitter: 0.0, slide: metres, float: metres }
    };
    let figures = clean_generated(level);
    assert!(most(figures.before.clone()) >= 0.015, "slides of up to 15 mm");
    assert_eq!(figures.constrained, figures.before.len());
    assert!(most(figures.slides) <= 0.001);
    assert!(mean(&figures.errors) <= 0.005);
    assert!(figures.acceleration <= 1.2);
    assert!(figures.knee <= 1.2);
}

#[test]
fn jittering_feet_are_held_as_well() {
    let figures = clean_generated(|_, recipe| recipe.character.noise);
    assert_eq!(figures.constrained, figures.before.len());
    assert!(most(figures.slides) <= 0.001);
    // Feet that tremble are stilled, hips that tremble with them are not: knees take it up.
    assert!(figures.acceleration <= 3.0 && figures.knee <= 2.2);
}

#[test]
fn feet_that_stand_do_not_slide() {
    for recipe in full_set(0.0) {
        let still = generate(&recipe, 0);
        let skeleton = Skeleton::main(&still.clip, &Overrides::default());
        let skate = skate::measure(&still.clip, &skeleton, &Contacts::from(&still.truth)).expect("feet");
        assert!(skate.mean() < 0.001 && skate.worst() < 0.002, "{}: {}", recipe.name, skate.worst());
    }
}

#[test]
fn stairs_stay_stairs_and_belts_run_on() {
    for recipe in hard_cases(0.0) {
        let still = generate(&recipe, 0);
        let contacts = Contacts::from(&still.truth);
        let skeleton = Skeleton::main(&still.clip, &Overrides::default());
        let cleaned = skate::clean(&still.clip, &skeleton, &contacts, &Options::default()).expect("feet");
        let (_, errors) = stands(&cleaned, &still.clip, &skeleton, &contacts);
        let moves =
            cleaned.plants.iter().filter(|plant| plant.skip_reason == Some(SkipReason::MovesTooFar)).count();
        println!(
            "{}: {} of {} held, {moves} move, off by {:.2} mm, worst {:.2}",
            recipe.name,
            cleaned.held_count(),
            cleaned.plants.len(),
            1e3 * mean(&errors),
            1e3 * most(errors.clone())
        );
        match recipe.name.as_str() {
            "treadmill" => {
                assert!(moves > 0 && cleaned.notices.iter().any(|n| n.code == Code::Unconstrained))
            }
            "stairs" | "slope-2" | "slope-5" => assert!(mean(&errors) < 0.003),
            "afloat" => {
                assert!(cleaned.clip == still.clip && cleaned.notices[0].code == Code::NothingPlanted)
            }
            _ => {}
        }
    }
}

#[test]
fn recorded_feet_stand() {
    let Some(corpus) = support::corpus::folder() else { return };
    let mut all: Vec<CleanedPlant> = Vec::new();
    for path in support::bvh_files(&corpus.join("cmu")) {
        if path.file_stem().is_some_and(|name| name == "13_30") {
            continue;
        }
        let clip = support::read(&path).clip;
        let skeleton = Skeleton::main(&clip, &Overrides::default());
        let Ok(feet) = Feet::new(&clip, &skeleton) else { continue };
        let contacts = Contacts::from(&plants::detect(&feet, ValidParams::default()));
        let cleaned = skate::clean(&clip, &skeleton, &contacts, &Options::default()).expect("feet");
        let (acceleration, knee, place) = roughness(&clip, &cleaned.clip, &skeleton);
        println!(
            "{}: {} of {} held, acceleration x {acceleration:.2} ({place}), knee x {knee:.2}",
            path.file_stem().unwrap_or_default().to_string_lossy(),
            cleaned.held_count(),
            cleaned.plants.len()
        );
        all.extend(cleaned.plants);
    }
    let held: Vec<&CleanedPlant> = all.iter().filter(|plant| plant.skip_reason.is_none()).collect();
    let before = mean(&held.iter().map(|plant| plant.before).collect::<Vec<f64>>());
    let after = mean(&held.iter().map(|plant| plant.after).collect::<Vec<f64>>());
    println!("{} of {} held, mean slide {:.1} -> {:.4} mm", held.len(), all.len(), 1e3 * before, 1e3 * after);
    assert!(held.len() * 10 >= all.len() * 9);
    assert!(after <= 0.05 * before);
}
