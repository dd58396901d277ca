//! Means, medians and percentiles.
//!
//! The three medians differ for an even number of values only: the low and the high median are the
//! two middle values, the median is their mean.

/// Returns the arithmetic mean; NaN if there are no values.
pub(crate) fn mean(values: impl ExactSizeIterator<Item = f64>) -> f64 {
    let count = values.len() as f64;
    values.sum::<f64>() / count
}

/// Returns the standard deviation with divisor n; NaN if there are no values.
pub(crate) fn standard_deviation(values: &[f64]) -> f64 {
    let mean = mean(values.iter().copied());
    (values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / values.len() as f64).sqrt()
}

/// Returns the median of ascending values.
///
/// # Panics
/// If there are no values.
pub(crate) fn median_of_sorted(sorted: &[f64]) -> f64 {
    let upper = sorted.len() / 2;
    if sorted.len() % 2 == 1 { sorted[upper] } else { (sorted[upper - 1] + sorted[upper]) / 2.0 }
}

/// Returns the median, or the lower of two middle values; `None` if there are no values.
pub(crate) fn median_low(values: impl Iterator<Item = f64>) -> Option<f64> {
    let mut values: Vec<f64> = values.collect();
    let middle = values.len().checked_sub(1)? / 2;
    Some(nth_smallest(&mut values, middle))
}

/// Returns the median, or the higher of two middle values; `None` if there are no values.
pub(crate) fn median_high(values: impl Iterator<Item = f64>) -> Option<f64> {
    let mut values: Vec<f64> = values.collect();
    let middle = values.len() / 2;
    (!values.is_empty()).then(|| nth_smallest(&mut values, middle))
}

/// Returns the value at index `n` of the ascending order; reorders `values`.
///
/// # Panics
/// If there are no more than `n` values.
pub(crate) fn nth_smallest(values: &mut [f64], n: usize) -> f64 {
    *values.select_nth_unstable_by(n, f64::total_cmp).1
}

/// Returns the value below which `fraction` of the values lie, linearly interpolated between
/// neighbours; 0 if there are no values.
pub(crate) fn percentile(mut values: Vec<f64>, fraction: f64) -> f64 {
    if values.is_empty() {
        return 0.0;
    }
    let position = fraction * (values.len() - 1) as f64;
    let (_, &mut low, above) = values.select_nth_unstable_by(position as usize, f64::total_cmp);
    let high = above.iter().copied().fold(f64::INFINITY, f64::min);
    if position.fract() > 0.0 { low + (high - low) * position.fract() } else { low }
}

/// Returns the value nearest to the percentile's position in the ascending order, without
/// interpolation; 0 if there are no values.
pub(crate) fn nearest_percentile(mut values: Vec<f64>, fraction: f64) -> f64 {
    let index = (fraction * values.len().saturating_sub(1) as f64).round() as usize;
    if values.is_empty() { 0.0 } else { nth_smallest(&mut values, index) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn medians_differ_for_even_counts_only() {
        let medians = |values: &[f64]| {
            let mut sorted = values.to_vec();
            sorted.sort_unstable_by(f64::total_cmp);
            let all = || values.iter().copied();
            [median_low(all()).unwrap(), median_of_sorted(&sorted), median_high(all()).unwrap()]
        };
        assert_eq!(medians(&[3.0, 1.0, 2.0]), [2.0; 3]);
        assert_eq!(medians(&[4.0, 1.0, 2.0, 3.0]), [2.0, 2.5, 3.0]);
        assert_eq!((median_low([].into_iter()), median_high([].into_iter())), (None, None));
    }

    #[test]
    fn percentiles_lie_between_the_extremes() {
        let values = vec![4.0, 1.0, 3.0, 2.0];
        assert_eq!(percentile(values.clone(), 0.0), 1.0);
        assert_eq!(percentile(values.clone(), 0.5), 2.5);
        assert_eq!(percentile(values.clone(), 1.0), 4.0);
        assert_eq!(nearest_percentile(values, 0.6), 3.0);
        assert_eq!((percentile(vec![], 0.5), nearest_percentile(vec![], 0.5)), (0.0, 0.0));
    }

    #[test]
    fn deviation_is_about_the_mean() {
        assert_eq!(mean([1.0, 2.0, 6.0].into_iter()), 3.0);
        assert_eq!(standard_deviation(&[2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0]), 2.0);
    }
}
