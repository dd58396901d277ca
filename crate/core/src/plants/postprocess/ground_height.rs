//! Height of the ground.

use crate::kinematics::Track;
use crate::numeric::stats;
use crate::plants::{Feet, PartLabels};

/// Returns the height of the ground along the up axis, in file units.
///
/// The median height of the lowest joint of planted feet; if no foot is ever planted, the minimum
/// height.
pub(crate) fn height(feet: &Feet, labels: &PartLabels) -> f64 {
    let lowest = |foot: usize, frame: usize| {
        let tracks = &feet.tracks[foot];
        let height = |track: &Track| feet.up.height(&track[frame]);
        let tip = tracks.tip.as_ref().map_or(f64::INFINITY, height);
        height(&tracks.ankle).min(height(&tracks.toe)).min(tip)
    };
    let frames =
        || [0, 1].into_iter().flat_map(|foot| (0..feet.frame_count()).map(move |frame| (foot, frame)));
    let planted = frames().filter(|&(foot, frame)| labels.feet[foot].planted[frame]);
    stats::median_high(planted.map(|(foot, frame)| lowest(foot, frame)))
        .unwrap_or_else(|| frames().map(|(foot, frame)| lowest(foot, frame)).fold(f64::INFINITY, f64::min))
}
