//! The clean-up as a whole: from the feet to a new clip and a report.

use std::fmt;
use std::ops::Range;

use nalgebra::{Matrix3, Rotation3, Vector3};

use crate::bvh::{Channel, Clip};
use crate::foot::Side;
use crate::kinematics::Kinematics;
use crate::notice::{Code, Notice};
use crate::skate::constraints::{Correction, Planted, Setting};
use crate::skate::leg::{Joints, Leg};
use crate::skate::{Feet, euler, knee, leg, root};
use crate::skeleton::{Role, Skeleton};

/// How to clean up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Seconds over which a correction comes before a plant and goes after it; default 0.4.
    pub blend: f64,
    /// Whether plants at about the same height are put on one level; default true. Stairs and
    /// slopes stay as they are.
    pub level: bool,
    /// Plants that slide farther than this are left alone, in legs; default 0.25.
    pub farthest: f64,
}

impl Default for Options {
    fn default() -> Options {
        Options { blend: 0.4, level: true, farthest: 0.25 }
    }
}

/// A clip with its feet held, and what became of each plant.
#[derive(Clone, Debug, PartialEq)]
pub struct Cleaned {
    /// The same hierarchy with new values.
    pub clip: Clip,
    /// The left foot's plants in order of time, then the right's.
    pub plants: Vec<CleanedPlant>,
    /// What was left out or assumed.
    pub notices: Vec<Notice>,
}

/// What became of one plant.
#[derive(Clone, Debug, PartialEq)]
pub struct CleanedPlant {
    /// Which foot.
    pub side: Side,
    /// The frames in which heel or toe stands.
    pub frames: Range<usize>,
    /// Where the foot is held, in file units and axes: its toe, or its heel where the toe never
    /// stands. `None` where it is not held.
    pub position: Option<Vector3<f64>>,
    /// How far it slid, in metres, as [`crate::skate::Slide::farthest`].
    pub before: f64,
    /// How far it still does.
    pub after: f64,
    /// Why the plant is not held, if it is not.
    pub why_not: Option<WhyNot>,
}

/// Why a plant is not held.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WhyNot {
    /// The foot moves too far for one that stands: on a treadmill, say.
    Moves,
    /// Hip joint or knee is not known, or cannot be turned.
    NoLeg,
    /// The leg is too short to reach the place, or the foot turns too far on it.
    OutOfReach,
}

impl fmt::Display for WhyNot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            WhyNot::Moves => "the foot moves too far for one that stands",
            WhyNot::NoLeg => "the leg has no hip joint or knee that can be turned",
            WhyNot::OutOfReach => "the leg does not reach or the foot turns too far",
        })
    }
}

impl Cleaned {
    /// Number of plants that are held.
    pub fn constrained(&self) -> usize {
        self.plants.iter().filter(|plant| plant.why_not.is_none()).count()
    }
}

/// Half the time over which the way of the hips is smoothed, in seconds, thrice over.
const SMOOTH: f64 = 0.09;
/// Time over which the hips are lowered ahead of and after a leg that does not reach, in seconds.
const SPREAD: f64 = 0.6;
/// Half the time over which an ankle is steadied, in seconds.
const STEADY: f64 = 0.1;
/// A plant that is held slides no farther than this, in metres.
const STILL: f64 = 0.001;
/// Movements smaller than this are none, in legs.
const NOTHING: f64 = 1e-9;

