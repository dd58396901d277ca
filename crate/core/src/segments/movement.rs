//! Movement of the body: joint positions and velocities, independent of the place and heading of the
//! performer, of the unit of length and of the frame rate.

use std::ops::Range;

use nalgebra::{Rotation3, Vector3};

use crate::bvh::Clip;
use crate::kinematics::Kinematics;
use crate::segments::body;
use crate::segments::grid::SampleGrid;
use crate::skeleton::{Role, Skeleton};

/// Sample rate, in Hz, or the frame rate of the clip if that is lower. Samples coincide with frames of
/// clips at 30, 60 and 120 Hz.
const RATE: f64 = 30.0;

/// Joints that are compared, by role, in the order of the rows.
const JOINTS: [Role; 11] = [
    Role::LeftShank,
    Role::RightShank,
    Role::LeftAnkle,
    Role::RightAnkle,
    Role::Head,
    Role::LeftArm,
    Role::RightArm,
    Role::LeftForearm,
    Role::RightForearm,
    Role::LeftHand,
    Role::RightHand,
];

/// Minimum number of compared joints.
const MIN_JOINTS: u32 = 4;

/// Joints on the left and the right of the body, whose connection gives the heading; the first pair
/// that is known is used.
const SIDES: [[Role; 2]; 2] = [[Role::LeftThigh, Role::RightThigh], [Role::LeftArm, Role::RightArm]];

/// Number of values of the joints' positions, padded to a multiple of four.
const POSITIONS: usize = 36;

/// Number of values of a row, padded to a multiple of four.
const WIDTH: usize = 76;

/// Index of the first velocity in a row.
const VELOCITIES: usize = POSITIONS;

/// Index of the velocity of the hips in a row.
const HIPS_VELOCITY: usize = VELOCITIES + 3 * JOINTS.len();

/// Index of the turning rate in a row.
const TURNING: usize = HIPS_VELOCITY + 3;

/// Distance in time of the two positions that give a velocity, on either side of a sample, in seconds.
const HALF_SPAN: f64 = 0.1;

/// Factor from a velocity to a comparable difference of positions, in seconds. Chosen on seeds 0 to 3 of
/// the generator, where 0.15 to 0.3 distinguish the actions about equally well.
const VELOCITY_WEIGHT: f64 = 0.3;

/// Factor from a turning rate in radians per second to a comparable difference of positions.
const TURNING_WEIGHT: f64 = 0.1;

/// Horizontal length of the connection of both sides, in leg lengths, below which the heading of the
/// sample before is used.
const MIN_SIDE: f64 = 0.02;

/// Movement in one sample, in leg lengths: positions of the joints relative to the hips, with the
/// heading turned away; their velocities and that of the hips, times [`VELOCITY_WEIGHT`]; the rate of
/// turning, times [`TURNING_WEIGHT`]. Values of joints are divided by the square root of the number of
/// joints, so that distances do not depend on it.
pub(crate) type Row = [f32; WIDTH];

/// Known joints of a skeleton, one bit for each of [`JOINTS`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct JointSet(u16);

impl JointSet {
    pub fn bits(self) -> u16 {
        self.0
    }

    pub fn from_bits(bits: u16) -> JointSet {
        JointSet(bits)
    }

    fn count(self) -> u32 {
        self.0.count_ones()
    }

    fn contains(self, slot: usize) -> bool {
        self.0 >> slot & 1 == 1
    }

    /// Returns the joints of both sets; `None` if they are too few to compare.
    pub fn common(self, other: JointSet) -> Option<JointSet> {
        let common = JointSet(self.0 & other.0);
        (common.count() >= MIN_JOINTS).then_some(common)
    }

    /// Returns a row with these joints as one with the joints of a subset.
    pub fn restrict(self, row: &Row, subset: JointSet) -> Row {
        let scale = (f64::from(self.count()) / f64::from(subset.count())).sqrt() as f32;
        let mut restricted = *row;
        for slot in 0..JOINTS.len() {
            let scale = if subset.contains(slot) { scale } else { 0.0 };
            for first in [3 * slot, VELOCITIES + 3 * slot] {
                restricted[first..first + 3].iter_mut().for_each(|value| *value *= scale);
            }
        }
        restricted
    }
}

/// Movement of a clip, sampled at [`RATE`].
#[derive(Debug)]
pub(crate) struct Movement {
    rows: Vec<Row>,
    /// Joints that are known.
    pub joints: JointSet,
    grid: SampleGrid,
}

