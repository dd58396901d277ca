//! Runs too short for a person to make.

/// Fills gaps of less than `shortest` frames, then drops runs of less than that.
///
/// What touches either end stays: nobody knows how long it goes on.
pub(crate) fn drop_short_runs(labels: &mut [bool], shortest: usize) {
    for value in [false, true] {
        let lengths: Vec<usize> = labels.chunk_by(|a, b| a == b).map(<[bool]>::len).collect();
        let mut start = 0;
        for length in lengths {
            let run = start..start + length;
            let is_interior = run.start > 0 && run.end < labels.len();
            if is_interior && length < shortest && labels[run.start] == value {
                labels[run.clone()].fill(!value);
            }
            start = run.end;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cleaned(text: &str, shortest: usize) -> String {
        let mut labels: Vec<bool> = text.chars().map(|c| c == '#').collect();
        drop_short_runs(&mut labels, shortest);
        labels.iter().map(|&label| if label { '#' } else { '.' }).collect()
    }

    #[test]
    fn gaps_are_filled_before_runs_are_dropped() {
        assert_eq!(cleaned("...#.#.#....", 3), "...#####....");
        assert_eq!(cleaned("....##...###", 3), ".........###");
        assert_eq!(cleaned("#..........#", 3), "#..........#");
        assert_eq!(cleaned(".##########.", 3), ".##########.");
        assert_eq!(cleaned("", 3), "");
    }
}
