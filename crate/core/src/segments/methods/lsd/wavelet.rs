//! Wavelet denoising of a curve (patent, section 4.1).

use crate::numeric::stats::median_high;

/// Daubechies wavelet with four vanishing moments: reconstruction taps of the approximation.
const APPROXIMATION_TAPS: [f64; 8] = [
    0.230_377_813_308_896_5,
    0.714_846_570_552_915_7,
    0.630_880_767_929_858_9,
    -0.027_983_769_416_859_854,
    -0.187_034_811_719_093_1,
    0.030_841_381_835_560_764,
    0.032_883_011_666_885_2,
    -0.010_597_401_785_069_032,
];

/// Reconstruction taps of the detail: reversed, with alternating signs.
const DETAIL_TAPS: [f64; 8] = {
    let mut taps = [0.0; 8];
    let mut tap = 0;
    while tap < 8 {
        taps[tap] = if tap % 2 == 0 { APPROXIMATION_TAPS[7 - tap] } else { -APPROXIMATION_TAPS[7 - tap] };
        tap += 1;
    }
    taps
};

/// Median of the absolute value of a normal distribution, in standard deviations.
const NORMAL_MEDIAN: f64 = 0.6745;

/// Returns the denoised curve.
///
/// Details are shrunk by σ√(2 ln n) (universal threshold of Donoho and Johnstone), with σ from the
/// details of the finest level, or of each level if `level_dependent`. Short curves have fewer than
/// `levels` levels.
pub(crate) fn denoise(values: &[f64], levels: usize, level_dependent: bool) -> Vec<f64> {
    // A further level would contain boundary values only.
    let max_levels = (values.len() as f64 / (APPROXIMATION_TAPS.len() - 1) as f64).log2() as usize;
    let universal = (2.0 * (values.len().max(1) as f64).ln()).sqrt();
    let mut coarse = values.to_vec();
    let mut threshold = 0.0;
    let mut parts = Vec::new();
    for level in 0..levels.min(max_levels) {
        let length = coarse.len();
        let (approximation, mut detail) = decompose(&coarse);
        if level_dependent || level == 0 {
            threshold =
                median_high(detail.iter().map(|x| x.abs())).unwrap_or(0.0) / NORMAL_MEDIAN * universal;
        }
        detail.iter_mut().for_each(|x| *x = x.signum() * (x.abs() - threshold).max(0.0));
        parts.push((detail, length));
        coarse = approximation;
    }
    parts.iter().rev().fold(coarse, |coarse, (detail, length)| reconstruct(&coarse, detail, *length))
}

/// Returns approximation and detail, half as many values each plus some for the boundaries.
fn decompose(values: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let sum = |index: usize, taps: &[f64; 8]| -> f64 {
        (0..8).map(|tap| taps[tap] * values[reflected_index(2 * index + tap, values.len())]).sum()
    };
    let half = (values.len() + 7) / 2;
    (0..half).map(|index| (sum(index, &APPROXIMATION_TAPS), sum(index, &DETAIL_TAPS))).unzip()
}

/// Inverse of [`decompose`].
fn reconstruct(coarse: &[f64], detail: &[f64], length: usize) -> Vec<f64> {
    let term = |index: usize, ahead: usize| {
        let (half, tap) = (index / 2 + ahead, index % 2 + 6 - 2 * ahead);
        coarse[half] * APPROXIMATION_TAPS[tap] + detail[half] * DETAIL_TAPS[tap]
    };
    (0..length).map(|index| (0..4).map(|ahead| term(index, ahead)).sum()).collect()
}

