//! Measurements of a body: up axis, leg length and unit.

use std::ops::Range;

use nalgebra::Vector3;

use super::unit::{self, AssumedUnit};
use super::{LegRoles, Role, Roles, Up};
use crate::bvh::Clip;
use crate::foot::Side;
use crate::kinematics::{self, Kinematics, Track};
use crate::numeric::sort;
use crate::numeric::stats::{median_low, percentile};

/// Number of poses on which axis and scale are measured.
const SAMPLED_POSES: usize = 512;

/// Number of pairs of poses on which motion of the lowest joint is measured.
const SAMPLED_PAIRS: usize = 128;

/// Time between the poses of a pair, in seconds.
const PAIR_SECONDS: f64 = 0.04;

/// Weights of the evidence for an up axis.
///
/// Set by hand so that each situation of the tests is decided: standing, walking, sitting, supine,
/// crawling, push-ups, handstands, and characters that are upside down or in another axis than their
/// rest pose.
mod weight {
    /// Trunk and legs point up.
    pub const UPRIGHT: f64 = 0.8;
    /// Trunk and legs of the rest pose point up.
    pub const REST_POSE: f64 = 0.9;
    /// One of the lowest joints is at rest while others move.
    pub const SUPPORT: f64 = 0.6;
    /// The lowest joint stays on one level.
    pub const LEVEL: f64 = 0.2;
    /// The lowest level is near zero.
    pub const ZERO: f64 = 0.2;
    /// Prior of each direction of `Up::ALL`: most files use Y, then Z.
    pub const AXIS: [f64; 6] = [0.06, 0.05, 0.0, -0.05, -0.05, -0.1];
}

/// Cosine of the angle between trunk and legs of a rest pose that stands, at least.
const STANDING_REST: f64 = 0.7;

/// Variation of the lowest level, in leg lengths, at which its evidence has faded to 1/e.
const LEVEL_SPREAD: f64 = 0.15;

/// Distance of the lowest level from zero, in leg lengths, at which its evidence has faded to 1/e.
const ZERO_LEVEL: f64 = 0.1;

/// Height above the lowest joint, in leg lengths, up to which joints count as lowest.
const GROUND: f64 = 0.3;

/// Speed, in leg lengths per second, above which poses count as moving.
const MOVING: f64 = 0.05;

/// Evidence of posture and support, from 0 to 1, above which it confirms a direction.
const CLEAR: f64 = 0.4;

/// Evidence of posture for another direction, from 0 to 1, above which it contradicts the up axis.
const CONTRADICTION: f64 = 0.7;

/// Difference of the evidence for two directions below which the up axis is uncertain.
const UNCERTAIN: f64 = 0.15;

/// Up axis found in a clip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct UpEstimate {
    pub up: Up,
    pub is_certain: bool,
}

/// Tracks of the joints that determine axis and scale, at sampled poses.
pub(super) struct Body<'a> {
    clip: &'a Clip,
    members: Range<usize>,
    hips: Track,
    head: Option<Track>,
    /// Tracks of thigh, shank, ankle, toe and tip of each side.
    legs: [[Option<Track>; 5]; 2],
    /// Least and largest coordinates of all joints in each pose.
    bounds: Vec<[Vector3<f64>; 2]>,
    /// Vectors from feet to hips and from hips to head in the rest pose.
    rest: [Option<Vector3<f64>>; 2],
}

