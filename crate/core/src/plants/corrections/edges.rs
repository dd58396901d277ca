//! Boundaries of plants that are early or late.

use std::cell::OnceCell;
use std::ops::Range;
use std::sync::Arc;

use crate::foot::Part;
use crate::intervals::intervals;
use crate::numeric::sort;
use crate::plants::corrections::example::{Example, MIN_AFFINITY};
use crate::plants::corrections::profile::{Profile, affinity, difference};
use crate::plants::{Edge, FootLabels};

/// Time before and after a boundary within which boundaries must be similar, in seconds.
const REACH: f64 = 0.25;
/// Time before and after a boundary within which boundaries are aligned, in seconds.
const ALIGNED_REACH: f64 = 0.1;
/// Interval of the compared samples, in seconds.
const STEP: f64 = 0.025;
/// Maximum shift of an alignment, and the interval of the tried shifts, in seconds.
const MAX_SHIFT: f64 = 0.2;
const SHIFT_STEP: f64 = 0.004;
/// Root mean square difference of two windows at which the affinity is 1/e.
const BANDWIDTH: f64 = 0.15;
/// Standard deviation of boundaries whose instant is known to the frame only, in seconds.
const FRAME_UNCERTAINTY: f64 = 0.03;
/// Distance of a corrected time from the ends of the corrected frame, as a fraction of the frame: a time at its end
/// would be rounded to the next frame. Chosen on generated motion (seeds 0 to 9).
const FRAME_MARGIN: f64 = 0.02;
/// Numbers of standard deviations up to which a correction does not count and from which it counts in full.
const SIGNIFICANT: [f64; 2] = [2.0, 3.0];
/// Minimum sum of the squared errors that several corrections show, as a multiple of the variance of a boundary;
/// chosen from 1, 2 and 4 on generated motion (seeds 0 to 9) and with knowledge of trials over force plates.
const MIN_SIGNIFICANCE: f64 = 2.0;
/// Maximum ratio of the error of a correction to the error of the detection with which the correction is used.
const MAX_ERROR_RATIO: f64 = 0.5;
/// Number of bisections for a common offset, for an error far below a nanosecond.
const BISECTIONS: usize = 40;

/// Largest number of corrected boundaries of one kind that are used, the latest ones, and of those that are
/// similar to one boundary; more would take time and change little.
const MAX_EXAMPLES: usize = 64;
const MAX_SIMILAR: usize = 8;

/// A boundary of a plant that a person corrected or confirmed.
#[derive(Clone, Debug)]
pub(super) struct EdgeExample {
    pub part: Part,
    /// True for a foot strike, false for a foot off.
    is_strike: bool,
    profile: Arc<Profile>,
    /// Motion around the detected time, and around the corrected time.
    detected_window: Vec<f32>,
    corrected_window: Vec<f32>,
    /// Detected time and its standard deviation, in seconds.
    detected: f64,
    deviation: f64,
    /// Corrected time: the middle between two frames, or the detected time if it was confirmed. In seconds.
    corrected: f64,
    /// Times, in seconds, between which a boundary must be to agree with the corrected labels.
    allowed: [f64; 2],
}

impl EdgeExample {
    /// Returns the corrected time minus the detected time, in seconds.
    pub fn offset(&self) -> f64 {
        self.corrected - self.detected
    }

    /// Returns by how much a time is after the allowed ones; negative if it is before them, 0 if it is allowed.
    fn excess(&self, time: f64) -> f64 {
        let [first, last] = self.allowed;
        time - time.clamp(first, last)
    }

    /// Returns the standard deviation of the difference of detected and corrected time, in seconds; the corrected
    /// one is known to the frame.
    fn offset_deviation(&self) -> f64 {
        let [first, last] = self.allowed;
        (self.deviation.powi(2) + (last - first).powi(2) / 12.0).sqrt()
    }