/// Cleans up.
pub(crate) fn run(clip: &Clip, skeleton: &Skeleton, feet: Feet, options: &Options) -> Cleaned {
    let before = feet.skate(skeleton);
    let frames = |seconds: f64| {
        let frames = (seconds / clip.frame_time()).round();
        if frames.is_finite() { frames.clamp(0.0, clip.frame_count() as f64) as usize } else { 0 }
    };
    let setting = Setting {
        up: skeleton.up,
        length: feet.length,
        window: frames(options.blend).max(2),
        steady: frames(STEADY),
        level: options.level,
    };
    let far = options.farthest * feet.length * skeleton.metres_per_unit;
    let mut why_not: Vec<Option<WhyNot>> = before
        .plants
        .iter()
        .map(|plant| {
            let joints = &feet.legs[plant.side as usize].joints;
            let is_stiff = !joints.upper.is_some_and(|upper| can_turn(clip, upper, joints.ankle));
            if is_stiff { Some(WhyNot::NoLeg) } else { (plant.farthest > far).then_some(WhyNot::Moves) }
        })
        .collect();

    let Feet { legs, phases, plants, heels, length } = feet;
    let split = plants[0].len();
    let mut phases = phases.into_iter();
    let mut plants = plants.into_iter();
    let planted: [Planted; 2] = Side::BOTH.map(|side| {
        let why_not = if side == Side::Left { &why_not[..split] } else { &why_not[split..] };
        Planted {
            phases: phases.next().unwrap_or_default(),
            plants: plants.next().unwrap_or_default(),
            is_held: why_not.iter().map(Option::is_none).collect(),
            heel: heels[side as usize],
        }
    });
    let corrections = [0, 1].map(|foot| planted[foot].correction(&legs[foot], &setting));
    let mut notices = Vec::new();
    let mut way = vec![Vector3::zeros(); clip.frame_count()];
    let carrier = carrier(clip, skeleton, legs.each_ref().map(|leg| leg.joints));
    if carrier.is_some() {
        let standing = planted.each_ref().map(Planted::standing);
        way = root::way(&legs, &corrections, &standing, &setting, [frames(SMOOTH), frames(SPREAD)]);
    } else {
        let text = "The hips have no position channels: they stay, and legs reach as far as they can.";
        notices.push(Notice::new(Code::FixedRoot, text));
    }
    let cleaned = Bake { clip, legs: &legs, corrections: &corrections, carrier, way: &way, length }.clip();

    let after = Feet {
        legs: leg::legs(&cleaned, legs.each_ref().map(|leg| leg.joints)),
        phases: planted.each_ref().map(|foot| foot.phases.clone()),
        plants: planted.each_ref().map(|foot| foot.plants.clone()),
        heels,
        length,
    }
    .skate(skeleton);
    let positions = corrections.iter().flat_map(|correction| correction.positions.clone());
    let plants: Vec<CleanedPlant> = before
        .plants
        .into_iter()
        .zip(after.plants)
        .zip(positions.zip(&mut why_not))
        .map(|((before, after), (position, why_not))| CleanedPlant {
            side: before.side,
            frames: before.frames,
            position,
            before: before.farthest,
            after: after.farthest,
            why_not: why_not.or((after.farthest > STILL).then_some(WhyNot::OutOfReach)),
        })
        .collect();
    notices.extend(notice(&plants));
    Cleaned { clip: cleaned, plants, notices }
}

/// What there is to say of plants that are not held.
fn notice(plants: &[CleanedPlant]) -> Option<Notice> {
    if plants.is_empty() {
        let text = "Nothing is planted: the clip stays as it is.";
        return Some(Notice::new(Code::NothingPlanted, text));
    }
    let reasons = [WhyNot::Moves, WhyNot::NoLeg, WhyNot::OutOfReach].map(|reason| {
        let count = plants.iter().filter(|plant| plant.why_not == Some(reason)).count();
        (count > 0).then(|| format!("{count} because {reason}"))
    });
    let reasons: Vec<String> = reasons.into_iter().flatten().collect();
    let text = || format!("Of {} plants some are not held still: {}.", plants.len(), reasons.join(", "));
    (!reasons.is_empty()).then(|| Notice::new(Code::Unconstrained, text()))
}

/// Whether the joints of a leg can be turned as its solution asks.
fn can_turn(clip: &Clip, [thigh, shank]: [usize; 2], ankle: usize) -> bool {
    let channels = |joint: usize| &clip.joints()[joint].channels;
    let turns = |joint: usize| channels(joint).iter().any(|channel| matches!(channel, Channel::Rotation(_)));
    euler::is_free(channels(thigh)) && turns(shank) && turns(ankle)
}

