//! Removal of runs that are too short for human motion.

/// Fills gaps shorter than `min_length` frames, then removes runs shorter than `min_length`.
///
/// Runs that touch either end remain, as their length is unknown.
pub(crate) fn drop_short_runs(labels: &mut [bool], min_length: usize) {
    for value in [false, true] {
        let lengths: Vec<usize> = labels.chunk_by(|a, b| a == b).map(<[bool]>::len).collect();
        let mut start = 0;
        for length in lengths {
            let run = start..start + length;
            let is_interior = run.start > 0 && run.end < labels.len();
            if is_interior && length < min_length && labels[run.start] == value {
                labels[run.clone()].fill(!value);
            }
            start = run.end;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn after_removal(text: &str, min_length: usize) -> String {
        let mut labels: Vec<bool> = text.chars().map(|c| c == '#').collect();
        drop_short_runs(&mut labels, min_length);
        labels.iter().map(|&label| if label { '#' } else { '.' }).collect()
    }

    #[test]
    fn gaps_are_filled_before_runs_are_dropped() {
        assert_eq!(after_removal("...#.#.#....", 3), "...#####....");
        assert_eq!(after_removal("....##...###", 3), ".........###");
        assert_eq!(after_removal("#..........#", 3), "#..........#");
        assert_eq!(after_removal(".##########.", 3), ".##########.");
        assert_eq!(after_removal("", 3), "");
    }
}
