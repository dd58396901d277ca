//! Bandwidth σ of the kernel, from the knee of the sorted norms (paper, section 2.2).

use std::sync::Arc;

/// Bandwidth and the data that determine it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Bandwidth {
    /// Norms of the samples in ascending order.
    pub sorted: Arc<[f64]>,
    /// Index of the knee: the last norm up to which the running variance is at most r.
    pub knee: usize,
    /// r: upper bound of the running variance.
    pub tolerance: f64,
}

/// Returns the norms in ascending order.
pub(crate) fn sorted(norms: &[f64]) -> Arc<[f64]> {
    let mut sorted: Arc<[f64]> = norms.into();
    Arc::make_mut(&mut sorted).sort_unstable_by(f64::total_cmp);
    sorted
}

impl Bandwidth {
    /// Finds the knee of sorted norms for the variance bound r.
    pub fn from_knee(sorted: Arc<[f64]>, r: f64) -> Bandwidth {
        let within = |(index, variance): (usize, f64)| (variance <= r).then_some(index);
        let knee = running_variance(&sorted).enumerate().filter_map(within).last().unwrap_or(0);
        Bandwidth { sorted, knee, tolerance: r }
    }

    /// Returns σ: the norm at the knee.
    pub fn sigma(&self) -> f64 {
        self.sorted.get(self.knee).copied().unwrap_or(0.0)
    }
}

/// Returns the sample variance of `values[..=j]` for each j, by Welford's recurrence; 0 for the
/// first.
pub(crate) fn running_variance(values: &[f64]) -> impl Iterator<Item = f64> {
    let (mut mean, mut sum) = (0.0, 0.0);
    values.iter().enumerate().map(move |(index, value)| {
        let difference = value - mean;
        mean += difference / (index + 1) as f64;
        sum += difference * (value - mean);
        sum / index.max(1) as f64
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn running_variance_agrees_with_the_definition(values in prop::collection::vec(0.0..10.0_f64, 2..40)) {
            let running: Vec<f64> = running_variance(&values).collect();
            for (index, variance) in running.iter().enumerate().skip(1) {
                let first = &values[..=index];
                let mean = first.iter().sum::<f64>() / first.len() as f64;
                let sum: f64 = first.iter().map(|value| (value - mean).powi(2)).sum();
                prop_assert!((variance - sum / index as f64).abs() < 1e-9);
            }
            prop_assert_eq!(running[0], 0.0);
        }
    }

    #[test]
    fn the_last_norm_within_r_is_the_knee() {
        let bandwidth = Bandwidth::from_knee(sorted(&[5.0, 0.0, 0.0, 0.0, 0.1]), 0.01);
        assert_eq!((bandwidth.knee, bandwidth.sigma()), (3, 0.1));
        assert_eq!(Bandwidth::from_knee(sorted(&[1.0, 1.0]), 0.01).sigma(), 1.0);
    }
}
