//! The height that plants are put on.

use crate::numeric::sort;

/// Heights nearer to each other than this may be of one ground, in legs: feet float and sink ...
const GAP: f64 = 0.03;
/// ... but all of them together no farther apart than this: else the ground is a slope.
const RANGE: f64 = 0.04;

/// The height of the ground for each of `heights`, in their unit; `length` is the leg's.
///
/// Heights that are close together are taken for those of one level ground, at their median.
/// Steps of stairs are so many grounds; on a slope every plant has the height it has.
pub(crate) fn levels(heights: &[f64], length: f64) -> Vec<f64> {
    let mut levels = heights.to_vec();
    for ground in sort::argsort(heights).chunk_by(|&low, &high| heights[high] - heights[low] <= GAP * length)
    {
        let (low, high) = (heights[ground[0]], heights[ground[ground.len() - 1]]);
        if high - low <= RANGE * length {
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
    fn grounds_are_levelled_and_stairs_and_slopes_are_not() {
        assert_eq!(levels(&[0.010, -0.012, 0.002], 0.9), [0.002; 3]);
        assert_eq!(levels(&[0.0, 0.17, 0.34, 0.18], 0.9), [0.0, 0.175, 0.34, 0.175]);
        let slope: Vec<f64> = (0..9).map(|n| 0.02 * n as f64).collect();
        assert_eq!(levels(&slope, 0.9), slope);
        assert!(levels(&[], 0.9).is_empty());
    }
}
