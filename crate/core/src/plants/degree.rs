//! Degrees: how much like all other samples each sample is.
//!
//! The paper takes the eigenvector of the largest eigenvalue of D^-½ A D^-½.
//! A has no negative entry, so by Perron and Frobenius that eigenvector is √d,
//! the square roots of the degrees, with eigenvalue 1: no eigensolver is
//! needed. Where the graph falls apart numerically, √d is still the answer
//! while a solver returns any mixture.

use super::samples::Samples;

/// How likeness falls off with distance x in units of σ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kernel {
    /// exp(−x²): the paper's (section 2.2).
    Gaussian,
    /// 1 / (1 + x²): its long tail finds the edges of contact sooner.
    Cauchy,
}

impl Kernel {
    fn of_square(self, square: f64) -> f64 {
        match self {
            Kernel::Gaussian => (-square).exp(),
            Kernel::Cauchy => 1.0 / (1.0 + square),
        }
    }
}

/// Σ over j ≠ i of `weights[j]` × likeness of samples i and j, for each i; weights of 1 where none are given.
pub(super) fn degrees(samples: &Samples, sigma: f64, kernel: Kernel, weights: Option<&[f64]>) -> Vec<f64> {
    let count = samples.len();
    let per_square = 1.0 / (sigma * sigma);
    let mut degrees = vec![0.0; count];
    for i in 0..count {
        let point = samples.point(i);
        let mut degree = 0.0;
        for j in i + 1..count {
            let square: f64 = point.iter().zip(samples.point(j)).map(|(a, b)| (a - b) * (a - b)).sum();
            let likeness = kernel.of_square(square * per_square);
            degree += weights.map_or(1.0, |weights| weights[j]) * likeness;
            degrees[j] += weights.map_or(1.0, |weights| weights[i]) * likeness;
        }
        degrees[i] += degree;
    }
    degrees
}

#[cfg(test)]
mod tests {
    use nalgebra::{DMatrix, DVector, SymmetricEigen};
    use proptest::prelude::*;

    use super::*;

    fn samples(points: Vec<f64>, dimension: usize) -> Samples {
        let norms =
            points.chunks_exact(dimension).map(|point| point.iter().map(|x| x * x).sum::<f64>().sqrt());
        Samples { norms: norms.collect(), dimension, points }
    }

    /// Ω^½ D^-½ A D^-½ Ω^½ with D the weighted degrees, and its eigenvectors by a dense solver.
    fn dense(
        samples: &Samples,
        sigma: f64,
        kernel: Kernel,
        weights: &[f64],
    ) -> SymmetricEigen<f64, nalgebra::Dyn> {
        let count = samples.len();
        let affinity = DMatrix::from_fn(count, count, |i, j| {
            let between = samples.point(i).iter().zip(samples.point(j));
            let square: f64 = between.map(|(a, b)| (a - b).powi(2)).sum();
            if i == j { 0.0 } else { kernel.of_square(square / (sigma * sigma)) }
        });
        let degree = &affinity * DVector::from_column_slice(weights);
        let side = DMatrix::from_diagonal(&DVector::from_fn(count, |i, _| (weights[i] / degree[i]).sqrt()));
        SymmetricEigen::new(&side * affinity * &side)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        /// The closed form against a dense eigensolver, wherever the graph is
        /// connected well enough for the solver's answer to be unique.
        #[test]
        fn the_leading_eigenvector_is_the_root_of_the_degrees(
            points in prop::collection::vec(0.0..1.0_f64, 2 * 6..2 * 40),
            sigma in 0.05..0.5_f64,
            anchored in any::<bool>(),
        ) {
            let samples = samples(points[..points.len() / 2 * 2].to_vec(), 2);
            let weights: Vec<f64> =
                samples.norms.iter().map(|norm| if anchored { (-norm * norm).exp() } else { 1.0 }).collect();
            for kernel in [Kernel::Gaussian, Kernel::Cauchy] {
                let eigen = dense(&samples, sigma, kernel, &weights);
                let mut order: Vec<usize> = (0..samples.len()).collect();
                order.sort_by(|&a, &b| eigen.eigenvalues[b].total_cmp(&eigen.eigenvalues[a]));
                if 1.0 - eigen.eigenvalues[order[1]] <= 1e-8 {
                    continue;
                }
                prop_assert!((eigen.eigenvalues[order[0]] - 1.0).abs() < 1e-10);
                let found = degrees(&samples, sigma, kernel, Some(&weights));
                let ours = DVector::from_iterator(
                    samples.len(),
                    found.iter().zip(&weights).map(|(degree, weight)| (degree * weight).sqrt()),
                ).normalize();
                let theirs = eigen.eigenvectors.column(order[0]).map(f64::abs);
                prop_assert!((ours - theirs).amax() < 1e-6);
            }
        }
    }

    #[test]
    fn a_sample_is_not_its_own_neighbour() {
        let alone = samples(vec![0.0, 0.0, 9e9, 0.0], 2);
        assert_eq!(degrees(&alone, 1.0, Kernel::Gaussian, None), [0.0, 0.0]);
        let twins = samples(vec![0.5, 0.0, 0.5, 0.0], 2);
        assert_eq!(degrees(&twins, 1.0, Kernel::Cauchy, Some(&[2.0, 3.0])), [3.0, 2.0]);
    }
}
