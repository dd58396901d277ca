//! Ground under each foot: heights relative to the stances of that foot.
//!
//! On slopes, on stairs and on floors that are tilted against the up axis, each stance has another
//! height, and the lower foot is not the only one on the ground. A foot that is at rest while the
//! other one takes a step bears the weight, so its own height is that of the ground. Between two
//! such stances, the ground is the line from one to the other.

use std::collections::VecDeque;
use std::ops::Range;

use nalgebra::Vector3;

use crate::kinematics::Track;
use crate::plants::Feet;
use crate::plants::signal::Signals;
use crate::plants::signal::resampling::Resampler;

/// Half-width of the window for the local ground height, in seconds: longer than the flight of a
/// run, shorter than a stride.
const WINDOW: f64 = 0.5;
/// Speed below which a foot may bear weight, in leg lengths per second: feet that are planted on
/// moving ground or recorded with noise are slower, feet in swing are faster except at reversals.
const REST_SPEED: f64 = 0.8;
/// Speed above which a foot takes a step, in leg lengths per second.
const STEP_SPEED: f64 = 1.0;
/// Minimum length of a step during which the other foot must bear weight, in leg lengths.
const STEP_LENGTH: f64 = 0.15;
/// Maximum difference of height within a stance, in leg lengths: a foot that is lifted slowly leaves
/// the ground.
const STANCE_HEIGHT: f64 = 0.1;
/// Height above the line between the ends of the other foot's step up to which a foot is on the ground,
/// in leg lengths; a raised foot of a person who hops is higher.
const STEP_HEIGHT: f64 = 0.05;
/// Slope of the ground above which a foot is in the air rather than on higher ground: 27°.
const MAX_SLOPE: f64 = 0.5;
/// Typical difference of heights between stances on level ground, in leg lengths: noise of capture and
/// of feet that stand on heel or toe. Differences that are clearly larger are those of the ground. Chosen
/// on generated motion with and without noise (seeds 0 to 2).
const LEVEL: f64 = 0.04;
/// Horizontal distance of two stances below which the ground between them is interpolated by time
/// rather than by distance, in leg lengths.
const MIN_DISTANCE: f64 = 0.1;

/// Stance of one foot, in resampled frames.
struct Stance {
    frames: Range<usize>,
    /// Frames in which the foot bears the whole weight.
    proof: Range<usize>,
}

/// Stances of one foot in order of time.
type Stances = Vec<Stance>;

/// Subtracts the height of the ground under each foot from the heights of its ankle and toe.
///
/// The ground is at least as high as the lowest height of both feet within [`WINDOW`]. Returns, by foot
/// and resampled frame, by how much the ground under the ankle exceeds that under the toe, in file
/// units: the height of the heel of a foot that stands on its toe.
pub(crate) fn subtract(
    feet: &Feet,
    resampler: &Resampler,
    ankle: &mut Signals,
    toe: &mut Signals,
) -> [Vec<f32>; 2] {
    let Resampler { fine_spans: spans, factor, frame_time, .. } = resampler;
    let half = (WINDOW / frame_time + 0.55).floor() as usize;
    let soles = Soles { ankle, toe, feet, leg: feet.leg, factor: *factor, frame_time: *frame_time };
    let stances: Vec<[Stances; 2]> =
        spans.iter().map(|span| [0, 1].map(|foot| soles.stances(foot, span))).collect();
    let mut heel_rise = [0, 1].map(|foot: usize| vec![0.0; ankle[foot].height.len()]);
    for (signals, sign) in [(ankle, 1.0), (toe, -1.0)] {
        for (span, stances) in spans.iter().zip(&stances) {
            let lower = |frame: usize| signals[0].height[frame].min(signals[1].height[frame]);
            let local = sliding_minimum(span.clone().map(lower).collect(), half);
            for foot in 0..2 {
                let path = Path { track: &feet.tracks[foot].toe, factor: *factor, feet };
                let heights = &mut signals[foot].height;
                let own = ground_of_stances(heights, span, &stances[foot], half, path);
                for (frame, (own, local)) in span.clone().zip(own.into_iter().zip(&local)) {
                    let rise = rise(own - local, feet.leg);
                    heights[frame] = (heights[frame] - local - rise).max(0.0);
                    heel_rise[foot][frame] += (sign * rise) as f32;
                }
            }
        }
    }
    for rise in heel_rise.iter_mut().flatten() {
        *rise = rise.max(0.0);
    }
    heel_rise
}

