//! Clean-up of generated clips, whose true foot positions are known.

#[path = "support/roughness.rs"]
mod roughness;

use std::fs;
use std::ops::Range;
use std::path::Path;

use nalgebra::Vector3;
use plantigrade::bvh::{self, Axis, Channel, Clip};
use plantigrade::foot::Side;
use plantigrade::kinematics;
use plantigrade::notice::Code;
use plantigrade::plants::{self, Feet, ValidParams};
use plantigrade::skate::{self, Cleaned, Contacts, Options, SkipReason};
use plantigrade::skeleton::{Overrides, Skeleton};
use plantigrade_synth::noise::Noise;
use plantigrade_synth::{ClipSpec, Generated, full_set, generate, hard_cases};
use roughness::{mean, roughness};

/// Returns generated motion with the given noise, and the same motion without noise.
fn pair(spec: &ClipSpec, noise: Noise) -> [Generated; 2] {
    let mut spec = ClipSpec { noise_level: 1.0, ..spec.clone() };
    spec.character.noise = noise;
    let clean = ClipSpec { noise_level: 0.0, ..spec.clone() };
    let pair = [generate(&spec, 0), generate(&clean, 0)];
    assert_eq!(pair[0].truth, pair[1].truth, "noise does not change the truth");
    pair
}

/// Returns the joints that bear on the ground with their frames: the toe, and the ankle while both heel and
/// toe are planted.
fn parts(skeleton: &Skeleton, contacts: &Contacts, side: Side) -> [(usize, Vec<bool>); 2] {
    let foot = contacts.foot(side);
    let (heel, toe) = (foot.heel.clone().expect("truth"), foot.toe.clone().expect("truth"));
    let both = heel.iter().zip(&toe).map(|(heel, toe)| *heel && *toe).collect();
    [(skeleton.toe(side).expect("a toe"), toe), (skeleton.heel(side).expect("an ankle"), both)]
}

/// Returns two distances in metres for each plant and part: the maximum distance of the joint from its mean
/// position, measured independently of the library, and its mean distance from the true position.
fn slides_and_errors(
    cleaned: &Cleaned,
    truth: &Clip,
    skeleton: &Skeleton,
    contacts: &Contacts,
) -> (Vec<f64>, Vec<f64>) {
    let (mut slides, mut errors) = (Vec::new(), Vec::new());
    for plant in &cleaned.plants {
        for (joint, down) in parts(skeleton, contacts, plant.side) {
            for run in plantigrade::intervals::intervals(&down[plant.frames.clone()]) {
                let frames = run.start + plant.frames.start..run.end + plant.frames.start;
                let [actual, truth] = [&cleaned.clip, truth]
                    .map(|clip| kinematics::tracks_at(clip, &[joint], frames.clone()).remove(0));
                let weight = skeleton.metres_per_unit / actual.len() as f64;
                let mean = actual.iter().sum::<Vector3<f64>>() / actual.len() as f64;
                let max_distance = actual.iter().map(|position| (position - mean).norm()).fold(0.0, f64::max);
                slides.push(skeleton.metres_per_unit * max_distance);
                errors.push(weight * actual.iter().zip(&truth).map(|(a, b)| (a - b).norm()).sum::<f64>());
            }
        }
    }
    (slides, errors)
}

fn max(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(0.0, f64::max)
}

/// Cleans the full set, with the given noise for each clip.
fn clean_generated(noise: impl Fn(usize, &ClipSpec) -> Noise) -> Figures {
    let mut figures = Figures::default();
    for (n, spec) in full_set(1.0).iter().enumerate() {
        let [noisy, truth] = pair(spec, noise(n, spec));
        let contacts = Contacts::from(&noisy.truth);
        let skeleton = Skeleton::main(&noisy.clip, &Overrides::default());
        let cleaned = skate::clean(&noisy.clip, &skeleton, &contacts, &Options::default()).expect("feet");
        // The T-pose and the jump from it do not belong to the motion.
        let from = if spec.leading_t_pose { 2 } else { 0 };
        let [before, after] = [&noisy.clip, &cleaned.clip].map(|clip| clip.slice(from..clip.frame_count()));
        let (acceleration, knee, joint) = roughness(&before, &after, &skeleton);
        let (slides, errors) = slides_and_errors(&cleaned, &truth.clip, &skeleton, &contacts);
        println!(
            "{}: {} of {} constrained, worst slide {:.2} -> {:.3} mm, error {:.1} mm, acceleration x {acceleration:.2} ({joint}), knee x {knee:.2}",
            spec.name,
            cleaned.constrained_count(),
            cleaned.plants.len(),
            1e3 * max(cleaned.plants.iter().map(|plant| plant.before)),
            1e3 * max(slides.clone()),
            1e3 * mean(&errors),
        );
        figures.before.extend(cleaned.plants.iter().map(|plant| plant.before));
        figures.constrained += cleaned.constrained_count();
        figures.slides.extend(slides);
        figures.errors.extend(errors);
        figures.acceleration = figures.acceleration.max(acceleration);
        figures.knee = figures.knee.max(knee);
    }
    println!(
        "{} of {} constrained, slide {:.2} (worst {:.2}) -> worst {:.3} mm, error {:.2} mm, acceleration x {:.2}, knee x {:.2}",
        figures.constrained,
        figures.before.len(),
        1e3 * mean(&figures.before),
        1e3 * max(figures.before.clone()),
        1e3 * max(figures.slides.clone()),
        1e3 * mean(&figures.errors),
        figures.acceleration,
        figures.knee,
    );
    figures
}

