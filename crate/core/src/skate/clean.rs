//! Clean-up of foot skate: from tracks of the feet to a new clip and a report.

use std::borrow::Cow;
use std::fmt;
use std::ops::Range;

use nalgebra::Vector3;

use crate::bvh::Clip;
use crate::foot::Side;
use crate::notice::{Code, Notice};
use crate::numeric::sort;
use crate::skate::channels::{ChannelWriter, can_rotate, translating_joint};
use crate::skate::constraints::{Correction, Planted, Settings};
use crate::skate::foot_data::{FootData, SkateError};
use crate::skate::leg::Leg;
use crate::skate::measure::Slide;
use crate::skate::{Contacts, harm, leg, root, spikes};
use crate::skeleton::Skeleton;

/// Options of the clean-up.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// Time over which a correction fades in before a plant and out after it, in seconds; default
    /// 0.4.
    pub blend: f64,
    /// If true, plants of similar height are moved to one level; stairs and slopes are preserved.
    /// Default true.
    pub level: bool,
    /// Maximum slide of plants that are corrected, in leg lengths; default 0.25.
    pub max_slide: f64,
    /// If true, short jumps of the hips to another place and back are interpolated. Default true.
    pub repair_spikes: bool,
    /// If not empty, only plants that overlap one of these frame ranges of their foot are corrected. Default
    /// empty.
    pub only: Vec<(Side, Range<usize>)>,
}

impl Default for Options {
    fn default() -> Options {
        Options { blend: 0.4, level: true, max_slide: 0.25, repair_spikes: true, only: Vec::new() }
    }
}

/// A clip with its planted feet constrained, and the result for each plant.
#[derive(Clone, Debug, PartialEq)]
pub struct Cleaned {
    /// Same hierarchy with new values.
    pub clip: Clip,
    /// Plants of the left foot in order of time, then of the right foot.
    pub plants: Vec<CleanedPlant>,
    /// Assumptions and omissions.
    pub notices: Vec<Notice>,
}

/// Result for one plant.
#[derive(Clone, Debug, PartialEq)]
pub struct CleanedPlant {
    /// The foot.
    pub side: Side,
    /// Frames in which heel or toe is planted.
    pub frames: Range<usize>,
    /// Position to which the foot is constrained, in file units and axes: its toe, or its heel if
    /// the toe is never planted. `None` if the plant is not constrained. On a treadmill, the foot is there in
    /// the first frame and moves with the belt.
    pub position: Option<Vector3<f64>>,
    /// Slide before the clean-up, in metres; see [`crate::skate::Slide::distance`].
    pub before: f64,
    /// Slide after the clean-up, in metres.
    pub after: f64,
    /// Reason why the plant is not constrained, if it is not.
    pub skip_reason: Option<SkipReason>,
}

/// Reason why a plant is not constrained.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SkipReason {
    /// The foot moves too far for a planted foot.
    MovesTooFar,
    /// Hip joint or knee is unknown or cannot rotate.
    NoLeg,
    /// The leg is too short to reach the position, or the foot rotates too far about it.
    OutOfReach,
    /// The correction would make the clip worse: the foot would slide more or get below the ground, the hips
    /// would move too far, or joints would jerk.
    Harmful,
    /// The options limit the clean-up to other plants.
    NotSelected,
}

impl SkipReason {
    /// All reasons.
    pub const ALL: [SkipReason; 5] = [
        SkipReason::MovesTooFar,
        SkipReason::NoLeg,
        SkipReason::OutOfReach,
        SkipReason::Harmful,
        SkipReason::NotSelected,
    ];
}

impl fmt::Display for SkipReason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            SkipReason::MovesTooFar => "the foot moves too far for a planted foot",
            SkipReason::NoLeg => "the leg has no hip joint or knee that can rotate",
            SkipReason::OutOfReach => "the leg is too short or the foot rotates too far",
            SkipReason::Harmful => "the correction would make the clip worse",
            SkipReason::NotSelected => "it was not selected",
        })
    }
}

