//! The scale σ of the kernel, from the knee of the sorted norms (paper, section 2.2).

/// The norms of samples, as the knee is looked for in them.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Norms {
    /// In ascending order.
    pub sorted: Vec<f64>,
    /// Sample variance of the first norms up to each one.
    pub running_variance: Vec<f64>,
}

/// How σ was found.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Scale {
    pub norms: Norms,
    /// Index of the knee: the last norm up to which the variance keeps to r.
    pub knee: usize,
    /// r: what the variance was compared with.
    pub tolerance: f64,
}

impl Norms {
    /// Of norms in any order.
    pub fn of(norms: &[f64]) -> Norms {
        let mut sorted = norms.to_vec();
        sorted.sort_unstable_by(f64::total_cmp);
        Norms { running_variance: running_variance(&sorted), sorted }
    }
}

impl Scale {
    /// Finds the knee for variance threshold r.
    pub fn find(norms: Norms, r: f64) -> Scale {
        let knee = norms.running_variance.iter().rposition(|&variance| variance <= r).unwrap_or(0);
        Scale { norms, knee, tolerance: r }
    }

    /// σ: the norm at the knee.
    pub fn sigma(&self) -> f64 {
        self.norms.sorted.get(self.knee).copied().unwrap_or(0.0)
    }
}

/// Sample variance of `values[..=j]` for each j, by Welford's recurrence; 0 for the first.
fn running_variance(values: &[f64]) -> Vec<f64> {
    let (mut mean, mut sum) = (0.0, 0.0);
    values
        .iter()
        .enumerate()
        .map(|(index, value)| {
            let off = value - mean;
            mean += off / (index + 1) as f64;
            sum += off * (value - mean);
            sum / index.max(1) as f64
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn variance_is_the_textbook_one(values in prop::collection::vec(0.0..10.0_f64, 2..40)) {
            let running = running_variance(&values);
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
        let scale = Scale::find(Norms::of(&[5.0, 0.0, 0.0, 0.0, 0.1]), 0.01);
        assert_eq!((scale.knee, scale.sigma()), (3, 0.1));
        assert_eq!(Scale::find(Norms::of(&[1.0, 1.0]), 0.01).sigma(), 1.0);
    }
}
