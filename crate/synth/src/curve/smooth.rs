//! Filters on samples of an even grid.

use crate::random::Random;

/// The samples blurred by about a Gaussian of standard deviation `sigma` samples
/// (three box filters); ends are held.
pub fn blur(samples: &[f64], sigma: f64) -> Vec<f64> {
    // Three boxes of half-width w have the variance w(w + 1).
    let half = ((sigma * sigma + 0.25).sqrt() - 0.5).round() as usize;
    (0..3).fold(samples.to_vec(), |samples, _| box_mean(&samples, half))
}

fn box_mean(samples: &[f64], half: usize) -> Vec<f64> {
    let Some(last) = samples.len().checked_sub(1) else { return Vec::new() };
    let at = |index: isize| samples[index.clamp(0, last as isize) as usize];
    let half = half as isize;
    // The running sum is restarted now and then so that rounding does not build up.
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

/// Smooth noise with standard deviation 1: white noise through two one-pole low
/// passes and back through them, so that little is left above `cutoff` hertz.
pub fn drift(random: &mut Random, count: usize, rate: f64, cutoff: f64) -> Vec<f64> {
    // Enough samples before and after for the filter to forget where it began.
    let lead = (2.0 * rate / cutoff) as usize;
    let mut samples: Vec<f64> = (0..count + 2 * lead).map(|_| random.normal()).collect();
    let keep = libm::exp(-std::f64::consts::TAU * 2.0 * cutoff / rate);
    for _ in 0..2 {
        low_pass(samples.iter_mut(), keep);
        low_pass(samples.iter_mut().rev(), keep);
    }
    // What four passes of y = keep·y + (1 − keep)·x leave of the variance of white noise.
    let k = keep * keep;
    let numerator = power(1.0 - keep, 8) * (1.0 + 9.0 * k + 9.0 * k * k + k * k * k);
    let gain = numerator / power(1.0 - k, 7);
    samples[lead..lead + count].iter().map(|sample| sample / gain.sqrt()).collect()
}

/// A power by plain multiplication: `powi` may round differently from machine to machine.
fn power(base: f64, exponent: usize) -> f64 {
    std::iter::repeat_n(base, exponent).product()
}

fn low_pass<'a>(samples: impl Iterator<Item = &'a mut f64>, keep: f64) {
    let mut state = 0.0;
    for sample in samples {
        state = keep * state + (1.0 - keep) * *sample;
        *sample = state;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn drift_has_unit_variance() {
        for cutoff in [0.8, 12.0] {
            let samples = drift(&mut Random::new(0, "test"), 400_000, 240.0, cutoff);
            let variance = samples.iter().map(|x| x * x).sum::<f64>() / samples.len() as f64;
            assert!((variance - 1.0).abs() < 0.1, "{cutoff}: {variance}");
        }
    }

    #[test]
    fn blur_keeps_a_constant_and_the_sum_of_a_spike() {
        assert!(blur(&[2.0; 50], 4.0).iter().all(|x| (x - 2.0).abs() < 1e-12));
        let mut spike = vec![0.0; 101];
        spike[50] = 1.0;
        assert!((blur(&spike, 5.0).iter().sum::<f64>() - 1.0).abs() < 1e-12);
        assert!(blur(&[], 3.0).is_empty());
    }
}
