//! One skeleton of a clip: structure, parsed names and sampled poses.

use std::cell::OnceCell;
use std::ops::Range;

use nalgebra::Vector3;

use crate::bvh::{Channel, Clip, JointKind};
use crate::foot::Side;
use crate::kinematics::{self, Kinematics, Track};
use crate::numeric::stats::median_low;
use crate::skeleton::names::{self, BodyPart, ParsedName};

/// Number of poses on which bone lengths and directions are measured.
const SAMPLED_POSES: usize = 64;

/// Time between the two poses of a step, in seconds.
const STEP_SECONDS: f64 = 0.04;

/// Fraction of the lengths of all bones along one direction, above which a rest pose is not one of a
/// standing body, whose legs take less than half.
const PARALLEL_REST: f64 = 0.75;

/// Relative difference of lengths of mirrored joints, at most.
pub(super) const MIRROR_TOLERANCE: f64 = 0.05;

/// Rotation range, in degrees, below which a joint counts as not animated.
const STILL_DEGREES: f64 = 1e-3;

/// One skeleton of a clip with the meaning of its joint names.
pub(super) struct Tree<'a> {
    pub clip: &'a Clip,
    pub root: usize,
    /// Parsed name of each member, indexed from the root.
    names: Vec<ParsedName>,
    /// End of the subtree of each member, as a joint index.
    ends: Vec<usize>,
    /// Positions of all joints of the clip at sampled poses, computed on first use.
    tracks: OnceCell<Vec<Track>>,
    /// Pairs of poses of the members, computed on first use.
    steps: OnceCell<Vec<[Vec<Vector3<f64>>; 2]>>,
}

impl<'a> Tree<'a> {
    pub fn new(clip: &'a Clip, root: usize) -> Tree<'a> {
        let joints = clip.joints();
        let end = joints[root + 1..].iter().position(|joint| joint.parent.is_none());
        let members = root..end.map_or(joints.len(), |count| root + 1 + count);
        let named: Vec<usize> =
            members.clone().filter(|&joint| joints[joint].kind != JointKind::EndSite).collect();
        let parsed = names::parse_all(named.iter().map(|&joint| joints[joint].name.as_str()));
        let mut names = vec![ParsedName { is_tip: true, ..ParsedName::default() }; members.len()];
        for (joint, name) in named.into_iter().zip(parsed) {
            names[joint - root] = name;
        }
        // A subtree is contiguous because joints are in depth-first order.
        let mut ends: Vec<usize> = members.clone().map(|joint| joint + 1).collect();
        for joint in members.rev() {
            if let Some(parent) = joints[joint].parent {
                ends[parent - root] = ends[parent - root].max(ends[joint - root]);
            }
        }
        Tree { clip, root, names, ends, tracks: OnceCell::new(), steps: OnceCell::new() }
    }

    /// Returns the joints of the skeleton, parents first.
    pub fn members(&self) -> Range<usize> {
        self.root..self.root + self.names.len()
    }

    /// Returns the parsed name of a joint.
    pub fn name(&self, joint: usize) -> &ParsedName {
        &self.names[joint - self.root]
    }

    /// Returns the body part of a joint that is neither a helper nor the end of a bone.
    pub fn part(&self, joint: usize) -> Option<BodyPart> {
        let name = self.name(joint);
        name.part.filter(|_| !name.is_helper && !name.is_tip)
    }

    /// Returns the side in the name of a joint, or of its nearest ancestor with one.
    pub fn side(&self, joint: usize) -> Option<Side> {
        std::iter::once(joint).chain(self.ancestors(joint)).find_map(|joint| self.name(joint).side)
    }

    pub fn parent(&self, joint: usize) -> Option<usize> {
        self.clip.joints()[joint].parent
    }

    /// Returns the ancestors of `joint`, nearest first.
    pub fn ancestors(&self, joint: usize) -> impl Iterator<Item = usize> + '_ {
        std::iter::successors(self.parent(joint), |&joint| self.parent(joint))
    }

    /// Returns the descendants of `joint`, in file order.
    pub fn descendants(&self, joint: usize) -> Range<usize> {
        joint + 1..self.ends[joint - self.root]
    }

    /// True if `joint` is `other` or below it.
    pub fn is_within(&self, joint: usize, other: usize) -> bool {
        joint == other || self.descendants(other).contains(&joint)
    }

