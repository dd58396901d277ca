//! Foot skate: measuring the slide of planted feet, and removing it.
//!
//! After Kovar, Schreiner and Gleicher, *Footskate cleanup for motion capture editing*, Symposium
//! on Computer Animation 2002. Every plant gets a position at which the foot is held. The hips move
//! where legs would not reach. Each leg is solved in closed form, and corrections are blended
//! between plants. The bones of a BVH file cannot stretch as in the paper, so the hips move far
//! enough for every leg to reach.
//!
//! Data flow: [`Contacts`] → phases (heel, flat, toe) → plants → constraints → corrections of the
//! feet → offset of the hips → legs → channels.

mod blend;
mod clean;
mod constraints;
mod contacts;
mod euler;
mod ground;
mod heel;
mod knee;
mod leg;
mod measure;
mod phases;
mod root;
#[cfg(test)]
mod tests;

pub use clean::{Cleaned, CleanedPlant, Options, SkipReason};
pub use contacts::{Contacts, FootContacts};
pub use measure::{Skate, Slide};

use nalgebra::Vector3;

use crate::bvh::Clip;
use crate::foot::Side;
use crate::skeleton::Skeleton;
use leg::{Joints, Leg};
use phases::Phase;

/// Error: foot skate cannot be measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SkateError {
    /// The clip is a rest pose.
    #[error("the clip has no motion, so no foot can skate")]
    NoMotion,
    /// The ankles are unknown.
    #[error("no pair of feet was found; name the joints of both ankles")]
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

/// Holds every planted foot still. Only the rotations of legs and feet and the position of the hips
/// change.
///
/// Heel and toe are held as labelled: the foot rolls over its heel, is flat, and rolls over its
/// toe. If only toes are labelled (the method of the paper), the toe is held and the foot rotates
/// as before. If only contact is labelled, the pitch of the foot determines the part. The time is
/// proportional to the number of frames.
///
/// # Errors
/// Those of [`measure`].
pub fn clean(
    clip: &Clip,
    skeleton: &Skeleton,
    contacts: &Contacts,
    options: &Options,
) -> Result<Cleaned, SkateError> {
    Ok(clean::run(clip, skeleton, FootData::new(clip, skeleton, contacts)?, options))
}

/// Tracks, phases and plants of both feet.
struct FootData {
    legs: [Leg; 2],
    phases: [Vec<Phase>; 2],
    plants: [Vec<std::ops::Range<usize>>; 2],
    heels: [Vector3<f64>; 2],
    /// Leg length, in file units.
    length: f64,
}

impl FootData {
    fn new(clip: &Clip, skeleton: &Skeleton, contacts: &Contacts) -> Result<FootData, SkateError> {
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
        let (legs, up) = (leg::legs(clip, [left, right]), skeleton.up);
        let phases =
            Side::BOTH.map(|side| phases::phases(&legs[side as usize], contacts.foot(side), up, length));
        let plants = [0, 1].map(|foot| phases::plants(&legs[foot], &phases[foot], length));
        let heels =
            [0, 1].map(|foot| heel::locate_heel(&legs[foot], &phases[foot], &plants[foot], up, length));
        Ok(FootData { legs, phases, plants, heels, length })
    }

    /// Returns the slides of all plants.
    fn skate(&self, skeleton: &Skeleton) -> Skate {
        let of_foot = |side: Side| {
            let foot = side as usize;
            self.plants[foot].iter().map(move |frames| {
                let slide = measure::slide(
                    &self.legs[foot],
                    &self.phases[foot],
                    frames,
                    self.heels[foot],
                    skeleton.up,
                );
                let [distance, path] = [slide.0, slide.1].map(|units| units * skeleton.metres_per_unit);
                Slide { side, frames: frames.clone(), distance, path }
            })
        };
        Skate { plants: Side::BOTH.into_iter().flat_map(of_foot).collect() }
    }
}
