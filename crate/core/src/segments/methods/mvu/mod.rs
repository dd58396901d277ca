//! Cuts where the residual of maximum variance unfolding jumps.
//!
//! After the segmentation by residual jumps of Zhang and Wang. The poses of a growing window are
//! unfolded: moved apart as far as the distances to their neighbours allow (Weinberger and Saul
//! 2006). A window of one action unfolds into few dimensions; when another action begins, the
//! variance beyond these dimensions jumps.

mod bands;
mod inverse_iteration;
mod neighbours;
mod unfold;

use std::mem::take;
use std::ops::Range;

use nalgebra::{DMatrix, DMatrixView};

use crate::segments::body::Body;
use crate::segments::methods::growing_window::JumpDetector;
use crate::segments::methods::method_info::{Input, MethodInfo, MethodOption, Output};
use crate::segments::pose::{Poses, RECORDED_RATE};
use crate::segments::progress::{Cancelled, Checkpoint};
use crate::segments::{Residual, SegmentError};

use unfold::InteriorPoint;

pub(crate) const METHOD: MethodInfo = MethodInfo {
    name: "mvu",
    title: "Maximum variance unfolding",
    description: "Unfolds the poses of a growing window and cuts where the variance beyond few dimensions jumps.",
    // With the published 10 dimensions the residual is almost zero.
    options: &[MethodOption::Dims(1), MethodOption::Residual, MethodOption::Published],
    refines_cuts: false,
    segment,
};

/// k: number of neighbours of a pose whose distances are preserved.
const NEIGHBOURS: usize = 6;
/// First window 2 s, differences over 2/3 s, cuts 1/3 s before detection, windows of at most 20 s.
const JUMP_DETECTOR: JumpDetector =
    JumpDetector { first: 12, step: 1, lag: 4, factor: 3.0, min_differences: 4, lead: 2, max_length: 120 };
/// As published: compared with the previous window and with the mean difference.
const PUBLISHED_DETECTOR: JumpDetector = JumpDetector { lag: 1, factor: 1.0, ..JUMP_DETECTOR };

fn segment(input: &mut Input) -> Result<Output, SegmentError> {
    let body = Body::rotation_joints(input.clip, input.skeleton)?;
    let poses = Poses::new(input.clip, &body, &input.frames, RECORDED_RATE);
    let (dims, kind) = (input.settings.dims, input.settings.residual);
    let mut previous = PreviousWindow::default();
    let window_residual = |window: Range<usize>, checkpoint: &mut Checkpoint| {
        previous.slide_to(window.start);
        residual(poses.columns.columns_range(window), dims, kind, &mut previous, checkpoint)
    };
    let detector = if input.settings.published { PUBLISHED_DETECTOR } else { JUMP_DETECTOR };
    let trace = detector.trace(poses.count(), window_residual, input.progress)?;
    let cuts: Vec<usize> = trace.cuts.iter().map(|&cut| poses.frame(cut)).collect();
    let curve = trace.curve("Residual of the unfolded poses", &poses);
    Ok(Output::from_cuts(input.clip.frame_count(), &cuts, curve, body.notices()))
}

/// State of the previous window, from which the next one starts.
#[derive(Default)]
struct PreviousWindow {
    first: usize,
    interior: InteriorPoint,
    eigenvalues: Vec<f64>,
}

impl PreviousWindow {
    /// Removes the poses before `first`.
    fn slide_to(&mut self, first: usize) {
        let removed = (first - self.first).min(self.interior.count());
        self.interior = take(&mut self.interior).without_first(removed);
        self.first = first;
    }
}

/// Returns the residual of the unfolded window beyond the first `dims` eigenvalues.
fn residual(
    poses: DMatrixView<f64>,
    dims: usize,
    kind: Residual,
    previous: &mut PreviousWindow,
    checkpoint: &mut Checkpoint,
) -> Result<f64, Cancelled> {
    let unfolded = unfold_window(poses, NEIGHBOURS, previous, checkpoint)?;
    let total = unfolded.trace();
    previous.eigenvalues = inverse_iteration::largest_eigenvalues(unfolded, dims, &previous.eigenvalues);
    let remaining = (total - previous.eigenvalues.iter().sum::<f64>()).max(0.0);
    Ok(match kind {
        Residual::Absolute => remaining,
        Residual::Ratio if total > 0.0 => remaining / total,
        Residual::Ratio => 0.0,
    })
}

/// Returns the inner products of the unfolded poses.
fn unfold_window(
    poses: DMatrixView<f64>,
    k: usize,
    previous: &mut PreviousWindow,
    checkpoint: &mut Checkpoint,
) -> Result<DMatrix<f64>, Cancelled> {
    let distances = neighbours::squared_distances(poses);
    if k + 1 >= poses.ncols() {
        // All distances are preserved, so nothing can move.
        return Ok(neighbours::centred_products(&distances));
    }
    let edges = neighbours::edges(&distances, k);
    let unfolded = unfold::unfold(poses.ncols(), &edges, &previous.interior, checkpoint)?;
    previous.interior = unfolded.interior;
    Ok(unfolded.products)
}

#[cfg(test)]
mod tests;
