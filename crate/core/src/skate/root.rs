//! How the hips go along, so that legs keep their length and reach their feet.

use nalgebra::{Matrix3, SVector, Vector3};

use crate::skate::constraints::{Correction, Setting};
use crate::skate::knee;
use crate::skate::leg::{Leg, upright};

/// What a free foot's say in the hips' way is, next to a planted one's.
const FREE: f64 = 0.05;

/// What it costs the hips to move at all, next to the change of a leg's length.
const INERTIA: f64 = 0.05;

/// A leg has to point down at least this much for lower hips to bring it nearer to its foot.
const DOWN: f64 = 0.3;

/// How far the hips move in each frame, in file units.
///
/// The way that changes the lengths of the legs least (least squares along each of them, the
/// standing ones first), smoothed over `smooth` frames; and then down, smoothly over `spread`
/// frames, wherever a leg would have to be straighter than [`knee::reach`] lets it.
pub(crate) fn way(
    legs: &[Leg; 2],
    corrections: &[Correction; 2],
    planted: &[Vec<bool>; 2],
    setting: &Setting,
    [smooth, spread]: [usize; 2],
) -> Vec<Vector3<f64>> {
    let count = legs[0].ankle.len();
    let mut terms: Vec<SVector<f64, 9>> = vec![SVector::zeros(); count];
    for ((leg, correction), planted) in legs.iter().zip(corrections).zip(planted) {
        for frame in 0..count {
            let weight = knee::stiffness(leg, frame) * if planted[frame] { 1.0 } else { FREE };
            let along = (leg.ankle[frame] - leg.hip[frame]).try_normalize(1e-9).unwrap_or_default();
            let pulled = along * (weight * along.dot(&correction.ankle[frame]));
            let [x, y, z] = along.into();
            let term = [x * x, y * y, z * z, x * y, y * z, z * x].map(|term| weight * term);
            terms[frame] += SVector::from_iterator(term.into_iter().chain(pulled.iter().copied()));
        }
    }
    for _ in 0..3 {
        terms = mean(&terms, smooth);
    }
    let mut way: Vec<Vector3<f64>> = terms
        .iter()
        .map(|term| {
            let [xx, yy, zz, xy, yz, zx] = std::array::from_fn(|n| term[n]);
            let matrix = Matrix3::new(xx, xy, zx, xy, yy, yz, zx, yz, zz) + Matrix3::identity() * INERTIA;
            matrix.lu().solve(&Vector3::new(term[6], term[7], term[8])).unwrap_or_default()
        })
        .collect();
    lower(&mut way, legs, corrections, setting, spread);
    way
}

/// Lowers the hips where a leg does not reach its foot.
fn lower(
    way: &mut [Vector3<f64>],
    legs: &[Leg; 2],
    corrections: &[Correction; 2],
    setting: &Setting,
    spread: usize,
) {
    let upright = upright(setting.up);
    let lack = |frame: usize, leg: &Leg, correction: &Correction| {
        if correction.ankle[frame] == Vector3::zeros() && way[frame] == Vector3::zeros() {
            return 0.0;
        }
        let apart = leg.ankle[frame] + correction.ankle[frame] - leg.hip[frame] - way[frame];
        let drop = -upright.dot(&apart);
        let reach = knee::reach(leg, frame);
        if drop < DOWN * apart.norm() || apart.norm() <= reach {
            return 0.0;
        }
        let across = apart.norm_squared() - drop * drop;
        drop - (reach * reach - across).max(0.0).sqrt()
    };
    let lacks: Vec<SVector<f64, 1>> = (0..way.len())
        .map(|frame| {
            let most = legs.iter().zip(corrections).map(|(leg, correction)| lack(frame, leg, correction));
            SVector::from([most.fold(0.0, f64::max)])
        })
        .collect();
    // The means reach no farther than the maximum: nowhere is less taken off than is lacking.
    let half = spread / 3;
    let mut lowered = most(&lacks, 3 * half);
    for _ in 0..3 {
        lowered = mean(&lowered, half);
    }
    for (way, lowered) in way.iter_mut().zip(lowered) {
        *way -= upright * lowered[0];
    }
}

/// The mean over `half` frames to either side; ends are held.
fn mean<const N: usize>(samples: &[SVector<f64, N>], half: usize) -> Vec<SVector<f64, N>> {
    let Some(last) = samples.len().checked_sub(1) else { return Vec::new() };
    let share = 1.0 / (2 * half + 1) as f64;
    let at = |frame: isize| samples[frame.clamp(0, last as isize) as usize];
    let half = half as isize;
    let mut sum = SVector::zeros();
    let means = (0..=last as isize).map(|frame| {
        // Summed anew now and then, so that rounding does not build up.
        if frame % 256 == 0 {
            sum = (frame - half..=frame + half).map(at).sum();
        } else {
            sum += at(frame + half) - at(frame - half - 1);
        }
        sum * share
    });
    means.collect()
}

/// The greatest sample within `half` frames of each.
fn most(samples: &[SVector<f64, 1>], half: usize) -> Vec<SVector<f64, 1>> {
    let window = |frame: usize| frame.saturating_sub(half)..(frame + half + 1).min(samples.len());
    let greatest = |frame| samples[window(frame)].iter().map(|sample| sample[0]).fold(0.0, f64::max);
    (0..samples.len()).map(|frame| SVector::from([greatest(frame)])).collect()
}
