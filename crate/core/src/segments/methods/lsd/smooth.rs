//! Gaussian means over neighbouring samples, so that results do not depend on where samples fall
//! between frames.

use crate::segments::methods::lsd::align::Shape;

/// Half-width of the kernel, in standard deviations.
const HALF_WIDTH: f64 = 4.0;

/// Returns the samples around one of `count` with Gaussian weights; `deviation` is in samples.
///
/// With a deviation of 0 it returns the sample itself.
pub(crate) fn gaussian_window(
    sample: usize,
    deviation: f64,
    count: usize,
) -> impl Iterator<Item = (usize, f64)> {
    let half = (HALF_WIDTH * deviation).ceil() as usize;
    let deviation = deviation.max(f64::MIN_POSITIVE);
    let weight = move |other: usize| (-0.5 * (other.abs_diff(sample) as f64 / deviation).powi(2)).exp();
    (sample.saturating_sub(half)..(sample + half + 1).min(count)).map(move |other| (other, weight(other)))
}

/// Returns a curve smoothed by the Gaussian.
pub(crate) fn curve(values: &[f64], deviation: f64) -> Vec<f64> {
    let mean = |sample: usize| {
        let (mut sum, mut total) = (0.0, 0.0);
        for (other, weight) in gaussian_window(sample, deviation, values.len()) {
            sum += weight * values[other];
            total += weight;
        }
        sum / total
    };
    (0..values.len()).map(mean).collect()
}

/// Returns the Gaussian mean of the shapes around a sample.
pub(crate) fn shape(
    sample: usize,
    deviation: f64,
    count: usize,
    mut shape: impl FnMut(usize) -> Shape,
) -> Shape {
    Shape::mean(gaussian_window(sample, deviation, count).map(|(other, weight)| (shape(other), weight)))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn fast_waves_are_attenuated() {
        let wave = |samples: f64| move |i: usize| (i as f64 * std::f64::consts::TAU / samples).sin();
        let largest = |values: &[f64]| values[20..80].iter().fold(0.0, |max: f64, x| max.max(x.abs()));
        let smoothed = |samples: f64| curve(&(0..100).map(wave(samples)).collect::<Vec<_>>(), 2.4);
        // A Gaussian reduces a wave by the factor exp(-2 (π σ / λ)²).
        for (samples, expected) in [(4.0, 0.001), (12.0, 0.454), (40.0, 0.931)] {
            assert!(
                (largest(&smoothed(samples)) - expected).abs() < 0.01,
                "{samples}: {}",
                largest(&smoothed(samples))
            );
        }
    }

    proptest! {
        #[test]
        fn means_are_within_the_range(values in prop::collection::vec(-1e3..1e3_f64, 1..80), deviation in 0.0..9.0_f64) {
            let (low, high) = values.iter().fold((f64::MAX, f64::MIN), |(a, b), &x| (a.min(x), b.max(x)));
            let smoothed = curve(&values, deviation);
            prop_assert!(smoothed.iter().all(|x| (low - 1e-9..=high + 1e-9).contains(x)));
            prop_assert_eq!(curve(&values, 0.0), values);
        }
    }
}
