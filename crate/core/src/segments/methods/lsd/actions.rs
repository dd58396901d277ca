//! From motifs to actions (patent, section 4.3).

use std::collections::HashMap;
use std::ops::Range;

use crate::segments::methods::lsd::periods;

/// What lies between periodic actions and has fewer motifs is a transition ...
const MOTIFS: usize = 2;

/// ... and so is what takes less, in seconds; no split leaves a shorter part.
const SHORT: f64 = 0.5;

/// Amplitudes next to each other that differ by more than this factor belong to two actions.
const RATIO: f64 = 3.0;

/// What takes less is no action, in seconds.
const ACTION: f64 = 1.5;

/// Motifs that make an action.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Action {
    /// Its motifs.
    pub motifs: Range<usize>,
    /// The classes that it repeats, from the least on; empty where it does not.
    pub cycle: Vec<usize>,
}

/// What is known of the motifs of a clip.
#[derive(Clone, Debug)]
pub(crate) struct Sequence {
    /// When the turning points are that they lie between, in seconds.
    pub times: Vec<f64>,
    /// How far the curve rises in each.
    pub rises: Vec<f64>,
    /// The class of each.
    pub classes: Vec<usize>,
}

/// The actions of a clip, at least one; motifs between two of them are a transition.
///
/// As `published`, what does not repeat is split by its amplitudes alone. Otherwise only where
/// no motif comes again, for different actions are made of different motifs (patent, section 1).
pub(crate) fn actions(sequence: &Sequence, published: bool) -> Vec<Action> {
    let count = sequence.classes.len();
    let mut actions = Vec::new();
    let mut done = 0;
    for repeat in periods::repeats(&sequence.classes) {
        actions.extend(sequence.split(done..repeat.motifs.start, published));
        done = repeat.motifs.end;
        actions.push(repeat);
    }
    actions.extend(sequence.split(done..count, published));
    let mut actions = sequence.lasting(actions);
    // Two periodic actions of one cycle with no other between them are one.
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

    /// The actions in what lies between periodic ones.
    fn split(&self, rest: Range<usize>, published: bool) -> Vec<Action> {
        let mut parts = Vec::new();
        if rest.len() < MOTIFS || self.seconds(&rest) < SHORT {
            return parts;
        }
        let last: HashMap<usize, usize> = rest.clone().map(|motif| (self.classes[motif], motif)).collect();
        let mut part = |motifs| parts.push(Action { motifs, cycle: Vec::new() });
        let (mut start, mut again) = (rest.start, rest.start);
        for joint in rest.start + 1..rest.end {
            again = again.max(last[&self.classes[joint - 1]]);
            let (a, b) = (self.rises[joint - 1].abs(), self.rises[joint].abs());
            let is_split = a.max(b) > RATIO * a.min(b) && (published || again < joint);
            if is_split && [start..joint, joint..rest.end].iter().all(|part| self.seconds(part) >= SHORT) {
                part(start..joint);
                start = joint;
            }
        }
        part(start..rest.end);
        parts
    }

    /// Puts together what is too short, the shortest first: a part goes to the shorter of those
    /// that it was split from; what stands alone becomes a transition.
    fn lasting(&self, mut actions: Vec<Action>) -> Vec<Action> {
        let seconds = |action: &Action| self.seconds(&action.motifs);
        while actions.len() > 1 {
            let shortest =
                (0..actions.len()).min_by(|&a, &b| seconds(&actions[a]).total_cmp(&seconds(&actions[b])));
            let Some(short) = shortest.filter(|&action| seconds(&actions[action]) < ACTION) else { break };
            let is_split = |first: &usize| match &actions[*first..] {
                [a, b, ..] => a.motifs.end == b.motifs.start && a.cycle.is_empty() && b.cycle.is_empty(),
                _ => false,
            };
            let joints = [short.checked_sub(1), Some(short)].into_iter().flatten().filter(is_split);
            // Either joint has the short part itself on one side.
            let both = |first: usize| seconds(&actions[first]) + seconds(&actions[first + 1]);
            match joints.min_by(|&a, &b| both(a).total_cmp(&both(b))) {
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

    /// Motifs of 0.6 s each, rising and falling in turn.
    fn sequence(classes: &[usize], amplitudes: &[f64]) -> Sequence {
        let sign = |motif: usize| if motif.is_multiple_of(2) { 1.0 } else { -1.0 };
        Sequence {
            times: (0..=classes.len()).map(|turn| turn as f64 * 0.6).collect(),
            rises: amplitudes.iter().enumerate().map(|(motif, amplitude)| sign(motif) * amplitude).collect(),
            classes: classes.to_vec(),
        }
    }

    fn ranges(sequence: &Sequence, published: bool) -> Vec<Range<usize>> {
        actions(sequence, published).into_iter().map(|action| action.motifs).collect()
    }

    #[test]
    fn what_repeats_is_an_action_and_so_is_what_lies_between() {
        let walk_bend_walk = sequence(&[1, 2, 1, 2, 3, 4, 5, 1, 2, 1, 2], &[20.0; 11]);
        let found = actions(&walk_bend_walk, false);
        let motifs: Vec<_> = found.iter().map(|action| action.motifs.clone()).collect();
        assert_eq!(motifs, [0..4, 4..7, 7..11]);
        assert_eq!((&found[0].cycle[..], &found[1].cycle[..]), (&[1, 2][..], &[][..]));
    }

    #[test]
    fn one_motif_between_is_a_transition() {
        let motifs = sequence(&[1, 2, 1, 2, 9, 3, 4, 3, 4], &[20.0; 9]);
        assert_eq!(ranges(&motifs, false), [0..4, 5..9]);
    }

    #[test]
    fn two_motifs_that_are_too_short_are_a_transition_too() {
        let mut motifs = sequence(&[1, 2, 1, 2, 8, 9, 3, 4, 3, 4], &[20.0; 10]);
        motifs.times[5..].iter_mut().for_each(|time| *time -= 0.5);
        motifs.times[6..].iter_mut().for_each(|time| *time -= 0.5);
        assert_eq!(ranges(&motifs, false), [0..4, 6..10]);
    }

    #[test]
    fn amplitudes_split_what_does_not_repeat() {
        let amplitudes = [20.0, 22.0, 18.0, 70.0, 75.0, 80.0];
        assert_eq!(ranges(&sequence(&[1, 2, 3, 4, 5, 6], &amplitudes), false), [0..3, 3..6]);
        // The same motif on both sides: one action, but for the letter of the patent.
        let again = sequence(&[1, 2, 3, 4, 3, 6], &amplitudes);
        assert_eq!((ranges(&again, false), ranges(&again, true)), (vec![0..6], vec![0..3, 3..6]));
    }

    #[test]
    fn short_parts_go_back_to_what_they_were_split_from() {
        let motifs = sequence(&[1, 2, 3, 4, 5, 6, 7], &[20.0, 20.0, 90.0, 20.0, 20.0, 20.0, 20.0]);
        assert_eq!(ranges(&motifs, false), [0..3, 3..7]);
    }

    #[test]
    fn the_same_cycle_after_a_transition_goes_on() {
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
