//! Actions from motifs (patent, section 4.3).

use std::collections::HashMap;
use std::ops::Range;

use crate::segments::methods::lsd::action::Action;
use crate::segments::methods::lsd::periods;

/// Minimum number of motifs between periodic actions; fewer are a transition …
const MIN_MOTIFS: usize = 2;

/// … as are motifs of a shorter total duration, in seconds. No split leaves a shorter part.
const MIN_PART: f64 = 0.5;

/// Ratio of neighbouring amplitudes above which they belong to two actions.
const AMPLITUDE_RATIO: f64 = 3.0;

/// Minimum duration of an action, in seconds.
const MIN_ACTION: f64 = 1.5;

/// Motifs of a clip.
#[derive(Clone, Debug)]
pub(crate) struct Sequence {
    /// Times of the turning points, in seconds.
    pub times: Vec<f64>,
    /// Change of the curve over each motif.
    pub changes: Vec<f64>,
    /// Class of each motif.
    pub classes: Vec<usize>,
}

/// Returns the actions of a clip, at least one. Motifs between two actions are a transition.
///
/// If `published`, motifs that do not repeat are split by their amplitudes alone. Otherwise they
/// are split only where no motif occurs on both sides, as different actions consist of different
/// motifs (patent, section 1).
pub(crate) fn actions(sequence: &Sequence, published: bool) -> Vec<Action> {
    let count = sequence.classes.len();
    let mut actions = Vec::new();
    let mut next = 0;
    for repeat in periods::repetitions(&sequence.classes) {
        actions.extend(sequence.split(next..repeat.motifs.start, published));
        next = repeat.motifs.end;
        actions.push(repeat);
    }
    actions.extend(sequence.split(next..count, published));
    let mut actions = sequence.merge_short(actions);
    // Two periodic actions with the same cycle and no other action between them are merged.
    actions.dedup_by(|next, last| {
        let is_same = !next.cycle.is_empty() && next.cycle == last.cycle;
        if is_same {
            last.motifs.end = next.motifs.end;
        }
        is_same
    });
    if actions.is_empty() {
        actions.push(Action { motifs: 0..count, cycle: Vec::new() });
    }
    actions
}

impl Sequence {
    fn seconds(&self, motifs: &Range<usize>) -> f64 {
        self.times[motifs.end] - self.times[motifs.start]
    }

    /// Returns the actions between periodic ones.
    fn split(&self, between: Range<usize>, published: bool) -> Vec<Action> {
        let mut parts = Vec::new();
        if between.len() < MIN_MOTIFS || self.seconds(&between) < MIN_PART {
            return parts;
        }
        let last: HashMap<usize, usize> = between.clone().map(|motif| (self.classes[motif], motif)).collect();
        let mut part = |motifs| parts.push(Action { motifs, cycle: Vec::new() });
        let (mut start, mut last_occurrence) = (between.start, between.start);
        for boundary in between.start + 1..between.end {
            last_occurrence = last_occurrence.max(last[&self.classes[boundary - 1]]);
            let (a, b) = (self.changes[boundary - 1].abs(), self.changes[boundary].abs());
            let is_split = a.max(b) > AMPLITUDE_RATIO * a.min(b) && (published || last_occurrence < boundary);
            if is_split
                && [start..boundary, boundary..between.end].iter().all(|part| self.seconds(part) >= MIN_PART)
            {
                part(start..boundary);
                start = boundary;
            }
        }
        part(start..between.end);
        parts
    }

