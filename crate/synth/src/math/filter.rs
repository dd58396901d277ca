//! Filters for uniformly sampled signals.

use crate::math::Random;

/// Returns the samples smoothed by an approximate Gaussian with standard deviation `sigma` samples
/// (three box filters). Signals are extended by their end values.
pub fn gaussian_blur(samples: &[f64], sigma: f64) -> Vec<f64> {
    // Three boxes of half-width w have the variance w(w + 1).
    let half = ((sigma * sigma + 0.25).sqrt() - 0.5).round() as usize;
    (0..3).fold(samples.to_vec(), |samples, _| box_mean(&samples, half))
}

fn box_mean(samples: &[f64], half: usize) -> Vec<f64> {
    let Some(last) = samples.len().checked_sub(1) else { return Vec::new() };
    let at = |index: isize| samples[index.clamp(0, last as isize) as usize];
    let half = half as isize;
    // The running sum is restarted regularly so that rounding errors do not accumulate.
    let mut means = Vec::with_capacity(samples.len());
    let mut sum = 0.0;
    for centre in 0..=last as isize {
        if centre % 1024 == 0 {
            sum = (centre - half..=centre + half).map(at).sum();
        } else {
            sum += at(centre + half) - at(centre - half - 1);
        }
        means.push(sum / (2 * half + 1) as f64);
    }
    means
}

/// Returns smooth noise with standard deviation 1: white noise filtered forward and backward by two
/// one-pole low-pass filters with little energy above `cutoff` Hz.
pub fn smooth_noise(random: &mut Random, count: usize, rate: f64, cutoff: f64) -> Vec<f64> {
    // Padding for the filter transients at both ends.
    let lead = (2.0 * rate / cutoff) as usize;
    let mut samples: Vec<f64> = (0..count + 2 * lead).map(|_| random.normal()).collect();
    let pole = libm::exp(-std::f64::consts::TAU * 2.0 * cutoff / rate);
    for _ in 0..2 {
        low_pass(samples.iter_mut(), pole);
        low_pass(samples.iter_mut().rev(), pole);
    }
    // Variance gain of four passes of y = k·y + (1 − k)·x on white noise, k the pole.
    let k = pole * pole;
    let numerator = power(1.0 - pole, 8) * (1.0 + 9.0 * k + 9.0 * k * k + k * k * k);
    let gain = numerator / power(1.0 - k, 7);
    samples[lead..lead + count].iter().map(|sample| sample / gain.sqrt()).collect()
}

/// Returns a power by repeated multiplication: `powi` may round differently on different machines.
fn power(base: f64, exponent: usize) -> f64 {
    std::iter::repeat_n(base, exponent).product()
}

fn low_pass<'a>(samples: impl Iterator<Item = &'a mut f64>, pole: f64) {
    let mut state = 0.0;
    for sample in samples {
        state = pole * state + (1.0 - pole) * *sample;
        *sample = state;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn smooth_noise_has_unit_variance() {
        for cutoff in [0.8, 12.0] {
            let samples = smooth_noise(&mut Random::new(0, "test"), 400_000, 240.0, cutoff);
            let variance = samples.iter().map(|x| x * x).sum::<f64>() / samples.len() as f64;
            assert!((variance - 1.0).abs() < 0.1, "{cutoff}: {variance}");
        }
    }

    #[test]
    fn blur_preserves_constants_and_sums() {
        assert!(gaussian_blur(&[2.0; 50], 4.0).iter().all(|x| (x - 2.0).abs() < 1e-12));
        let mut spike = vec![0.0; 101];
        spike[50] = 1.0;
        assert!((gaussian_blur(&spike, 5.0).iter().sum::<f64>() - 1.0).abs() < 1e-12);
        assert!(gaussian_blur(&[], 3.0).is_empty());
    }
}
