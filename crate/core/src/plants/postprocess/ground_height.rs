//! Where the ground is.

use crate::kinematics::Track;
use crate::plants::{Feet, PartLabels};

/// The height of the lowest joint of each foot, per frame, along the up axis and in file units.
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

/// Height of the ground along the up axis, in file units.
///
/// The middle height of the lowest joint of a planted foot; where no foot is
/// ever planted, the lowest that any comes.
pub(crate) fn height(lowest: &[Vec<f64>; 2], labels: &PartLabels) -> f64 {
    let all = || lowest.iter().zip(&labels.feet).flat_map(|(lowest, foot)| lowest.iter().zip(&foot.planted));
    let mut planted: Vec<f64> = all().filter(|(_, planted)| **planted).map(|(lowest, _)| *lowest).collect();
    if planted.is_empty() {
        return all().map(|(lowest, _)| *lowest).fold(f64::INFINITY, f64::min);
    }
    let middle = planted.len() / 2;
    *planted.select_nth_unstable_by(middle, f64::total_cmp).1
}