/// Returns the part of a difference of ground heights that exceeds the differences between stances
/// on level ground.
fn rise(difference: f64, leg: f64) -> f64 {
    if difference > 0.0 { difference / (1.0 + (LEVEL * leg / difference).powi(4)) } else { 0.0 }
}

/// Signals of ankle and toe of both feet; heights are along the up axis.
struct Soles<'a> {
    ankle: &'a Signals,
    toe: &'a Signals,
    feet: &'a Feet,
    leg: f64,
    factor: usize,
    frame_time: f64,
}

impl Soles<'_> {
    /// Returns the speed of the slower part of a foot.
    fn sole_speed(&self, foot: usize, frame: usize) -> f64 {
        self.ankle[foot].speed[frame].min(self.toe[foot].speed[frame])
    }

    /// Returns the ranges within a span in which a foot satisfies a condition on its speed.
    fn ranges(&self, foot: usize, span: &Range<usize>, condition: impl Fn(f64) -> bool) -> Vec<Range<usize>> {
        let mut ranges: Vec<Range<usize>> = Vec::new();
        for frame in span.clone().filter(|frame| condition(self.sole_speed(foot, *frame))) {
            match ranges.last_mut().filter(|range| range.end == frame) {
                Some(range) => range.end += 1,
                None => ranges.push(frame..frame + 1),
            }
        }
        ranges
    }

    /// Returns the stances within a span in which a foot must bear weight: it is at rest while the
    /// other one takes a step.
    fn stances(&self, foot: usize, span: &Range<usize>) -> Stances {
        let steps = self.ranges(1 - foot, span, |speed| speed > STEP_SPEED * self.leg);
        let rests = self.ranges(foot, span, |speed| speed < REST_SPEED * self.leg);
        let stance = |rest: Range<usize>| {
            let first = steps.partition_point(|step| step.end <= rest.start);
            let within = steps[first..].iter().take_while(|step| step.start < rest.end);
            let proofs = within.filter_map(|step| self.proof(foot, &rest, step, span));
            let proof = proofs.reduce(|first, last| first.start..last.end)?;
            Some(Stance { frames: self.at_one_height(foot, rest, proof.clone()), proof })
        };
        rests.into_iter().filter_map(stance).collect()
    }

    /// Returns the frames of `rest` that prove that a foot bears weight, if there are any: the other
    /// foot takes a long step between places which are about as high.
    fn proof(
        &self,
        foot: usize,
        rest: &Range<usize>,
        step: &Range<usize>,
        span: &Range<usize>,
    ) -> Option<Range<usize>> {
        let proof = rest.start.max(step.start)..rest.end.min(step.end);
        let length: f64 = proof.clone().map(|frame| self.sole_speed(1 - foot, frame) * self.frame_time).sum();
        if length < STEP_LENGTH * self.leg {
            return None;
        }
        let up = self.feet.up;
        let place = self.path(foot).position(usize::midpoint(proof.start, proof.end));
        let other = self.path(1 - foot);
        let before = step.start.checked_sub(1).filter(|frame| *frame >= span.start);
        let after = Some(step.end).filter(|frame| *frame < span.end);
        let from = other.position(before.or(after)?);
        let to = other.position(after.or(before)?);
        let way = other.horizontal(to - from);
        let progress = if way.norm_squared() > 0.0 {
            (other.horizontal(place - from).dot(&way) / way.norm_squared()).clamp(0.0, 1.0)
        } else {
            0.0
        };
        let nearest = from.lerp(&to, progress);
        let allowed = STEP_HEIGHT * self.leg + MAX_SLOPE * other.horizontal(place - nearest).norm();
        (up.height(&place) - up.height(&nearest) < allowed).then_some(proof)
    }

    fn path(&self, foot: usize) -> Path<'_> {
        Path { track: &self.feet.tracks[foot].toe, factor: self.factor, feet: self.feet }
    }

    /// Returns the frames of a range around `proof` in which ankle or toe is as high as at the
    /// nearest frame of `proof`.
    fn at_one_height(&self, foot: usize, range: Range<usize>, proof: Range<usize>) -> Range<usize> {
        let is_as_high = |frame: usize, other: usize| {
            [&self.ankle[foot], &self.toe[foot]]
                .iter()
                .any(|signal| (signal.height[frame] - signal.height[other]).abs() < STANCE_HEIGHT * self.leg)
        };
        let before = (range.start..proof.start).rev().find(|frame| !is_as_high(*frame, proof.start));
        let after = (proof.end..range.end).find(|frame| !is_as_high(*frame, proof.end - 1));
        before.map_or(range.start, |frame| frame + 1)..after.unwrap_or(range.end)
    }
}

