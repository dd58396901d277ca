//! Motion of the ground: belts of treadmills, platforms, and floors that turn in the file because the
//! camera or the calibration drifts.
//!
//! At almost any time a foot is planted, and it is the slower one. The median velocity of the slower
//! foot within a fraction of a second is that of the ground, unless it is as small as that of a
//! planted foot that rolls, or the feet disagree whenever both are slow: then one of them is dragged.
//!
//! On a fast belt the planted foot is not the slower one: a foot that reverses is slower for a moment.
//! The velocity of a belt is found in another way ([`belt`]) and subtracted before. If the hips never move, the
//! ground that is not a belt moves with them ([`fixed_hips`]).

use std::ops::Range;

use nalgebra::Vector3;

use crate::kinematics::Track;
use crate::numeric::{self, stats};
use crate::plants::Feet;
use crate::plants::signal::belt::{self, REST_SPEED, ToeSample};
use crate::plants::signal::fixed_hips::{self, FootVelocities};

/// Rate at which the velocity of the ground is sampled, in Hz; stances last several samples.
const RATE: f64 = 30.0;
/// Half-width of the window of the median, in seconds: shorter than a stance, longer than the
/// reversal of a foot in swing.
const WINDOW: f64 = 0.3;
/// Half-width of the window in which the feet are compared and the velocity must last, in seconds: any
/// stride has a double support within it.
const COMPARISON_WINDOW: f64 = 0.6;
/// Speed above which a foot is in swing, in leg lengths per second: faster than planted feet on slow
/// belts and slower than feet that beat in the air (generated motion, seeds 0 to 2).
const SWING_SPEED: f64 = 0.8;
/// Minimum fraction of the window in which a foot is slower than that; otherwise there is flight and
/// no evidence of the ground.
const MIN_FRACTION: f64 = 0.6;
/// Minimum velocity of the ground in the wider window, as a fraction: feet that beat in the air reverse
/// within it, ground does not.
const MIN_DURABILITY: f64 = 0.4;
/// Percentile of the velocity differences of both feet, and its weight against the velocity of the
/// ground. Chosen on a dragged foot and a platform (generated motion, seeds 0 to 2) and on walks on ground
/// that turns.
const AGREEMENT: f64 = 0.25;
const DISAGREEMENT_WEIGHT: f64 = 0.5;

/// Returns the displacement of the ground in each frame of a clip, relative to the start of each
/// span; `None` if the ground is at rest.
pub(crate) fn displacement(feet: &Feet, spans: &[Range<usize>]) -> Option<Track> {
    let step = (1.0 / (RATE * feet.frame_time)).round().max(1.0) as usize;
    let velocities: Vec<_> = spans.iter().map(|span| velocities(feet, span, step)).collect();
    if velocities.iter().flatten().all(|velocity| *velocity == Vector3::zeros()) {
        return None;
    }
    let mut displacement = vec![Vector3::zeros(); feet.frame_count()];
    for (span, velocities) in spans.iter().zip(velocities) {
        let mut position = Vector3::zeros();
        for frame in span.clone() {
            displacement[frame] = position;
            let nearest = (frame - span.start + step / 2) / step;
            position += velocities[nearest.min(velocities.len() - 1)] * feet.frame_time;
        }
    }
    Some(displacement)
}

