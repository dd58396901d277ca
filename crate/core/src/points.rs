//! Clips of points: positions of named points per frame, of any source, without rotations.
//!
//! A point clip goes through the same detection as a clip that was read from a file, because its joints
//! have the given positions exactly ([`PositionRule::Global`]).

use nalgebra::Vector3;

use crate::bvh::{Axis, Channel, Clip, FRAME_RATES, Joint, JointKind, Limits, PositionRule};
use crate::notice::{Code, Notice, shortened};
use crate::skeleton::{Overrides, Role, Skeleton, UNITS};

/// Leg length that is assumed if neither hips nor knees are known, in metres.
const ASSUMED_LEG: f64 = 0.9;

/// Name of the joint above all points, which is added if the points have no common parent.
const ORIGIN: &str = "origin of the points";

/// Positions of points, and what is known about them.
#[derive(Clone, Debug)]
pub struct Points<'a> {
    /// Frames × points × 3 coordinates in row-major order.
    pub positions: &'a [f64],
    /// Name of each point; names that mean nothing, such as numbers, are allowed.
    pub names: &'a [String],
    /// Parent of each point in any order, `None` for a root; empty if the points are not connected.
    pub parents: &'a [Option<usize>],
    /// Frame rate, in Hz.
    pub rate: f64,
}

/// A clip of points with its skeleton.
#[derive(Clone, Debug)]
pub struct PointClip {
    /// The clip. Its joints are the points in depth-first order, below an added joint if the points have no
    /// common parent.
    pub clip: Clip,
    /// The skeleton of all points, with notices on what was assumed.
    pub skeleton: Skeleton,
    /// Joint of each point.
    pub joints: Vec<usize>,
}

/// Error: points do not form a clip. Frames and points count from 0.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PointsError {
    /// There are no points.
    #[error("the positions have no points")]
    NoPoints,
    /// There are no frames.
    #[error("the positions have no frames")]
    NoFrames,
    /// The number of values is not frames × points × 3.
    #[error("the number of coordinates, {values}, is not a multiple of 3 × {points} points")]
    Length {
        /// Number of coordinates.
        values: usize,
        /// Number of points.
        points: usize,
    },
    /// The number of parents is not that of the points.
    #[error("there are {found} parents for {points} points")]
    ParentCount {
        /// Number of parents.
        found: usize,
        /// Number of points.
        points: usize,
    },
    /// A parent is not a point.
    #[error("the parent of point {point} is {parent}, but there are {points} points")]
    Parent {
        /// The point.
        point: usize,
        /// Its parent.
        parent: usize,
        /// Number of points.
        points: usize,
    },
    /// A point is its own ancestor.
    #[error("point {0} is its own ancestor")]
    Cycle(usize),
    /// A role has a joint that is not a point.
    #[error("the role {role} has point {point}, but there are {points} points")]
    RolePoint {
        /// Name of the role.
        role: &'static str,
        /// Its point.
        point: usize,
        /// Number of points.
        points: usize,
    },
    /// A coordinate is not a finite number.
    #[error("the position of point {point} ({name}) in frame {frame} is {value}")]
    NotFinite {
        /// Frame.
        frame: usize,
        /// Point.
        point: usize,
        /// Name of the point.
        name: String,
        /// The coordinate.
        value: f64,
    },
    /// A coordinate is larger than [`Limits::value`].
    #[error("the coordinate {value:e} of point {point} in frame {frame} is beyond ±{limit:e}", limit = Limits::default().value)]
    TooLarge {
        /// Frame.
        frame: usize,
        /// Point.
        point: usize,
        /// The coordinate.
        value: f64,
    },
    /// The frame rate is not in [`FRAME_RATES`].
    #[error("the frame rate must be a number from {low} to {high} Hz, not {0}", low = FRAME_RATES.start(), high = FRAME_RATES.end())]
    Rate(f64),
    /// The unit is not in [`UNITS`].
    #[error("the unit must be a number from {low} to {high} metres, not {0}", low = UNITS.start(), high = UNITS.end())]
    Unit(f64),
}

/// Point and parent of a joint.
struct Place {
    /// The point; `None` for the origin.
    point: Option<usize>,
    /// Joint of the parent.
    parent: Option<usize>,
}