/// Path of a foot along the ground.
#[derive(Clone, Copy)]
struct Path<'a> {
    track: &'a Track,
    factor: usize,
    feet: &'a Feet,
}

impl Path<'_> {
    /// Returns the position at a resampled frame.
    fn position(&self, frame: usize) -> Vector3<f64> {
        let (index, rest) = (frame / self.factor, frame % self.factor);
        if rest == 0 {
            return self.track[index];
        }
        self.track[index].lerp(&self.track[index + 1], rest as f64 / self.factor as f64)
    }

    /// Returns how much of the way between two frames is done at each frame of `frames`: by horizontal
    /// distance, or by time if the distance is small.
    fn progress(
        &self,
        between: [usize; 2],
        frames: Range<usize>,
        range: [f64; 2],
    ) -> impl Iterator<Item = f64> {
        let [from, to] = between.map(|frame| self.horizontal(self.position(frame)));
        let way = to - from;
        let inertia = (MIN_DISTANCE * self.feet.leg).powi(2);
        let total = way.norm_squared() + inertia;
        let duration = (between[1] - between[0]) as f64;
        frames.map(move |frame| {
            let done = (self.horizontal(self.position(frame)) - from).dot(&way);
            let time = ((frame as f64 - between[0] as f64) / duration).clamp(0.0, 1.0);
            ((done + inertia * time) / total).clamp(range[0], range[1])
        })
    }

    fn horizontal(&self, position: Vector3<f64>) -> Vector3<f64> {
        let mut position = position;
        position[self.feet.up.axis.index()] = 0.0;
        position
    }
}

/// Returns the height of the ground under one foot in each frame of a span, as far as its stances
/// determine it; elsewhere negative infinity.
fn ground_of_stances(
    heights: &[f64],
    span: &Range<usize>,
    stances: &Stances,
    half: usize,
    path: Path,
) -> Vec<f64> {
    let mut ground = vec![f64::NEG_INFINITY; span.len()];
    for Stance { frames, proof } in stances {
        let own = sliding_minimum(heights[proof.clone()].to_vec(), half);
        for frame in frames.clone() {
            ground[frame - span.start] = own[frame.clamp(proof.start, proof.end - 1) - proof.start];
        }
    }
    let mut fill = |between: [usize; 2], frames: Range<usize>, range: [f64; 2]| {
        let [from, to] = between.map(|frame| ground[frame - span.start]);
        for (frame, progress) in frames.clone().zip(path.progress(between, frames, range)) {
            ground[frame - span.start] = from + (to - from) * progress;
        }
    };
    for pair in stances.windows(2) {
        fill(
            [pair[0].frames.end - 1, pair[1].frames.start],
            pair[0].frames.end..pair[1].frames.start,
            [0.0, 1.0],
        );
    }
    // Before the first and after the last stance, the line continues for the length of one stride.
    if let [first, second, ..] = stances.as_slice() {
        fill([first.frames.end - 1, second.frames.start], span.start..first.frames.start, [-1.0, 0.0]);
    }
    if let [.., second_last, last] = stances.as_slice() {
        fill([second_last.frames.end - 1, last.frames.start], last.frames.end..span.end, [1.0, 2.0]);
    }
    ground
}