impl Cleaned {
    /// Returns the number of plants that are constrained.
    pub fn constrained_count(&self) -> usize {
        self.plants.iter().filter(|plant| plant.skip_reason.is_none()).count()
    }
}

/// Half-width of the window that smooths the offset of the hips, in seconds; applied three times.
const HIP_SMOOTHING: f64 = 0.09;
/// Time over which the hips are lowered before and after a leg is out of reach, in seconds.
const LOWERING_TIME: f64 = 0.6;
/// Half-width of the window that smooths an ankle, in seconds.
const ANKLE_SMOOTHING: f64 = 0.1;
/// Number of attempts after which all plants near a harmful frame are withdrawn at once.
const MAX_ROUNDS: usize = 8;
/// Maximum slide of a plant that counts as constrained, in metres.
const CONSTRAINT_TOLERANCE: f64 = 0.001;

/// Constrains every planted foot to one position on the [`Ground`](crate::plants::Ground) that the plants
/// define; on a treadmill the position moves with the belt. Only the rotations of legs and feet and the
/// position of the hips change.
///
/// Heel and toe are constrained as labelled: the foot rolls over its heel, is flat, and rolls over its
/// toe. If only toes are labelled (the method of the paper), the toe is constrained and the foot rotates
/// as before. If only contact is labelled, the pitch of the foot determines the part. The time is
/// proportional to the number of frames.
///
/// Spikes of the hips are repaired first. A correction that would make the clip worse, as
/// [`SkipReason::Harmful`] tells, is withdrawn.
///
/// # Errors
/// The errors of [`measure`](crate::skate::measure).
pub fn clean(
    clip: &Clip,
    skeleton: &Skeleton,
    contacts: &Contacts,
    options: &Options,
) -> Result<Cleaned, SkateError> {
    let feet = FootData::new(clip, skeleton, contacts)?;
    let translating_joint = translating_joint(clip, skeleton, feet.legs.each_ref().map(|leg| leg.joints));
    let mut notices = Vec::new();
    if translating_joint.is_none() {
        let text = "The hips have no position channels; they do not move, and legs reach as far as they can.";
        notices.push(Notice::new(Code::FixedRoot, text));
    }
    let spikes = translating_joint
        .filter(|_| options.repair_spikes)
        .map(|joint| (joint, spikes::find(clip, joint, feet.length)))
        .filter(|(_, spikes)| !spikes.is_empty());
    let (repaired, feet) = match spikes {
        Some((joint, spikes)) => {
            notices.push(spike_notice(&spikes));
            let repaired = spikes::repair(clip, joint, &spikes);
            let feet = FootData::new(&repaired, skeleton, contacts)?;
            (Cow::Owned(repaired), feet)
        }
        None => (Cow::Borrowed(clip), feet),
    };
    let cleanup = Cleanup::new(&repaired, skeleton, feet, translating_joint, options);
    let (clip, plants) = cleanup.run();
    notices.extend(plants_notice(&plants));
    Ok(Cleaned { clip, plants, notices })
}

/// A clip with its feet, and the options in frames and file units.
struct Cleanup<'a> {
    clip: &'a Clip,
    skeleton: &'a Skeleton,
    feet: FootData,
    /// Slide of each plant.
    before: Vec<Slide>,
    translating_joint: Option<usize>,
    settings: Settings,
    /// Maximum slide of plants that are corrected, in metres.
    max_slide: f64,
    /// Frames of the plants that are corrected; empty for all.
    only: &'a [(Side, Range<usize>)],
    /// Half-widths of smoothing and of lowering the hips, in frames.
    hip_windows: [usize; 2],
}

/// Result of correcting some of the plants.
struct Attempt {
    clip: Clip,
    legs: [Leg; 2],
    corrections: [Correction; 2],
    hip_offset: Vec<Vector3<f64>>,
    /// Slide of each plant, in metres.
    slides: Vec<f64>,
}

