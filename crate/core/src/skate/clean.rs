//! Clean-up of foot skate: from tracks of the feet to a new clip and a report.

use std::fmt;
use std::ops::Range;

use nalgebra::{Matrix3, Rotation3, Vector3};

use crate::bvh::{Channel, Clip};
use crate::foot::Side;
use crate::kinematics::Kinematics;
use crate::notice::{Code, Notice};
use crate::skate::constraints::{Correction, Planted, Settings};
use crate::skate::foot_data::{FootData, SkateError};
use crate::skate::leg::{Joints, Leg};
use crate::skate::{Contacts, euler, knee, leg, root};
use crate::skeleton::{Role, Skeleton};

/// Options of the clean-up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Time over which a correction fades in before a plant and out after it, in seconds; default
    /// 0.4.
    pub blend: f64,
    /// If true, plants of similar height are moved to one level; stairs and slopes are preserved.
    /// Default true.
    pub level: bool,
    /// Maximum slide of plants that are corrected, in leg lengths; default 0.25.
    pub max_slide: f64,
}

impl Default for Options {
    fn default() -> Options {
        Options { blend: 0.4, level: true, max_slide: 0.25 }
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
}

impl fmt::Display for SkipReason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            SkipReason::MovesTooFar => "the foot moves too far for a planted foot",
            SkipReason::NoLeg => "the leg has no hip joint or knee that can rotate",
            SkipReason::OutOfReach => "the leg is too short or the foot rotates too far",
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
/// Maximum slide of a plant that counts as constrained, in metres.
const CONSTRAINT_TOLERANCE: f64 = 0.001;
/// Movements smaller than this count as zero, in leg lengths.
const NEGLIGIBLE: f64 = 1e-9;

/// Constrains every planted foot to one position on the [`Ground`](crate::plants::Ground) that the plants
/// define; on a treadmill the position moves with the belt. Only the rotations of legs and feet and the position of the hips
/// change.
///
/// Heel and toe are constrained as labelled: the foot rolls over its heel, is flat, and rolls over its
/// toe. If only toes are labelled (the method of the paper), the toe is constrained and the foot rotates
/// as before. If only contact is labelled, the pitch of the foot determines the part. The time is
/// proportional to the number of frames.
///
/// # Errors
/// The errors of [`measure`](crate::skate::measure).
pub fn clean(
    clip: &Clip,
    skeleton: &Skeleton,
    contacts: &Contacts,
    options: &Options,
) -> Result<Cleaned, SkateError> {
    Ok(run(clip, skeleton, FootData::new(clip, skeleton, contacts)?, options))
}

/// Cleans up a clip.
fn run(clip: &Clip, skeleton: &Skeleton, feet: FootData, options: &Options) -> Cleaned {
    let before = feet.skate(skeleton);
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
    let max_slide = options.max_slide * feet.length * skeleton.metres_per_unit;
    let mut skip_reasons: Vec<Option<SkipReason>> = before
        .plants
        .iter()
        .map(|plant| {
            let joints = &feet.legs[plant.side as usize].joints;
            let is_rigid = !joints.upper.is_some_and(|upper| can_rotate(clip, upper, joints.ankle));
            if is_rigid {
                Some(SkipReason::NoLeg)
            } else {
                (plant.distance > max_slide).then_some(SkipReason::MovesTooFar)
            }
        })
        .collect();

    let FootData { legs, phases, plants, heels, length, ground } = feet;
    let split = plants[0].len();
    let mut phases = phases.into_iter();
    let mut plants = plants.into_iter();
    let planted: [Planted; 2] = Side::BOTH.map(|side| {
        let skip_reason = if side == Side::Left { &skip_reasons[..split] } else { &skip_reasons[split..] };
        Planted {
            phases: phases.next().unwrap_or_default(),
            plants: plants.next().unwrap_or_default(),
            is_constrained: skip_reason.iter().map(Option::is_none).collect(),
            heel: heels[side as usize],
        }
    });
    let corrections = [0, 1].map(|foot| planted[foot].correction(&legs[foot], &settings));
    let mut notices = Vec::new();
    let mut hip_offset = vec![Vector3::zeros(); clip.frame_count()];
    let translating_joint = translating_joint(clip, skeleton, legs.each_ref().map(|leg| leg.joints));
    if translating_joint.is_some() {
        let constrained_frames = planted.each_ref().map(Planted::constrained_frames);
        hip_offset = root::hip_offset(
            &legs,
            &corrections,
            &constrained_frames,
            &settings,
            [frames(HIP_SMOOTHING), frames(LOWERING_TIME)],
        );
    } else {
        let text = "The hips have no position channels; they do not move, and legs reach as far as they can.";
        notices.push(Notice::new(Code::FixedRoot, text));
    }
    let cleaned = ChannelWriter {
        clip,
        legs: &legs,
        corrections: &corrections,
        translating_joint,
        hip_offset: &hip_offset,
        length,
    }
    .write();

    let mut cleaned_legs = leg::legs(&cleaned, legs.each_ref().map(|leg| leg.joints));
    cleaned_legs.iter_mut().for_each(|leg| leg.subtract_belt(&ground, clip.frame_time()));
    let after = FootData {
        legs: cleaned_legs,
        phases: planted.each_ref().map(|foot| foot.phases.clone()),
        plants: planted.each_ref().map(|foot| foot.plants.clone()),
        heels,
        length,
        ground: ground.clone(),
    }
    .skate(skeleton);
    let positions = corrections.iter().flat_map(|correction| correction.positions.clone());
    let plants: Vec<CleanedPlant> = before
        .plants
        .into_iter()
        .zip(after.plants)
        .zip(positions.zip(&mut skip_reasons))
        .map(|((before, after), (position, skip_reason))| {
            (before.frames.start, before, after, position, skip_reason)
        })
        .map(|(start, before, after, position, skip_reason)| CleanedPlant {
            side: before.side,
            frames: before.frames,
            position: position.map(|position| position + ground.displacement(start, clip.frame_time())),
            before: before.distance,
            after: after.distance,
            skip_reason: skip_reason
                .or((after.distance > CONSTRAINT_TOLERANCE).then_some(SkipReason::OutOfReach)),
        })
        .collect();
    notices.extend(notice(&plants));
    Cleaned { clip: cleaned, plants, notices }
}

/// Returns a notice about plants that are not constrained.
fn notice(plants: &[CleanedPlant]) -> Option<Notice> {
    if plants.is_empty() {
        let text = "No foot is planted; the clip is unchanged.";
        return Some(Notice::new(Code::NothingPlanted, text));
    }
    let reasons = [SkipReason::MovesTooFar, SkipReason::NoLeg, SkipReason::OutOfReach].map(|reason| {
        let count = plants.iter().filter(|plant| plant.skip_reason == Some(reason)).count();
        (count > 0).then(|| format!("{count} because {reason}"))
    });
    let reasons: Vec<String> = reasons.into_iter().flatten().collect();
    let text = || format!("Some of {} plants are not corrected: {}.", plants.len(), reasons.join(", "));
    (!reasons.is_empty()).then(|| Notice::new(Code::Unconstrained, text()))
}

/// True if the joints of a leg can rotate as the solution requires.
fn can_rotate(clip: &Clip, [thigh, shank]: [usize; 2], ankle: usize) -> bool {
    let channels = |joint: usize| &clip.joints()[joint].channels;
    let rotates =
        |joint: usize| channels(joint).iter().any(|channel| matches!(channel, Channel::Rotation(_)));
    euler::is_ball_joint(channels(thigh)) && rotates(shank) && rotates(ankle)
}

/// Returns the joint that translates the hips: the lowest common ancestor of both legs with three
/// position channels.
fn translating_joint(clip: &Clip, skeleton: &Skeleton, legs: [Joints; 2]) -> Option<usize> {
    let above = |joint: usize| std::iter::successors(Some(joint), |&j| clip.joints()[j].parent);
    let tops = legs.map(|leg| leg.upper.map_or(leg.ankle, |[thigh, _]| thigh));
    let can_translate = |joint: usize| {
        let positions = clip.joints()[joint].channels.iter();
        positions.filter(|channel| matches!(channel, Channel::Position(_))).count() == 3
    };
    let hips = skeleton.roles.get(Role::Hips).unwrap_or(skeleton.root);
    let is_common_ancestor =
        |joint: usize| tops.iter().all(|&top| top != joint && above(top).any(|j| j == joint));
    above(hips).find(|&joint| is_common_ancestor(joint) && can_translate(joint))
}

impl Planted {
    /// Returns true for each frame in which the foot is constrained.
    fn constrained_frames(&self) -> Vec<bool> {
        let mut constrained = vec![false; self.phases.len()];
        for (plant, _) in
            self.plants.iter().zip(&self.is_constrained).filter(|(_, is_constrained)| **is_constrained)
        {
            constrained[plant.clone()].fill(true);
        }
        constrained
    }
}

/// Writes corrections into the channels of a clip.
struct ChannelWriter<'a> {
    clip: &'a Clip,
    legs: &'a [Leg; 2],
    corrections: &'a [Correction; 2],
    translating_joint: Option<usize>,
    hip_offset: &'a [Vector3<f64>],
    length: f64,
}

