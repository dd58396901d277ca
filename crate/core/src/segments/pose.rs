//! Poses as joint rotations, at a rate independent of the frame rate.

use std::ops::Range;

use nalgebra::{DMatrix, DMatrixView, Quaternion, UnitQuaternion, Vector3};

use crate::bvh::{Channel, Clip};
use crate::numeric::interpolate;
use crate::segments::body::Body;
use crate::segments::grid::SampleGrid;
use crate::skeleton::Skeleton;

/// Number of steps with which the first step is compared.
const COMPARED_STEPS: usize = 10;
/// The first frame is an added pose if the first step is larger than the others by this factor …
const JUMP_FACTOR: f64 = 5.0;
/// … and a joint rotates by at least this angle, in radians.
const MIN_JUMP: f64 = 0.2;

/// Pose rate in Hz that coincides with frames at 24, 30, 60 and 120 Hz.
///
/// Methods that restart at each cut propagate the smallest difference between poses to all later
/// cuts, so they use recorded rather than interpolated poses.
pub(crate) const RECORDED_RATE: f64 = 6.0;

/// Poses at a fixed rate: one column per instant, four rows per joint.
///
/// Rotations are local and the root is excluded, so that location and heading do not matter.
#[derive(Debug)]
pub(crate) struct Poses {
    /// Quaternions of all joints, w first. The quaternions of each joint are continuous and have w
    /// ≥ 0 on average.
    pub columns: DMatrix<f64>,
    grid: SampleGrid,
}

impl Poses {
    /// Samples the poses of a range of frames at `rate` per second, or one per frame of slower clips:
    /// interpolated poses tell nothing that the frames do not.
    pub fn new(clip: &Clip, body: &Body, frames: &Range<usize>, rate: f64) -> Poses {
        let grid = SampleGrid::new(clip, frames, rate.min(clip.rate()));
        let mut columns = DMatrix::zeros(4 * body.joints.len(), grid.count());
        for (index, &joint) in body.joints.iter().enumerate() {
            let mut last = Quaternion::identity();
            let mut sum = 0.0;
            for sample in 0..grid.count() {
                let quaternion = align_sign(last, interpolated_rotation(clip, joint, &grid, sample));
                last = quaternion;
                sum += quaternion.w;
                for (row, value) in
                    [quaternion.w, quaternion.i, quaternion.j, quaternion.k].into_iter().enumerate()
                {
                    columns[(4 * index + row, sample)] = value;
                }
            }
            if sum < 0.0 {
                columns.rows_mut(4 * index, 4).neg_mut();
            }
        }
        Poses { columns, grid }
    }

    /// Returns the number of poses.
    pub fn count(&self) -> usize {
        self.columns.ncols()
    }

    /// Returns the frame nearest to a pose.
    pub fn frame(&self, column: usize) -> usize {
        self.grid.frame(column)
    }

    /// Returns the time from the first pose to another, in seconds.
    pub fn seconds(&self, column: usize) -> f64 {
        self.grid.seconds(column)
    }

    /// Returns the position of a pose, in fractional frames.
    pub fn position(&self, column: usize) -> f64 {
        self.grid.position(column)
    }
}

/// Returns the differences of poses, one per column, from their mean.
pub(crate) fn centred(poses: DMatrixView<f64>) -> DMatrix<f64> {
    let mean = poses.column_mean();
    let mut centred = poses.into_owned();
    for mut pose in centred.column_iter_mut() {
        pose -= &mean;
    }
    centred
}

/// Returns the rotation of a joint at a sample, interpolated between frames.
fn interpolated_rotation(clip: &Clip, joint: usize, grid: &SampleGrid, sample: usize) -> Quaternion<f64> {
    let (frames, t) = grid.neighbours(sample);
    let at = |frame: usize| rotation(clip, joint, frame).into_inner();
    if t < 1e-6 {
        return at(frames[1]);
    }
    let near = at(frames[1]);
    let quaternions = frames.map(|frame| align_sign(near, at(frame)));
    let interpolated = interpolate::catmull_rom(quaternions, t);
    // Opposite rotations in neighbouring frames have no interpolation.
    if interpolated.norm() > 1e-6 { interpolated.normalize() } else { near }
}

/// Returns the one of ±`rotation` that is nearer to `reference`.
fn align_sign(reference: Quaternion<f64>, rotation: Quaternion<f64>) -> Quaternion<f64> {
    if rotation.dot(&reference) < 0.0 { -rotation } else { rotation }
}

/// Returns the rotation of a joint relative to its parent.
pub(crate) fn rotation(clip: &Clip, joint: usize, frame: usize) -> UnitQuaternion<f64> {
    let values = &clip.row(frame)[clip.channel_range(joint)];
    let mut rotation = UnitQuaternion::identity();
    for (channel, value) in clip.joints()[joint].channels.iter().zip(values) {
        if let Channel::Rotation(axis) = channel {
            let mut scaled_axis = Vector3::zeros();
            scaled_axis[axis.index()] = value.to_radians();
            rotation *= UnitQuaternion::from_scaled_axis(scaled_axis);
        }
    }
    rotation
}

/// Returns the first frame of motion: 1 if frame 0 is an added pose, otherwise 0.
pub(crate) fn first_motion_frame(clip: &Clip, skeleton: &Skeleton) -> usize {
    let Ok(body) = Body::rotation_joints(clip, skeleton) else { return 0 };
    if clip.frame_count() < COMPARED_STEPS + 2 {
        return 0;
    }
    let step = |frame: usize| {
        let angles = body
            .joints
            .iter()
            .map(|&joint| rotation(clip, joint, frame).angle_to(&rotation(clip, joint, frame + 1)));
        angles.fold(0.0, f64::max)
    };
    let largest = (1..=COMPARED_STEPS).map(step).fold(0.0, f64::max);
    usize::from(step(0) > MIN_JUMP.max(JUMP_FACTOR * largest))
}
