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
    /// Side in the name of each member, or of its nearest ancestor with one.
    sides: Vec<Option<Side>>,
    /// End of the subtree of each member, as a joint index.
    ends: Vec<usize>,
    /// Positions of the members at sampled poses, computed on first use.
    tracks: OnceCell<Vec<Track>>,
    /// Median distance of each member from its parent, computed on first use.
    bones: OnceCell<Vec<f64>>,
    /// Length and last joint of the longest chain from each member, computed on first use.
    chains: OnceCell<Vec<(f64, usize)>>,
    /// Pairs of poses of the members, computed on first use.
    steps: OnceCell<Steps>,
}

/// Pairs of poses of the members.
struct Steps {
    poses: Vec<[Vec<Vector3<f64>>; 2]>,
    /// Mean distance that the root moves in a step.
    mean: f64,
    /// True if the root travels farther than the size of the body.
    travels: bool,
}

impl<'a> Tree<'a> {
    pub fn new(clip: &'a Clip, root: usize) -> Tree<'a> {
        let joints = clip.joints();
        let members = clip.skeleton_joints(root);
        let named: Vec<usize> =
            members.clone().filter(|&joint| joints[joint].kind != JointKind::EndSite).collect();
        let parsed = names::parse_all(named.iter().map(|&joint| joints[joint].name.as_str()));
        let mut names = vec![ParsedName { is_tip: true, ..ParsedName::default() }; members.len()];
        for (joint, name) in named.into_iter().zip(parsed) {
            names[joint - root] = name;
        }
        let mut sides: Vec<Option<Side>> = names.iter().map(|name| name.side).collect();
        for joint in members.clone().skip(1) {
            let inherited = joints[joint].parent.and_then(|parent| sides[parent - root]);
            sides[joint - root] = sides[joint - root].or(inherited);
        }
        // A subtree is contiguous because joints are in depth-first order.
        let mut ends: Vec<usize> = members.clone().map(|joint| joint + 1).collect();
        for joint in members.rev() {
            if let Some(parent) = joints[joint].parent {
                ends[parent - root] = ends[parent - root].max(ends[joint - root]);
            }
        }
        let (tracks, bones, chains, steps) = Default::default();
        Tree { clip, root, names, sides, ends, tracks, bones, chains, steps }
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
        self.sides[joint - self.root]
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

    /// Returns the positions of a joint at sampled poses.
    pub fn track(&self, joint: usize) -> &Track {
        &self.tracks()[joint - self.root]
    }

    /// Returns the positions of the members at sampled poses.
    pub fn tracks(&self) -> &[Track] {
        self.tracks.get_or_init(|| {
            let mut kinematics = Kinematics::for_skeleton(self.clip, self.members());
            let frames = kinematics::sample_frames(self.clip, SAMPLED_POSES);
            let mut tracks = vec![Vec::with_capacity(frames.len()); self.names.len()];
            for frame in frames {
                for (track, &position) in tracks.iter_mut().zip(kinematics.pose(frame)) {
                    track.push(position);
                }
            }
            tracks
        })
    }

    /// Returns the median distance between two joints, in file units.
    pub fn distance(&self, a: usize, b: usize) -> f64 {
        if self.parent(b) == Some(a) {
            return self.bones()[b - self.root];
        }
        self.median_distance(a, b)
    }

    fn median_distance(&self, a: usize, b: usize) -> f64 {
        let poses = self.track(a).iter().zip(self.track(b));
        median_low(poses.map(|(a, b)| (a - b).norm())).unwrap_or_default()
    }

    /// Returns the median distance of each member from its parent, in file units; 0 for the root.
    fn bones(&self) -> &[f64] {
        self.bones.get_or_init(|| {
            let length = |joint| self.parent(joint).map_or(0.0, |parent| self.median_distance(parent, joint));
            self.members().map(length).collect()
        })
    }

    /// Returns the longest chain from `joint` down, with its length, in file units. Helpers, and heels that
    /// have siblings, do not belong to chains.
    pub fn main_chain(&self, joint: usize) -> (f64, Vec<usize>) {
        let (length, last) = self.chains()[joint - self.root];
        (length, self.path(joint, last))
    }

    fn chains(&self) -> &[(f64, usize)] {
        self.chains.get_or_init(|| {
            let is_heel = |child: usize| self.name(child).part == Some(BodyPart::Heel);
            let mut chains: Vec<(f64, usize)> = self.members().map(|joint| (0.0, joint)).collect();
            for joint in self.members().rev() {
                let mut children: Vec<usize> =
                    self.children(joint).filter(|&child| !self.name(child).is_helper).collect();
                if !children.iter().all(|&child| is_heel(child)) {
                    children.retain(|&child| !is_heel(child));
                }
                // Of equal chains, the last one in the file counts.
                for child in children.into_iter().rev() {
                    let (length, last) = chains[child - self.root];
                    let length = length + self.bones()[child - self.root];
                    if length > chains[joint - self.root].0 {
                        chains[joint - self.root] = (length, last);
                    }
                }
            }
            chains
        })
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
        let Steps { poses, mean, travels } = self.steps();
        let moved = |step: &[Vec<Vector3<f64>>; 2], joint: usize| {
            (step[1][joint - self.root] - step[0][joint - self.root]).norm()
        };
        if !travels {
            return None;
        }
        let travelling = || poses.iter().filter(|step| moved(step, self.root) > 0.5 * mean);
        let resting = travelling()
            .filter(|step| joints.iter().any(|&joint| moved(step, joint) < 0.25 * moved(step, self.root)));
        Some(resting.count() as f64 / travelling().count().max(1) as f64)
    }

    /// Returns poses of the members in pairs that are 0.04 s apart, at equal distances over the clip.
    fn steps(&self) -> &Steps {
        self.steps.get_or_init(|| {
            let apart = ((STEP_SECONDS / self.clip.frame_time()).round() as usize).max(1);
            let count = self.clip.frame_count().saturating_sub(apart);
            let mut kinematics = Kinematics::for_skeleton(self.clip, self.members());
            let samples = count.min(SAMPLED_POSES);
            let poses: Vec<[Vec<Vector3<f64>>; 2]> = (0..samples)
                .map(|sample| sample * count / samples)
                .map(|frame| [frame, frame + apart].map(|frame| kinematics.pose(frame).to_vec()))
                .collect();
            let moved = poses.iter().map(|[before, after]| (after[0] - before[0]).norm());
            let mean = moved.sum::<f64>() / poses.len().max(1) as f64;
            let travels = poses.first().zip(poses.last()).is_some_and(|([first, _], [last, _])| {
                let sizes = first.iter().map(|position| (position - first[0]).norm());
                (last[0] - first[0]).norm() >= sizes.fold(0.0, f64::max)
            });
            Steps { poses, mean, travels }
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