    /// Returns the time near a boundary at which the motion is most similar to that at the corrected time.
    fn align(&self, profile: &Profile, time: f64) -> f64 {
        let steps = (MAX_SHIFT / SHIFT_STEP).round() as i32;
        let at = |step: i32| time + f64::from(step) * SHIFT_STEP;
        let differences: Vec<f64> = (-steps..=steps)
            .map(|step| difference(&self.corrected_window, &window(profile, at(step), ALIGNED_REACH)))
            .collect();
        let best = (0..differences.len()).min_by(|a, b| differences[*a].total_cmp(&differences[*b]));
        let best = best.expect("at least one shift");
        // The vertex of the parabola through the best three shifts.
        let fraction = match differences.get(best.wrapping_sub(1)..best + 2) {
            Some(&[before, here, after]) if before + after > 2.0 * here => {
                (before - after) / (2.0 * (before + after - 2.0 * here))
            }
            _ => 0.0,
        };
        at(best as i32 - steps) + fraction * SHIFT_STEP
    }
}

/// Returns the motion around a time.
fn window(profile: &Profile, time: f64, reach: f64) -> Vec<f32> {
    let steps = (reach / STEP).round() as i32;
    profile.window((-steps..=steps).map(move |step| time + f64::from(step) * STEP))
}

/// Returns time and standard deviation of a boundary, in seconds.
fn instant(labels: &FootLabels, frame: usize, frame_time: f64) -> (f64, f64) {
    let edge = labels.edge(frame);
    (labels.boundary_time(frame, frame_time), edge.map_or(FRAME_UNCERTAINTY, |edge| edge.uncertainty))
}

/// A boundary of labels and its correction.
pub(super) struct Match {
    /// First frame after the boundary before the correction.
    pub old: usize,
    /// First frame after the boundary after the correction.
    pub new: usize,
    is_strike: bool,
}

/// Returns the boundaries of plants that overlap before and after a correction.
pub(super) fn matches(before: &[bool], after: &[bool]) -> Vec<Match> {
    let (old, new) = (intervals(before), intervals(after));
    let overlap = |a: &Range<usize>, b: &Range<usize>| a.start < b.end && b.start < a.end;
    let mut matches = Vec::new();
    for plant in &old {
        let mut overlapping = new.iter().filter(|other| overlap(plant, other));
        let Some(first) = overlapping.next() else { continue };
        let last = overlapping.next_back().unwrap_or(first);
        // Of several plants that a correction joins, the outer boundaries count.
        if old.iter().find(|other| overlap(other, first)) == Some(plant) {
            matches.push(Match { old: plant.start, new: first.start, is_strike: true });
        }
        if old.iter().rfind(|other| overlap(other, last)) == Some(plant) {
            matches.push(Match { old: plant.end, new: last.end, is_strike: false });
        }
    }
    matches
}

/// Returns the boundaries that a person stated.
pub(super) fn learn(example: &Example, profile: &Arc<Profile>) -> Vec<EdgeExample> {
    let Example { part, before, after, stated, .. } = example;
    let frame_time = profile.frame_time;
    let is_inside = |frame: usize| frame > 0 && frame < stated.len();
    // A boundary that moved was moved by an edit; one that stayed is confirmed if both sides are stated.
    let is_stated = |edge: &Match| {
        let is_confirmed = || stated[edge.new - 1] && stated[edge.new];
        is_inside(edge.old) && is_inside(edge.new) && (edge.old != edge.new || is_confirmed())
    };
    let edges = matches(&before.planted, &after.planted).into_iter().filter(is_stated);
    let examples = edges.map(|Match { old, new, is_strike }| {
        let (detected, deviation) = instant(before, old, frame_time);
        // A confirmed boundary is known more exactly than to the frame.
        let corrected = if old == new { detected } else { (new as f64 - 0.5) * frame_time };
        EdgeExample {
            part: *part,
            is_strike,
            profile: profile.clone(),
            detected_window: window(profile, detected, REACH),
            corrected_window: window(profile, corrected, ALIGNED_REACH),
            detected,
            deviation,
            corrected,
            allowed: [new as f64 - 1.0 + FRAME_MARGIN, new as f64 - FRAME_MARGIN]
                .map(|frame| frame * frame_time),
        }
    });
    examples.collect()
}

