//! Lowering of the pelvis so that standing legs reach the ground without overextension.

use plantigrade::foot::Side;

use super::pelvis_pose::PelvisPose;
use crate::character::{Proportions, lateral_sign};
use crate::foot_path::FootPose;
use crate::math::TimeGrid;
use crate::math::Vec3;

/// Maximum length of a standing leg, as a fraction of its full length.
const MAX_EXTENSION: f64 = 0.983;

/// Half-width of the smoothing of the lowering, in seconds.
const SMOOTHING_TIME: f64 = 0.1;

/// Time around the ends of a flight in which the legs must reach the ground, in seconds.
const FLIGHT_END_TIME: f64 = 0.05;

/// Lowers the pelvis smoothly where a standing foot would be out of reach.
pub fn lower_pelvis(poses: &mut [PelvisPose], feet: &[Vec<FootPose>; 2], proportions: &Proportions) {
    let excess: Vec<f64> = (0..poses.len())
        .map(|n| {
            let over = Side::BOTH.map(|side| excess(&poses[n], &feet[side as usize][n], side, proportions));
            over[0].max(over[1]).max(0.0)
        })
        .collect();
    if excess.iter().all(|&e| e <= 0.0) {
        return;
    }
    // The kernel is not wider than the window of the maximum, so the pelvis is lowered by at least
    // the excess.
    let half = TimeGrid::points(SMOOTHING_TIME) as usize;
    let wide = sliding_maximum(&excess, half);
    let kernel: Vec<f64> = (0..=2 * half)
        .map(|n| 1.0 - libm::cos(std::f64::consts::TAU * (n as f64 + 1.0) / (2 * half + 2) as f64))
        .collect();
    let total: f64 = kernel.iter().sum();
    let last = poses.len() - 1;
    for (n, pose) in poses.iter_mut().enumerate() {
        let weighted = kernel
            .iter()
            .enumerate()
            .map(|(k, weight)| weight * wide[(n + k).saturating_sub(half).min(last)]);
        pose.position.y -= weighted.sum::<f64>() / total;
    }
}

/// Returns how far the pelvis is too high around `time`, in metres; 0 if all feet are in reach.
pub fn excess_height(
    poses: &[PelvisPose],
    feet: &[Vec<FootPose>; 2],
    proportions: &Proportions,
    grid: &TimeGrid,
    time: f64,
) -> f64 {
    let half = TimeGrid::points(FLIGHT_END_TIME) as usize;
    let centre = grid.point_at(time);
    let around = centre.saturating_sub(half)..(centre + half + 1).min(poses.len());
    let excesses = around
        .flat_map(|n| Side::BOTH.map(|side| excess(&poses[n], &feet[side as usize][n], side, proportions)));
    excesses.fold(0.0, f64::max)
}

/// Returns how far the pelvis is too high for one foot, in metres; negative if the foot is in
/// reach.
fn excess(pelvis: &PelvisPose, foot: &FootPose, side: Side, proportions: &Proportions) -> f64 {
    if foot.freedom > 0.5 {
        return 0.0;
    }
    let hip = hip(pelvis, side, proportions);
    let offset = hip - foot.ankle;
    let horizontal = offset.x * offset.x + offset.z * offset.z;
    let length = MAX_EXTENSION * proportions.leg_length();
    let vertical = (length * length - horizontal).max(0.1 * length * length);
    offset.y - vertical.sqrt()
}

/// Returns the position of the hip joint.
pub(crate) fn hip(pelvis: &PelvisPose, side: Side, proportions: &Proportions) -> Vec3 {
    let rest = Vec3::new(lateral_sign(side) * proportions.hip, -proportions.pelvis_above_hips(), 0.0);
    pelvis.position + pelvis.rotation * rest
}

/// Returns the maximum within `half` samples of each sample.
fn sliding_maximum(samples: &[f64], half: usize) -> Vec<f64> {
    (0..samples.len())
        .map(|n| {
            let window = &samples[n.saturating_sub(half)..(n + half + 1).min(samples.len())];
            window.iter().copied().fold(f64::NEG_INFINITY, f64::max)
        })
        .collect()
}