/// Measurements of many clips, in metres.
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
fn cleaned_feet_are_at_their_true_positions() {
    // Standard deviations; plants slide and float up to about twice as far.
    let level = |n: usize, _: &ClipSpec| {
        let metres = 0.001 * (1 + n % 6) as f64;
        Noise { jitter: 0.0, slide: metres, float: metres }
    };
    let figures = clean_generated(level);
    assert!(max(figures.before.clone()) >= 0.015, "slides of up to 15 mm");
    assert_eq!(figures.constrained, figures.before.len());
    assert!(max(figures.slides) <= 0.001);
    assert!(mean(&figures.errors) <= 0.005);
    assert!(figures.acceleration <= 1.2);
    assert!(figures.knee <= 1.2);
}

#[test]
fn jittering_feet_are_constrained() {
    let figures = clean_generated(|_, spec| spec.character.noise);
    assert_eq!(figures.constrained, figures.before.len());
    assert!(max(figures.slides) <= 0.001);
    // The feet are constrained, but the hips still jitter, and the knees compensate.
    assert!(figures.acceleration <= 3.0 && figures.knee <= 2.2);
}

#[test]
fn true_plants_do_not_slide() {
    for spec in full_set(0.0) {
        let generated = generate(&spec, 0);
        let skeleton = Skeleton::main(&generated.clip, &Overrides::default());
        let skate =
            skate::measure(&generated.clip, &skeleton, &Contacts::from(&generated.truth)).expect("feet");
        // Heels roll on their curve: up to 2.4 mm in a stagger with steep landings.
        assert!(skate.mean() < 0.001 && skate.worst() < 0.003, "{}: {}", spec.name, skate.worst());
    }
}

#[test]
fn stairs_keep_their_heights_and_treadmills_their_motion() {
    for spec in hard_cases(0.0) {
        let generated = generate(&spec, 0);
        let contacts = Contacts::from(&generated.truth);
        let skeleton = Skeleton::main(&generated.clip, &Overrides::default());
        let cleaned = skate::clean(&generated.clip, &skeleton, &contacts, &Options::default()).expect("feet");
        let (_, errors) = slides_and_errors(&cleaned, &generated.clip, &skeleton, &contacts);
        let moves =
            cleaned.plants.iter().filter(|plant| plant.skip_reason == Some(SkipReason::MovesTooFar)).count();
        println!(
            "{}: {} of {} constrained, {moves} not constrained, error {:.2} mm, worst {:.2}",
            spec.name,
            cleaned.constrained_count(),
            cleaned.plants.len(),
            1e3 * mean(&errors),
            1e3 * max(errors.clone())
        );
        match spec.name.as_str() {
            "treadmill" | "slow-treadmill" => assert!(moves == 0 && mean(&errors) < 0.003),
            "stairs" | "slope-2" | "slope-5" => assert!(mean(&errors) < 0.003),
            "afloat" => {
                assert!(cleaned.clip == generated.clip && cleaned.notices[0].code == Code::NothingPlanted)
            }
            _ => {}
        }
    }
}

/// Returns a clip with `jump` added to a channel of the root in the given frames.
fn with_spike(clip: &Clip, channel: Channel, frames: Range<usize>, jump: f64) -> Clip {
    let mut values = clip.values().to_vec();
    let slot = clip.joints()[0].channels.iter().position(|other| *other == channel).expect("a channel");
    for frame in frames {
        values[frame * clip.channel_count() + slot] += jump;
    }
    Clip::new(clip.joints().to_vec(), clip.frame_time(), values).with_position_rule(clip.position_rule())
}

