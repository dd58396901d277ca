//! Runs of consecutive frames.

use std::ops::Range;

/// Returns the runs of `true` as half-open frame ranges, in order.
pub fn intervals(labels: &[bool]) -> Vec<Range<usize>> {
    let mut intervals = Vec::new();
    let mut frame = 0;
    for run in labels.chunk_by(|a, b| a == b) {
        if run[0] {
            intervals.push(frame..frame + run.len());
        }
        frame += run.len();
    }
    intervals
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn intervals_are_the_runs_of_true() {
        assert!(intervals(&[]).is_empty());
        assert!(intervals(&[false, false]).is_empty());
        assert_eq!(intervals(&[true, true]), vec![0..2]);
        assert_eq!(intervals(&[true, false, true, true, false]), vec![0..1, 2..4]);
    }
}
