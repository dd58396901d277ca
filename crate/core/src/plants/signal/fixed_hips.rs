//! Ground of clips whose hips never move, as the root motion is missing or positions are relative to the hips.
//!
//! The ground then moves up and down, and to and fro, with the hips. The lowest part of both feet is on the
//! ground at almost any time, so that its velocity is that of the ground. In flight it is not, and what the hips
//! did there is lost.

use std::ops::Range;

use nalgebra::Vector3;

use crate::numeric::stats;
use crate::plants::Feet;

/// Velocities of ankle and toe of one foot, in file units per second.
pub(super) type FootVelocities = [Vector3<f64>; 2];

/// Maximum motion of hips that never move, in leg lengths: less than the sway of a standing person.
const MAX_MOTION: f64 = 0.001;

/// True if the hips do not move in a span of frames; false if their track is empty.
pub(crate) fn are_fixed(feet: &Feet, span: &Range<usize>) -> bool {
    let Some(hips) = feet.hips.get(span.clone()) else { return false };
    hips.iter().all(|position| (position - hips[0]).norm() <= MAX_MOTION * feet.leg)
}

/// Returns the velocity of the lowest part of both feet at every `step`-th frame of a span.
///
/// `parts` are the velocities of ankle and toe of both feet at these frames.
pub(super) fn velocities(
    feet: &Feet,
    span: &Range<usize>,
    step: usize,
    parts: &[[FootVelocities; 2]],
) -> Vec<Vector3<f64>> {
    let height = |position: &Vector3<f64>| feet.up.height(position);
    let frames = span.clone().step_by(step);
    let rise = |frame: usize| {
        feet.tracks.each_ref().map(|foot| height(&foot.ankle[frame]) - height(&foot.toe[frame]))
    };
    // Height of the ankle above the toe of a foot that is flat on the ground, as it is most of the time.
    let flat_rise = stats::nearest_percentile(frames.clone().flat_map(rise).collect(), 0.5);
    let lowest = |(frame, parts): (usize, &[FootVelocities; 2])| {
        let mut lowest = (f64::INFINITY, Vector3::zeros());
        for (foot, [ankle, toe]) in feet.tracks.iter().zip(parts) {
            let heights = [height(&foot.ankle[frame]) - flat_rise, height(&foot.toe[frame])];
            for (height, velocity) in heights.into_iter().zip([ankle, toe]) {
                if height < lowest.0 {
                    lowest = (height, *velocity);
                }
            }
        }
        lowest.1
    };
    frames.zip(parts).map(lowest).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants::FootTracks;
    use crate::skeleton::Up;

    #[test]
    fn hips_that_sway_are_not_fixed() {
        let hips = vec![Vector3::zeros(); 600];
        let foot = FootTracks { ankle: hips.clone(), toe: hips.clone(), tip: None };
        let tracks = [foot.clone(), foot];
        let mut feet = Feet { tracks, hips, up: Up::Y, leg: 1.0, metres_per_unit: 1.0, frame_time: 0.01 };
        assert!(are_fixed(&feet, &(0..600)));
        feet.hips[300].x = 0.002;
        assert!(!are_fixed(&feet, &(0..600)) && are_fixed(&feet, &(301..600)));
        feet.hips.clear();
        assert!(!are_fixed(&feet, &(0..600)));
    }
}