#[test]
fn spikes_do_not_spread() {
    for spec in full_set(1.0).into_iter().step_by(12) {
        let generated = generate(&spec, 0);
        let clip = &generated.clip;
        let skeleton = Skeleton::main(clip, &Overrides::default());
        let contacts = Contacts::from(&generated.truth);
        let units = |metres: f64| metres / skeleton.metres_per_unit;
        let leg = skeleton.leg.expect("a leg");
        let short = ((0.05 * clip.rate()) as usize).max(1);
        for (channel, jump, is_repaired) in [
            (Channel::Position(Axis::Y), units(0.3), true),
            (Channel::Position(Axis::Y), units(-0.25), true),
            (Channel::Position(Axis::X), units(0.2), true),
            (Channel::Rotation(Axis::X), 40.0, false),
            (Channel::Rotation(Axis::Z), 170.0, false),
        ] {
            for (at, length) in [(20, 1), (clip.frame_count() / 2, short), (clip.frame_count() - 30, 1)] {
                let spike = at..at + length;
                let spiked = with_spike(clip, channel, spike.clone(), jump);
                for repair_spikes in [true, false] {
                    let what = format!("{} {channel:?} {jump} {spike:?} {repair_spikes}", spec.name);
                    let options = Options { repair_spikes, ..Options::default() };
                    let cleaned = skate::clean(&spiked, &skeleton, &contacts, &options).expect("feet");
                    let [before, after] = [&spiked, &cleaned.clip]
                        .map(|clip| kinematics::tracks(clip, &[skeleton.root]).remove(0));
                    let moved = |frame: usize| (after[frame] - before[frame]).norm() / leg;
                    let others = (0..before.len()).filter(|frame| !spike.contains(frame));
                    assert!(max(others.map(moved)) <= 0.15, "{what}: the hips move in other frames");
                    let has_notice = cleaned.notices.iter().any(|notice| notice.code == Code::Spike);
                    assert_eq!(has_notice, is_repaired && repair_spikes, "{what}");
                    if has_notice {
                        let line = (before[spike.start - 1] + before[spike.end]) / 2.0;
                        assert!((after[spike.start] - line).norm() / leg < 0.1, "{what}");
                    }
                    // Plants that are not corrected do not slide more, either.
                    assert!(cleaned.plants.iter().all(|plant| plant.after <= plant.before + 0.001), "{what}");
                }
            }
        }
    }
}

#[test]
fn glitches_of_an_ankle_do_not_press_feet_into_the_ground() {
    // A clip with fast steps, in which labels of the glitches are plants below the ground.
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../samples/frog-jumps.bvh");
    let clip = bvh::parse(&fs::read(path).expect("a sample"), bvh::Options::default()).expect("BVH").clip;
    let skeleton = Skeleton::main(&clip, &Overrides::default());
    let toes = Side::BOTH.map(|side| skeleton.toe(side).expect("a toe"));
    let slot = clip.channel_range(skeleton.heel(Side::Right).expect("an ankle")).start;
    let leg = skeleton.leg.expect("a leg");
    let heights = |clip: &Clip| -> Vec<f64> {
        kinematics::tracks(clip, &toes).iter().flatten().map(|toe| skeleton.up.height(toe) / leg).collect()
    };
    let mut sorted = heights(&clip);
    sorted.sort_by(f64::total_cmp);
    let ground = sorted[sorted.len() / 20];
    for at in (20..clip.frame_count() - 20).step_by(2) {
        let mut values = clip.values().to_vec();
        for frame in at..at + 4 {
            values[frame * clip.channel_count() + slot + 1] += 36.67;
        }
        let glitch = Clip::new(clip.joints().to_vec(), clip.frame_time(), values);
        let feet = Feet::new(&glitch, &skeleton).expect("feet");
        let contacts = Contacts::from(&plants::detect(&feet, ValidParams::default()));
        let cleaned = skate::clean(&glitch, &skeleton, &contacts, &Options::default()).expect("feet");
        for (before, after) in heights(&glitch).into_iter().zip(heights(&cleaned.clip)) {
            assert!(after > ground.min(before) - 0.06, "{at}: {before} -> {after}, ground {ground}");
        }
    }
}