    /// Merges actions that are too short, the shortest first, with the shorter of the neighbours
    /// from which they were split. An action without such a neighbour becomes a transition.
    fn merge_short(&self, mut actions: Vec<Action>) -> Vec<Action> {
        let seconds = |action: &Action| self.seconds(&action.motifs);
        while actions.len() > 1 {
            let shortest =
                (0..actions.len()).min_by(|&a, &b| seconds(&actions[a]).total_cmp(&seconds(&actions[b])));
            let Some(short) = shortest.filter(|&action| seconds(&actions[action]) < MIN_ACTION) else {
                break;
            };
            let is_split = |first: &usize| match &actions[*first..] {
                [a, b, ..] => a.motifs.end == b.motifs.start && a.cycle.is_empty() && b.cycle.is_empty(),
                _ => false,
            };
            let boundaries = [short.checked_sub(1), Some(short)].into_iter().flatten().filter(is_split);
            // The short action is next to either boundary, so the merged durations compare its neighbours.
            let merged_duration = |first: usize| seconds(&actions[first]) + seconds(&actions[first + 1]);
            match boundaries.min_by(|&a, &b| merged_duration(a).total_cmp(&merged_duration(b))) {
                Some(first) => actions[first].motifs.end = actions.remove(first + 1).motifs.end,
                None => drop(actions.remove(short)),
            }
        }
        actions
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Motifs of 0.6 s each, alternately rising and falling.
    fn sequence(classes: &[usize], amplitudes: &[f64]) -> Sequence {
        let sign = |motif: usize| if motif.is_multiple_of(2) { 1.0 } else { -1.0 };
        Sequence {
            times: (0..=classes.len()).map(|turn| turn as f64 * 0.6).collect(),
            changes: amplitudes
                .iter()
                .enumerate()
                .map(|(motif, amplitude)| sign(motif) * amplitude)
                .collect(),
            classes: classes.to_vec(),
        }
    }

    fn ranges(sequence: &Sequence, published: bool) -> Vec<Range<usize>> {
        actions(sequence, published).into_iter().map(|action| action.motifs).collect()
    }

    #[test]
    fn repeating_motifs_and_those_between_are_actions() {
        let walk_bend_walk = sequence(&[1, 2, 1, 2, 3, 4, 5, 1, 2, 1, 2], &[20.0; 11]);
        let found = actions(&walk_bend_walk, false);
        let motifs: Vec<_> = found.iter().map(|action| action.motifs.clone()).collect();
        assert_eq!(motifs, [0..4, 4..7, 7..11]);
        assert_eq!((&found[0].cycle[..], &found[1].cycle[..]), (&[1, 2][..], &[][..]));
    }

    #[test]
    fn a_single_motif_between_actions_is_a_transition() {
        let motifs = sequence(&[1, 2, 1, 2, 9, 3, 4, 3, 4], &[20.0; 9]);
        assert_eq!(ranges(&motifs, false), [0..4, 5..9]);
    }

    #[test]
    fn short_motifs_between_actions_are_a_transition() {
        let mut motifs = sequence(&[1, 2, 1, 2, 8, 9, 3, 4, 3, 4], &[20.0; 10]);
        motifs.times[5..].iter_mut().for_each(|time| *time -= 0.5);
        motifs.times[6..].iter_mut().for_each(|time| *time -= 0.5);
        assert_eq!(ranges(&motifs, false), [0..4, 6..10]);
    }

    #[test]
    fn amplitudes_split_motifs_that_do_not_repeat() {
        let amplitudes = [20.0, 22.0, 18.0, 70.0, 75.0, 80.0];
        assert_eq!(ranges(&sequence(&[1, 2, 3, 4, 5, 6], &amplitudes), false), [0..3, 3..6]);
        // With the same motif on both sides there is one action, except as published.
        let repeated = sequence(&[1, 2, 3, 4, 3, 6], &amplitudes);
        assert_eq!((ranges(&repeated, false), ranges(&repeated, true)), (vec![0..6], vec![0..3, 3..6]));
    }

    #[test]
    fn short_parts_are_merged_with_their_neighbours() {
        let motifs = sequence(&[1, 2, 3, 4, 5, 6, 7], &[20.0, 20.0, 90.0, 20.0, 20.0, 20.0, 20.0]);
        assert_eq!(ranges(&motifs, false), [0..3, 3..7]);
    }

    #[test]
    fn a_cycle_continues_after_a_transition() {
        let motifs = sequence(&[1, 2, 1, 2, 1, 9, 8, 2, 1, 2, 1], &[20.0; 11]);
        let found = actions(&motifs, false);
        assert_eq!((found.len(), found[0].motifs.clone(), &found[0].cycle[..]), (1, 0..11, &[1, 2][..]));
    }

    #[test]
    fn few_motifs_are_one_action() {
        for count in 0..4 {
            let classes: Vec<usize> = (1..=count).collect();
            assert_eq!(ranges(&sequence(&classes, &[0.0; 4]), false), [0..count]);
        }
    }
}