/// Returns the velocity of the ground at every `step`-th frame of a span.
fn velocities(feet: &Feet, span: &Range<usize>, step: usize) -> Vec<Vector3<f64>> {
    let half = |seconds: f64| (seconds / (step as f64 * feet.frame_time)).round() as usize;
    let parts: Vec<[FootVelocities; 2]> = span
        .clone()
        .step_by(step)
        .map(|frame| [0, 1].map(|foot| foot_velocities(feet, foot, span, frame, step)))
        .collect();
    let toe_samples = |(index, parts): (usize, &[FootVelocities; 2])| {
        let height = |foot: usize| feet.up.height(&feet.tracks[foot].toe[span.start + index * step]);
        [0, 1].map(|foot| ToeSample { velocity: parts[foot][1], height: height(foot) })
    };
    let toes: Vec<[ToeSample; 2]> = parts.iter().enumerate().map(toe_samples).collect();
    let belt = belt::velocities(&toes, feet.leg, step as f64 * feet.frame_time);
    if fixed_hips::are_fixed(feet, span) {
        let lowest = fixed_hips::velocities(feet, span, step, &parts);
        let ground = belt.into_iter().zip(lowest);
        return ground.map(|(belt, lowest)| if belt == Vector3::zeros() { lowest } else { belt }).collect();
    }
    let both: Vec<[Option<Vector3<f64>>; 2]> = parts
        .iter()
        .zip(&belt)
        .map(|(parts, belt)| parts.map(|foot| planted_velocity(foot, belt, SWING_SPEED * feet.leg)))
        .collect();
    let slower: Vec<Option<Vector3<f64>>> = both
        .iter()
        .map(|feet| {
            feet.iter().flatten().min_by(|a, b| a.norm_squared().total_cmp(&b.norm_squared())).copied()
        })
        .collect();
    let medians: Vec<Vector3<f64>> = windows(&slower, half(WINDOW)).map(median).collect();
    let mean = |medians: &[Vector3<f64>]| medians.iter().sum::<Vector3<f64>>() / medians.len() as f64;
    let wide = half(COMPARISON_WINDOW);
    windows(&medians, half(WINDOW) / 2)
        .map(mean)
        .zip(windows(&medians, wide).map(mean))
        .zip(windows(&both, wide))
        .zip(belt)
        .map(|(((mean, wide_mean), both), belt)| {
            let rest = REST_SPEED * feet.leg;
            let is_lasting = wide_mean.dot(&mean) > MIN_DURABILITY * mean.norm_squared();
            if mean.norm() < rest / 2.0 || !is_lasting {
                return belt;
            }
            let doubt = rest.max(DISAGREEMENT_WEIGHT * disagreement(both));
            belt + mean / (1.0 + (doubt / mean.norm()).powi(4))
        })
        .collect()
}

/// Returns the values within `half` indices on either side of each index.
fn windows<T>(values: &[T], half: usize) -> impl Iterator<Item = &[T]> {
    (0..values.len()).map(move |index| numeric::around(values, index, half))
}

/// Returns the velocities of ankle and toe of a foot at a frame.
fn foot_velocities(
    feet: &Feet,
    foot: usize,
    span: &Range<usize>,
    frame: usize,
    step: usize,
) -> FootVelocities {
    let from = frame.saturating_sub(step).max(span.start);
    let to = (frame + step).min(span.end - 1);
    let seconds = (to - from).max(1) as f64 * feet.frame_time;
    let tracks = &feet.tracks[foot];
    [&tracks.ankle, &tracks.toe].map(|track| (track[to] - track[from]) / seconds)
}

/// Returns the velocity relative to a belt of the slower part of a foot, unless it is in swing.
fn planted_velocity(parts: FootVelocities, belt: &Vector3<f64>, swing_speed: f64) -> Option<Vector3<f64>> {
    let [ankle, toe] = parts.map(|part| part - belt);
    let slower = if ankle.norm_squared() < toe.norm_squared() { ankle } else { toe };
    (slower.norm() < swing_speed).then_some(slower)
}

/// Returns the median of the known velocities, by coordinate; zero if too few are known.
fn median(velocities: &[Option<Vector3<f64>>]) -> Vector3<f64> {
    let known = || velocities.iter().flatten();
    if (known().count() as f64) < MIN_FRACTION * velocities.len() as f64 {
        return Vector3::zeros();
    }
    Vector3::from_fn(|axis, _| {
        stats::median_high(known().map(|velocity| velocity[axis])).expect("a velocity is known")
    })
}