/// Estimate of the instants of similar boundaries, in order of preference.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Rule {
    /// The detected instant.
    Keep,
    /// A constant time after the detected instant ([`Examples::common_offset`]).
    Shift,
    /// The instant at which the motion is most similar to that of the corrected boundaries.
    Align,
}

/// Corrected boundaries of one kind.
struct Examples<'a> {
    examples: Vec<&'a EdgeExample>,
    /// For each boundary and each other one, the time that alignment with the other one gives; computed when
    /// it is needed.
    aligned: Vec<OnceCell<f64>>,
}

impl<'a> Examples<'a> {
    fn new(examples: &[&'a EdgeExample], is_strike: bool) -> Examples<'a> {
        let of_kind = examples.iter().copied().filter(|example| example.is_strike == is_strike);
        let mut examples: Vec<&EdgeExample> = of_kind.collect();
        let surplus = examples.len().saturating_sub(MAX_EXAMPLES);
        examples.drain(..surplus);
        let aligned = vec![OnceCell::new(); examples.len() * examples.len()];
        Examples { examples, aligned }
    }

    /// Returns the time of a boundary that alignment with another one gives.
    fn aligned(&self, index: usize, other: usize) -> f64 {
        let align = || {
            let example = self.examples[index];
            self.examples[other].align(&example.profile, example.detected)
        };
        *self.aligned[index * self.examples.len() + other].get_or_init(align)
    }

    /// Returns the indices of the boundaries that are similar to one at `time`, the most similar first.
    fn similar(&self, profile: &Profile, time: f64) -> Vec<usize> {
        let window = window(profile, time, REACH);
        let affinities: Vec<f64> = self
            .examples
            .iter()
            .map(|example| affinity(&example.detected_window, &window, BANDWIDTH))
            .collect();
        let similar = (0..affinities.len()).filter(|&index| affinities[index] >= MIN_AFFINITY).collect();
        let mut similar = sort::sort_descending(similar, |&index: &usize| affinities[index]);
        similar.truncate(MAX_SIMILAR);
        similar
    }

    /// Returns the rule that is best for some boundaries, of which each one is corrected by means of the others
    /// (leave-one-out cross-validation). Needs at least two.
    fn best_rule(&self, similar: &[usize]) -> Rule {
        let count = similar.len() as f64;
        let mean =
            |value: &dyn Fn(usize) -> f64| similar.iter().map(|&index| value(index)).sum::<f64>() / count;
        // Mean square error of the times that a rule gives, by the index of a boundary and those of the others.
        let mean_square = |time: &dyn Fn(usize, &[usize]) -> f64| {
            mean(&|index| {
                let others: Vec<usize> = similar.iter().copied().filter(|&other| other != index).collect();
                self.examples[index].excess(time(index, &others)).powi(2)
            })
        };
        let detected = |index: usize| self.examples[index].detected;
        let keep = mean_square(&|index, _| detected(index));
        let shift = mean_square(&|index, others| detected(index) + self.common_offset(others));
        let align = mean_square(&|index, others| {
            others.iter().map(|&other| self.aligned(index, other)).sum::<f64>() / (count - 1.0)
        });
        // The errors that the corrections show must be larger than the uncertainty of a boundary explains.
        let variance = mean(&|index| self.examples[index].deviation.powi(2));
        let is_significant = count * keep > MIN_SIGNIFICANCE * variance;
        let is_better = |error: f64| is_significant && error < MAX_ERROR_RATIO.powi(2) * keep;
        if is_better(align) && align < shift {
            Rule::Align
        } else if is_better(shift) {
            Rule::Shift
        } else {
            Rule::Keep
        }
    }

    /// Returns the smallest offset that agrees best with the corrections of some boundaries, in seconds: the one
    /// with the least sum of squared errors (interval-censored least squares).
    fn common_offset(&self, indices: &[usize]) -> f64 {
        let excesses = |offset: f64| {
            let examples = indices.iter().map(|&index| self.examples[index]);
            examples.map(move |example| example.excess(example.detected + offset))
        };
        // The sum of the excesses grows with the offset. Bisection for its zero that is nearest to 0.
        let sign = excesses(0.0).sum::<f64>().signum();
        let (mut near, mut far) = (0.0, -sign * excesses(0.0).map(f64::abs).fold(0.0, f64::max));
        for _ in 0..BISECTIONS {
            let middle = f64::midpoint(near, far);
            if sign * excesses(middle).sum::<f64>() > 0.0 {
                near = middle;
            } else {
                far = middle;
            }
        }
        far
    }

    /// Returns the corrected time of a boundary that was detected at `time`; the same time if no correction
    /// applies.
    fn corrected_time(&self, profile: &Profile, time: f64) -> f64 {
        let similar = self.similar(profile, time);
        match similar[..] {
            [] => time,
            // A single correction must be larger than the uncertainty of the boundary explains (firm shrinkage,
            // Gao and Bruce 1997).
            [index] => {
                let example = self.examples[index];
                let [low, high] = SIGNIFICANT.map(|deviations| deviations * example.offset_deviation());
                let offset = example.offset();
                time + offset * ((offset.abs() - low) / (high - low)).clamp(0.0, 1.0)
            }
            _ => match self.best_rule(&similar) {
                Rule::Keep => time,
                Rule::Shift => time + self.common_offset(&similar),
                Rule::Align => {
                    let aligned = similar.iter().map(|&index| self.examples[index].align(profile, time));
                    aligned.sum::<f64>() / similar.len() as f64
                }
            },
        }
    }
}

/// Moves the boundaries that are similar to corrected ones; those of `fixed` frames and outside of
/// `scope` stay.
pub(super) fn apply(
    examples: &[&EdgeExample],
    profile: &Profile,
    fixed: &[Option<bool>],
    scope: &Range<usize>,
    labels: &mut FootLabels,
) {
    if examples.iter().all(|example| example.offset() == 0.0) {
        return;
    }
    let [offs, strikes] = [false, true].map(|is_strike| Examples::new(examples, is_strike));
    let frame_time = profile.frame_time;
    let frames = labels.planted.len();
    let old: Vec<usize> =
        (1..frames).filter(|&frame| labels.planted[frame] != labels.planted[frame - 1]).collect();
    let mut moved: Vec<(usize, Option<Edge>)> = Vec::with_capacity(old.len());
    for (index, &frame) in old.iter().enumerate() {
        let unchanged = (frame, labels.edge(frame).copied());
        let (time, uncertainty) = instant(labels, frame, frame_time);
        let of_kind = if labels.planted[frame] { &strikes } else { &offs };
        let is_fixed = !scope.contains(&frame) || fixed[frame - 1].or(fixed[frame]).is_some();
        let corrected = if is_fixed { time } else { of_kind.corrected_time(profile, time) };
        // Contact changes with the first frame after the instant.
        let new = ((corrected / frame_time).floor() + 1.0).clamp(1.0, frames as f64 - 1.0) as usize;
        let previous = moved.last().map_or(0, |(frame, _)| *frame);
        let next = old.get(index + 1).copied().unwrap_or(frames);
        let is_stated = fixed[frame.min(new)..frame.max(new)].iter().any(Option::is_some);
        let is_free = new > previous && new < next && !is_stated;
        moved.push(if corrected == time || !is_free {
            unchanged
        } else {
            (new, unchanged.1.map(|_| Edge { frame: new, time: corrected, uncertainty }))
        });
    }
    let mut planted = labels.planted[0];
    let mut start = 0;
    for (frame, _) in &moved {
        labels.planted[start..*frame].fill(planted);
        (start, planted) = (*frame, !planted);
    }
    labels.planted[start..].fill(planted);
    labels.edges = moved.into_iter().filter_map(|(_, edge)| edge).collect();
}