impl Points<'_> {
    /// Returns the clip of the points. The joints of `overrides` are points.
    ///
    /// Without hips, their position is the middle of the hip joints, or else the mean of all points. Without
    /// hips, hip joints and knees, legs of 0.9 m are assumed. Notices of the skeleton state both.
    ///
    /// # Errors
    /// If there are no frames or points, a coordinate is not finite, the frame rate or the unit is out of
    /// range, or parents or roles are invalid.
    pub fn clip(&self, overrides: &Overrides) -> Result<PointClip, PointsError> {
        let frame_count = self.check(overrides)?;
        let children = self.children();
        let roots = children.last().map_or(0, Vec::len);
        let has_origin = roots > 1;
        let order = self.depth_first(&children, has_origin)?;
        let joints = order.iter().map(|place| Joint {
            name: place.point.map_or(ORIGIN, |point| self.names[point].as_str()).into(),
            kind: if place.parent.is_none() { JointKind::Root } else { JointKind::Joint },
            parent: place.parent,
            offset: Vector3::zeros(),
            channels: Axis::ALL.map(Channel::Position).to_vec(),
        });
        let joints = joints.collect();
        let mut values = Vec::with_capacity(frame_count * order.len() * 3);
        for row in self.positions.chunks_exact(3 * self.names.len()) {
            for place in &order {
                match place.point {
                    Some(point) => values.extend_from_slice(&row[3 * point..3 * point + 3]),
                    None => values.extend_from_slice(mean(row.chunks_exact(3)).as_slice()),
                }
            }
        }
        let mut clip =
            Clip::new(joints, frame_time(self.rate), values).with_position_rule(PositionRule::Global);
        let mut joint_of = vec![0; self.names.len()];
        for (joint, place) in order.iter().enumerate() {
            if let Some(point) = place.point {
                joint_of[point] = joint;
            }
        }
        let roles = overrides.roles.iter().map(|&(role, point)| (role, point.map(|point| joint_of[point])));
        let overrides = Overrides { roles: roles.collect(), ..*overrides };
        let mut skeleton = Skeleton::main(&clip, &overrides);
        if has_origin {
            skeleton = place_origin(&mut clip, skeleton, &overrides);
        }
        assume_leg(&mut skeleton, &overrides);
        Ok(PointClip { clip, skeleton, joints: joint_of })
    }

    /// Checks all values and returns the number of frames.
    fn check(&self, overrides: &Overrides) -> Result<usize, PointsError> {
        let points = self.names.len();
        let values = self.positions.len();
        if points == 0 {
            return Err(PointsError::NoPoints);
        }
        if !values.is_multiple_of(3 * points) {
            return Err(PointsError::Length { values, points });
        }
        if values == 0 {
            return Err(PointsError::NoFrames);
        }
        if !FRAME_RATES.contains(&self.rate) {
            return Err(PointsError::Rate(self.rate));
        }
        if let Some(unit) = overrides.metres_per_unit.filter(|unit| !UNITS.contains(unit)) {
            return Err(PointsError::Unit(unit));
        }
        if !self.parents.is_empty() && self.parents.len() != points {
            return Err(PointsError::ParentCount { found: self.parents.len(), points });
        }
        for (point, &parent) in self.parents.iter().enumerate() {
            if let Some(parent) = parent.filter(|&parent| parent >= points) {
                return Err(PointsError::Parent { point, parent, points });
            }
        }
        for &(role, point) in &overrides.roles {
            if let Some(point) = point.filter(|&point| point >= points) {
                return Err(PointsError::RolePoint { role: role.name(), point, points });
            }
        }
        let limit = Limits::default().value;
        // NaN is not within the limit either.
        if let Some(index) = self.positions.iter().position(|value| !(-limit..=limit).contains(value)) {
            let (value, point, frame) = (self.positions[index], index / 3 % points, index / 3 / points);
            return Err(if value.is_finite() {
                PointsError::TooLarge { frame, point, value }
            } else {
                PointsError::NotFinite {
                    frame,
                    point,
                    name: shortened(&self.names[point]).into_owned(),
                    value,
                }
            });
        }
        Ok(values / (3 * points))
    }

    /// Returns the children of each point, and the roots as the last entry.
    fn children(&self) -> Vec<Vec<usize>> {
        let points = self.names.len();
        let mut children = vec![Vec::new(); points + 1];
        for point in 0..points {
            let parent = self.parents.get(point).copied().flatten();
            children[parent.unwrap_or(points)].push(point);
        }
        children
    }

    /// Returns the joints in depth-first order: the origin, if one is added, and the points.
    fn depth_first(&self, children: &[Vec<usize>], has_origin: bool) -> Result<Vec<Place>, PointsError> {
        let points = self.names.len();
        let mut order = Vec::with_capacity(points + 1);
        if has_origin {
            order.push(Place { point: None, parent: None });
        }
        let origin = has_origin.then_some(0);
        let mut open: Vec<(usize, Option<usize>)> =
            children[points].iter().rev().map(|&root| (root, origin)).collect();
        let mut is_reached = vec![false; points];
        while let Some((point, parent)) = open.pop() {
            is_reached[point] = true;
            let joint = order.len();
            order.push(Place { point: Some(point), parent });
            open.extend(children[point].iter().rev().map(|&child| (child, Some(joint))));
        }
        // Points that no root leads to form a cycle.
        match is_reached.iter().position(|reached| !reached) {
            Some(point) => Err(PointsError::Cycle(point)),
            None => Ok(order),
        }
    }
}