/// Returns the difference of the velocities of both feet when they agree best; 0 if they are never
/// both known.
fn disagreement(both: &[[Option<Vector3<f64>>; 2]]) -> f64 {
    let differences = both.iter().filter_map(|[left, right]| Some(((*left)? - (*right)?).norm()));
    stats::nearest_percentile(differences.collect(), AGREEMENT)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants::FootTracks;
    use crate::skeleton::Up;

    const RATE: f64 = 60.0;

    /// Feet with legs of one unit, from the positions of the toes by time.
    fn feet(seconds: f64, toes: [&dyn Fn(f64) -> Vector3<f64>; 2]) -> Feet {
        let frames = (seconds * RATE) as usize;
        let tracks = toes.map(|toe| {
            let toe: Track = (0..frames).map(|frame| toe(frame as f64 / RATE)).collect();
            FootTracks { ankle: toe.iter().map(|toe| toe + 0.1 * Vector3::y()).collect(), toe, tip: None }
        });
        let hips = Track::new();
        Feet { tracks, hips, up: Up::Y, leg: 1.0, metres_per_unit: 1.0, frame_time: 1.0 / RATE }
    }

    /// Steps of one leg length in 0.4 s, one per 1.1 s.
    fn walk(time: f64, ahead: f64) -> Vector3<f64> {
        let cycles = time / 1.1 + ahead;
        let swing = ((cycles.fract() - 0.64) / 0.36).max(0.0);
        Vector3::z() * (cycles.floor() + swing * swing * (3.0 - 2.0 * swing))
    }

    /// Displacement of the ground from the second to the eighth second of ten.
    fn moved(toes: [&dyn Fn(f64) -> Vector3<f64>; 2]) -> Vector3<f64> {
        let feet = feet(10.0, toes);
        displacement(&feet, &[0..feet.frame_count()])
            .map_or(Vector3::zeros(), |ground| ground[(8.0 * RATE) as usize] - ground[(2.0 * RATE) as usize])
    }

    #[test]
    fn ground_at_rest_has_no_displacement() {
        let feet = feet(10.0, [&|time| walk(time, 0.0), &|time| walk(time, 0.5)]);
        assert_eq!(displacement(&feet, &[0..200, 200..600]), None);
    }

    #[test]
    fn velocity_of_a_belt_is_found() {
        let belt = |time: f64| Vector3::z() * -0.6 * time;
        let ground = moved([&|time| walk(time, 0.0) + belt(time), &|time| walk(time, 0.5) + belt(time)]);
        assert!((ground - belt(6.0)).norm() < 0.1, "{ground}");
    }

    #[test]
    fn fast_belts_are_found() {
        for speed in [0.9, 1.3, 2.0] {
            let belt = |time: f64| Vector3::z() * -speed * time;
            let lift = |time: f64, ahead: f64| Vector3::y() * 0.1 * is_swing(time, ahead);
            let foot =
                |time: f64, ahead: f64| speed * 1.1 * walk(time, ahead) + belt(time) + lift(time, ahead);
            let ground = moved([&|time| foot(time, 0.0), &|time| foot(time, 0.5)]);
            assert!((ground - belt(6.0)).norm() < 0.1, "{speed}: {ground}");
        }
    }

    /// Returns 1 while [`walk`] swings, otherwise 0.
    fn is_swing(time: f64, ahead: f64) -> f64 {
        f64::from((time / 1.1 + ahead).fract() > 0.64)
    }

    #[test]
    fn feet_that_swing_at_a_constant_velocity_are_not_on_a_belt() {
        // Steps of three leg lengths in 0.8 s, 60 % of which are swing.
        let run = |time: f64, ahead: f64| {
            let cycles = time / 0.8 + ahead;
            let swing = ((cycles.fract() - 0.4) / 0.6).max(0.0);
            let lift = 0.3 * (std::f64::consts::PI * swing).sin();
            Vector3::new(0.0, lift, 3.0 * (cycles.floor() + swing))
        };
        let feet = feet(10.0, [&|time| run(time, 0.0), &|time| run(time, 0.5)]);
        assert_eq!(displacement(&feet, &[0..600]), None);
    }

    #[test]
    fn vertical_motion_of_the_ground_is_found() {
        let lift = |time: f64| Vector3::y() * 0.5 * (0.8 * time).sin();
        let feet = feet(10.0, [&|time| walk(time, 0.0) + lift(time), &|time| walk(time, 0.5) + lift(time)]);
        let ground = displacement(&feet, &[0..feet.frame_count()]).unwrap();
        let [low, high] = [f64::min, f64::max].map(|of| ground.iter().map(|ground| ground.y).fold(0.0, of));
        // Near the reversals the ground is so slow that it counts as resting.
        assert!((0.7..1.05).contains(&(high - low)), "{low} {high}");
    }

    /// Vertical motion relative to hips that sink by 0.5 leg lengths every 2 s.
    fn squat(time: f64) -> Vector3<f64> {
        Vector3::y() * (0.25 - 0.25 * (std::f64::consts::PI * time).cos())
    }

    #[test]
    fn ground_moves_with_hips_that_never_move() {
        let kick = |time: f64| squat(time) + Vector3::y() * 0.4 * (5.0 * time).sin().max(0.0);
        for right in [&squat as &dyn Fn(f64) -> Vector3<f64>, &kick] {
            let mut feet = feet(10.0, [&squat, right]);
            feet.hips = vec![Vector3::y(); feet.frame_count()];
            let ground = displacement(&feet, &[0..600]).expect("ground that moves");
            for (ground, toe) in ground.iter().zip(&feet.tracks[0].toe) {
                assert!((ground - toe).norm() < 0.05, "{ground} {toe}");
            }
        }
    }
}
