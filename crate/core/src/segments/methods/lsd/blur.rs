//! Means over what is near in time: what falls between two frames, or on one, is not to decide.

use crate::segments::methods::lsd::align::Shape;

/// Standard deviations beyond which nothing counts.
const REACH: f64 = 4.0;

/// The samples about one, of `count`, with weights from a Gaussian whose standard `deviation` is in samples.
///
/// For a deviation of 0 it is the one alone.
pub(crate) fn near(sample: usize, deviation: f64, count: usize) -> impl Iterator<Item = (usize, f64)> {
    let reach = (REACH * deviation).ceil() as usize;
    let spread = deviation.max(f64::MIN_POSITIVE);
    let weight = move |other: usize| (-0.5 * (other.abs_diff(sample) as f64 / spread).powi(2)).exp();
    (sample.saturating_sub(reach)..(sample + reach + 1).min(count)).map(move |other| (other, weight(other)))
}

/// A curve of the means about each sample.
pub(crate) fn curve(values: &[f64], deviation: f64) -> Vec<f64> {
    let mean = |sample: usize| {
        let (mut sum, mut total) = (0.0, 0.0);
        for (other, weight) in near(sample, deviation, values.len()) {
            sum += weight * values[other];
            total += weight;
        }
        sum / total
    };
    (0..values.len()).map(mean).collect()
}

/// The mean of the shapes about a sample.
pub(crate) fn shape(
    sample: usize,
    deviation: f64,
    count: usize,
    mut shape: impl FnMut(usize) -> Shape,
) -> Shape {
    Shape::mean(near(sample, deviation, count).map(|(other, weight)| (shape(other), weight)))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn ripples_go_and_slow_waves_stay() {
        let wave = |samples: f64| move |i: usize| (i as f64 * std::f64::consts::TAU / samples).sin();
        let largest = |values: &[f64]| values[20..80].iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let blurred = |samples: f64| curve(&(0..100).map(wave(samples)).collect::<Vec<_>>(), 2.4);
        // A Gaussian leaves exp(-2 (π σ / λ)²) of a wave.
        for (samples, left) in [(4.0, 0.001), (12.0, 0.454), (40.0, 0.931)] {
            assert!(
                (largest(&blurred(samples)) - left).abs() < 0.01,
                "{samples}: {}",
                largest(&blurred(samples))
            );
        }
    }

    proptest! {
        #[test]
        fn means_lie_between(values in prop::collection::vec(-1e3..1e3_f64, 1..80), deviation in 0.0..9.0_f64) {
            let (low, high) = values.iter().fold((f64::MAX, f64::MIN), |(a, b), &x| (a.min(x), b.max(x)));
            let blurred = curve(&values, deviation);
            prop_assert!(blurred.iter().all(|x| (low - 1e-9..=high + 1e-9).contains(x)));
            prop_assert_eq!(curve(&values, 0.0), values);
        }
    }
}
