//! A window that grows from one cut to the next: the sums for its covariance, and the rule that
//! cuts where a residual jumps.

use std::ops::Range;

use nalgebra::{DMatrix, DVector, DVectorView};

use crate::segments::pose::Poses;
use crate::segments::progress::{Cancelled, Checkpoint, Progress};
use crate::segments::{Curve, Residual};

/// Relative rounding error of the difference of two sums.
const ROUNDING_ERROR: f64 = 1e-12;

/// Sums over the poses of a window, from which mean and scatter are computed.
pub(crate) struct Moments {
    count: usize,
    sum: DVector<f64>,
    products: DMatrix<f64>,
}

impl Moments {
    /// Creates sums over no poses.
    pub fn new(dims: usize) -> Moments {
        Moments { count: 0, sum: DVector::zeros(dims), products: DMatrix::zeros(dims, dims) }
    }

    /// Adds a pose.
    pub fn add(&mut self, pose: DVectorView<f64>) {
        self.count += 1;
        self.sum += pose;
        self.products.syger(1.0, &pose, &pose, 1.0);
    }

    /// Returns the mean pose.
    pub fn mean(&self) -> DVector<f64> {
        &self.sum / self.count as f64
    }

    /// Returns the scatter matrix: the sum of outer products of the differences from the mean;
    /// lower triangle only.
    pub fn scatter(&self) -> DMatrix<f64> {
        let mut scatter = self.products.clone();
        scatter.syger(-1.0 / self.count as f64, &self.sum, &self.sum, 1.0);
        scatter
    }

    /// Returns the eigenvalues of the scatter matrix. Eigenvalues of the size of rounding errors
    /// are 0, so that constant poses have no variation.
    pub fn eigenvalues(&self) -> DVector<f64> {
        let min = ROUNDING_ERROR * self.products.trace();
        self.scatter().symmetric_eigenvalues().map(|value| if value < min { 0.0 } else { value })
    }
}

/// Returns the residual: the eigenvalues beyond the `dims` largest, in the given definition.
pub(crate) fn residual(eigenvalues: &[f64], dims: usize, kind: Residual) -> f64 {
    let mut sorted: Vec<f64> = eigenvalues.iter().map(|value| value.max(0.0)).collect();
    sorted.sort_unstable_by(f64::total_cmp);
    sorted.reverse();
    let rest: f64 = sorted.iter().skip(dims).sum();
    match kind {
        Residual::Absolute => rest,
        Residual::Ratio => {
            let total: f64 = sorted.iter().sum();
            if total > 0.0 { rest / total } else { 0.0 }
        }
    }
}

/// Rule that detects jumps of a residual. Lengths are in poses; windows grow by `step`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct JumpDetector {
    /// Length of the first window after a cut.
    pub first: usize,
    /// Growth of the window.
    pub step: usize,
    /// Number of windows between the compared residuals.
    pub lag: usize,
    /// Threshold, as a multiple of the mean of the differences so far.
    pub factor: f64,
    /// Number of differences before the first possible jump.
    pub min_differences: usize,
    /// Number of poses between the cut and the end of the window that detects it.
    pub lead: usize,
    /// Maximum length; a longer window slides.
    pub max_length: usize,
}

/// Residuals of the windows, and the cuts. Windows are identified by their end.
#[derive(Debug, Default)]
pub(crate) struct Trace {
    pub cuts: Vec<usize>,
    pub ends: Vec<usize>,
    pub residuals: Vec<f64>,
    /// Threshold of each residual.
    pub thresholds: Vec<f64>,
}

impl JumpDetector {
    /// Evaluates `residual` for windows over `count` poses and detects jumps.
    pub fn trace(
        &self,
        count: usize,
        mut residual: impl FnMut(Range<usize>, &mut Checkpoint) -> Result<f64, Cancelled>,
        progress: &mut Progress,
    ) -> Result<Trace, Cancelled> {
        let mut trace = Trace::default();
        let mut start = 0;
        while start + self.first <= count {
            let mut values: Vec<f64> = Vec::new();
            let mut differences: Vec<f64> = Vec::new();
            let mut next = count;
            for end in (start + self.first..=count).step_by(self.step) {
                let mut checkpoint = || progress(end as f64 / count as f64);
                checkpoint()?;
                let value = residual(end.saturating_sub(self.max_length).max(start)..end, &mut checkpoint)?;
                let before = values.len().checked_sub(self.lag).map(|index| values[index]);
                let mean_difference = differences.iter().sum::<f64>() / differences.len().max(1) as f64;
                values.push(value);
                let is_ready = differences.len() >= self.min_differences;
                let threshold =
                    before.filter(|_| is_ready).map(|before| before + self.factor * mean_difference);
                trace.ends.push(end);
                trace.residuals.push(value);
                trace.thresholds.push(threshold.unwrap_or(value));
                if threshold.is_some_and(|threshold| value > threshold) {
                    next = end - self.lead;
                    trace.cuts.push(next);
                    break;
                }
                differences.extend(before.map(|before| (value - before).abs()));
            }
            start = next;
        }
        Ok(trace)
    }
}

impl Trace {
    /// Returns the residuals as a curve; each value is at the end of its window.
    pub fn curve(self, title: &'static str, poses: &Poses) -> Curve {
        Curve {
            title,
            frames: self.ends.iter().map(|&end| poses.position(end - 1)).collect(),
            values: self.residuals,
            threshold: self.thresholds,
            extrema: Vec::new(),
        }
    }
}
