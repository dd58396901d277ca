//! A person who corrects labels, simulated with the truth.

use std::ops::Range;

use plantigrade::foot::{Part, Side};
use plantigrade::intervals::intervals;
use plantigrade::plants::Edit;
use plantigrade::score::Truth;

/// Time that a person looks at before and after wrong frames, in seconds.
const VIEW: f64 = 0.6;

/// Returns the frames of one correction of wrong labels: those within 0.6 s of the longest run of wrong frames,
/// up to the middles of the plants or swings next to it; `None` if all labels are right.
pub fn next_correction(
    labels: [&[bool]; 2],
    truth: &[Truth; 2],
    frame_time: f64,
) -> Option<(Side, Range<usize>)> {
    let wrong = |side: Side| {
        let (labels, truth) = (labels[side as usize], &truth[side as usize]);
        let differs: Vec<bool> =
            labels.iter().zip(truth).map(|(label, truth)| *truth == Some(!label)).collect();
        intervals(&differs).into_iter().map(move |run| (side, run))
    };
    let (side, run) = Side::BOTH.into_iter().flat_map(wrong).max_by_key(|(_, run)| run.len())?;
    Some((side, around(&truth[side as usize], &run, frame_time)))
}

/// Returns the frames that a person judges with a run: to the middles of the neighbouring runs of the truth,
/// at most 0.6 s before and after it.
pub fn around(truth: &Truth, run: &Range<usize>, frame_time: f64) -> Range<usize> {
    let view = (VIEW / frame_time) as usize;
    // Middle of the run of equal labels that contains a frame.
    let bound = |frame: usize, step: isize| {
        let label = truth[frame];
        let mut end = frame;
        while let Some(next) = end.checked_add_signed(step).filter(|&next| truth.get(next) == Some(&label)) {
            end = next;
        }
        let next_run = end.checked_add_signed(step).filter(|&next| next < truth.len());
        match next_run {
            None => end,
            Some(first) => {
                let label = truth[first];
                let mut last = first;
                while let Some(next) =
                    last.checked_add_signed(step).filter(|&next| truth.get(next) == Some(&label))
                {
                    last = next;
                }
                first.midpoint(last)
            }
        }
    };
    let start = bound(run.start, -1).max(run.start.saturating_sub(view));
    let end = (bound(run.end - 1, 1) + 1).min(run.end + view);
    start..end.min(truth.len())
}

/// Returns the edits that state the truth of one foot within a range, where it is known.
pub fn state_truth(side: Side, part: Part, truth: &Truth, range: &Range<usize>) -> Vec<Edit> {
    let mut edits = Vec::new();
    let mut start = range.start;
    for run in truth[range.clone()].chunk_by(|a, b| a == b) {
        let end = start + run.len();
        edits.extend(run[0].map(|planted| Edit { side, part, start, end, planted }));
        start = end;
    }
    edits
}

/// Returns the frames of the first plant of a foot with a known edge, with half of the swings around it.
pub fn first_stance(truth: &Truth, frame_time: f64) -> Option<Range<usize>> {
    let known: Vec<bool> = truth.iter().map(|label| *label == Some(true)).collect();
    let is_swing = |frame: usize| truth.get(frame) == Some(&Some(false));
    let plants = intervals(&known).into_iter();
    let first =
        plants.into_iter().find(|run| run.start > 0 && is_swing(run.start - 1) || is_swing(run.end))?;
    Some(around(truth, &first, frame_time))
}