impl<'a> Body<'a> {
    pub fn measure(clip: &'a Clip, root: usize, roles: &Roles) -> Body<'a> {
        let members = clip.skeleton_joints(root);
        let hips = roles.get(Role::Hips).unwrap_or(root);
        let head = roles.get(Role::Head).or(roles.get(Role::Neck));
        let legs = Side::BOTH.map(|side| {
            let leg = LegRoles::for_side(side);
            [leg.thigh, leg.shank, leg.ankle, leg.toe, leg.tip].map(|role| roles.get(role))
        });
        let mut kinematics = Kinematics::for_skeleton(clip, members.clone());
        let frames = kinematics::sample_frames(clip, SAMPLED_POSES);
        let track = |joint: usize| (joint, Track::with_capacity(frames.len()));
        let mut hips = track(hips);
        let mut head = head.map(track);
        let mut legs = legs.map(|leg| leg.map(|joint| joint.map(track)));
        let mut bounds = Vec::with_capacity(frames.len());
        for frame in frames {
            let pose = kinematics.pose(frame);
            let tracks = legs.iter_mut().flatten().flatten().chain(&mut head);
            for (joint, track) in tracks.chain(std::iter::once(&mut hips)) {
                track.push(pose[*joint - root]);
            }
            bounds.push([
                pose.iter().fold(pose[0], |a, b| a.inf(b)),
                pose.iter().fold(pose[0], |a, b| a.sup(b)),
            ]);
        }
        let rest = rest_directions(clip, root, roles);
        Body {
            clip,
            members,
            hips: hips.1,
            head: head.map(|(_, track)| track),
            legs: legs.map(|leg| leg.map(|joint| joint.map(|(_, track)| track))),
            bounds,
            rest,
        }
    }

    /// Returns the up axis with the strongest evidence, or `None` without feet and head.
    pub fn up(&self, leg: Option<f64>) -> Option<UpEstimate> {
        let feet: Vec<&Track> = self.legs.iter().filter_map(|leg| leg[2].as_ref()).collect();
        if feet.is_empty() && self.head.is_none() {
            return None;
        }
        let scale = leg.unwrap_or_else(|| self.extent() / 2.0);
        let upright = self.upright(&feet);
        let rest = self.rest_up();
        let support = self.support(scale);
        let scores: Vec<(f64, Up)> = Up::ALL
            .into_iter()
            .zip(weight::AXIS)
            .enumerate()
            .map(|(index, (up, axis))| {
                let levels: Vec<f64> = self.bounds.iter().map(|bounds| lowest(bounds, up)).collect();
                let level = median_low(levels.iter().copied()).unwrap_or_default();
                let spread = percentile(levels.clone(), 0.9) - percentile(levels, 0.1);
                let score = weight::UPRIGHT * upright[index]
                    + weight::REST_POSE * f64::from(rest == Some(up))
                    + weight::SUPPORT * support[index]
                    + weight::LEVEL * (-spread / (LEVEL_SPREAD * scale)).exp()
                    + weight::ZERO * (-level.abs() / (ZERO_LEVEL * scale)).exp()
                    + axis;
                (score, up)
            })
            .collect();
        let scores = sort::sort_descending(scores, |(score, _)| *score);
        let is_measured = upright.iter().any(|&part| part > 0.0) || rest.is_some();
        let (best, up) = scores[0];
        // The rest pose, or a posture that rests on the ground, must agree with the direction; and no posture
        // may contradict it.
        let evidence = |up: Up| {
            let index = Up::ALL.iter().position(|&other| other == up).unwrap_or_default();
            (upright[index], support[index])
        };
        let (own_upright, own_support) = evidence(up);
        let is_confirmed = rest == Some(up) || own_upright > CLEAR && own_support > CLEAR;
        let is_contradicted = upright.iter().any(|&part| part > CONTRADICTION.max(own_upright));
        let is_certain = best - scores[1].0 >= UNCERTAIN && is_confirmed && !is_contradicted;
        is_measured.then_some(UpEstimate { up, is_certain })
    }

    /// Returns how well trunk and legs point along each direction: the mean over poses, from 0 to 1.
    ///
    /// The legs begin between the hip joints, as the root of a list of points may be anywhere.
    fn upright(&self, feet: &[&Track]) -> [f64; 6] {
        let mut sums = [0.0; 6];
        let mut count = 0.0;
        let hip_joints = [self.legs[0][0].as_ref(), self.legs[1][0].as_ref()];
        for (frame, hips) in self.hips.iter().enumerate() {
            let hips = match hip_joints {
                [Some(left), Some(right)] => &((left[frame] + right[frame]) / 2.0),
                _ => hips,
            };
            let legs = (!feet.is_empty()).then(|| {
                let sum: Vector3<f64> = feet.iter().map(|foot| foot[frame]).sum();
                hips - sum / feet.len() as f64
            });
            let trunk = self.head.as_ref().map(|head| head[frame] - hips);
            for direction in [legs, trunk].into_iter().flatten().filter_map(|v| v.try_normalize(0.0)) {
                count += 1.0;
                for (sum, up) in sums.iter_mut().zip(Up::ALL) {
                    *sum += up.height(&direction).max(0.0).powi(2);
                }
            }
        }
        sums.map(|sum| if count > 0.0 { sum / count } else { 0.0 })
    }

    /// Returns the up axis of the rest pose, if it is one of a standing body.
    fn rest_up(&self) -> Option<Up> {
        let [legs, trunk] = self.rest.map(|vector| vector.and_then(|vector| vector.try_normalize(0.0)));
        let up = match (legs, trunk) {
            (Some(legs), Some(trunk)) if legs.dot(&trunk) > STANDING_REST => legs + trunk,
            (None, Some(trunk)) => trunk,
            (Some(legs), None) => legs,
            _ => return None,
        };
        Some(Up::nearest(up))
    }

    /// Returns how still the lowest joints are in each direction while the body moves: 1 if one of
    /// them is at rest, 0 if all move at least as much as the mean of all joints.
    fn support(&self, scale: f64) -> [f64; 6] {
        let frame_time = self.clip.frame_time();
        let step = ((PAIR_SECONDS / frame_time).round() as usize).max(1);
        let frame_count = self.clip.frame_count();
        let mut sums = [0.0; 6];
        let mut count = 0.0;
        if frame_count <= step {
            return sums;
        }
        let mut kinematics = Kinematics::for_skeleton(self.clip, self.members.clone());
        let samples = SAMPLED_PAIRS.min(frame_count - step);
        for sample in 0..samples {
            let frame = sample * (frame_count - step) / samples;
            let before = kinematics.pose(frame).to_vec();
            let after = kinematics.pose(frame + step);
            let moved = |joint: usize| (after[joint] - before[joint]).norm();
            let mean = (0..before.len()).map(moved).sum::<f64>() / before.len() as f64;
            if mean < MOVING * scale * step as f64 * frame_time {
                continue;
            }
            count += 1.0;
            for (sum, up) in sums.iter_mut().zip(Up::ALL) {
                let heights: Vec<f64> = before.iter().map(|position| up.height(position)).collect();
                let ground = heights.iter().copied().fold(f64::INFINITY, f64::min) + GROUND * scale;
                let low = (0..before.len()).filter(|&joint| heights[joint] <= ground);
                let least = low.map(moved).fold(f64::INFINITY, f64::min);
                *sum += (1.0 - least / mean).max(0.0);
            }
        }
        sums.map(|sum| if count > 0.0 { sum / count } else { 0.0 })
    }

    /// Returns the leg length of the longer leg, from positions, as some files have no offsets.
    pub fn leg(&self) -> Option<f64> {
        let length = |[thigh, shank, ankle, ..]: &[Option<Track>; 5]| {
            let ankle = ankle.as_ref()?;
            let bone = |a: &Track, b: &Track| {
                median_low(a.iter().zip(b).map(|(a, b)| (a - b).norm())).unwrap_or_default()
            };
            match (thigh, shank) {
                (Some(thigh), Some(shank)) => Some(bone(thigh, shank) + bone(shank, ankle)),
                (None, Some(upper)) | (Some(upper), None) => Some(bone(upper, ankle)),
                (None, None) => Some(bone(&self.hips, ankle)),
            }
        };
        let longest = self.legs.iter().filter_map(length).fold(0.0, f64::max);
        (longest > 0.0).then_some(longest)
    }

    /// Returns the unit by the height of the hip joint above the sole, or by the extent of the body.
    pub fn unit(&self, leg: Option<f64>, up: Up, is_animal: bool) -> AssumedUnit {
        match leg {
            Some(leg) => unit::of_leg(leg + self.ankle_height(up), is_animal),
            // A character without measurable legs is assumed to be 1.7 m tall.
            None => {
                let extent = self.extent();
                let metres_per_unit = if extent > 0.0 { 1.7 / extent } else { 1.0 };
                AssumedUnit { metres_per_unit, is_certain: true }
            }
        }
    }

    /// Returns the distance between two joints of the first pose that are far apart, in file units: the joint
    /// farthest from the root, and the joint farthest from that one.
    fn extent(&self) -> f64 {
        let mut kinematics = Kinematics::for_skeleton(self.clip, self.members.clone());
        let pose = kinematics.pose(0);
        let farthest = |from: Vector3<f64>| {
            pose.iter().fold((0.0, from), |best, &position| {
                let distance = (position - from).norm();
                if distance > best.0 { (distance, position) } else { best }
            })
        };
        farthest(farthest(pose[0]).1).0
    }

    /// Returns the height of the ankles above the lowest part of the feet, without outliers.
    fn ankle_height(&self, up: Up) -> f64 {
        let fifth_percentile = |tracks: &mut dyn Iterator<Item = &Track>| {
            let mut heights: Vec<f64> =
                tracks.flat_map(|track| track.iter().map(|position| up.height(position))).collect();
            heights.sort_unstable_by(f64::total_cmp);
            heights.get(heights.len() / 20).copied()
        };
        let ankles = fifth_percentile(&mut self.legs.iter().filter_map(|leg| leg[2].as_ref()));
        let soles = fifth_percentile(&mut self.legs.iter().flat_map(|leg| leg[2..].iter().flatten()));
        ankles.zip(soles).map_or(0.0, |(ankle, sole)| (ankle - sole).max(0.0))
    }
}

/// Returns the lowest level of a pose in the direction `up`.
fn lowest([least, largest]: &[Vector3<f64>; 2], up: Up) -> f64 {
    up.height(if up.negative { largest } else { least })
}

/// Returns the vectors from the feet to the hips and from the hips to the head in the rest pose.
fn rest_directions(clip: &Clip, root: usize, roles: &Roles) -> [Option<Vector3<f64>>; 2] {
    let position = |joint: usize| {
        let mut sum = Vector3::zeros();
        let mut next = Some(joint).filter(|&joint| joint != root);
        while let Some(joint) = next {
            sum += clip.joints()[joint].offset;
            next = clip.joints()[joint].parent.filter(|&parent| parent != root);
        }
        sum
    };
    let hips = position(roles.get(Role::Hips).unwrap_or(root));
    let [left, right] = Side::BOTH.map(|side| roles.get(LegRoles::for_side(side).ankle).map(position));
    let legs = left.zip(right).map(|(left, right)| hips - (left + right) / 2.0);
    let head = roles.get(Role::Head).or(roles.get(Role::Neck)).map(position);
    [legs, head.map(|head| head - hips)]
}