impl ChannelWriter<'_> {
    fn write(&self) -> Clip {
        let clip = self.clip;
        let (mut values, width) = (clip.values().to_vec(), clip.channel_count());
        let joints: Vec<usize> =
            self.legs.iter().map(|leg| leg.joints.ankle).chain(self.translating_joint).collect();
        let mut kinematics = Kinematics::for_joints(clip, &joints);
        for (frame, row) in values.chunks_exact_mut(width.max(1)).enumerate() {
            kinematics.pose(frame);
            let rotations = kinematics.rotations();
            self.translate_hips(frame, rotations, row);
            for (leg, correction) in self.legs.iter().zip(self.corrections) {
                self.rotate_leg(leg, correction, frame, rotations, row);
            }
        }
        Clip::new(clip.joints().to_vec(), clip.frame_time(), values).with_position_rule(clip.position_rule())
    }

    /// Translates the hips.
    fn translate_hips(&self, frame: usize, rotations: &[Matrix3<f64>], row: &mut [f64]) {
        let Some(translating_joint) = self.translating_joint else { return };
        let offset = self.hip_offset[frame];
        if offset.norm() <= NEGLIGIBLE * self.length || !offset.norm().is_finite() {
            return;
        }
        let joint = &self.clip.joints()[translating_joint];
        let offset = joint.parent.map_or(offset, |parent| rotations[parent].transpose() * offset);
        for (value, channel) in
            row[self.clip.channel_range(translating_joint)].iter_mut().zip(&joint.channels)
        {
            if let Channel::Position(axis) = channel {
                *value += offset[axis.index()];
            }
        }
    }

    /// Rotates the joints of one leg.
    fn rotate_leg(
        &self,
        leg: &Leg,
        correction: &Correction,
        frame: usize,
        rotations: &[Matrix3<f64>],
        row: &mut [f64],
    ) {
        let Joints { upper: Some([thigh, shank]), ankle, .. } = leg.joints else { return };
        if !can_rotate(self.clip, [thigh, shank], ankle) {
            return;
        }
        let (translation, rotation_vector) =
            (correction.ankle[frame] - self.hip_offset[frame], correction.foot[frame]);
        if translation.norm() <= NEGLIGIBLE * self.length && rotation_vector.norm() <= NEGLIGIBLE {
            return;
        }
        let hip_to_ankle = leg.ankle[frame] - leg.hip[frame] + translation;
        let [upper, lower] = knee::rotations(leg, frame, rotations[thigh] * leg.hinge, hip_to_ankle);
        let foot = Rotation3::new(rotation_vector).into_inner();
        // Joints in between follow the joint above them.
        let mut above: Matrix3<f64> = Matrix3::identity();
        for (joint, rotation) in [(thigh, upper), (shank, lower), (ankle, foot)] {
            let parent = self.clip.joints()[joint].parent.map_or(Matrix3::identity(), |p| rotations[p]);
            let target = (above * parent).transpose() * rotation * rotations[joint];
            let channels = &self.clip.joints()[joint].channels;
            euler::set_rotation(channels, &mut row[self.clip.channel_range(joint)], &target);
            above = rotation;
        }
    }
}
