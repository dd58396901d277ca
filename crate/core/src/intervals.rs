//! Runs of consecutive frames.

/// The runs of `true` in `labels` as half-open ranges of frames.
pub fn intervals(labels: &[bool]) -> Vec<std::ops::Range<usize>> {
    let mut found = Vec::new();
    let mut frame = 0;
    for run in labels.chunk_by(|a, b| a == b) {
        if run[0] {
            found.push(frame..frame + run.len());
        }
        frame += run.len();
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn intervals_are_the_runs_of_planted_frames() {
        assert!(intervals(&[]).is_empty());
        assert!(intervals(&[false, false]).is_empty());
        assert_eq!(intervals(&[true, true]), vec![0..2]);
        assert_eq!(intervals(&[true, false, true, true, false]), vec![0..1, 2..4]);
    }
}