/// Returns the minimum of the values within `half` indices on either side, in linear time.
fn sliding_minimum(values: Vec<f64>, half: usize) -> Vec<f64> {
    // Indices whose values may still become the minimum; indices and values ascend.
    let mut candidates: VecDeque<usize> = VecDeque::new();
    let mut next = 0;
    (0..values.len())
        .map(|index| {
            while next < values.len().min(index + half + 1) {
                while candidates.back().is_some_and(|&last| values[last] >= values[next]) {
                    candidates.pop_back();
                }
                candidates.push_back(next);
                next += 1;
            }
            while candidates.front().is_some_and(|&first| first + half < index) {
                candidates.pop_front();
            }
            values[candidates[0]]
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::plants::FootTracks;
    use crate::plants::signal;
    use crate::skeleton::Up;

    proptest! {
        #[test]
        fn sliding_minimum_agrees_with_the_definition(
            values in prop::collection::vec(-9.0..9.0_f64, 0..40),
            half in 0_usize..12,
        ) {
            let expected: Vec<f64> = (0..values.len())
                .map(|index| {
                    let window = &values[index.saturating_sub(half)..(index + half + 1).min(values.len())];
                    window.iter().copied().fold(f64::INFINITY, f64::min)
                })
                .collect();
            prop_assert_eq!(sliding_minimum(values, half), expected);
        }
    }

    /// Time of a step cycle in which a foot is planted, as a fraction.
    const STANCE: f64 = 0.64;
    const RATE: f64 = 120.0;

    /// Position of a foot that takes steps of one leg length in 1.1 s, each higher by `rise`.
    fn step(time: f64, ahead: f64, rise: f64) -> Vector3<f64> {
        let cycles = time / 1.1 + ahead;
        let swing = ((cycles.fract() - STANCE) / (1.0 - STANCE)).max(0.0);
        let done = cycles.floor() - ahead + swing * swing * (3.0 - 2.0 * swing);
        let lift = 0.15 * (std::f64::consts::PI * swing).sin().powi(2);
        Vector3::new(0.0, rise * done + lift, done)
    }

    /// Heights of the toes of both feet above the ground, in leg lengths, in a clip of eight seconds.
    fn heights(toes: [&dyn Fn(f64) -> Vector3<f64>; 2]) -> [Vec<f64>; 2] {
        let frames = (8.0 * RATE) as usize;
        let tracks = toes.map(|toe| {
            let toe: Track = (0..frames).map(|frame| toe(frame as f64 / RATE)).collect();
            FootTracks { ankle: toe.iter().map(|toe| toe + 0.1 * Vector3::y()).collect(), toe, tip: None }
        });
        let hips = Track::new();
        let feet = Feet { tracks, hips, up: Up::Y, leg: 1.0, metres_per_unit: 1.0, frame_time: 1.0 / RATE };
        let resampler = Resampler::new(&feet, &[0..frames]);
        let [mut ankle, mut toe] = [
            signal::filtered(&feet, &resampler, |foot| &foot.ankle),
            signal::filtered(&feet, &resampler, |foot| &foot.toe),
        ];
        subtract(&feet, &resampler, &mut ankle, &mut toe);
        toe.map(|signal| signal.height)
    }

    #[test]
    fn planted_feet_have_no_height_on_slopes_and_stairs() {
        for rise in [0.0, 0.1, 0.4, -0.1, -0.4] {
            let feet = heights([&|time| step(time, 0.0, rise), &|time| step(time, 0.5, rise)]);
            for (heights, ahead) in feet.iter().zip([0.0, 0.5]) {
                for (frame, height) in heights.iter().enumerate() {
                    let phase = (frame as f64 / RATE / 1.1 + ahead).fract();
                    let is_mid_stance = (0.05..STANCE - 0.05).contains(&phase);
                    let limit = if is_mid_stance { 0.02 } else { 0.5 };
                    // At the ends, no step of the other foot tells which foot bears weight.
                    let is_inside = (1.0..7.0).contains(&(frame as f64 / RATE));
                    assert!(!is_inside || *height < limit, "{rise}, {frame}: {height}");
                    let is_mid_swing = (phase - (1.0 + STANCE) / 2.0).abs() < 0.02;
                    assert!(!is_mid_swing || *height > 0.1, "{rise}, {frame}: {height}");
                }
            }
        }
    }

    #[test]
    fn a_raised_foot_does_not_define_the_ground() {
        let hop = |time: f64| Vector3::new(0.0, 0.2 * (4.0 * time).sin().max(0.0), 0.0);
        let [_, raised] = heights([&hop, &|_| Vector3::new(0.2, 0.4, 0.0)]);
        assert!(raised.iter().all(|height| *height > 0.35));
    }
}
