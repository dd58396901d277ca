//! The positions that detection needs: ankle and toe of both feet.

use crate::bvh::Clip;
use crate::foot::Side;
use crate::kinematics;
use crate::kinematics::Track;
use crate::skeleton::{LegRoles, Role, Skeleton, Up};

/// Both feet of a clip in motion, with the measures that make them comparable.
#[derive(Clone, Debug, PartialEq)]
pub struct Feet {
    /// The left foot's tracks, then the right's.
    pub tracks: [FootTracks; 2],
    /// The hips' track, for telling travel from standing.
    pub hips: Track,
    /// The axis that points up.
    pub up: Up,
    /// Thigh plus shank, in the tracks' units.
    pub leg: f64,
    /// Metres per unit, for methods whose thresholds are in metres.
    pub metres_per_unit: f64,
    /// Seconds from one frame to the next.
    pub frame_time: f64,
}

/// The tracks of one foot.
#[derive(Clone, Debug, PartialEq)]
pub struct FootTracks {
    /// The ankle's, which stands for the heel.
    pub ankle: Track,
    /// The toe base's, or that of what stands in for it.
    pub toe: Track,
    /// That of the foot's end, where it has one ahead of the toe.
    pub tip: Option<Track>,
}

/// Why a clip has no plants to find.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum DetectError {
    /// The clip is a rest pose.
    #[error("the clip has no motion: there is nothing to detect")]
    NoMotion,
    /// The ankles are not known.
    #[error("no pair of feet was found: name the joints of both ankles")]
    NoFeet,
}

impl Feet {
    /// The feet of one skeleton of a clip.
    ///
    /// # Errors
    /// If the clip has no motion or the skeleton no feet.
    pub fn of(clip: &Clip, skeleton: &Skeleton) -> Result<Feet, DetectError> {
        if clip.frame_count() == 0 {
            return Err(DetectError::NoMotion);
        }
        let foot = |side| {
            let tip = skeleton.roles.get(LegRoles::of(side).tip);
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
        // One pass for all: the feet share the joints above them.
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

    /// Number of frames.
    pub fn frame_count(&self) -> usize {
        self.tracks[0].ankle.len()
    }

    /// Frames that last `seconds`, rounded down; the margin keeps 0.0333 and 1/30 s alike.
    pub(crate) fn frames_in(&self, seconds: f64) -> usize {
        (seconds / self.frame_time + 0.05).floor() as usize
    }
}
