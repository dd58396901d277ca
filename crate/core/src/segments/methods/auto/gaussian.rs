//! Cost of describing a range of poses by one Gaussian.

use nalgebra::{DMatrix, SMatrix, SVector};

use crate::numeric::sort;

/// Number of principal components.
pub(crate) const DIMS: usize = 6;
/// Added to each variance, where the clip has a total variance of 1: the noise of a held pose.
const ADDED_VARIANCE: f64 = 0.01;

type Point = SVector<f64, DIMS>;
type Products = SMatrix<f64, DIMS, DIMS>;

/// Running sums of the reduced poses, from which the Gaussian of any range follows in constant
/// time.
pub(crate) struct Gaussians {
    /// Sums of points and of their outer products, before each pose and after the last.
    sums: Vec<(Point, Products)>,
}

impl Gaussians {
    /// Reduces poses, one per column, to their principal components with a total variance of 1.
    pub fn new(poses: &DMatrix<f64>) -> Gaussians {
        let count = poses.ncols();
        let centred = DMatrix::from_columns(&{
            let mean = poses.column_mean();
            poses.column_iter().map(|pose| pose - &mean).collect::<Vec<_>>()
        });
        let eigen = (&centred * centred.transpose() / count as f64).symmetric_eigen();
        let mut order = sort::argsort_descending(eigen.eigenvalues.as_slice());
        order.truncate(DIMS);
        let total: f64 = order.iter().map(|&index| eigen.eigenvalues[index].max(0.0)).sum();
        let scale = if total > 1e-12 { total.sqrt().recip() } else { 0.0 };
        let axes: Vec<_> = order.iter().map(|&index| eigen.eigenvectors.column(index) * scale).collect();
        let mut sums = Vec::with_capacity(count + 1);
        sums.push((Point::zeros(), Products::zeros()));
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

    /// Returns the negative log-likelihood of the poses `start..end` under their Gaussian, up to
    /// terms that are equal for all segmentations: half the number of poses times the
    /// log-determinant of the covariance.
    pub fn cost(&self, start: usize, end: usize) -> f64 {
        let count = (end - start) as f64;
        let mean = (self.sums[end].0 - self.sums[start].0) / count;
        let products = (self.sums[end].1 - self.sums[start].1) / count;
        let mut covariance = products - mean * mean.transpose();
        for dim in 0..DIMS {
            covariance[(dim, dim)] += ADDED_VARIANCE;
        }
        // The added variance makes the matrix positive definite despite rounding.
        let factor = covariance.cholesky().expect("a covariance with added variance is positive definite");
        count * factor.l_dirty().diagonal().product().ln()
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn cost_follows_from_the_covariance() {
        // Two poses in one dimension at a distance of 2: variance 1 before and after scaling.
        let gaussians = Gaussians::new(&DMatrix::from_row_slice(2, 2, &[5.0, 7.0, 3.0, 3.0]));
        let expected = 2.0 * 0.5 * (1.01_f64.ln() + 5.0 * 0.01_f64.ln());
        assert!((gaussians.cost(0, 2) - expected).abs() < 1e-9);
    }

    #[test]
    fn constant_poses_have_the_added_variance() {
        let gaussians = Gaussians::new(&DMatrix::from_element(8, 20, 0.5));
        assert!((gaussians.cost(3, 13) - 10.0 * 3.0 * 0.01_f64.ln()).abs() < 1e-9);
    }

    proptest! {
        /// The pruning relies on this property.
        #[test]
        fn a_cut_never_increases_the_cost(values in prop::collection::vec(-1.0..1.0_f64, 80), at in 1_usize..19) {
            let gaussians = Gaussians::new(&DMatrix::from_vec(4, 20, values));
            prop_assert!(gaussians.cost(0, at) + gaussians.cost(at, 20) <= gaussians.cost(0, 20) + 1e-9);
        }
    }
}
