//! Height of the ground below each plant.

use crate::numeric::sort;

/// Maximum difference of neighbouring heights of one level, in leg lengths, as feet float and sink
/// …
const MAX_GAP: f64 = 0.03;
/// … and maximum range of all heights of one level; a larger range is a slope.
const MAX_RANGE: f64 = 0.04;

/// Returns the level for each of `heights`, in their unit; `length` is the leg length.
///
/// Heights close together belong to one level at their median. Each step of stairs is a level; on a
/// slope the height of each plant is preserved.
pub(crate) fn levels(heights: &[f64], length: f64) -> Vec<f64> {
    let mut levels = heights.to_vec();
    for ground in
        sort::argsort(heights).chunk_by(|&low, &high| heights[high] - heights[low] <= MAX_GAP * length)
    {
        let (low, high) = (heights[ground[0]], heights[ground[ground.len() - 1]]);
        if high - low <= MAX_RANGE * length {
            let (below, above) = (ground[(ground.len() - 1) / 2], ground[ground.len() / 2]);
            let level = (heights[below] + heights[above]) / 2.0;
            ground.iter().for_each(|&plant| levels[plant] = level);
        }
    }
    levels
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_are_equalised_and_slopes_are_preserved() {
        assert_eq!(levels(&[0.010, -0.012, 0.002], 0.9), [0.002; 3]);
        assert_eq!(levels(&[0.0, 0.17, 0.34, 0.18], 0.9), [0.0, 0.175, 0.34, 0.175]);
        let slope: Vec<f64> = (0..9).map(|n| 0.02 * n as f64).collect();
        assert_eq!(levels(&slope, 0.9), slope);
        assert!(levels(&[], 0.9).is_empty());
    }
}