impl<'a> Cleanup<'a> {
    fn new(
        clip: &'a Clip,
        skeleton: &'a Skeleton,
        feet: FootData,
        translating_joint: Option<usize>,
        options: &'a Options,
    ) -> Cleanup<'a> {
        let frames = |seconds: f64| {
            let frames = (seconds / clip.frame_time()).round();
            if frames.is_finite() { frames.clamp(0.0, clip.frame_count() as f64) as usize } else { 0 }
        };
        let settings = Settings {
            up: skeleton.up,
            length: feet.length,
            window: frames(options.blend).max(2),
            ankle_half_width: frames(ANKLE_SMOOTHING),
            level: options.level,
            ground: feet.ground.clone(),
        };
        Cleanup {
            clip,
            skeleton,
            before: feet.skate(skeleton).plants,
            translating_joint,
            settings,
            max_slide: options.max_slide * feet.length * skeleton.metres_per_unit,
            only: &options.only,
            hip_windows: [frames(HIP_SMOOTHING), frames(LOWERING_TIME)],
            feet,
        }
    }

    /// Corrects all plants that can be, and withdraws corrections that harm.
    fn run(&self) -> (Clip, Vec<CleanedPlant>) {
        let mut skipped: Vec<Option<SkipReason>> =
            self.before.iter().map(|plant| self.skip_reason(plant)).collect();
        let mut attempt = self.attempt(&skipped);
        for round in 1.. {
            let harmful = self.harmful_plants(&attempt, &skipped, round >= MAX_ROUNDS);
            if harmful.is_empty() {
                break;
            }
            for plant in harmful {
                skipped[plant] = Some(SkipReason::Harmful);
            }
            attempt = self.attempt(&skipped);
        }
        let positions = attempt.corrections.iter().flat_map(|correction| &correction.positions);
        let belt = |frame: usize| self.feet.ground.displacement(frame, self.clip.frame_time());
        let plants = self.before.iter().zip(&attempt.slides).zip(positions.zip(skipped));
        let plants = plants.map(|((before, &after), (position, skip_reason))| CleanedPlant {
            side: before.side,
            frames: before.frames.clone(),
            position: position.map(|position| position + belt(before.frames.start)),
            before: before.distance,
            after,
            skip_reason: skip_reason.or((after > CONSTRAINT_TOLERANCE).then_some(SkipReason::OutOfReach)),
        });
        (attempt.clip, plants.collect())
    }

    /// Returns the reason why a plant is not to be corrected, if there is one.
    fn skip_reason(&self, plant: &Slide) -> Option<SkipReason> {
        let is_selected = |(side, frames): &(Side, Range<usize>)| {
            *side == plant.side && frames.start < plant.frames.end && plant.frames.start < frames.end
        };
        if !self.only.is_empty() && !self.only.iter().any(is_selected) {
            return Some(SkipReason::NotSelected);
        }
        let joints = &self.feet.legs[plant.side as usize].joints;
        if !joints.upper.is_some_and(|upper| can_rotate(self.clip, upper, joints.ankle)) {
            return Some(SkipReason::NoLeg);
        }
        (plant.distance > self.max_slide).then_some(SkipReason::MovesTooFar)
    }

    /// Corrects the plants that are not skipped.
    fn attempt(&self, skipped: &[Option<SkipReason>]) -> Attempt {
        let FootData { legs, phases, plants, heels, length, ground } = &self.feet;
        let (left, right) = skipped.split_at(plants[0].len());
        let planted = [left, right].map(|skipped| skipped.iter().map(Option::is_none).collect::<Vec<_>>());
        let planted = [0, 1].map(|foot| Planted {
            phases: &phases[foot],
            plants: &plants[foot],
            is_constrained: &planted[foot],
            heel: heels[foot],
        });
        let corrections = [0, 1].map(|foot| planted[foot].correction(&legs[foot], &self.settings));
        let mut hip_offset = vec![Vector3::zeros(); self.clip.frame_count()];
        if self.translating_joint.is_some() {
            let constrained = planted.each_ref().map(Planted::constrained_frames);
            hip_offset = root::hip_offset(legs, &corrections, &constrained, &self.settings, self.hip_windows);
        }
        let clip = ChannelWriter {
            clip: self.clip,
            legs,
            corrections: &corrections,
            translating_joint: self.translating_joint,
            hip_offset: &hip_offset,
            length: *length,
        }
        .write();
        let mut cleaned_legs = leg::legs(&clip, legs.each_ref().map(|leg| leg.joints));
        cleaned_legs.iter_mut().for_each(|leg| leg.subtract_belt(ground, clip.frame_time()));
        let slides = self.feet.slides(&cleaned_legs, self.skeleton);
        let slides = slides.plants.iter().map(|plant| plant.distance).collect();
        Attempt { clip, legs: cleaned_legs, corrections, hip_offset, slides }
    }

    /// Returns the corrected plants whose correction makes the clip worse: of the plants near a harmful frame,
    /// the one that moves its ankle farthest, or `all` of them.
    fn harmful_plants(&self, attempt: &Attempt, skipped: &[Option<SkipReason>], all: bool) -> Vec<usize> {
        let is_corrected = |plant: usize| skipped[plant].is_none();
        let more_slide =
            |plant: &usize| attempt.slides[*plant] > self.before[*plant].distance + CONSTRAINT_TOLERANCE;
        let mut harmful: Vec<usize> =
            (0..self.before.len()).filter(|&plant| is_corrected(plant)).filter(more_slide).collect();
        let reach = self.settings.window + self.hip_windows[1];
        let displacement = |plant: usize, near: &Range<usize>| {
            let Slide { side, frames, .. } = &self.before[plant];
            let frames = frames.start.max(near.start)..frames.end.min(near.end);
            frames.map(|frame| attempt.corrections[*side as usize].ankle[frame].norm()).fold(0.0, f64::max)
        };
        for frames in harm::harmful_frames(
            &self.feet.legs,
            &attempt.legs,
            &attempt.hip_offset,
            self.settings.up,
            self.feet.length,
            self.clip.frame_time(),
        ) {
            let near = frames.start.saturating_sub(reach)..frames.end + reach;
            let corrected = (0..self.before.len()).filter(|&plant| is_corrected(plant));
            let moved: Vec<(f64, usize)> = corrected
                .map(|plant| (displacement(plant, &near), plant))
                .filter(|&(displacement, _)| displacement > 0.0)
                .collect();
            let moved = sort::sort_descending(moved, |(displacement, _)| *displacement);
            harmful.extend(moved.iter().take(if all { moved.len() } else { 1 }).map(|&(_, plant)| plant));
        }
        harmful
    }
}

