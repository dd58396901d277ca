//! Keeps the pelvis where standing legs can reach the ground without being stretched.

use plantigrade::foot::Side;

use super::PelvisPose;
use crate::character::{Build, outward};
use crate::feet::FootPose;
use crate::grid::Grid;
use crate::maths::Vec3;

/// Length that a standing leg may take, as a share of its full length.
const STRETCH: f64 = 0.983;

/// Seconds over which the lowering is spread.
const SPREAD: f64 = 0.1;

/// Seconds around the end of a flight in which the legs must reach the ground.
const NEAR: f64 = 0.05;

/// Lowers the pelvis smoothly wherever a standing foot would be out of reach.
pub fn lower(poses: &mut [PelvisPose], feet: &[Vec<FootPose>; 2], build: &Build) {
    let excess: Vec<f64> = (0..poses.len())
        .map(|n| {
            let over = Side::BOTH.map(|side| excess(&poses[n], &feet[side as usize][n], side, build));
            over[0].max(over[1]).max(0.0)
        })
        .collect();
    if excess.iter().all(|&e| e <= 0.0) {
        return;
    }
    // The kernel is no wider than the window of the maximum: what is taken off is
    // never less than the excess.
    let half = Grid::points(SPREAD) as usize;
    let wide = sliding_maximum(&excess, half);
    let kernel: Vec<f64> = (0..=2 * half)
        .map(|n| 1.0 - libm::cos(std::f64::consts::TAU * (n as f64 + 1.0) / (2 * half + 2) as f64))
        .collect();
    let total: f64 = kernel.iter().sum();
    let last = poses.len() - 1;
    for (n, pose) in poses.iter_mut().enumerate() {
        let spread = kernel
            .iter()
            .enumerate()
            .map(|(k, weight)| weight * wide[(n + k).saturating_sub(half).min(last)]);
        pose.position.y -= spread.sum::<f64>() / total;
    }
}

/// How much too high the pelvis is around `time`, in metres; 0 if it is not.
pub fn shortfall(
    poses: &[PelvisPose],
    feet: &[Vec<FootPose>; 2],
    build: &Build,
    grid: &Grid,
    time: f64,
) -> f64 {
    let half = Grid::points(NEAR) as usize;
    let centre = grid.at(time);
    let around = centre.saturating_sub(half)..(centre + half + 1).min(poses.len());
    let excesses =
        around.flat_map(|n| Side::BOTH.map(|side| excess(&poses[n], &feet[side as usize][n], side, build)));
    excesses.fold(0.0, f64::max)
}

/// How much too high the pelvis is for one foot, in metres; negative if it is not.
fn excess(pelvis: &PelvisPose, foot: &FootPose, side: Side, build: &Build) -> f64 {
    if foot.freedom > 0.5 {
        return 0.0;
    }
    let hip = hip(pelvis, side, build);
    let apart = hip - foot.ankle;
    let across = apart.x * apart.x + apart.z * apart.z;
    let length = STRETCH * build.leg();
    let room = (length * length - across).max(0.1 * length * length);
    apart.y - room.sqrt()
}

/// The hip joint.
pub(crate) fn hip(pelvis: &PelvisPose, side: Side, build: &Build) -> Vec3 {
    let rest = Vec3::new(outward(side) * build.hip, -build.pelvis_rise(), 0.0);
    pelvis.position + pelvis.rotation * rest
}

/// The greatest sample within `half` of each.
fn sliding_maximum(samples: &[f64], half: usize) -> Vec<f64> {
    (0..samples.len())
        .map(|n| {
            let window = &samples[n.saturating_sub(half)..(n + half + 1).min(samples.len())];
            window.iter().copied().fold(f64::NEG_INFINITY, f64::max)
        })
        .collect()
}
