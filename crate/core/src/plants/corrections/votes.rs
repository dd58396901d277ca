//! Labels of single frames by the nearest frames whose label a person stated.

use std::ops::Range;

use crate::foot::{Part, Side};
use crate::intervals::intervals;
use crate::numeric::sort;
use crate::plants::FootLabels;
use crate::plants::corrections::example::{Example, MIN_AFFINITY};
use crate::plants::corrections::profile::{Profile, difference};

/// Number of the nearest stated frames that vote, and of those that must agree; chosen from 3 and 4 on generated
/// motion (seeds 0 to 9), as is the bandwidth from 0.15, 0.2 and 0.3.
const NEIGHBOURS: usize = 5;
const MIN_VOTES: usize = 4;
/// Time before and after a frame at which the motion is compared as well, in seconds.
const REACH: f64 = 0.05;
/// Root mean square difference of two frames at which the affinity is 1/e.
const BANDWIDTH: f64 = 0.2;
/// Largest number of stated frames that are used, the latest ones, and of folds of the cross-validation.
const MAX_STATED: usize = 512;
const MAX_FOLDS: usize = 8;
/// Minimum number of folds of a kind. One corrected plant per foot gives two.
const MIN_FOLDS: usize = 3;

/// What votes change: a foot off, a foot strike, or an entire run.
const OFF: usize = 0;
const STRIKE: usize = 1;
const RUN: usize = 2;

/// A frame whose label a person stated.
#[derive(Clone, Debug)]
pub(super) struct StatedFrame {
    pub part: Part,
    planted: bool,
    window: Vec<f32>,
}

/// Returns the motion at a frame, and just before and after it.
fn window(profile: &Profile, frame: usize) -> Vec<f32> {
    let time = frame as f64 * profile.frame_time;
    profile.window([time - REACH, time, time + REACH].into_iter())
}

/// Returns the stated frames.
pub(super) fn learn(example: &Example, profile: &Profile) -> Vec<StatedFrame> {
    let frames = (0..example.stated.len()).filter(|&frame| example.stated[frame]);
    let stated = |frame: usize| StatedFrame {
        part: example.part,
        planted: example.after.planted[frame],
        window: window(profile, frame),
    };
    frames.map(stated).collect()
}

/// Result of a cross-validation, per kind of change.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Validation {
    folds: [usize; 3],
    /// Numbers of wrong frames without and with votes.
    wrong: [[usize; 2]; 3],
}

impl Validation {
    /// Adds a fold with its numbers of wrong frames without and with votes.
    pub fn add_fold(&mut self, fold: &Fold, wrong: [usize; 2]) {
        self.folds[fold.kind] += 1;
        (0..2).for_each(|index| self.wrong[fold.kind][index] += wrong[index]);
    }

    /// Adds the folds of another clip.
    pub fn extend(&mut self, other: &Validation) {
        for kind in [OFF, STRIKE, RUN] {
            self.folds[kind] += other.folds[kind];
            (0..2).for_each(|index| self.wrong[kind][index] += other.wrong[kind][index]);
        }
    }

    /// Returns which kinds of changes make labels better.
    pub fn better(&self) -> [bool; 3] {
        [OFF, STRIKE, RUN].map(|kind| {
            let [without, with] = self.wrong[kind];
            self.folds[kind] >= MIN_FOLDS && with < without
        })
    }
}

/// Stated frames that are left out in a cross-validation.
pub(super) struct Fold {
    pub frames: Range<usize>,
    kind: usize,
}

/// Returns the folds of a cross-validation: windows of stated frames, cut at the middles of the runs of equal
/// labels that they contain. Each fold has one boundary or none.
pub(super) fn folds(example: &Example) -> Vec<Fold> {
    let planted = &example.after.planted;
    let mut folds = Vec::new();
    for window in intervals(&example.stated) {
        let changes = (window.start + 1..window.end).filter(|&frame| planted[frame] != planted[frame - 1]);
        let changes: Vec<usize> = changes.collect();
        let mut start = window.start;
        for (index, &change) in changes.iter().enumerate() {
            let end = changes.get(index + 1).map_or(window.end, |next| change.midpoint(*next));
            folds.push(Fold { frames: start..end, kind: usize::from(planted[change]) });
            start = end;
        }
        if changes.is_empty() {
            folds.push(Fold { frames: window, kind: RUN });
        }
    }
    let surplus = folds.len().saturating_sub(MAX_FOLDS);
    folds.drain(..surplus);
    folds
}

/// Removes the folds of kinds of which there are too few; most corrections are too few for votes.
pub(super) fn retain_frequent(folds: &mut Vec<(Side, Part, Fold)>) {
    let mut counts = [0; 3];
    folds.iter().for_each(|(.., fold)| counts[fold.kind] += 1);
    folds.retain(|(.., fold)| counts[fold.kind] >= MIN_FOLDS);
}

/// Labels the frames in `scope` that are similar to stated ones as most of the nearest ones. Changes only the
/// given kinds, and adds no run.
pub(super) fn apply(
    stated: &[&StatedFrame],
    profile: &Profile,
    fixed: &[Option<bool>],
    (scope, kinds): (&Range<usize>, [bool; 3]),
    labels: &mut FootLabels,
) {
    if kinds == [false; 3] {
        return;
    }
    let stated = &stated[stated.len().saturating_sub(MAX_STATED)..];
    let planted = &mut labels.planted;
    let is_changed: Vec<bool> = (0..planted.len())
        .map(|frame| {
            scope.contains(&frame)
                && fixed[frame].is_none()
                && vote(stated, &window(profile, frame)).is_some_and(|vote| vote != planted[frame])
        })
        .collect();
    let before = planted.clone();
    for run in intervals(&is_changed).into_iter().flat_map(|range| equal_runs(&before, range)) {
        let was_planted = before[run.start];
        let differs = |frame: Option<&bool>| frame.is_some_and(|&planted| planted != was_planted);
        let starts = differs(run.start.checked_sub(1).and_then(|frame| before.get(frame)));
        let ends = differs(before.get(run.end));
        let kind = match (starts, ends) {
            (false, false) => continue,
            (true, true) => RUN,
            (true, false) => usize::from(was_planted),
            (false, true) => usize::from(!was_planted),
        };
        if kinds[kind] {
            planted[run].fill(!was_planted);
        }
    }
    let planted = &labels.planted;
    labels.edges.retain(|edge| planted[edge.frame] != planted[edge.frame - 1]);
}

/// Returns the parts of a range with equal labels.
fn equal_runs(planted: &[bool], range: Range<usize>) -> Vec<Range<usize>> {
    let mut start = range.start;
    let runs = planted[range].chunk_by(|a, b| a == b).map(|run| {
        start += run.len();
        start - run.len()..start
    });
    runs.collect()
}

/// Returns the label of most of the nearest frames; `None` if too few are similar or agree.
fn vote(stated: &[&StatedFrame], window: &[f32]) -> Option<bool> {
    let limit = -MIN_AFFINITY.ln() * BANDWIDTH.powi(2);
    let differences = stated.iter().map(|frame| difference(&frame.window, window)).zip(0..);
    let mut near: Vec<(f64, usize)> = differences.filter(|(difference, _)| *difference <= limit).collect();
    if near.len() < NEIGHBOURS {
        return None;
    }
    sort::truncate_to_smallest(&mut near, NEIGHBOURS);
    let planted = near.iter().filter(|&&(_, index)| stated[index].planted).count();
    (planted.max(NEIGHBOURS - planted) >= MIN_VOTES).then_some(planted >= MIN_VOTES)
}