impl Movement {
    /// Samples the movement in a range of frames; `None` if too few joints are known.
    pub fn new(clip: &Clip, skeleton: &Skeleton, frames: &Range<usize>) -> Option<Movement> {
        let roles = &skeleton.roles;
        let hips = roles.get(Role::Hips)?;
        let known = |[left, right]: [Role; 2]| Some([roles.get(left)?, roles.get(right)?]);
        let [left, right] = SIDES.into_iter().find_map(known)?;
        let slots = JOINTS.map(|role| roles.get(role));
        let joints = slots.iter().rev().fold(0, |set, joint| set << 1 | u16::from(joint.is_some()));
        let joints = JointSet(joints);
        if joints.count() < MIN_JOINTS {
            return None;
        }
        let grid = SampleGrid::new(clip, frames, RATE.min(clip.rate()));
        let needed: Vec<usize> = slots.into_iter().flatten().chain([hips, left, right]).collect();
        let mut kinematics = Kinematics::for_joints(clip, &needed);
        let scale = body::leg_length(skeleton).recip();
        let mut positions = |frame: usize| -> Vec<Vector3<f64>> {
            let pose = kinematics.pose(frame);
            needed.iter().map(|&joint| skeleton.up.to_y_up(pose[joint] * scale)).collect()
        };
        let mut path = Path::default();
        let mut rows = Vec::with_capacity(grid.count());
        for sample in 0..grid.count() {
            let ([_, before, after, _], t) = grid.neighbours(sample);
            let mut pose = positions(before);
            if t > 1e-6 {
                pose.iter_mut().zip(positions(after)).for_each(|(a, b)| *a += (b - *a) * t);
            }
            let [.., hips, left, right] = pose[..] else { continue };
            let to_body = path.push(hips, left - right);
            let mut joints = pose.into_iter();
            let mut row = [0.0; WIDTH];
            for (values, _) in row.chunks_exact_mut(3).zip(slots).filter(|(_, joint)| joint.is_some()) {
                let position = to_body * (joints.next().unwrap_or_default() - hips);
                values.copy_from_slice(position.cast::<f32>().as_slice());
            }
            rows.push(row);
        }
        let mut movement = Movement { rows, joints, grid };
        movement.add_velocities(&path);
        Some(movement)
    }

    fn add_velocities(&mut self, path: &Path) {
        let last = self.rows.len().saturating_sub(1);
        let step = self.grid.seconds(1);
        let reach = if step > 0.0 { ((HALF_SPAN / step).round() as usize).max(1) } else { 1 };
        let joint_scale = f64::from(self.joints.count()).sqrt().recip() as f32;
        for sample in 0..self.rows.len() {
            let (from, to) = (sample.saturating_sub(reach), (sample + reach).min(last));
            let span = self.grid.seconds(to - from);
            let rate = if span > 0.0 { span.recip() } else { 0.0 };
            let weight = (VELOCITY_WEIGHT * rate) as f32;
            for value in 0..3 * JOINTS.len() {
                let change = self.rows[to][value] - self.rows[from][value];
                self.rows[sample][VELOCITIES + value] = weight * change;
            }
            let hips = path.to_body(sample) * (path.hips[to] - path.hips[from]);
            let turn = path.headings[to] - path.headings[from];
            let row = &mut self.rows[sample];
            row[HIPS_VELOCITY..TURNING].copy_from_slice((hips.cast::<f32>() * weight).as_slice());
            row[TURNING] = (TURNING_WEIGHT * rate * turn) as f32;
        }
        for row in &mut self.rows {
            row[..HIPS_VELOCITY].iter_mut().for_each(|value| *value *= joint_scale);
        }
    }

    /// Returns the samples of a range of frames, at least one.
    pub fn rows(&self, frames: &Range<usize>) -> &[Row] {
        &self.rows[self.samples(frames)]
    }

    /// Returns the indices of the samples of a range of frames, at least one.
    pub fn samples(&self, frames: &Range<usize>) -> Range<usize> {
        let last = self.rows.len() - 1;
        let start = self.grid.sample_from(frames.start).min(last);
        start..self.grid.sample_from(frames.end).clamp(start + 1, last + 1)
    }

    /// Returns all samples.
    pub fn all_rows(&self) -> &[Row] {
        &self.rows
    }

    /// Returns the frame nearest to a sample.
    pub fn frame(&self, sample: usize) -> usize {
        self.grid.frame(sample)
    }

    /// Returns the time between samples, in seconds.
    pub fn step(&self) -> f64 {
        self.grid.seconds(1)
    }
}

/// Path and heading of the hips.
#[derive(Default)]
struct Path {
    hips: Vec<Vector3<f64>>,
    /// Headings in radians, continuous.
    headings: Vec<f64>,
}

impl Path {
    /// Adds a sample with the vector from the right to the left side of the body. Returns the rotation
    /// to coordinates in which the left side has the direction x.
    fn push(&mut self, hips: Vector3<f64>, side: Vector3<f64>) -> Rotation3<f64> {
        let last = self.headings.last().copied();
        let heading =
            if side.x.hypot(side.z) > MIN_SIDE { f64::atan2(-side.z, side.x) } else { last.unwrap_or(0.0) };
        let turns = last.map_or(0.0, |last| ((last - heading) / std::f64::consts::TAU).round());
        self.hips.push(hips);
        self.headings.push(heading + turns * std::f64::consts::TAU);
        self.to_body(self.hips.len() - 1)
    }

    fn to_body(&self, sample: usize) -> Rotation3<f64> {
        Rotation3::from_axis_angle(&Vector3::y_axis(), -self.headings[sample])
    }
}

/// Returns the squared distance of two movements.
pub(crate) fn squared_distance(a: &Row, b: &Row) -> f32 {
    sum_of_squares(a, b)
}

/// Returns the squared distance of the joint positions of two movements.
pub(crate) fn squared_pose_distance(a: &Row, b: &Row) -> f32 {
    sum_of_squares(&a[..POSITIONS], &b[..POSITIONS])
}

/// Returns the squared distance of two vectors whose length is a multiple of four. Four sums allow vector
/// instructions.
fn sum_of_squares(a: &[f32], b: &[f32]) -> f32 {
    let mut sums = [0.0; 4];
    for (a, b) in a.chunks_exact(4).zip(b.chunks_exact(4)) {
        for lane in 0..4 {
            sums[lane] += (a[lane] - b[lane]) * (a[lane] - b[lane]);
        }
    }
    sums.iter().sum()
}