/// Returns a notice about repaired spikes.
fn spike_notice(spikes: &[Range<usize>]) -> Notice {
    let first = spikes[0].start;
    let spikes = if spikes.len() == 1 { "a spike".into() } else { format!("{} spikes", spikes.len()) };
    let text = format!(
        "The hips have {spikes}, from frame {first} on: they jump away and back within 0.05 s. Their position \
         is interpolated there."
    );
    Notice::new(Code::Spike, text)
}

/// Returns a notice about plants that are not constrained.
fn plants_notice(plants: &[CleanedPlant]) -> Option<Notice> {
    if plants.is_empty() {
        let text = "No foot is planted; the clip is unchanged.";
        return Some(Notice::new(Code::NothingPlanted, text));
    }
    let reasons = SkipReason::ALL.map(|reason| {
        if reason == SkipReason::NotSelected {
            return None;
        }
        let count = plants.iter().filter(|plant| plant.skip_reason == Some(reason)).count();
        (count > 0).then(|| format!("{count} because {reason}"))
    });
    let reasons: Vec<String> = reasons.into_iter().flatten().collect();
    let text = || format!("Some of {} plants are not corrected: {}.", plants.len(), reasons.join(", "));
    (!reasons.is_empty()).then(|| Notice::new(Code::Unconstrained, text()))
}