/// The joint that takes the hips along: the lowest above both legs with three position channels.
fn carrier(clip: &Clip, skeleton: &Skeleton, legs: [Joints; 2]) -> Option<usize> {
    let above = |joint: usize| std::iter::successors(Some(joint), |&j| clip.joints()[j].parent);
    let tops = legs.map(|leg| leg.upper.map_or(leg.ankle, |[thigh, _]| thigh));
    let moves = |joint: usize| {
        let positions = clip.joints()[joint].channels.iter();
        positions.filter(|channel| matches!(channel, Channel::Position(_))).count() == 3
    };
    let hips = skeleton.roles.get(Role::Hips).unwrap_or(skeleton.root);
    let carries = |joint: usize| tops.iter().all(|&top| top != joint && above(top).any(|j| j == joint));
    above(hips).find(|&joint| carries(joint) && moves(joint))
}

impl Planted {
    /// Whether the foot is held, per frame.
    fn standing(&self) -> Vec<bool> {
        let mut standing = vec![false; self.phases.len()];
        for (plant, _) in self.plants.iter().zip(&self.is_held).filter(|(_, is_held)| **is_held) {
            standing[plant.clone()].fill(true);
        }
        standing
    }
}

/// All that is to be written into the channels.
struct Bake<'a> {
    clip: &'a Clip,
    legs: &'a [Leg; 2],
    corrections: &'a [Correction; 2],
    carrier: Option<usize>,
    way: &'a [Vector3<f64>],
    length: f64,
}

impl Bake<'_> {
    fn clip(&self) -> Clip {
        let clip = self.clip;
        let (mut values, width) = (clip.values().to_vec(), clip.channel_count());
        let joints: Vec<usize> = self.legs.iter().map(|leg| leg.joints.ankle).chain(self.carrier).collect();
        let mut kinematics = Kinematics::for_joints(clip, &joints);
        for (frame, row) in values.chunks_exact_mut(width.max(1)).enumerate() {
            kinematics.pose(frame);
            let rotations = kinematics.rotations();
            self.shift(frame, rotations, row);
            for (leg, correction) in self.legs.iter().zip(self.corrections) {
                self.bend(leg, correction, frame, rotations, row);
            }
        }
        Clip::new(clip.joints().to_vec(), clip.frame_time(), values).with_position_rule(clip.position_rule())
    }

    /// Moves the hips.
    fn shift(&self, frame: usize, rotations: &[Matrix3<f64>], row: &mut [f64]) {
        let Some(carrier) = self.carrier else { return };
        let way = self.way[frame];
        if way.norm() <= NOTHING * self.length || !way.norm().is_finite() {
            return;
        }
        let joint = &self.clip.joints()[carrier];
        let way = joint.parent.map_or(way, |parent| rotations[parent].transpose() * way);
        for (value, channel) in row[self.clip.channel_range(carrier)].iter_mut().zip(&joint.channels) {
            if let Channel::Position(axis) = channel {
                *value += way[axis.index()];
            }
        }
    }

    /// Bends one leg.
    fn bend(
        &self,
        leg: &Leg,
        correction: &Correction,
        frame: usize,
        rotations: &[Matrix3<f64>],
        row: &mut [f64],
    ) {
        let Joints { upper: Some([thigh, shank]), ankle, .. } = leg.joints else { return };
        if !can_turn(self.clip, [thigh, shank], ankle) {
            return;
        }
        let (moved, turned) = (correction.ankle[frame] - self.way[frame], correction.foot[frame]);
        if moved.norm() <= NOTHING * self.length && turned.norm() <= NOTHING {
            return;
        }
        let apart = leg.ankle[frame] - leg.hip[frame] + moved;
        let [upper, lower] = knee::turns(leg, frame, rotations[thigh] * leg.hinge, apart);
        let foot = Rotation3::new(turned).into_inner();
        // Joints between go along with the one above them.
        let mut above: Matrix3<f64> = Matrix3::identity();
        for (joint, turn) in [(thigh, upper), (shank, lower), (ankle, foot)] {
            let parent = self.clip.joints()[joint].parent.map_or(Matrix3::identity(), |p| rotations[p]);
            let target = (above * parent).transpose() * turn * rotations[joint];
            let channels = &self.clip.joints()[joint].channels;
            euler::set(channels, &mut row[self.clip.channel_range(joint)], &target);
            above = turn;
        }
    }
}
