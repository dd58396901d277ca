//! A window that grows from one cut until the next: the sums that its covariance is made of,
//! and the rule that cuts where a residual jumps.

use std::ops::Range;

use nalgebra::DMatrix;
use nalgebra::DVector;
use nalgebra::DVectorView;

use crate::segments::pose::Poses;
use crate::segments::task::{Cancelled, Pause, Progress};
use crate::segments::{Curve, Residual};

/// Share of the poses' squares that the difference of two sums may be off by.
const ROUNDING: f64 = 1e-12;

/// Sums over the poses of a window, from which its mean and scatter are had at any time.
pub(crate) struct Moments {
    count: usize,
    sum: DVector<f64>,
    products: DMatrix<f64>,
}

impl Moments {
    /// Of no poses yet.
    pub fn new(dims: usize) -> Moments {
        Moments { count: 0, sum: DVector::zeros(dims), products: DMatrix::zeros(dims, dims) }
    }

    /// Takes one more pose in.
    pub fn add(&mut self, pose: DVectorView<f64>) {
        self.count += 1;
        self.sum += pose;
        self.products.syger(1.0, &pose, &pose, 1.0);
    }

    /// The mean pose.
    pub fn mean(&self) -> DVector<f64> {
        &self.sum / self.count as f64
    }

    /// Sum of the outer products of the poses' differences from their mean; the lower triangle only.
    pub fn scatter(&self) -> DMatrix<f64> {
        let mut scatter = self.products.clone();
        scatter.syger(-1.0 / self.count as f64, &self.sum, &self.sum, 1.0);
        scatter
    }

    /// The scatter's eigenvalues; ones that rounding alone may have made are 0, or poses that do not
    /// change would seem to.
    pub fn spread(&self) -> DVector<f64> {
        let least = ROUNDING * self.products.trace();
        self.scatter().symmetric_eigenvalues().map(|value| if value < least { 0.0 } else { value })
    }
}

/// What eigenvalues beyond the first `dims` amount to; order does not matter.
pub(crate) fn residual(eigenvalues: &[f64], dims: usize, kind: Residual) -> f64 {
    let mut sorted: Vec<f64> = eigenvalues.iter().map(|value| value.max(0.0)).collect();
    sorted.sort_unstable_by(f64::total_cmp);
    sorted.reverse();
    let rest: f64 = sorted.iter().skip(dims).sum();
    match kind {
        Residual::Absolute => rest,
        Residual::Ratio => {
            let whole: f64 = sorted.iter().sum();
            if whole > 0.0 { rest / whole } else { 0.0 }
        }
    }
}

/// When a residual is said to jump; lengths are in poses, and windows grow by [`Jumps::step`].
#[derive(Clone, Copy, Debug)]
pub(crate) struct Jumps {
    /// Length of the first window after a cut.
    pub first: usize,
    /// Poses by which it grows.
    pub step: usize,
    /// Windows from one residual to the one it is compared with.
    pub lag: usize,
    /// How many times the mean of the differences so far one has to be.
    pub factor: f64,
    /// Differences before the first that may be a jump.
    pub fewest: usize,
    /// Poses from the cut to the end of the window in which it shows.
    pub early: usize,
    /// Longest window: a longer one slides on.
    pub longest: usize,
}

/// The residual of each window by the pose that it ends before, with the places that it cuts at.
#[derive(Debug, Default)]
pub(crate) struct Traced {
    pub cuts: Vec<usize>,
    pub ends: Vec<usize>,
    pub residuals: Vec<f64>,
    /// The residual at which each window would have been cut.
    pub limits: Vec<f64>,
}

impl Jumps {
    /// Follows `residual` of windows over `count` poses; one that takes its time pauses now and then.
    pub fn trace(
        &self,
        count: usize,
        mut residual: impl FnMut(Range<usize>, &mut Pause) -> Result<f64, Cancelled>,
        progress: &mut Progress,
    ) -> Result<Traced, Cancelled> {
        let mut traced = Traced::default();
        let mut start = 0;
        while start + self.first <= count {
            let mut own: Vec<f64> = Vec::new();
            let mut sizes: Vec<f64> = Vec::new();
            let mut next = count;
            for end in (start + self.first..=count).step_by(self.step) {
                let mut pause = || progress(end as f64 / count as f64);
                pause()?;
                let value = residual(end.saturating_sub(self.longest).max(start)..end, &mut pause)?;
                let before = own.len().checked_sub(self.lag).map(|index| own[index]);
                let usual = sizes.iter().sum::<f64>() / sizes.len().max(1) as f64;
                own.push(value);
                let is_ready = sizes.len() >= self.fewest;
                let limit = before.filter(|_| is_ready).map(|before| before + self.factor * usual);
                traced.ends.push(end);
                traced.residuals.push(value);
                traced.limits.push(limit.unwrap_or(value));
                if limit.is_some_and(|limit| value > limit) {
                    next = end - self.early;
                    traced.cuts.push(next);
                    break;
                }
                sizes.extend(before.map(|before| (value - before).abs()));
            }
            start = next;
        }
        Ok(traced)
    }
}

impl Traced {
    /// The residuals for plotting: each lies where its window ends.
    pub fn curve(self, title: &'static str, poses: &Poses) -> Curve {
        Curve {
            title,
            frames: self.ends.iter().map(|&end| poses.place(end - 1)).collect(),
            values: self.residuals,
            threshold: self.limits,
            extrema: Vec::new(),
        }
    }
}
