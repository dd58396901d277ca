//! Comparison of classes of actions with reference classes.

use std::collections::BTreeMap;
use std::ops::Range;

use crate::score::Tally;
use crate::score::assignment::best_assignment;

/// Agreement of classes with reference classes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClassScore {
    /// Frames of the reference, and those whose class corresponds to the reference class after the
    /// assignment of classes to reference classes, one to one, that gives the most.
    pub frames: Tally,
    /// Adjusted Rand index over frames (Hubert and Arabie 1985): 1 for equal groups, 0 on average for
    /// random ones.
    pub adjusted_rand: f64,
}

/// Compares the classes of frame ranges with reference classes.
///
/// Classes are given by names, which need not be those of the reference. Frames without a range, or with
/// an empty name, do not count in the reference; in `detected` they have a class of their own.
pub fn classes<'a>(detected: &[(Range<usize>, &'a str)], truth: &[(Range<usize>, &'a str)]) -> ClassScore {
    let counts = contingency(detected, truth);
    let total: usize = counts.iter().flatten().sum();
    let values: Vec<Vec<f64>> =
        counts.iter().map(|row| row.iter().map(|&count| count as f64).collect()).collect();
    let assigned = best_assignment(&values);
    let correct = counts.iter().zip(assigned).filter_map(|(row, column)| Some(row[column?])).sum();
    ClassScore { frames: Tally { correct, total }, adjusted_rand: adjusted_rand(&counts) }
}

/// Returns the number of frames by reference class and class.
fn contingency(detected: &[(Range<usize>, &str)], truth: &[(Range<usize>, &str)]) -> Vec<Vec<usize>> {
    // Class 0 is that of frames without a class.
    let mut classes = BTreeMap::from([("", 0)]);
    for (_, name) in detected {
        let next = classes.len();
        classes.entry(name).or_insert(next);
    }
    let mut rows: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
    for (true_range, true_name) in truth.iter().filter(|(_, name)| !name.is_empty()) {
        let row = rows.entry(true_name).or_insert_with(|| vec![0; classes.len()]);
        let mut remaining = true_range.len();
        for (range, name) in detected {
            let overlap = range.end.min(true_range.end).saturating_sub(range.start.max(true_range.start));
            row[classes[name]] += overlap;
            remaining = remaining.saturating_sub(overlap);
        }
        row[0] += remaining;
    }
    rows.into_values().collect()
}

fn adjusted_rand(counts: &[Vec<usize>]) -> f64 {
    let pairs = |count: usize| count as f64 * (count as f64 - 1.0) / 2.0;
    let columns = counts.first().map_or(0, Vec::len);
    let column_total = |column: usize| counts.iter().map(|row| row[column]).sum::<usize>();
    let agreeing: f64 = counts.iter().flatten().map(|&count| pairs(count)).sum();
    let in_truth: f64 = counts.iter().map(|row| pairs(row.iter().sum())).sum();
    let in_detected: f64 = (0..columns).map(|column| pairs(column_total(column))).sum();
    let total = pairs(counts.iter().flatten().sum());
    let expected = if total > 0.0 { in_truth * in_detected / total } else { 0.0 };
    let mean = (in_truth + in_detected) / 2.0;
    // Both have one class only, or every frame has its own.
    if mean == expected { 1.0 } else { (agreeing - expected) / (mean - expected) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_do_not_matter() {
        let truth = [(0..10, "walk"), (10..30, "jump"), (30..40, "walk")];
        let detected = [(0..10, "B"), (10..30, "A"), (30..40, "B")];
        let score = classes(&detected, &truth);
        assert_eq!(score, ClassScore { frames: Tally { correct: 40, total: 40 }, adjusted_rand: 1.0 });
    }

    #[test]
    fn each_class_corresponds_to_one_reference_class() {
        let truth = [(0..10, "walk"), (10..30, "jump"), (30..40, "walk")];
        let split = classes(&[(0..10, "A"), (10..30, "B"), (30..40, "C")], &truth);
        assert_eq!(split.frames, Tally { correct: 30, total: 40 });
        let merged = classes(&[(0..40, "A")], &truth);
        assert_eq!((merged.frames.correct, merged.adjusted_rand), (20, 0.0));
        assert!(split.adjusted_rand > 0.0 && split.adjusted_rand < 1.0);
    }

    #[test]
    fn adjusted_rand_index_follows_its_definition() {
        // Hubert and Arabie's index of the table [[2, 1], [0, 3]]: (4 − 6·7/15) / (6.5 − 6·7/15).
        let truth = [(0..3, "a"), (3..6, "b")];
        let detected = [(0..2, "x"), (2..6, "y")];
        let expected = 42.0 / 15.0;
        assert!(
            (classes(&detected, &truth).adjusted_rand - (4.0 - expected) / (6.5 - expected)).abs() < 1e-12
        );
    }

    #[test]
    fn unknown_frames_do_not_count() {
        let truth = [(0..10, "walk"), (10..20, ""), (20..30, "jump")];
        let detected = [(0..15, "A"), (25..30, "B")];
        let score = classes(&detected, &truth);
        // Frames 20 to 25 have no detected class.
        assert_eq!(score.frames, Tally { correct: 15, total: 20 });
        assert_eq!(classes(&[], &[]).frames, Tally::default());
        assert_eq!(classes(&[], &[]).adjusted_rand, 1.0);
    }
}
