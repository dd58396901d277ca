//! Runs of frames with a wrong label.

use std::ops::Range;

use crate::foot::{Part, Side};
use crate::numeric::sort;
use crate::plants::FootLabels;
use crate::plants::corrections::edges;
use crate::plants::corrections::example::{Example, MIN_AFFINITY};
use crate::plants::corrections::profile::{Profile, affinity};

/// Number of samples of a run that are compared, at equal distances from its start to its end.
const SAMPLES: usize = 16;
/// Time before and after a run that is compared as well, in seconds, and the number of its samples.
const MARGIN: f64 = 0.1;
const MARGIN_SAMPLES: usize = 4;
/// Maximum ratio of the durations of similar runs.
const MAX_RATIO: f64 = 1.75;
/// Root mean square difference of two runs at which the affinity is 1/e.
const BANDWIDTH: f64 = 0.15;
/// Minimum duration of a wrong run; shorter ones are errors of a boundary. In seconds.
const MIN_RUN: f64 = 0.05;

/// A run of frames whose label a person corrected or confirmed.
#[derive(Clone, Debug)]
pub(super) struct RunExample {
    pub part: Part,
    pub side: Side,
    /// Label of the method.
    was_planted: bool,
    /// True if the person confirmed the label.
    pub is_confirmed: bool,
    /// True if the run is an entire run of the labels of the method, false if it is a part of one.
    is_whole: bool,
    /// Duration, in seconds.
    duration: f64,
    window: Vec<f32>,
    /// Largest affinity to the motion of other frames whose label a person confirmed; motion with a smaller
    /// affinity does not belong to the correction.
    affinity_to_confirmed: f64,
}

impl RunExample {
    /// Returns its number of frames in a clip.
    fn frames(&self, profile: &Profile) -> usize {
        (self.duration / profile.frame_time).round().max(1.0) as usize
    }
}

/// Returns the motion of a run of frames, and of the time just before and after it.
fn window(profile: &Profile, run: &Range<usize>) -> Vec<f32> {
    let frame_time = profile.frame_time;
    let (start, end) = ((run.start as f64 - 0.5) * frame_time, (run.end as f64 - 0.5) * frame_time);
    let step = (end - start) / SAMPLES as f64;
    let within = (0..SAMPLES).map(move |index| start + (index as f64 + 0.5) * step);
    let margin =
        |time: f64| (1..=MARGIN_SAMPLES).map(move |index| time * index as f64 / MARGIN_SAMPLES as f64);
    let before = margin(-MARGIN).map(move |time| start + time);
    let after = margin(MARGIN).map(move |time| end + time);
    profile.window(before.chain(within).chain(after))
}

/// Returns the runs of equal labels.
fn runs(planted: &[bool]) -> impl Iterator<Item = Range<usize>> {
    planted.chunk_by(|a, b| a == b).scan(0, |start, run| {
        let range = *start..*start + run.len();
        *start = range.end;
        Some(range)
    })
}

/// Returns the runs that a person corrected or confirmed.
pub(super) fn learn(example: &Example, profile: &Profile) -> Vec<RunExample> {
    let Example { part, side, before, after, stated } = example;
    let is_wrong = wrong_frames(&before.planted, &after.planted);
    let mut examples = Vec::new();
    for run in runs(&before.planted) {
        let create = |range: &Range<usize>, is_confirmed: bool| RunExample {
            part: *part,
            side: *side,
            was_planted: before.planted[run.start],
            is_confirmed,
            is_whole: *range == run,
            duration: range.len() as f64 * profile.frame_time,
            window: window(profile, range),
            affinity_to_confirmed: 0.0,
        };
        let wrong: Vec<Range<usize>> = runs(&is_wrong[run.clone()])
            .map(|range| range.start + run.start..range.end + run.start)
            .filter(|range| is_wrong[range.start])
            .collect();
        // A run of which a person stated half and changed nothing is right.
        let stated_frames = stated[run.clone()].iter().filter(|stated| **stated).count();
        if wrong.is_empty() && 2 * stated_frames >= run.len() {
            examples.push(create(&run, true));
        }
        let is_long = |range: &&Range<usize>| range.len() as f64 * profile.frame_time >= MIN_RUN;
        examples.extend(wrong.iter().filter(is_long).map(|range| create(range, false)));
    }
    for part in examples.iter_mut().filter(|run| !run.is_confirmed && !run.is_whole) {
        let was_planted = part.was_planted;
        let is_confirmed =
            |frame: usize| [before, after].iter().all(|labels| labels.planted[frame] == was_planted);
        // Number of confirmed frames before each frame.
        let mut counts = vec![0];
        counts.extend((0..stated.len()).scan(0, |count, frame| {
            *count += usize::from(stated[frame] && is_confirmed(frame));
            Some(*count)
        }));
        let length = part.frames(profile);
        let starts = 0..=(stated.len() - length);
        let confirmed = starts.filter(|&start| 2 * (counts[start + length] - counts[start]) >= length);
        part.affinity_to_confirmed = confirmed
            .map(|start| affinity(&part.window, &window(profile, &(start..start + length)), BANDWIDTH))
            .fold(0.0, f64::max);
    }
    examples
}

