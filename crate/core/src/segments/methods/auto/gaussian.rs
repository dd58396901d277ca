//! Cost of describing a range of poses by one Gaussian.

use nalgebra::DMatrix;

use crate::numeric::sort;
use crate::segments::pose;

/// Number of principal components.
pub(crate) const DIMS: usize = 6;
/// Added to each variance, where the clip has a total variance of 1: the noise of a held pose.
const ADDED_VARIANCE: f64 = 0.01;

type Point = [f64; DIMS];
/// Symmetric matrix by rows.
type Products = [[f64; DIMS]; DIMS];

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
        let centred = pose::centred(poses.as_view());
        let eigen = (&centred * centred.transpose() / count as f64).symmetric_eigen();
        let mut order = sort::argsort_descending(eigen.eigenvalues.as_slice());
        order.truncate(DIMS);
        let total: f64 = order.iter().map(|&index| eigen.eigenvalues[index].max(0.0)).sum();
        let scale = if total > 1e-12 { total.sqrt().recip() } else { 0.0 };
        let axes: Vec<_> = order.iter().map(|&index| eigen.eigenvectors.column(index) * scale).collect();
        let mut sums = Vec::with_capacity(count + 1);
        let (mut sum, mut products) = (Point::default(), Products::default());
        sums.push((sum, products));
        for pose in centred.column_iter() {
            let mut point = Point::default();
            for (value, axis) in point.iter_mut().zip(&axes) {
                *value = axis.dot(&pose);
            }
            for row in 0..DIMS {
                sum[row] += point[row];
                for column in 0..DIMS {
                    products[row][column] += point[row] * point[column];
                }
            }
            sums.push((sum, products));
        }
        Gaussians { sums }
    }

    /// Returns the negative log-likelihood of the poses `start..end` under their Gaussian, up to
    /// terms that are equal for all segmentations: half the number of poses times the
    /// log-determinant of the covariance.
    pub fn cost(&self, start: usize, end: usize) -> f64 {
        let count = (end - start) as f64;
        let share = count.recip();
        let ((sum_before, products_before), (sum, products)) = (&self.sums[start], &self.sums[end]);
        let mut mean = Point::default();
        for row in 0..DIMS {
            mean[row] = (sum[row] - sum_before[row]) * share;
        }
        let mut covariance = Products::default();
        for row in 0..DIMS {
            for column in 0..DIMS {
                let product = (products[row][column] - products_before[row][column]) * share;
                covariance[row][column] = product - mean[row] * mean[column];
            }
            // The added variance makes the matrix positive definite despite rounding.
            covariance[row][row] += ADDED_VARIANCE;
        }
        0.5 * count * determinant(covariance).ln()
    }
}

/// Returns the determinant of a positive definite matrix, by Gaussian elimination. For so few rows, the
/// factorisations of nalgebra take several times as long.
fn determinant(mut matrix: Products) -> f64 {
    let mut determinant = 1.0;
    for pivot in 0..DIMS {
        let above = matrix[pivot];
        determinant *= above[pivot];
        for row in &mut matrix[pivot + 1..] {
            let factor = row[pivot] / above[pivot];
            for column in 0..DIMS {
                row[column] -= factor * above[column];
            }
        }
    }
    determinant
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
