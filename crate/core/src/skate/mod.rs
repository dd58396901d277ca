//! Foot skate: how far planted feet slide, and clips without it.
//!
//! After Kovar, Schreiner and Gleicher, *Footskate cleanup for motion capture editing*,
//! Symposium on Computer Animation 2002. Every plant gets a position at which the foot is held;
//! the hips go along where legs would not reach; each leg is solved in closed form, and what
//! was changed blends in and out between the plants. Bones of a BVH file cannot stretch as they
//! do in the paper: here the hips do all that is needed for legs to reach.
//!
//! The way of the data: [`Contacts`] → phases (heel, flat, toe) → plants → constraints →
//! corrections of the feet → way of the hips → legs → channels.

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

pub use clean::{Cleaned, CleanedPlant, Options, WhyNot};
pub use contacts::{Contacts, FootContacts};
pub use measure::{Skate, Slide};

use nalgebra::Vector3;

use crate::bvh::Clip;
use crate::foot::Side;
use crate::skeleton::Skeleton;
use leg::{Joints, Leg};
use phases::Phase;

/// Why a clip's foot skate cannot be told.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SkateError {
    /// The clip is a rest pose.
    #[error("the clip has no motion: no foot can skate")]
    NoMotion,
    /// The ankles are not known.
    #[error("no pair of feet was found: name the joints of both ankles")]
    NoFeet,
    /// Labels of another clip.
    #[error("the labels are of {found} frames, and the clip has {frames}")]
    Length {
        /// Frames of the labels.
        found: usize,
        /// Frames of the clip.
        frames: usize,
    },
}

/// Measures how far every plant slides, in metres. Takes time proportional to the frames.
///
/// # Errors
/// If the clip has no motion, the skeleton no feet, or the labels are of another length.
pub fn measure(clip: &Clip, skeleton: &Skeleton, contacts: &Contacts) -> Result<Skate, SkateError> {
    Ok(Feet::of(clip, skeleton, contacts)?.skate(skeleton))
}

/// Holds every planted foot still where it stands: the same clip but for the channels of legs and
/// feet, and of the position of the hips.
///
/// Heel and toe are held as labelled: the foot rolls over its heel, stands, and rolls over its
/// toe. With toes alone labelled (the published detector), the toe is held and the foot turns as
/// it did. With contact alone, the pitch of the foot tells what it stands on. Takes time
/// proportional to the frames.
///
/// # Errors
/// As [`measure`].
pub fn clean(
    clip: &Clip,
    skeleton: &Skeleton,
    contacts: &Contacts,
    options: &Options,
) -> Result<Cleaned, SkateError> {
    Ok(clean::run(clip, skeleton, Feet::of(clip, skeleton, contacts)?, options))
}

/// Both feet with what they stand on.
struct Feet {
    legs: [Leg; 2],
    phases: [Vec<Phase>; 2],
    plants: [Vec<std::ops::Range<usize>>; 2],
    heels: [Vector3<f64>; 2],
    /// Thigh plus shank, in file units.
    length: f64,
}

impl Feet {
    fn of(clip: &Clip, skeleton: &Skeleton, contacts: &Contacts) -> Result<Feet, SkateError> {
        let frames = clip.frame_count();
        if frames == 0 {
            return Err(SkateError::NoMotion);
        }
        if let Some(found) = contacts.other_length(frames) {
            return Err(SkateError::Length { found, frames });
        }
        let joints = Side::BOTH.map(|side| Joints::of(clip, skeleton, side));
        let ([Some(left), Some(right)], Some(length)) = (joints, skeleton.leg) else {
            return Err(SkateError::NoFeet);
        };
        let (legs, up) = (leg::legs(clip, [left, right]), skeleton.up);
        let phases =
            Side::BOTH.map(|side| phases::phases(&legs[side as usize], contacts.foot(side), up, length));
        let plants = [0, 1].map(|foot| phases::plants(&legs[foot], &phases[foot], length));
        let heels = [0, 1].map(|foot| heel::heel(&legs[foot], &phases[foot], &plants[foot], up, length));
        Ok(Feet { legs, phases, plants, heels, length })
    }

    /// The slides of all plants.
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
                let [farthest, path] = [slide.0, slide.1].map(|units| units * skeleton.metres_per_unit);
                Slide { side, frames: frames.clone(), farthest, path }
            })
        };
        Skate { plants: Side::BOTH.into_iter().flat_map(of_foot).collect() }
    }
}
