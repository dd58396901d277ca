//! Noise taken off a curve by its wavelet coefficients (patent, section 4.1).

/// Daubechies' wavelet with four vanishing moments: the taps that join coarse values.
const COARSE: [f64; 8] = [
    0.230_377_813_308_896_5,
    0.714_846_570_552_915_7,
    0.630_880_767_929_858_9,
    -0.027_983_769_416_859_854,
    -0.187_034_811_719_093_1,
    0.030_841_381_835_560_764,
    0.032_883_011_666_885_2,
    -0.010_597_401_785_069_032,
];

/// The taps that join details: the others backwards, every second negated.
const DETAIL: [f64; 8] = {
    let mut taps = [0.0; 8];
    let mut tap = 0;
    while tap < 8 {
        taps[tap] = if tap % 2 == 0 { COARSE[7 - tap] } else { -COARSE[7 - tap] };
        tap += 1;
    }
    taps
};

/// Median of the sizes of normally distributed values, in standard deviations.
const MEDIAN: f64 = 0.6745;

/// The curve without what may be noise.
///
/// Details shrink by σ√(2 ln n) (Donoho and Johnstone's universal threshold), with σ from the
/// finest level's details, or from each level's `own`. Short curves have fewer than `levels`.
pub(crate) fn denoised(values: &[f64], levels: usize, own: bool) -> Vec<f64> {
    // A level more would see nothing but the ends.
    let most = (values.len() as f64 / (COARSE.len() - 1) as f64).log2() as usize;
    let universal = (2.0 * (values.len().max(1) as f64).ln()).sqrt();
    let mut coarse = values.to_vec();
    let mut threshold = 0.0;
    let mut parts = Vec::new();
    for level in 0..levels.min(most) {
        let length = coarse.len();
        let (coarser, mut detail) = parted(&coarse);
        if own || level == 0 {
            threshold = median_size(&detail) / MEDIAN * universal;
        }
        detail.iter_mut().for_each(|x| *x = x.signum() * (x.abs() - threshold).max(0.0));
        parts.push((detail, length));
        coarse = coarser;
    }
    parts.iter().rev().fold(coarse, |coarse, (detail, length)| joined(&coarse, detail, *length))
}

fn median_size(values: &[f64]) -> f64 {
    let mut sizes: Vec<f64> = values.iter().map(|x| x.abs()).collect();
    sizes.sort_unstable_by(f64::total_cmp);
    sizes.get(sizes.len() / 2).copied().unwrap_or(0.0)
}

/// Coarse values and details, half as many each and some for the ends.
fn parted(values: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let sum = |place: usize, taps: &[f64; 8]| -> f64 {
        (0..8).map(|tap| taps[tap] * values[mirrored(2 * place + tap, values.len())]).sum()
    };
    let half = (values.len() + 7) / 2;
    (0..half).map(|place| (sum(place, &COARSE), sum(place, &DETAIL))).unzip()
}

/// Undoes [`parted`].
fn joined(coarse: &[f64], detail: &[f64], length: usize) -> Vec<f64> {
    let term = |place: usize, ahead: usize| {
        let (half, tap) = (place / 2 + ahead, place % 2 + 6 - 2 * ahead);
        coarse[half] * COARSE[tap] + detail[half] * DETAIL[tap]
    };
    (0..length).map(|place| (0..4).map(|ahead| term(place, ahead)).sum()).collect()
}

/// Where a value lies, counted from six before the curve, that goes on beyond its ends as in a mirror.
fn mirrored(place: usize, length: usize) -> usize {
    let place = (place as isize - 6).rem_euclid(2 * length as isize) as usize;
    place.min(2 * length - 1 - place)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn the_taps_are_orthonormal() {
        assert!((COARSE.iter().sum::<f64>() - 2.0_f64.sqrt()).abs() < 1e-12);
        assert!(DETAIL.iter().sum::<f64>().abs() < 1e-12);
        let product = |a: &[f64; 8], b: &[f64; 8], shift: usize| -> f64 {
            a[shift..].iter().zip(b).map(|(a, b)| a * b).sum()
        };
        for shift in [0, 2, 4, 6] {
            let one = if shift == 0 { 1.0 } else { 0.0 };
            assert!((product(&COARSE, &COARSE, shift) - one).abs() < 1e-12);
            assert!((product(&DETAIL, &DETAIL, shift) - one).abs() < 1e-12);
            assert!(product(&COARSE, &DETAIL, shift).abs() < 1e-12);
            assert!(product(&DETAIL, &COARSE, shift).abs() < 1e-12);
        }
    }

    #[test]
    fn details_of_cubics_vanish() {
        let cubic: Vec<f64> = (0..40).map(f64::from).map(|x| 0.01 * x.powi(3) - x * x + 3.0).collect();
        let (_, detail) = parted(&cubic);
        assert!(detail[3..20].iter().all(|x| x.abs() < 1e-9), "{detail:?}");
    }

    /// As PyWavelets has it: `pywt.dwt(x, "db4", "symmetric")`.
    #[test]
    fn agrees_with_pywavelets() {
        let (coarse, detail) = parted(&[1.0, 4.0, -2.0, 3.0, 0.0, 5.0, 7.0, -1.0, 2.0, 2.0, 6.0]);
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
        let agree =
            |ours: &[f64], theirs: &[f64]| ours.iter().zip(theirs).all(|(a, b)| (a - b).abs() < 1e-11);
        assert!(coarse.len() == 9 && agree(&coarse, &true_coarse) && agree(&detail, &true_detail));
    }

    #[test]
    fn noise_goes_and_the_curve_stays() {
        let wave = |i: usize| 20.0 * (i as f64 / 100.0).sin();
        // Noise without any tool: a linear congruential generator.
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
        assert!(error(&denoised(&noisy, 5, false)) < 0.1);
        assert!(error(&denoised(&noisy, 5, true)) < 1.0);
        let clean: Vec<f64> = (0..1000).map(wave).collect();
        assert!(error(&denoised(&clean, 5, false)) < 0.01);
    }

    proptest! {
        #[test]
        fn what_is_parted_can_be_joined(values in prop::collection::vec(-1e3..1e3_f64, 1..60)) {
            let (coarse, detail) = parted(&values);
            prop_assert_eq!(coarse.len(), (values.len() + 7) / 2);
            let back = joined(&coarse, &detail, values.len());
            prop_assert!(back.iter().zip(&values).all(|(a, b)| (a - b).abs() < 1e-9));
        }

        #[test]
        fn any_curve_stays_as_long(values in prop::collection::vec(-1e9..1e9_f64, 0..70), own: bool) {
            let smooth = denoised(&values, 5, own);
            prop_assert_eq!(smooth.len(), values.len());
            prop_assert!(smooth.iter().all(|x| x.is_finite()));
        }
    }
}
