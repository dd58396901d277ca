//! Height of the ground.

use crate::kinematics::Track;
use crate::numeric::stats;
use crate::plants::{Feet, PartLabels};

/// Returns the height of the lowest joint of each foot per frame, along the up axis in file units.
pub(crate) fn lowest(feet: &Feet) -> [Vec<f64>; 2] {
    feet.tracks.each_ref().map(|tracks| {
        let height = |track: &Track, frame: usize| feet.up.height(&track[frame]);
        let lowest = |frame: usize| {
            let tip = tracks.tip.as_ref().map_or(f64::INFINITY, |tip| height(tip, frame));
            height(&tracks.ankle, frame).min(height(&tracks.toe, frame)).min(tip)
        };
        (0..feet.frame_count()).map(lowest).collect()
    })
}

/// Returns the height of the ground along the up axis, in file units.
///
/// The median height of the lowest joint of planted feet; if no foot is ever planted, the minimum
/// height.
pub(crate) fn height(lowest: &[Vec<f64>; 2], labels: &PartLabels) -> f64 {
    let all = || lowest.iter().zip(&labels.feet).flat_map(|(lowest, foot)| lowest.iter().zip(&foot.planted));
    let planted = all().filter(|(_, planted)| **planted).map(|(lowest, _)| *lowest);
    stats::median_high(planted)
        .unwrap_or_else(|| all().map(|(lowest, _)| *lowest).fold(f64::INFINITY, f64::min))
}
