//! Frames that belong to no motion: leading and trailing poses, and jumps in between.

use std::ops::Range;

use crate::kinematics::Track;
use crate::plants::Feet;

/// A foot faster than this, in legs per second, near an end of the clip: a pose that was stuck on.
const STUCK_ON: f64 = 12.0;
/// Frame steps from either end in which such poses are looked for.
const STEPS: usize = 5;
/// Frames dropped after the step, in which filters of the recording still ring.
const RINGING: usize = 2;
/// Both feet faster than this, in legs per second: no motion, but a cut.
const TELEPORT: f64 = 25.0;

/// The runs of frames that are one motion each; at least one frame is kept.
pub(crate) fn pieces(feet: &Feet) -> Vec<Range<usize>> {
    let frames = feet.frame_count();
    let kept = kept(feet);
    let mut pieces = Vec::new();
    let mut start = kept.start;
    for step in kept.start..kept.end.saturating_sub(1).min(frames) {
        let is_cut = feet.tracks.iter().all(|foot| step_speed(feet, &foot.ankle, step) > TELEPORT);
        if is_cut {
            pieces.push(start..step + 1);
            start = step + 1;
        }
    }
    pieces.push(start..kept.end);
    pieces
}

fn kept(feet: &Feet) -> Range<usize> {
    let frames = feet.frame_count();
    if frames < 4 * STEPS {
        return 0..frames;
    }
    let is_stuck_on = |step: &usize| {
        feet.tracks
            .iter()
            .flat_map(|foot| [&foot.ankle, &foot.toe])
            .any(|track| step_speed(feet, track, *step) > STUCK_ON)
    };
    // Step k leads from frame k to frame k + 1.
    let first = (0..STEPS).rev().find(is_stuck_on).map_or(0, |step| step + 1 + RINGING);
    let end = (frames - 1 - STEPS..frames - 1).find(is_stuck_on).map_or(frames, |step| step + 1 - RINGING);
    first..end
}

/// Speed of the step from `frame` to the next, in legs per second.
fn step_speed(feet: &Feet, track: &Track, frame: usize) -> f64 {
    (track[frame + 1] - track[frame]).norm() / (feet.frame_time * feet.leg)
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;

    use super::*;
    use crate::plants::FootTracks;
    use crate::skeleton::Up;

    /// Feet of a leg of one unit at 100 Hz that jump by one unit where told.
    fn feet(frames: usize, jumps: &[usize]) -> Feet {
        let track: Track = (0..frames)
            .map(|frame| Vector3::x() * jumps.iter().filter(|&&jump| frame >= jump).count() as f64)
            .collect();
        let foot = FootTracks { ankle: track.clone(), toe: track.clone(), tip: None };
        Feet {
            tracks: [foot.clone(), foot],
            hips: track,
            up: Up::Y,
            leg: 1.0,
            metres_per_unit: 1.0,
            frame_time: 0.01,
        }
    }

    #[test]
    fn whole_clips_stay_whole() {
        assert_eq!(pieces(&feet(100, &[])), [0..100]);
    }

    #[test]
    fn poses_at_the_ends_are_dropped() {
        assert_eq!(pieces(&feet(100, &[1])), [3..100]);
        assert_eq!(pieces(&feet(100, &[2, 99])), [4..97]);
    }

    #[test]
    fn teleports_split() {
        assert_eq!(pieces(&feet(100, &[50])), [0..50, 50..100]);
    }
}
