//! How badly one Gaussian describes a run of poses.

use nalgebra::DMatrix;
use nalgebra::SMatrix;
use nalgebra::SVector;

use crate::numeric::sort;

/// Dimensions that are kept of the poses.
pub(crate) const DIMS: usize = 6;
/// Added to every variance, of a total of 1 for the clip: what recording makes of a pose that is held.
const FLOOR: f64 = 0.01;

type Point = SVector<f64, DIMS>;
type Spread = SMatrix<f64, DIMS, DIMS>;

/// Running sums of the reduced poses, from which any run's Gaussian is had at once.
pub(crate) struct Gaussians {
    /// Sums of points and of their products, before each pose and after the last.
    sums: Vec<(Point, Spread)>,
}

impl Gaussians {
    /// Reduces poses, one per column, to their principal components, with a total variance of 1.
    pub fn of(poses: &DMatrix<f64>) -> Gaussians {
        let count = poses.ncols();
        let centred = DMatrix::from_columns(&{
            let mean = poses.column_mean();
            poses.column_iter().map(|pose| pose - &mean).collect::<Vec<_>>()
        });
        let eigen = (&centred * centred.transpose() / count as f64).symmetric_eigen();
        let mut order = sort::descending(eigen.eigenvalues.as_slice());
        order.truncate(DIMS);
        let total: f64 = order.iter().map(|&index| eigen.eigenvalues[index].max(0.0)).sum();
        let scale = if total > 1e-12 { total.sqrt().recip() } else { 0.0 };
        let axes: Vec<_> = order.iter().map(|&index| eigen.eigenvectors.column(index) * scale).collect();
        let mut sums = Vec::with_capacity(count + 1);
        sums.push((Point::zeros(), Spread::zeros()));
        for (index, pose) in centred.column_iter().enumerate() {
            let mut point = Point::zeros();
            for (value, axis) in point.iter_mut().zip(&axes) {
                *value = axis.dot(&pose);
            }
            let (sum, products) = &sums[index];
            sums.push((sum + point, products + point * point.transpose()));
        }
        Gaussians { sums }
    }

    /// Negative log likelihood of the poses `start..end` under their own Gaussian, but for
    /// what is the same for all ways of cutting: half the number of poses times the
    /// logarithm of the covariance's determinant.
    pub fn cost(&self, start: usize, end: usize) -> f64 {
        let count = (end - start) as f64;
        let mean = (self.sums[end].0 - self.sums[start].0) / count;
        let products = (self.sums[end].1 - self.sums[start].1) / count;
        let mut covariance = products - mean * mean.transpose();
        for dim in 0..DIMS {
            covariance[(dim, dim)] += FLOOR;
        }
        // The floor keeps it positive definite whatever the rounding.
        let factor = covariance.cholesky().expect("a covariance with a floor is positive definite");
        let log_root: f64 = factor.l_dirty().diagonal().iter().map(|value| value.ln()).sum();
        count * log_root
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn the_cost_is_that_of_the_covariance() {
        // Two poses in one dimension, 2 apart: a variance of 1 before scaling, and after.
        let gaussians = Gaussians::of(&DMatrix::from_row_slice(2, 2, &[5.0, 7.0, 3.0, 3.0]));
        let expected = 2.0 * 0.5 * (1.01_f64.ln() + 5.0 * 0.01_f64.ln());
        assert!((gaussians.cost(0, 2) - expected).abs() < 1e-9);
    }

    #[test]
    fn poses_that_never_change_cost_the_floor() {
        let gaussians = Gaussians::of(&DMatrix::from_element(8, 20, 0.5));
        assert!((gaussians.cost(3, 13) - 10.0 * 3.0 * 0.01_f64.ln()).abs() < 1e-9);
    }

    proptest! {
        /// The pruning rests on this.
        #[test]
        fn a_cut_never_adds_to_the_cost(values in prop::collection::vec(-1.0..1.0_f64, 80), at in 1_usize..19) {
            let gaussians = Gaussians::of(&DMatrix::from_vec(4, 20, values));
            prop_assert!(gaussians.cost(0, at) + gaussians.cost(at, 20) <= gaussians.cost(0, 20) + 1e-9);
        }
    }
}