    /// Returns the children of `joint`.
    pub fn children(&self, joint: usize) -> impl Iterator<Item = usize> + '_ {
        let range = self.descendants(joint);
        std::iter::successors(Some(range.start).filter(|_| !range.is_empty()), move |&child| {
            Some(self.ends[child - self.root]).filter(|&next| next < range.end)
        })
    }

    pub fn is_leaf(&self, joint: usize) -> bool {
        self.descendants(joint).is_empty()
    }

    /// Returns the nearest joint that is an ancestor of both joints.
    pub fn common_ancestor(&self, a: usize, b: usize) -> Option<usize> {
        self.ancestors(a).find(|&joint| self.is_within(b, joint))
    }

    /// Returns the joints from `top` to `joint`, both included; `joint` must be within `top`.
    pub fn path(&self, top: usize, joint: usize) -> Vec<usize> {
        let mut path = vec![joint];
        while let Some(&last) = path.last().filter(|&&last| last != top) {
            path.extend(self.parent(last));
        }
        path.reverse();
        path
    }

    /// Returns the positions of all joints of the clip at sampled poses.
    pub fn tracks(&self) -> &[Track] {
        self.tracks.get_or_init(|| {
            let joints: Vec<usize> = (0..self.clip.joints().len()).collect();
            kinematics::tracks_at(self.clip, &joints, kinematics::sample_frames(self.clip, SAMPLED_POSES))
        })
    }

    /// Returns the median distance between two joints, in file units.
    pub fn distance(&self, a: usize, b: usize) -> f64 {
        let tracks = self.tracks();
        median_low(tracks[a].iter().zip(&tracks[b]).map(|(a, b)| (a - b).norm())).unwrap_or_default()
    }

    /// Returns the positions of the members in the rest pose, relative to the root.
    pub fn rest_pose(&self) -> Vec<Vector3<f64>> {
        let mut positions: Vec<Vector3<f64>> = Vec::with_capacity(self.names.len());
        for joint in self.members() {
            let parent = self.parent(joint).map(|parent| positions[parent - self.root]);
            let offset = self.clip.joints()[joint].offset;
            positions.push(parent.map_or_else(Vector3::zeros, |parent| parent + offset));
        }
        positions
    }

    /// True if the offsets have several directions. Rigs whose bones point along one axis of their own have
    /// a rest pose in which all limbs are parallel.
    pub fn has_standing_rest_pose(&self) -> bool {
        let offsets = || self.members().skip(1).map(|joint| self.clip.joints()[joint].offset);
        let total: f64 = offsets().map(|offset| offset.norm()).sum();
        let along =
            |direction: Vector3<f64>| offsets().map(|offset| offset.dot(&direction).max(0.0)).sum::<f64>();
        let largest = (0..3)
            .flat_map(|axis| [1.0, -1.0].map(|sign| along(Vector3::ith(axis, sign))))
            .fold(0.0, f64::max);
        total > 0.0 && largest <= PARALLEL_REST * total
    }

    /// True if two joints have equal distances from their common ancestor.
    pub fn is_mirrored(&self, a: usize, b: usize) -> bool {
        let Some(fork) = self.common_ancestor(a, b) else { return false };
        let (a, b) = (self.distance(fork, a), self.distance(fork, b));
        (a - b).abs() <= MIRROR_TOLERANCE * a.max(b)
    }

    /// True if `joint` has no children but end sites.
    pub fn is_leaf_but_end(&self, joint: usize) -> bool {
        self.children(joint).all(|child| self.clip.joints()[child].kind == JointKind::EndSite)
    }

    /// Returns the fraction of the time in which one of the joints is at rest, while the root travels; `None`
    /// if it does not travel.
    ///
    /// At rest is a joint that moves less than a quarter as far as the root.
    pub fn rest_fraction(&self, joints: &[usize]) -> Option<f64> {
        let steps = self.steps();
        let moved = |step: &[Vec<Vector3<f64>>; 2], joint: usize| {
            (step[1][joint - self.root] - step[0][joint - self.root]).norm()
        };
        let mean = steps.iter().map(|step| moved(step, self.root)).sum::<f64>() / steps.len().max(1) as f64;
        let (first, last) = (steps.first()?, steps.last()?);
        let travel = (last[0][0] - first[0][0]).norm();
        let size =
            (1..self.names.len()).map(|index| (first[0][index] - first[0][0]).norm()).fold(0.0, f64::max);
        if travel < size {
            return None;
        }
        let travelling = || steps.iter().filter(|step| moved(step, self.root) > 0.5 * mean);
        let resting = travelling()
            .filter(|step| joints.iter().any(|&joint| moved(step, joint) < 0.25 * moved(step, self.root)));
        Some(resting.count() as f64 / travelling().count().max(1) as f64)
    }

    /// Returns poses of the members in pairs that are 0.04 s apart, at equal distances over the clip.
    fn steps(&self) -> &[[Vec<Vector3<f64>>; 2]] {
        self.steps.get_or_init(|| {
            let apart = ((STEP_SECONDS / self.clip.frame_time()).round() as usize).max(1);
            let Some(count) = self.clip.frame_count().checked_sub(apart).filter(|&count| count > 0) else {
                return Vec::new();
            };
            let mut kinematics = Kinematics::new(self.clip);
            let samples = count.min(SAMPLED_POSES);
            (0..samples)
                .map(|sample| sample * count / samples)
                .map(|frame| {
                    [frame, frame + apart].map(|frame| kinematics.pose(frame)[self.members()].to_vec())
                })
                .collect()
        })
    }

    /// True if the channels of any of `joints` change over the clip.
    pub fn is_animated(&self, joints: &[usize]) -> bool {
        let frames = kinematics::sample_frames(self.clip, SAMPLED_POSES);
        if self.clip.frame_count() < 2 {
            return true;
        }
        joints.iter().any(|&joint| {
            let channels = &self.clip.joints()[joint].channels;
            channels.iter().zip(self.clip.channel_range(joint)).any(|(channel, at)| {
                let values = frames.clone().map(|frame| self.clip.row(frame)[at]);
                let (low, high) = values
                    .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
                matches!(channel, Channel::Rotation(_)) && high - low > STILL_DEGREES
                    || matches!(channel, Channel::Position(_)) && high > low
            })
        })
    }
}
