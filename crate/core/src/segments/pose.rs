//! Poses as joint rotations, at instants that do not depend on the clip's rate.

use std::ops::Range;

use nalgebra::DMatrix;
use nalgebra::Quaternion;
use nalgebra::UnitQuaternion;
use nalgebra::Vector3;

use crate::bvh::{Channel, Clip};
use crate::numeric::interpolate;
use crate::segments::body::Body;
use crate::segments::grid::Grid;
use crate::skeleton::Skeleton;

/// Steps after the first with which it is compared.
const STEPS: usize = 10;
/// A first step this many times larger than any of those leads out of a pose that was stuck on ...
const JUMP: f64 = 5.0;
/// ... if a joint turns by at least this much in it, in radians.
const LEAST_JUMP: f64 = 0.2;

/// Poses per second that fall on frames at 24, 30, 60 and 120 Hz alike.
///
/// Methods that start anew at each cut carry the least difference between poses on to all that follows;
/// so they take poses that were recorded rather than ones between them.
pub(crate) const RECORDED_RATE: f64 = 6.0;

/// Poses at a fixed rate: one column for each instant, four rows for each joint.
///
/// Rotations are local and the root's are left out, so that neither place nor heading counts.
#[derive(Debug)]
pub(crate) struct Poses {
    /// Quaternions of all joints, w first; each joint's are continuous and have w ≥ 0 on average.
    pub columns: DMatrix<f64>,
    grid: Grid,
}

impl Poses {
    /// Poses of some frames, `rate` times per second.
    pub fn of(clip: &Clip, body: &Body, frames: &Range<usize>, rate: f64) -> Poses {
        let grid = Grid::over(clip, frames, rate);
        let mut columns = DMatrix::zeros(4 * body.joints.len(), grid.count());
        for (place, &joint) in body.joints.iter().enumerate() {
            let mut last = Quaternion::identity();
            let mut sum = 0.0;
            for sample in 0..grid.count() {
                let turn = towards(last, between(clip, joint, &grid, sample));
                last = turn;
                sum += turn.w;
                for (row, value) in [turn.w, turn.i, turn.j, turn.k].into_iter().enumerate() {
                    columns[(4 * place + row, sample)] = value;
                }
            }
            if sum < 0.0 {
                columns.rows_mut(4 * place, 4).neg_mut();
            }
        }
        Poses { columns, grid }
    }

    /// How many poses there are.
    pub fn count(&self) -> usize {
        self.columns.ncols()
    }

    /// The frame of the clip at a place among the columns.
    pub fn frame(&self, column: usize) -> usize {
        self.grid.frame(column)
    }

    /// The same with its fraction.
    pub fn place(&self, column: usize) -> f64 {
        self.grid.place(column)
    }
}

/// A joint's rotation at a sample, between those of the frames about it.
fn between(clip: &Clip, joint: usize, grid: &Grid, sample: usize) -> Quaternion<f64> {
    let (frames, t) = grid.about(sample);
    let at = |frame: usize| rotation(clip, joint, frame).into_inner();
    if t < 1e-6 {
        return at(frames[1]);
    }
    let near = at(frames[1]);
    let turns = frames.map(|frame| towards(near, at(frame)));
    let turn = interpolate::cubic(turns, t);
    // Opposite turns in neighbouring frames leave nothing between them.
    if turn.norm() > 1e-6 { turn.normalize() } else { near }
}

/// The one of a rotation's two quaternions that is nearer to another.
fn towards(other: Quaternion<f64>, turn: Quaternion<f64>) -> Quaternion<f64> {
    if turn.dot(&other) < 0.0 { -turn } else { turn }
}

/// A joint's rotation in its parent.
pub(crate) fn rotation(clip: &Clip, joint: usize, frame: usize) -> UnitQuaternion<f64> {
    let values = &clip.row(frame)[clip.channel_range(joint)];
    let mut rotation = UnitQuaternion::identity();
    for (channel, value) in clip.joints()[joint].channels.iter().zip(values) {
        if let Channel::Rotation(axis) = channel {
            let mut turn = Vector3::zeros();
            turn[axis.index()] = value.to_radians();
            rotation *= UnitQuaternion::from_scaled_axis(turn);
        }
    }
    rotation
}

/// The first frame that is motion: 1 where frame 0 is a pose that was stuck on, otherwise 0.
pub(crate) fn lead_in(clip: &Clip, skeleton: &Skeleton) -> usize {
    let Ok(body) = Body::turning(clip, skeleton) else { return 0 };
    if clip.frame_count() < STEPS + 2 {
        return 0;
    }
    let step = |frame: usize| {
        let turns = body
            .joints
            .iter()
            .map(|&joint| rotation(clip, joint, frame).angle_to(&rotation(clip, joint, frame + 1)));
        turns.fold(0.0, f64::max)
    };
    let largest = (1..=STEPS).map(step).fold(0.0, f64::max);
    usize::from(step(0) > LEAST_JUMP.max(JUMP * largest))
}
