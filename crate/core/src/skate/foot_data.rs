//! Tracks, phases and plants of both feet, and their slide.

use std::ops::Range;

use nalgebra::Vector3;

use crate::bvh::Clip;
use crate::foot::Side;
use crate::kinematics::Track;
use crate::plants::{Feet, FootTracks, Ground};
use crate::skate::contacts::Contacts;
use crate::skate::heel;
use crate::skate::leg::{self, Joints, Leg};
use crate::skate::measure::{self, Skate, Slide};
use crate::skate::phases::{self, Phase};
use crate::skeleton::Skeleton;

/// Error: foot skate cannot be measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SkateError {
    /// The clip is a rest pose.
    #[error("the clip has no motion, so foot skate cannot be measured")]
    NoMotion,
    /// The ankles are unknown.
    #[error("no feet were detected; choose both ankle joints")]
    NoFeet,
    /// The labels belong to another clip.
    #[error("the labels have {found} frames, but the clip has {frames}")]
    Length {
        /// Number of frames of the labels.
        found: usize,
        /// Number of frames of the clip.
        frames: usize,
    },
}

/// Measures the slide of every plant. The time is proportional to the number of frames.
///
/// # Errors
/// If the clip has no motion, the skeleton has no feet, or the labels have another length.
pub fn measure(clip: &Clip, skeleton: &Skeleton, contacts: &Contacts) -> Result<Skate, SkateError> {
    Ok(FootData::new(clip, skeleton, contacts)?.skate(skeleton))
}

/// Estimates the ground on which the feet stand.
fn ground(legs: &[Leg; 2], phases: &[Vec<Phase>; 2], clip: &Clip, skeleton: &Skeleton, leg: f64) -> Ground {
    let tracks = legs.each_ref().map(|leg| FootTracks {
        ankle: leg.ankle.clone(),
        toe: leg.toe.clone(),
        tip: Some(leg.tip.clone()),
    });
    let Skeleton { up, metres_per_unit, .. } = *skeleton;
    let feet = Feet { tracks, hips: Track::new(), up, leg, metres_per_unit, frame_time: clip.frame_time() };
    let planted = phases
        .each_ref()
        .map(|phases| -> Vec<bool> { phases.iter().map(|&phase| phase != Phase::Free).collect() });
    Ground::new(&feet, planted.each_ref().map(Vec::as_slice))
}

/// Tracks, phases and plants of both feet.
pub(crate) struct FootData {
    pub legs: [Leg; 2],
    pub phases: [Vec<Phase>; 2],
    pub plants: [Vec<Range<usize>>; 2],
    pub heels: [Vector3<f64>; 2],
    /// Leg length, in file units.
    pub length: f64,
    /// Ground on which the feet stand. The positions of the legs are relative to its belt.
    pub ground: Ground,
}

impl FootData {
    pub fn new(clip: &Clip, skeleton: &Skeleton, contacts: &Contacts) -> Result<FootData, SkateError> {
        let frames = clip.frame_count();
        if frames == 0 {
            return Err(SkateError::NoMotion);
        }
        if let Some(found) = contacts.mismatched_length(frames) {
            return Err(SkateError::Length { found, frames });
        }
        let joints = Side::BOTH.map(|side| Joints::new(clip, skeleton, side));
        let ([Some(left), Some(right)], Some(length)) = (joints, skeleton.leg) else {
            return Err(SkateError::NoFeet);
        };
        let (mut legs, up) = (leg::legs(clip, [left, right]), skeleton.up);
        let phases =
            Side::BOTH.map(|side| phases::phases(&legs[side as usize], contacts.foot(side), up, length));
        let ground = ground(&legs, &phases, clip, skeleton, length);
        legs.iter_mut().for_each(|leg| leg.subtract_belt(&ground, clip.frame_time()));
        let plants = [0, 1].map(|foot| phases::plants(&legs[foot], &phases[foot], length));
        let heels =
            [0, 1].map(|foot| heel::locate_heel(&legs[foot], &phases[foot], &plants[foot], up, length));
        Ok(FootData { legs, phases, plants, heels, length, ground })
    }

    /// Returns the slides of all plants.
    pub fn skate(&self, skeleton: &Skeleton) -> Skate {
        self.slides(&self.legs, skeleton)
    }

    /// Returns the slides of all plants for other tracks of the legs.
    pub fn slides(&self, legs: &[Leg; 2], skeleton: &Skeleton) -> Skate {
        let of_foot = |side: Side| {
            let foot = side as usize;
            self.plants[foot].iter().map(move |frames| {
                let (distance, frame, path) =
                    measure::slide(&legs[foot], &self.phases[foot], frames, self.heels[foot], skeleton.up);
                let [distance, path] = [distance, path].map(|units| units * skeleton.metres_per_unit);
                Slide { side, frames: frames.clone(), distance, frame, path }
            })
        };
        Skate { plants: Side::BOTH.into_iter().flat_map(of_foot).collect() }
    }
}
