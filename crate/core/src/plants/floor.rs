//! Where the ground is.

use super::{Feet, PartLabels};

/// Height of the ground along the up axis, in file units.
///
/// The middle height of the lowest joint of a planted foot; where no foot is
/// ever planted, the lowest that any comes.
pub(super) fn height(feet: &Feet, labels: &PartLabels) -> f64 {
    let lowest = |foot: usize, frame: usize| {
        let tracks = &feet.tracks[foot];
        let joints = [Some(&tracks.ankle), Some(&tracks.toe), tracks.tip.as_ref()];
        let heights = joints.into_iter().flatten().map(|track| feet.up.height(&track[frame]));
        heights.fold(f64::INFINITY, f64::min)
    };
    let places = || (0..2).flat_map(|foot| (0..feet.frame_count()).map(move |frame| (foot, frame)));
    let mut planted: Vec<f64> = places()
        .filter(|&(foot, frame)| labels.feet[foot].planted[frame])
        .map(|(foot, frame)| lowest(foot, frame))
        .collect();
    if planted.is_empty() {
        return places().map(|(foot, frame)| lowest(foot, frame)).fold(f64::INFINITY, f64::min);
    }
    let middle = planted.len() / 2;
    *planted.select_nth_unstable_by(middle, f64::total_cmp).1
}