/// Moves the origin of unconnected points between the hip joints, if the hips are not a point.
fn place_origin(clip: &mut Clip, mut skeleton: Skeleton, overrides: &Overrides) -> Skeleton {
    let roles = &skeleton.roles;
    if roles.get(Role::Hips).is_some_and(|hips| hips != skeleton.root) {
        return skeleton;
    }
    let thighs = roles.get(Role::LeftThigh).zip(roles.get(Role::RightThigh));
    let text = match thighs {
        Some((left, right)) => {
            let width = clip.channel_count();
            for row in clip.values_mut().chunks_exact_mut(width) {
                let middle = mean([left, right].iter().map(|joint| &row[3 * joint..3 * joint + 3]));
                row[..3].copy_from_slice(middle.as_slice());
            }
            skeleton = Skeleton::main(clip, overrides);
            "No point represents the hips; the middle of both hip joints is used."
        }
        None => "No point represents the hips; the mean of all points is used.",
    };
    skeleton.notices.push(Notice::new(Code::MissingJoints, text));
    skeleton
}

/// Assumes a leg length if no point is above the ankles.
fn assume_leg(skeleton: &mut Skeleton, overrides: &Overrides) {
    let roles = &skeleton.roles;
    let is_known = |role| roles.get(role).is_some_and(|joint| joint != skeleton.root);
    let above_ankles = [Role::Hips, Role::LeftThigh, Role::RightThigh, Role::LeftShank, Role::RightShank];
    if !roles.has_feet() || above_ankles.into_iter().any(is_known) {
        return;
    }
    let metres_per_unit = overrides.metres_per_unit.unwrap_or(1.0);
    skeleton.metres_per_unit = metres_per_unit;
    skeleton.leg = Some(ASSUMED_LEG / metres_per_unit);
    skeleton.notices.retain(|notice| notice.code != Code::Unit);
    let unit = if overrides.metres_per_unit.is_none() { "; the unit is assumed to be 1 m" } else { "" };
    let text = format!("Neither hips nor knees are known; legs of {ASSUMED_LEG} m are assumed{unit}.");
    skeleton.notices.push(Notice::new(Code::MissingJoints, text));
}

/// Returns the time between frames at `rate` Hz, in seconds.
///
/// Several numbers have the same rate after rounding. If one of them is a short decimal, as files have it, the
/// rate is that of a file, whose frame time is returned exactly.
fn frame_time(rate: f64) -> f64 {
    let time = 1.0 / rate;
    let digits = |time: f64| time.to_string().len();
    let is_decimal = |other: &f64| 1.0 / other == rate && digits(*other) + 3 <= digits(time);
    [time.next_down(), time.next_up()].into_iter().find(is_decimal).unwrap_or(time)
}

/// Returns the mean of positions.
fn mean<'a>(positions: impl ExactSizeIterator<Item = &'a [f64]>) -> Vector3<f64> {
    let count = positions.len() as f64;
    positions.map(Vector3::from_column_slice).sum::<Vector3<f64>>() / count
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frame_times_of_files_are_exact() {
        for time in [0.006667, 0.0083333, 0.008333, 0.0333333, 0.04, 0.016667, 1.0 / 30.0] {
            assert_eq!(frame_time(1.0 / time), time);
        }
        for rate in [24.0, 30.0, 60.0, 120.0, 29.97, 59.94] {
            assert_eq!(frame_time(rate), 1.0 / rate);
        }
    }
}
