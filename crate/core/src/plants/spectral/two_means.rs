//! Exact two-means clustering of numbers.

use std::ops::RangeInclusive;

use crate::numeric::stats::median_of_sorted;

/// Values whose difference is at most this fraction of the largest count as equal.
const EQUALITY_TOLERANCE: f64 = 1e-12;

/// Two classes of numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Classes {
    /// Middle of the gap between the classes.
    pub threshold: f64,
    /// Medians of the lower and the higher class.
    pub medians: [f64; 2],
}

/// Splits ascending values into the two classes with the smallest sum of squared distances to their
/// means; `None` if all values are equal.
///
/// Every split is tried, so the result is the global optimum; of equally good splits it is the
/// lowest.
pub(crate) fn classes(sorted: &[f64]) -> Option<Classes> {
    let (min, max) = (sorted.first()?, sorted.last()?);
    if max - min <= EQUALITY_TOLERANCE * max.abs().max(min.abs()) {
        return None;
    }
    let count = sorted.len();
    let mean = sorted.iter().sum::<f64>() / count as f64;
    // With zero mean the sums of the classes are opposite, and rounding errors stay small.
    let mut low_sum = 0.0;
    let mut best: Option<(f64, usize)> = None;
    for split in 1..count {
        low_sum += sorted[split - 1] - mean;
        if sorted[split - 1] < sorted[split] {
            let between = low_sum * low_sum * (1.0 / split as f64 + 1.0 / (count - split) as f64);
            if best.is_none_or(|(best, _)| between > best) {
                best = Some((between, split));
            }
        }
    }
    let (low, high) = sorted.split_at(best?.1);
    let threshold = (low[low.len() - 1] + high[0]) / 2.0;
    Some(Classes { threshold, medians: [median_of_sorted(low), median_of_sorted(high)] })
}

/// Returns the values in ascending order.
pub(crate) fn sorted(values: &[f64]) -> Vec<f64> {
    let mut sorted = values.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    sorted
}

/// Restores the order of sorted values after changes within `band`: the changed values were and are
/// within it.
pub(crate) fn sort_band(sorted: &mut [f64], values: &[f64], band: RangeInclusive<f64>) {
    let start = sorted.partition_point(|value| value < band.start());
    let end = sorted.partition_point(|value| value <= band.end());
    let within = values.iter().filter(|value| band.contains(value));
    sorted[start..end].iter_mut().zip(within).for_each(|(slot, value)| *slot = *value);
    sorted[start..end].sort_unstable_by(f64::total_cmp);
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn scatter(values: &[f64]) -> f64 {
        let mean = values.iter().sum::<f64>() / values.len().max(1) as f64;
        values.iter().map(|value| (value - mean).powi(2)).sum()
    }

    proptest! {
        /// Compares with every assignment of the values to two classes, contiguous or not.
        #[test]
        fn no_other_classes_are_better(values in prop::collection::vec(-1e3..1e3_f64, 2..11)) {
            let found = classes(&sorted(&values));
            prop_assume!(found.is_some());
            let threshold = found.unwrap().threshold;
            let classes = |in_high: &dyn Fn(usize) -> bool| {
                let (high, low): (Vec<_>, Vec<_>) = (0..values.len()).partition(|&index| in_high(index));
                [low, high].map(|class| class.into_iter().map(|index| values[index]).collect::<Vec<_>>())
            };
            let actual: f64 = classes(&|index| values[index] > threshold).iter().map(|class| scatter(class)).sum();
            for mask in 0..1_u32 << values.len() {
                let other: f64 = classes(&|index| mask >> index & 1 == 1).iter().map(|class| scatter(class)).sum();
                prop_assert!(actual <= other + 1e-6 * (1.0 + other));
            }
        }
    }

    #[test]
    fn equal_values_have_no_threshold() {
        assert_eq!(classes(&[2.0; 5]), None);
        assert_eq!(classes(&[]), None);
        let rounded = 0.1_f64 + 0.2;
        assert_eq!(classes(&[0.3, rounded, rounded.next_up()]), None);
        assert_eq!(classes(&[-rounded, -0.3]), None);
        let found = Classes { threshold: 2.0, medians: [1.0, 3.5] };
        assert_eq!(classes(&sorted(&[1.0, 4.0, 1.0, 1.0, 3.0])), Some(found));
    }

    proptest! {
        #[test]
        fn sorting_a_band_sorts_all_values(
            values in prop::collection::vec(0.0..1.0_f64, 1..40),
            changes in prop::collection::vec((any::<prop::sample::Index>(), 0.0..1.0_f64), 1..8),
        ) {
            let mut found = sorted(&values);
            let (mut changed, mut low, mut high) = (values.clone(), 1.0_f64, 0.0_f64);
            for (index, value) in changes {
                let old = std::mem::replace(&mut changed[index.index(values.len())], value);
                (low, high) = (low.min(old).min(value), high.max(old).max(value));
            }
            sort_band(&mut found, &changed, low..=high);
            prop_assert_eq!(found, sorted(&changed));
        }
    }
}
