//! Ranges of motifs that repeat a cycle (patent, section 4.3).

use std::ops::{Range, RangeInclusive};

use crate::numeric::sort;
use crate::segments::methods::lsd::action::Action;

/// Number of motifs in a cycle.
const CYCLE_LENGTHS: RangeInclusive<usize> = 2..=8;

/// Returns the ranges of `classes` that consist of two or more rounds of one cycle, in order.
///
/// Each round may deviate in one motif. The longest range is taken first; of equally long ranges
/// the one with the shorter cycle, then the earlier one.
pub(crate) fn repetitions(classes: &[usize]) -> Vec<Action> {
    let mut actions = Vec::new();
    let mut open = vec![0..classes.len()];
    while let Some(range) = open.pop() {
        let candidates =
            CYCLE_LENGTHS.filter_map(|period| Some((longest_repetition(classes, &range, period)?, period)));
        let best = candidates.reduce(|best, next| if next.0.len() > best.0.len() { next } else { best });
        let Some((motifs, period)) = best else { continue };
        open.extend([range.start..motifs.start, motifs.end..range.end]);
        actions.push(Action { cycle: cycle(&classes[motifs.clone()], period), motifs });
    }
    sort::sort_by_frames(actions, |action| (action.motifs.start, 0))
}

/// Returns the first of the longest ranges in which each motif has the class of the motif one
/// period later.
///
/// A deviation is allowed if there is no other within a period, and not at the ends.
fn longest_repetition(classes: &[usize], range: &Range<usize>, period: usize) -> Option<Range<usize>> {
    let mut best: Option<Range<usize>> = None;
    let (mut start, mut deviation) = (range.start, None);
    for motif in range.start..range.end.saturating_sub(period) {
        if classes[motif] == classes[motif + period] {
            let repetition = start..motif + 1 + period;
            let min_length = best.as_ref().map_or(2 * period, |best| best.len() + 1);
            if repetition.len() >= min_length {
                best = Some(repetition);
            }
            continue;
        }
        if let Some(deviation) =
            deviation.filter(|&deviation| deviation >= start && motif - deviation < period)
        {
            start = deviation + 1;
        }
        if start == motif {
            start += 1;
        }
        deviation = Some(motif);
    }
    best
}

/// Returns the most frequent class at each position of the cycle, from the smallest class.
fn cycle(classes: &[usize], period: usize) -> Vec<usize> {
    let most_frequent = |position: usize| {
        let mut occurrences: Vec<usize> = classes.iter().skip(position).step_by(period).copied().collect();
        occurrences.sort_unstable();
        // In reverse order the last of equally frequent classes is the smallest.
        occurrences.chunk_by(|a, b| a == b).rev().max_by_key(|run| run.len()).map_or(0, |run| run[0])
    };
    let cycle: Vec<usize> = (0..period).map(most_frequent).collect();
    let rotated = |from: usize| cycle[from..].iter().chain(&cycle[..from]).copied();
    (0..period).map(|from| rotated(from).collect()).min().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn repetitions_in(text: &str) -> Vec<(Range<usize>, Vec<usize>)> {
        let classes: Vec<usize> = text.split(' ').map(|word| word.parse().unwrap()).collect();
        repetitions(&classes).into_iter().map(|action| (action.motifs, action.cycle)).collect()
    }

    #[test]
    fn finds_the_cycles_of_the_patent() {
        let text = "1 2 1 2 1 2 1 3 4 5 6 7 4 5 8 9 8 9 8 10 11 12 13 10 11 14 15 16 17 18 15 19 20 \
                    21 22 23 24 21 22 23 24 21 22 25 26 27 26 27";
        let expected = [
            (0..7, vec![1, 2]),
            (14..19, vec![8, 9]),
            (33..43, vec![21, 22, 23, 24]),
            (44..48, vec![26, 27]),
        ];
        assert_eq!(repetitions_in(text), expected);
    }

    #[test]
    fn a_round_may_deviate_in_one_motif() {
        assert_eq!(repetitions_in("1 2 3 4 1 2 5 4 1 2 3 4"), [(0..12, vec![1, 2, 3, 4])]);
        assert_eq!(repetitions_in("1 2 3 4 1 6 5 4 1 2 3 4"), []);
        // At the ends, a deviating motif belongs to the neighbouring action.
        assert_eq!(repetitions_in("7 1 2 3 4 1 2 3 4 9 8"), [(1..9, vec![1, 2, 3, 4])]);
    }

    #[test]
    fn two_rounds_are_needed() {
        assert_eq!(repetitions_in("1 2 1"), []);
        assert_eq!(repetitions_in("1 2 1 2"), [(0..4, vec![1, 2])]);
        assert_eq!(repetitions_in("4 1 2 3 4 1 2"), []);
        assert_eq!(repetitions(&[]), []);
    }

    #[test]
    fn longer_ranges_and_shorter_cycles_are_preferred() {
        assert_eq!(repetitions_in("3 4 3 4 1 2 1 2 1 2"), [(0..4, vec![3, 4]), (4..10, vec![1, 2])]);
        assert_eq!(repetitions_in("1 2 1 2 1 2 1 2 1 2 1 2"), [(0..12, vec![1, 2])]);
        assert_eq!(repetitions_in("2 1 2 1"), [(0..4, vec![1, 2])]);
    }

    proptest! {
        #[test]
        fn ranges_are_disjoint_and_repeat(classes in prop::collection::vec(1_usize..5, 0..60)) {
            let found = repetitions(&classes);
            prop_assert!(found.windows(2).all(|pair| pair[0].motifs.end <= pair[1].motifs.start));
            for Action { motifs, cycle } in found {
                prop_assert!(CYCLE_LENGTHS.contains(&cycle.len()) && motifs.len() >= 2 * cycle.len());
                prop_assert!(motifs.end <= classes.len());
                let pairs = classes[motifs.clone()].iter().zip(&classes[motifs.start + cycle.len()..motifs.end]);
                let differ: Vec<bool> = pairs.map(|(a, b)| a != b).collect();
                prop_assert!(!differ[0] && !differ[differ.len() - 1]);
                let max = differ.windows(cycle.len()).map(|round| round.iter().filter(|&&differs| differs).count()).max();
                prop_assert!(max <= Some(1));
            }
        }
    }
}
