//! Degree as a function of height and speed, for plots.

use std::cell::OnceCell;

use crate::plants::signal::samples::{Ranges, Samples};
use crate::plants::spectral::affinity::Kernel;
use crate::plants::spectral::degree::{DegreeQuery, Summation};

/// Maximum number of samples; more would draw the same picture.
const MAX_SAMPLES: usize = 3000;

/// Square root of the degree that a foot would have at any height and speed, for comparison with
/// the threshold.
///
/// Of many samples every n-th is used with n times its weight: values of a long clip are accurate
/// enough for a picture, not for labels.
#[derive(Clone, Debug, PartialEq)]
pub struct DegreeField {
    samples: Samples,
    weights: Vec<f64>,
    sigma: f64,
    kernel: Kernel,
    ranges: Ranges,
}

impl DegreeField {
    /// Creates the field of samples whose heights and speeds were divided by `ranges`.
    pub(crate) fn new(query: &DegreeQuery, ranges: Ranges) -> DegreeField {
        let &DegreeQuery { weights, sigma, kernel, .. } = query;
        let samples = &query.samples.samples;
        let stride = samples.len().div_ceil(MAX_SAMPLES).max(1);
        let selected = || (0..samples.len()).step_by(stride);
        let factor = samples.len() as f64 / selected().count().max(1) as f64;
        DegreeField {
            weights: selected().map(|sample| weights[sample] * factor).collect(),
            samples: samples.select(selected()),
            sigma,
            kernel,
            ranges,
        }
    }

    /// Returns the values for feet of constant height and speed over the window, for each height
    /// all speeds, in file units and file units per second.
    ///
    /// Takes about 1 ns per pair of query and sample.
    pub fn sqrt_degrees(&self, heights: &[f64], speeds: &[f64]) -> Vec<f64> {
        let queries = Samples::at_constant(heights, speeds, self.ranges, self.samples.dimension).into();
        let &DegreeField { ref weights, sigma, kernel, .. } = self;
        let (samples, summation, expansion) =
            (&self.samples.clone().into(), Summation::AllPairs, OnceCell::new());
        DegreeQuery { samples, weights, sigma, kernel, summation, expansion }.sqrt_degrees_of(&queries).values
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants::spectral::cells::PartitionedSamples;

    /// Samples of alternating stance and swing without a window, so that each frame has a constant
    /// sample.
    fn swinging(count: usize) -> (Vec<[f64; 2]>, PartitionedSamples) {
        let positions: Vec<[f64; 2]> = (0..count)
            .map(|index| {
                let swing = (index as f64 * 0.0611).sin().max(0.0);
                [0.4 * swing, 3.0 * swing * swing]
            })
            .collect();
        let points = positions.iter().flat_map(|[height, speed]| [height / 0.4, speed / 3.0]).collect();
        (positions, Samples::new(2, points).into())
    }

    fn query<'a>(samples: &'a PartitionedSamples, weights: &'a [f64], kernel: Kernel) -> DegreeQuery<'a> {
        DegreeQuery {
            samples,
            weights,
            sigma: 0.15,
            kernel,
            summation: Summation::AllPairs,
            expansion: OnceCell::new(),
        }
    }

    fn field(samples: &PartitionedSamples, kernel: Kernel) -> DegreeField {
        let weights = vec![1.0; samples.samples.len()];
        DegreeField::new(&query(samples, &weights, kernel), Ranges { height: 0.4, speed: 3.0 })
    }

    #[test]
    fn the_field_at_a_sample_is_its_degree_plus_itself() {
        let (positions, samples) = swinging(500);
        let weights = vec![1.0; 500];
        for kernel in [Kernel::Gaussian, Kernel::Cauchy] {
            let expected = query(&samples, &weights, kernel).sqrt_degrees().values;
            for sample in [0, 20, 77, 499] {
                let [height, speed] = positions[sample];
                let value = field(&samples, kernel).sqrt_degrees(&[height], &[speed])[0];
                assert!((value * value - 1.0 - expected[sample] * expected[sample]).abs() < 1e-3);
            }
        }
    }

    #[test]
    fn a_subset_of_samples_draws_the_same_picture() {
        let (_, samples) = swinging(20_000);
        let heights: Vec<f64> = (0..8).map(|step| f64::from(step) * 0.05).collect();
        let speeds: Vec<f64> = (0..8).map(|step| f64::from(step) * 0.4).collect();
        for kernel in [Kernel::Gaussian, Kernel::Cauchy] {
            let reduced = field(&samples, kernel);
            assert!(reduced.samples.len() <= MAX_SAMPLES);
            let weights = vec![1.0; samples.samples.len()];
            let all = query(&samples, &weights, kernel);
            let queries = Samples::at_constant(&heights, &speeds, reduced.ranges, 2).into();
            let max = reduced.sqrt_degrees(&[0.0], &[0.0])[0];
            for (actual, all) in
                reduced.sqrt_degrees(&heights, &speeds).iter().zip(all.sqrt_degrees_of(&queries).values)
            {
                assert!((actual - all).abs() < 0.005 * max, "{actual} {all}");
            }
        }
    }
}
