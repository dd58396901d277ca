//! Tracks of both feet, the input of detection.

use crate::bvh::Clip;
use crate::foot::Side;
use crate::kinematics::{self, Track};
use crate::numeric::stats;
use crate::skeleton::{LegRoles, Role, Skeleton, Up};

/// Minimum number of different poses from which their usual duration is known.
const MIN_POSES: usize = 10;
/// Maximum usual duration of a pose in motion, in seconds; longer ones are rest between movements.
const MAX_POSE_TIME: f64 = 0.2;

/// Tracks of both feet, with up axis, leg length and units.
#[derive(Clone, Debug, PartialEq)]
pub struct Feet {
    /// Tracks of the left foot and of the right foot.
    pub tracks: [FootTracks; 2],
    /// Track of the hips, which distinguishes travel from standing.
    pub hips: Track,
    /// Up axis.
    pub up: Up,
    /// Leg length: thigh plus shank, in file units.
    pub leg: f64,
    /// Metres per file unit, for methods with thresholds in metres.
    pub metres_per_unit: f64,
    /// Time between frames, in seconds.
    pub frame_time: f64,
}

/// Tracks of one foot.
#[derive(Clone, Debug, PartialEq)]
pub struct FootTracks {
    /// Track of the ankle, which represents the heel.
    pub ankle: Track,
    /// Track of the toe base, or of the joint that replaces it.
    pub toe: Track,
    /// Track of the tip of the foot, if the skeleton has one in front of the toe.
    pub tip: Option<Track>,
}

/// Error: a clip cannot be labelled.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum DetectError {
    /// The clip is a rest pose.
    #[error("the clip has no motion in which plants could be detected")]
    NoMotion,
    /// The ankles are unknown.
    #[error("no feet were detected; choose both ankle joints")]
    NoFeet,
}

impl Feet {
    /// Computes the tracks of one skeleton of a clip.
    ///
    /// # Errors
    /// If the clip has no motion or the skeleton no feet.
    pub fn new(clip: &Clip, skeleton: &Skeleton) -> Result<Feet, DetectError> {
        if clip.frame_count() == 0 {
            return Err(DetectError::NoMotion);
        }
        let foot = |side| {
            let tip = skeleton.roles.get(LegRoles::for_side(side).tip);
            Some((skeleton.heel(side)?, skeleton.toe(side)?, tip))
        };
        let (Some(left), Some(right), Some(leg)) = (foot(Side::Left), foot(Side::Right), skeleton.leg) else {
            return Err(DetectError::NoFeet);
        };
        let mut joints = vec![skeleton.roles.get(Role::Hips).unwrap_or(skeleton.root)];
        for (ankle, toe, tip) in [left, right] {
            joints.extend([ankle, toe]);
            joints.extend(tip);
        }
        // One pass computes all tracks because the feet share ancestors.
        let mut tracks = kinematics::tracks(clip, &joints).into_iter();
        let mut next = || tracks.next().expect("each joint has a track");
        Ok(Feet {
            hips: next(),
            tracks: [left, right].map(|(_, _, tip)| FootTracks {
                ankle: next(),
                toe: next(),
                tip: tip.map(|_| next()),
            }),
            up: skeleton.up,
            leg,
            metres_per_unit: skeleton.metres_per_unit,
            frame_time: clip.frame_time(),
        })
    }

    /// Returns the number of frames.
    pub fn frame_count(&self) -> usize {
        self.tracks[0].ankle.len()
    }

    /// Returns the number of frames for which each pose usually lasts: more than 1 if the file has a
    /// higher rate than its motion.
    pub(crate) fn repeats(&self) -> usize {
        let tracks = || self.tracks.iter().flat_map(|foot| [&foot.ankle, &foot.toe]);
        let changes: Vec<usize> = (1..self.frame_count())
            .filter(|&frame| tracks().any(|track| track[frame] != track[frame - 1]))
            .collect();
        // The first and the last pose may be cut off.
        let mut lengths: Vec<f64> = changes.windows(2).map(|pair| (pair[1] - pair[0]) as f64).collect();
        if lengths.len() < MIN_POSES {
            return 1;
        }
        let middle = lengths.len() / 2;
        let median = stats::nth_smallest(&mut lengths, middle);
        if median * self.frame_time <= MAX_POSE_TIME { median as usize } else { 1 }
    }

    /// Returns the number of frames in `seconds`, rounded down. The margin makes 0.0333 s and 1/30
    /// s equal.
    pub(crate) fn frames_in(&self, seconds: f64) -> usize {
        (seconds / self.frame_time + 0.05).floor() as usize
    }
}