/// Returns the frames whose label was wrong, except for those between a boundary and its correction.
fn wrong_frames(before: &[bool], after: &[bool]) -> Vec<bool> {
    let mut wrong: Vec<bool> = before.iter().zip(after).map(|(before, after)| before != after).collect();
    for edges::Match { old, new, .. } in edges::matches(before, after) {
        wrong[old.min(new)..old.max(new)].fill(false);
    }
    wrong
}

/// Changes the labels of runs that are similar to corrected ones, except for those of `fixed` frames.
pub(super) fn apply(
    examples: &[&RunExample],
    profile: &Profile,
    fixed: &[Option<bool>],
    scope: &Range<usize>,
    labels: &mut FootLabels,
) {
    if examples.iter().all(|example| example.is_confirmed) {
        return;
    }
    let before = labels.planted.clone();
    for run in runs(&before).filter(|run| run.start < scope.end && scope.start < run.end) {
        let was_planted = before[run.start];
        let of_label = || examples.iter().filter(|example| example.was_planted == was_planted);
        let best = |range: &Range<usize>, of_kind: &dyn Fn(&RunExample) -> bool| {
            let (duration, window) = (range.len() as f64 * profile.frame_time, window(profile, range));
            let similar = of_label().filter(|example| of_kind(example)).filter(|example| {
                let ratio = duration / example.duration;
                (1.0 / MAX_RATIO..=MAX_RATIO).contains(&ratio)
            });
            similar.map(|example| affinity(&example.window, &window, BANDWIDTH)).fold(0.0, f64::max)
        };
        // A run that is stated in part can be wrong as well, unless the person confirmed that part.
        if !fixed[run.clone()].contains(&Some(was_planted)) {
            let corrected = best(&run, &|example| !example.is_confirmed && example.is_whole);
            if corrected >= MIN_AFFINITY && corrected > best(&run, &|example| example.is_confirmed) {
                labels.planted[run.clone()].fill(!was_planted);
                continue;
            }
        }
        change_parts(&of_label().copied().collect::<Vec<_>>(), profile, fixed, &run, scope, labels);
    }
    // A boundary that no longer exists has no instant.
    let planted = &labels.planted;
    labels.edges.retain(|edge| planted[edge.frame] != planted[edge.frame - 1]);
}

/// Changes the labels of parts of a run.
fn change_parts(
    examples: &[&RunExample],
    profile: &Profile,
    fixed: &[Option<bool>],
    run: &Range<usize>,
    scope: &Range<usize>,
    labels: &mut FootLabels,
) {
    for example in examples.iter().filter(|example| !example.is_confirmed && !example.is_whole) {
        let length = example.frames(profile);
        if length > run.len() {
            continue;
        }
        let was_planted = example.was_planted;
        let first = run.start.max(scope.start.saturating_sub(length));
        let starts = first..=(run.end - length).min(scope.end);
        let affinities: Vec<f64> = starts
            .map(|start| affinity(&example.window, &window(profile, &(start..start + length)), BANDWIDTH))
            .collect();
        let limit = example.affinity_to_confirmed.max(MIN_AFFINITY);
        // The most similar part first; parts do not overlap.
        let order = (0..affinities.len()).filter(|&index| affinities[index] >= limit).collect();
        let order = sort::sort_descending(order, |&index: &usize| affinities[index]);
        for index in order {
            let range = first + index..first + index + length;
            let is_free = fixed[range.clone()].iter().all(Option::is_none)
                && labels.planted[range.clone()].iter().all(|&planted| planted == was_planted);
            if is_free {
                labels.planted[range].fill(!was_planted);
            }
        }
    }
}
