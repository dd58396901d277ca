//! A window that grows from one cut to the next: the scatter of its poses, and the rule that cuts
//! where a residual jumps.

use std::ops::Range;

use nalgebra::{DMatrix, DVector};

use crate::segments::pose::{self, Poses};
use crate::segments::progress::{Cancelled, Checkpoint, Progress};
use crate::segments::{Curve, Residual};

/// Relative rounding error of the difference of two sums.
const ROUNDING_ERROR: f64 = 1e-12;

/// Poses of a window, and the sums from which their scatter is computed.
pub(crate) struct Window<'a> {
    poses: &'a DMatrix<f64>,
    range: Range<usize>,
    sum: DVector<f64>,
    products: DMatrix<f64>,
}

impl<'a> Window<'a> {
    /// Creates a window without poses, which grows from column `start` of `poses`.
    pub fn new(poses: &'a DMatrix<f64>, start: usize) -> Window<'a> {
        let dims = poses.nrows();
        let (sum, products) = (DVector::zeros(dims), DMatrix::zeros(dims, dims));
        Window { poses, range: start..start, sum, products }
    }

    /// Returns the range of its columns.
    pub fn range(&self) -> Range<usize> {
        self.range.clone()
    }

    /// Adds the poses before column `end`.
    pub fn grow_to(&mut self, end: usize) {
        for pose in self.range.end..end {
            let pose = self.poses.column(pose);
            self.sum += pose;
            self.products.syger(1.0, &pose, &pose, 1.0);
        }
        self.range.end = end;
    }

    /// Returns the mean pose.
    pub fn mean(&self) -> DVector<f64> {
        &self.sum / self.range.len() as f64
    }

    /// Returns the eigenvalues of the scatter matrix, the sum of outer products of the differences
    /// from the mean, without those that are 0 because the window has fewer poses than dimensions.
    /// Eigenvalues of the size of rounding errors are 0, so that constant poses have no variation.
    pub fn eigenvalues(&self) -> DVector<f64> {
        let min = ROUNDING_ERROR * self.products.trace();
        self.smaller_matrix().symmetric_eigenvalues().map(|value| if value < min { 0.0 } else { value })
    }

    /// Returns the eigenvalues and eigenvectors of the scatter matrix, in any order and as many as
    /// [`Window::eigenvalues`]. An eigenvector whose eigenvalue is 0 or a rounding error is any vector.
    pub fn eigen(&self) -> (DVector<f64>, DMatrix<f64>) {
        let mut eigen = self.smaller_matrix().symmetric_eigen();
        if self.has_few_poses() {
            eigen.eigenvectors = &self.centred() * eigen.eigenvectors;
            for mut vector in eigen.eigenvectors.column_iter_mut() {
                vector /= vector.norm().max(f64::MIN_POSITIVE);
            }
        }
        (eigen.eigenvalues, eigen.eigenvectors)
    }

    /// Returns the scatter matrix, or the inner products of the centred poses if there are fewer poses
    /// than dimensions: that matrix is smaller and has the same eigenvalues but for zeros. Lower
    /// triangle only.
    fn smaller_matrix(&self) -> DMatrix<f64> {
        if self.has_few_poses() {
            let centred = self.centred();
            return &centred.transpose() * centred;
        }
        let mut scatter = self.products.clone();
        scatter.syger(-1.0 / self.range.len() as f64, &self.sum, &self.sum, 1.0);
        scatter
    }

    fn has_few_poses(&self) -> bool {
        self.range.len() < self.sum.len()
    }

    /// Returns the differences of the poses from their mean.
    fn centred(&self) -> DMatrix<f64> {
        pose::centred(self.poses.columns_range(self.range()))
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

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn few_and_many_poses_have_the_eigenvalues_of_the_scatter_matrix(
            values in prop::collection::vec(-1.0..1.0_f64, 6 * 12),
            start in 0..3_usize,
            count in 1..9_usize,
        ) {
            let poses = DMatrix::from_vec(6, 12, values);
            let mut window = Window::new(&poses, start);
            window.grow_to(start + count.div_ceil(2));
            window.grow_to(start + count);
            let mut centred = poses.columns(start, count).into_owned();
            let mean = centred.column_mean();
            prop_assert!((window.mean() - &mean).amax() < 1e-12);
            centred.column_iter_mut().for_each(|mut pose| pose -= &mean);
            let scatter = &centred * centred.transpose();
            let sorted = |values: &DVector<f64>| {
                let mut values = values.as_slice().to_vec();
                values.resize(6, 0.0);
                values.sort_unstable_by(f64::total_cmp);
                values
            };
            let expected = sorted(&scatter.symmetric_eigenvalues());
            let (eigenvalues, eigenvectors) = window.eigen();
            for values in [window.eigenvalues(), eigenvalues.clone()] {
                for (value, expected) in sorted(&values).iter().zip(&expected) {
                    prop_assert!((value - expected).abs() < 1e-9);
                }
            }
            let pairs = eigenvalues.iter().zip(eigenvectors.column_iter());
            for (value, vector) in pairs.filter(|(value, _)| **value > 1e-6) {
                prop_assert!((&scatter * vector - vector * *value).amax() < 1e-9);
                prop_assert!((vector.norm() - 1.0).abs() < 1e-9);
            }
        }
    }
}
