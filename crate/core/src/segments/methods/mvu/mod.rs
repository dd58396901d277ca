//! Cuts where the residual of maximum variance unfolding jumps.
//!
//! After Zhang and Wang's segmentation by residual jumps. The poses of a growing window
//! are unfolded: pulled apart as far as the distances to their neighbours allow
//! (Weinberger and Saul 2006). A window of one action unfolds into few dimensions; when
//! another begins, what these leave over jumps.

mod bands;
mod inverse_iteration;
mod neighbours;
mod unfold;

use std::mem::take;
use std::ops::Range;

use nalgebra::DMatrix;
use nalgebra::DMatrixView;

use crate::segments::body::Body;
use crate::segments::methods::growing_window::Jumps;
use crate::segments::methods::{Entry, MethodOption};
use crate::segments::pose::{Poses, RECORDED_RATE};
use crate::segments::task::{Cancelled, Found, Pause, Task};
use crate::segments::{Residual, SegmentError};

use unfold::Inside;

pub(crate) const METHOD: Entry = Entry {
    name: "mvu",
    title: "Maximum variance unfolding",
    about: "Unfolds the poses of a growing window and cuts where what few dimensions leave over jumps.",
    // The published 10 dimensions leave hardly anything over.
    options: &[MethodOption::Dims(1), MethodOption::Residual, MethodOption::Published],
    segment,
};

/// k: neighbours of a pose whose distances are kept.
const NEIGHBOURS: usize = 6;
/// A first window of 2 s, differences over 2/3 s, cuts 1/3 s before they show, windows of at most 20 s.
const OWN: Jumps = Jumps { first: 12, step: 1, lag: 4, factor: 3.0, fewest: 4, early: 2, longest: 120 };
/// The rule as published: against the window before, and more than the mean.
const PUBLISHED: Jumps = Jumps { lag: 1, factor: 1.0, ..OWN };

fn segment(task: &mut Task) -> Result<Found, SegmentError> {
    let body = Body::turning(task.clip, task.skeleton)?;
    let poses = Poses::of(task.clip, &body, &task.frames, RECORDED_RATE);
    let (dims, kind) = (task.params.dims().unwrap_or_default(), task.params.residual());
    let mut last = Last::default();
    let of_window = |window: Range<usize>, pause: &mut Pause| {
        last.slide_to(window.start);
        residual(poses.columns.columns_range(window), dims, kind, &mut last, pause)
    };
    let rule = if task.params.published() { PUBLISHED } else { OWN };
    let traced = rule.trace(poses.count(), of_window, task.progress)?;
    let cuts: Vec<usize> = traced.cuts.iter().map(|&cut| poses.frame(cut)).collect();
    let curve = traced.curve("Residual of the unfolded poses", &poses);
    Ok(Found::of_cuts(task.clip.frame_count(), &cuts, curve, body.notices()))
}

/// What is left of the last window for the next, which is much the same.
#[derive(Default)]
struct Last {
    first: usize,
    inside: Inside,
    eigenvalues: Vec<f64>,
}

impl Last {
    /// Forgets the poses before `first`.
    fn slide_to(&mut self, first: usize) {
        let gone = (first - self.first).min(self.inside.count());
        self.inside = take(&mut self.inside).without_first(gone);
        self.first = first;
    }
}

/// What the first `dims` eigenvalues of the unfolded window leave over.
fn residual(
    poses: DMatrixView<f64>,
    dims: usize,
    kind: Residual,
    last: &mut Last,
    pause: &mut Pause,
) -> Result<f64, Cancelled> {
    let unfolded = unfolded(poses, NEIGHBOURS, last, pause)?;
    let whole = unfolded.trace();
    last.eigenvalues = inverse_iteration::largest(unfolded, dims, &last.eigenvalues);
    let rest = (whole - last.eigenvalues.iter().sum::<f64>()).max(0.0);
    Ok(match kind {
        Residual::Absolute => rest,
        Residual::Ratio if whole > 0.0 => rest / whole,
        Residual::Ratio => 0.0,
    })
}

/// The inner products of the unfolded poses.
fn unfolded(
    poses: DMatrixView<f64>,
    k: usize,
    last: &mut Last,
    pause: &mut Pause,
) -> Result<DMatrix<f64>, Cancelled> {
    let distances = neighbours::squared_distances(poses);
    if k + 1 >= poses.ncols() {
        // All distances are kept: nothing can move.
        return Ok(neighbours::centred_products(&distances));
    }
    let edges = neighbours::edges(&distances, k);
    let unfolded = unfold::unfold(poses.ncols(), &edges, &last.inside, pause)?;
    last.inside = unfolded.inside;
    Ok(unfolded.products)
}

#[cfg(test)]
mod tests;
