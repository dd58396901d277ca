//! Stretches of motifs that repeat themselves (patent, section 4.3).

use std::ops::Range;
use std::ops::RangeInclusive;

use crate::segments::methods::lsd::actions::Action;

use crate::numeric::sort;

/// Motifs in a period.
const PERIODS: RangeInclusive<usize> = 2..=8;

/// The stretches of `classes` that consist of two or more rounds of one cycle, in order.
///
/// In each round one motif may be another. The longest stretch is taken first, and of equally long
/// ones that of the shorter period, then the earlier.
pub(crate) fn repeats(classes: &[usize]) -> Vec<Action> {
    let mut found = Vec::new();
    let mut open = vec![0..classes.len()];
    while let Some(range) = open.pop() {
        let longest = PERIODS.filter_map(|period| Some((longest(classes, &range, period)?, period)));
        let best = longest.reduce(|best, next| if next.0.len() > best.0.len() { next } else { best });
        let Some((motifs, period)) = best else { continue };
        open.extend([range.start..motifs.start, motifs.end..range.end]);
        found.push(Action { cycle: cycle(&classes[motifs.clone()], period), motifs });
    }
    sort::by_frames(found, |action| (action.motifs.start, 0))
}

/// The first of the longest stretches in which each motif is like the one a period later.
///
/// Where one is not, no other within a period may be, nor are the first and the last of them.
fn longest(classes: &[usize], range: &Range<usize>, period: usize) -> Option<Range<usize>> {
    let mut best: Option<Range<usize>> = None;
    let (mut start, mut odd) = (range.start, None);
    for motif in range.start..range.end.saturating_sub(period) {
        if classes[motif] == classes[motif + period] {
            let stretch = start..motif + 1 + period;
            let enough = best.as_ref().map_or(2 * period, |best| best.len() + 1);
            if stretch.len() >= enough {
                best = Some(stretch);
            }
            continue;
        }
        if let Some(odd) = odd.filter(|&odd| odd >= start && motif - odd < period) {
            start = odd + 1;
        }
        if start == motif {
            start += 1;
        }
        odd = Some(motif);
    }
    best
}

/// The class that is most frequent at each place of the period, from the least on.
fn cycle(classes: &[usize], period: usize) -> Vec<usize> {
    let most_frequent = |place: usize| {
        let mut here: Vec<usize> = classes.iter().skip(place).step_by(period).copied().collect();
        here.sort_unstable();
        // Of equally frequent ones the last counts, from behind: the least class.
        here.chunk_by(|a, b| a == b).rev().max_by_key(|run| run.len()).map_or(0, |run| run[0])
    };
    let cycle: Vec<usize> = (0..period).map(most_frequent).collect();
    let turned = |from: usize| cycle[from..].iter().chain(&cycle[..from]).copied();
    (0..period).map(|from| turned(from).collect()).min().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn found(text: &str) -> Vec<(Range<usize>, Vec<usize>)> {
        let classes: Vec<usize> = text.split(' ').map(|word| word.parse().unwrap()).collect();
        repeats(&classes).into_iter().map(|action| (action.motifs, action.cycle)).collect()
    }

    #[test]
    fn the_patents_own_motifs() {
        let text = "1 2 1 2 1 2 1 3 4 5 6 7 4 5 8 9 8 9 8 10 11 12 13 10 11 14 15 16 17 18 15 19 20 \
                    21 22 23 24 21 22 23 24 21 22 25 26 27 26 27";
        let expected = [
            (0..7, vec![1, 2]),
            (14..19, vec![8, 9]),
            (33..43, vec![21, 22, 23, 24]),
            (44..48, vec![26, 27]),
        ];
        assert_eq!(found(text), expected);
    }

    #[test]
    fn a_round_may_have_one_motif_that_is_another() {
        assert_eq!(found("1 2 3 4 1 2 5 4 1 2 3 4"), [(0..12, vec![1, 2, 3, 4])]);
        assert_eq!(found("1 2 3 4 1 6 5 4 1 2 3 4"), []);
        // At the ends, another motif belongs to what is beyond.
        assert_eq!(found("7 1 2 3 4 1 2 3 4 9 8"), [(1..9, vec![1, 2, 3, 4])]);
    }

    #[test]
    fn two_rounds_are_needed() {
        assert_eq!(found("1 2 1"), []);
        assert_eq!(found("1 2 1 2"), [(0..4, vec![1, 2])]);
        assert_eq!(found("4 1 2 3 4 1 2"), []);
        assert_eq!(repeats(&[]), []);
    }

    #[test]
    fn the_longest_comes_first_then_the_shorter_period() {
        assert_eq!(found("3 4 3 4 1 2 1 2 1 2"), [(0..4, vec![3, 4]), (4..10, vec![1, 2])]);
        assert_eq!(found("1 2 1 2 1 2 1 2 1 2 1 2"), [(0..12, vec![1, 2])]);
        assert_eq!(found("2 1 2 1"), [(0..4, vec![1, 2])]);
    }

    proptest! {
        #[test]
        fn stretches_are_apart_and_repeat(classes in prop::collection::vec(1_usize..5, 0..60)) {
            let found = repeats(&classes);
            prop_assert!(found.windows(2).all(|pair| pair[0].motifs.end <= pair[1].motifs.start));
            for Action { motifs, cycle } in found {
                prop_assert!(PERIODS.contains(&cycle.len()) && motifs.len() >= 2 * cycle.len());
                prop_assert!(motifs.end <= classes.len());
                let pairs = classes[motifs.clone()].iter().zip(&classes[motifs.start + cycle.len()..motifs.end]);
                let differ: Vec<bool> = pairs.map(|(a, b)| a != b).collect();
                prop_assert!(!differ[0] && !differ[differ.len() - 1]);
                let most = differ.windows(cycle.len()).map(|round| round.iter().filter(|&&odd| odd).count()).max();
                prop_assert!(most <= Some(1));
            }
        }
    }
}
