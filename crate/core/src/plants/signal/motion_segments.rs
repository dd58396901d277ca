//! Spans of continuous motion: excludes poses at the ends of a clip and splits it at jumps.

use std::ops::Range;

use crate::kinematics::Track;
use crate::plants::Feet;

/// Foot speed near an end of the clip that indicates an added pose, in leg lengths per second.
const ADDED_POSE_SPEED: f64 = 12.0;
/// Number of frame steps at either end in which added poses are searched.
const SEARCH_STEPS: usize = 5;
/// Frames dropped next to an added pose, in which filters of the recording still ring.
const RINGING_FRAMES: usize = 2;
/// Speed of both feet that indicates a jump and not motion, in leg lengths per second.
const JUMP_SPEED: f64 = 25.0;

/// Returns the spans of continuous motion; at least one frame remains.
pub(crate) fn motion_spans(feet: &Feet) -> Vec<Range<usize>> {
    let frames = feet.frame_count();
    let pose_time = feet.frame_time * feet.repeats() as f64;
    let frames_left = without_added_poses(feet, pose_time);
    let mut spans = Vec::new();
    let mut start = frames_left.start;
    for step in frames_left.start..frames_left.end.saturating_sub(1).min(frames) {
        let is_jump =
            feet.tracks.iter().all(|foot| step_speed(feet, &foot.ankle, step, pose_time) > JUMP_SPEED);
        if is_jump {
            spans.push(start..step + 1);
            start = step + 1;
        }
    }
    spans.push(start..frames_left.end);
    spans
}

fn without_added_poses(feet: &Feet, pose_time: f64) -> Range<usize> {
    let frames = feet.frame_count();
    if frames < 4 * SEARCH_STEPS {
        return 0..frames;
    }
    let is_added_pose = |step: &usize| {
        feet.tracks
            .iter()
            .flat_map(|foot| [&foot.ankle, &foot.toe])
            .any(|track| step_speed(feet, track, *step, pose_time) > ADDED_POSE_SPEED)
    };
    // Step k leads from frame k to frame k + 1.
    let first = (0..SEARCH_STEPS).rev().find(is_added_pose).map_or(0, |step| step + 1 + RINGING_FRAMES);
    let end = (frames - 1 - SEARCH_STEPS..frames - 1)
        .find(is_added_pose)
        .map_or(frames, |step| step + 1 - RINGING_FRAMES);
    first..end
}

/// Returns the speed of the step from `frame` to the next, in leg lengths per second, if a pose takes
/// `pose_time` seconds.
fn step_speed(feet: &Feet, track: &Track, frame: usize, pose_time: f64) -> f64 {
    (track[frame + 1] - track[frame]).norm() / (pose_time * feet.leg)
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;

    use super::*;
    use crate::plants::FootTracks;
    use crate::skeleton::Up;

    /// Feet of a person with legs of one unit at 100 Hz, which jump by one unit at the given
    /// frames.
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
    fn continuous_clips_are_one_span() {
        assert_eq!(motion_spans(&feet(100, &[])), [0..100]);
    }

    #[test]
    fn added_poses_are_dropped() {
        assert_eq!(motion_spans(&feet(100, &[1])), [3..100]);
        assert_eq!(motion_spans(&feet(100, &[2, 99])), [4..97]);
    }

    #[test]
    fn steps_between_repeated_poses_are_no_jumps() {
        let every = |frames: usize| (1..100 / frames).map(|pose| pose * frames).collect::<Vec<_>>();
        // A quarter of the leg in 0.04 s is ordinary motion; in a single frame it would be an added pose.
        let feet = Feet { leg: 4.0, ..feet(100, &every(4)) };
        assert_eq!(feet.repeats(), 4);
        assert_eq!(motion_spans(&feet), [0..100]);
    }

    #[test]
    fn jumps_split_the_clip() {
        assert_eq!(motion_spans(&feet(100, &[50])), [0..50, 50..100]);
    }
}
