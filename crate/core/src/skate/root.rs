//! Offset of the hips that preserves the lengths of the legs and lets them reach their feet.

use nalgebra::{Matrix3, SVector, Vector3};

use crate::skate::constraints::{Correction, Settings};
use crate::skate::knee;
use crate::skate::leg::Leg;

/// Weight of a free foot relative to a planted one.
const FREE_WEIGHT: f64 = 0.05;

/// Weight of the offset itself relative to the change of a leg's length.
const OFFSET_WEIGHT: f64 = 0.05;

/// Minimum downward component of a leg, as a fraction, for which lower hips bring it nearer to its
/// foot.
const MIN_DOWNWARD: f64 = 0.3;

/// Returns the offset of the hips in each frame, in file units.
///
/// The offset that minimises the changes of the leg lengths (least squares, planted legs weighted
/// more), smoothed over `smoothing` frames. It is lowered, smoothly over `lowering` frames, where a
/// leg would have to be straighter than [`knee::reach`] allows.
pub(crate) fn hip_offset(
    legs: &[Leg; 2],
    corrections: &[Correction; 2],
    planted: &[Vec<bool>; 2],
    settings: &Settings,
    [smoothing, lowering]: [usize; 2],
) -> Vec<Vector3<f64>> {
    let count = legs[0].ankle.len();
    let mut terms: Vec<SVector<f64, 9>> = vec![SVector::zeros(); count];
    for ((leg, correction), planted) in legs.iter().zip(corrections).zip(planted) {
        for frame in 0..count {
            let weight = knee::stiffness(leg, frame) * if planted[frame] { 1.0 } else { FREE_WEIGHT };
            let along = (leg.ankle[frame] - leg.hip[frame]).try_normalize(1e-9).unwrap_or_default();
            let weighted = along * (weight * along.dot(&correction.ankle[frame]));
            let [x, y, z] = along.into();
            let term = [x * x, y * y, z * z, x * y, y * z, z * x].map(|term| weight * term);
            terms[frame] += SVector::from_iterator(term.into_iter().chain(weighted.iter().copied()));
        }
    }
    for _ in 0..3 {
        terms = sliding_mean(&terms, smoothing);
    }
    let mut offsets: Vec<Vector3<f64>> = terms
        .iter()
        .map(|term| {
            let [xx, yy, zz, xy, yz, zx] = std::array::from_fn(|n| term[n]);
            let matrix =
                Matrix3::new(xx, xy, zx, xy, yy, yz, zx, yz, zz) + Matrix3::identity() * OFFSET_WEIGHT;
            matrix.lu().solve(&Vector3::new(term[6], term[7], term[8])).unwrap_or_default()
        })
        .collect();
    lower_hips(&mut offsets, legs, corrections, settings, lowering);
    offsets
}

/// Lowers the hips where a leg does not reach its foot.
fn lower_hips(
    offsets: &mut [Vector3<f64>],
    legs: &[Leg; 2],
    corrections: &[Correction; 2],
    settings: &Settings,
    lowering: usize,
) {
    let up = settings.up.vector();
    let shortfall = |frame: usize, leg: &Leg, correction: &Correction| {
        if correction.ankle[frame] == Vector3::zeros() && offsets[frame] == Vector3::zeros() {
            return 0.0;
        }
        let hip_to_ankle = leg.ankle[frame] + correction.ankle[frame] - leg.hip[frame] - offsets[frame];
        let drop = -up.dot(&hip_to_ankle);
        let reach = knee::reach(leg, frame);
        if drop < MIN_DOWNWARD * hip_to_ankle.norm() || hip_to_ankle.norm() <= reach {
            return 0.0;
        }
        let horizontal = hip_to_ankle.norm_squared() - drop * drop;
        drop - (reach * reach - horizontal).max(0.0).sqrt()
    };
    let shortfalls: Vec<SVector<f64, 1>> = (0..offsets.len())
        .map(|frame| {
            let max = legs.iter().zip(corrections).map(|(leg, correction)| shortfall(frame, leg, correction));
            SVector::from([max.fold(0.0, f64::max)])
        })
        .collect();
    // The means have at most the width of the maximum, so the hips are lowered sufficiently
    // everywhere.
    let half = lowering / 3;
    let mut lowered = sliding_maximum(&shortfalls, 3 * half);
    for _ in 0..3 {
        lowered = sliding_mean(&lowered, half);
    }
    for (offset, lowered) in offsets.iter_mut().zip(lowered) {
        *offset -= up * lowered[0];
    }
}

/// Returns the mean over `half` frames on either side; the end values are repeated.
fn sliding_mean<const N: usize>(samples: &[SVector<f64, N>], half: usize) -> Vec<SVector<f64, N>> {
    let Some(last) = samples.len().checked_sub(1) else { return Vec::new() };
    let weight = 1.0 / (2 * half + 1) as f64;
    let at = |frame: isize| samples[frame.clamp(0, last as isize) as usize];
    let half = half as isize;
    let mut sum = SVector::zeros();
    let means = (0..=last as isize).map(|frame| {
        // Summed from scratch regularly, so that rounding errors do not accumulate.
        if frame % 256 == 0 {
            sum = (frame - half..=frame + half).map(at).sum();
        } else {
            sum += at(frame + half) - at(frame - half - 1);
        }
        sum * weight
    });
    means.collect()
}

/// Returns the maximum within `half` frames of each frame.
fn sliding_maximum(samples: &[SVector<f64, 1>], half: usize) -> Vec<SVector<f64, 1>> {
    let window = |frame: usize| frame.saturating_sub(half)..(frame + half + 1).min(samples.len());
    let maximum = |frame| samples[window(frame)].iter().map(|sample| sample[0]).fold(0.0, f64::max);
    (0..samples.len()).map(|frame| SVector::from([maximum(frame)])).collect()
}