/// Returns the index of a value counted from six before the curve, which is extended by reflection.
fn reflected_index(index: usize, length: usize) -> usize {
    let index = (index as isize - 6).rem_euclid(2 * length as isize) as usize;
    index.min(2 * length - 1 - index)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn taps_are_orthonormal() {
        assert!((APPROXIMATION_TAPS.iter().sum::<f64>() - 2.0_f64.sqrt()).abs() < 1e-12);
        assert!(DETAIL_TAPS.iter().sum::<f64>().abs() < 1e-12);
        let product = |a: &[f64; 8], b: &[f64; 8], shift: usize| -> f64 {
            a[shift..].iter().zip(b).map(|(a, b)| a * b).sum()
        };
        for shift in [0, 2, 4, 6] {
            let one = if shift == 0 { 1.0 } else { 0.0 };
            assert!((product(&APPROXIMATION_TAPS, &APPROXIMATION_TAPS, shift) - one).abs() < 1e-12);
            assert!((product(&DETAIL_TAPS, &DETAIL_TAPS, shift) - one).abs() < 1e-12);
            assert!(product(&APPROXIMATION_TAPS, &DETAIL_TAPS, shift).abs() < 1e-12);
            assert!(product(&DETAIL_TAPS, &APPROXIMATION_TAPS, shift).abs() < 1e-12);
        }
    }

    #[test]
    fn details_of_cubics_vanish() {
        let cubic: Vec<f64> = (0..40).map(f64::from).map(|x| 0.01 * x.powi(3) - x * x + 3.0).collect();
        let (_, detail) = decompose(&cubic);
        assert!(detail[3..20].iter().all(|x| x.abs() < 1e-9), "{detail:?}");
    }

    /// Reference: `pywt.dwt(x, "db4", "symmetric")`.
    #[test]
    fn agrees_with_pywavelets() {
        let (coarse, detail) = decompose(&[1.0, 4.0, -2.0, 3.0, 0.0, 5.0, 7.0, -1.0, 2.0, 2.0, 6.0]);
        let true_coarse = [
            2.373694448654,
            1.595752088058,
            2.56891027407,
            2.139036644041,
            0.248351393851,
            7.839708797214,
            1.211002760098,
            5.088379074872,
            7.444479843099,
        ];
        let true_detail = [
            -1.284013015137,
            -4.327959265129,
            -2.284855821596,
            2.437192190564,
            2.261651723665,
            1.453523271566,
            -2.589796123312,
            -2.424924003985,
            -0.63907884693,
        ];
        let agree = |actual: &[f64], expected: &[f64]| {
            actual.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-11)
        };
        assert!(coarse.len() == 9 && agree(&coarse, &true_coarse) && agree(&detail, &true_detail));
    }

    #[test]
    fn noise_is_reduced() {
        let wave = |i: usize| 20.0 * (i as f64 / 100.0).sin();
        // Deterministic noise from a linear congruential generator.
        let mut state = 1_u64;
        let mut noise = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 40) as f64 / (1_u64 << 24) as f64 - 0.5
        };
        let noisy: Vec<f64> = (0..1000).map(|i| wave(i) + noise()).collect();
        let error = |values: &[f64]| {
            let squares = values.iter().enumerate().map(|(i, value)| (value - wave(i)).powi(2));
            (squares.sum::<f64>() / 1000.0).sqrt()
        };
        assert!(error(&noisy) > 0.28);
        assert!(error(&denoise(&noisy, 5, false)) < 0.1);
        assert!(error(&denoise(&noisy, 5, true)) < 1.0);
        let clean: Vec<f64> = (0..1000).map(wave).collect();
        assert!(error(&denoise(&clean, 5, false)) < 0.01);
    }

    proptest! {
        #[test]
        fn reconstruction_inverts_decomposition(values in prop::collection::vec(-1e3..1e3_f64, 1..60)) {
            let (coarse, detail) = decompose(&values);
            prop_assert_eq!(coarse.len(), (values.len() + 7) / 2);
            let back = reconstruct(&coarse, &detail, values.len());
            prop_assert!(back.iter().zip(&values).all(|(a, b)| (a - b).abs() < 1e-9));
        }

        #[test]
        fn the_length_is_preserved(values in prop::collection::vec(-1e9..1e9_f64, 0..70), level_dependent: bool) {
            let denoised = denoise(&values, 5, level_dependent);
            prop_assert_eq!(denoised.len(), values.len());
            prop_assert!(denoised.iter().all(|x| x.is_finite()));
        }
    }
}
