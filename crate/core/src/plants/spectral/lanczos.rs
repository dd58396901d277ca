//! Leading eigenvector of a symmetric matrix given by its products.

use nalgebra::{DMatrix, SymmetricEigen};

/// Maximum number of steps.
const MAX_STEPS: usize = 80;
/// Relative change of the eigenvalue at convergence.
const TOLERANCE: f64 = 1e-9;

/// Returns the eigenvector of the largest eigenvalue that is orthogonal to `known`, a unit
/// vector.
///
/// Lanczos iteration with full reorthogonalisation. The start vector is fixed, so the result is
/// deterministic; its sign is arbitrary.
pub(crate) fn leading_eigenvector(multiply: impl Fn(&[f64]) -> Vec<f64>, known: &[f64]) -> Vec<f64> {
    let count = known.len();
    // A start vector that is orthogonal to no eigenvector.
    let start: Vec<f64> = (0..count).map(|i| ((i as f64 + 1.0) * 0.618_033_988_75).fract() - 0.5).collect();
    let mut basis: Vec<Vec<f64>> = vec![known.to_vec()];
    let (mut diagonal, mut off_diagonal) = (Vec::new(), Vec::new());
    let mut next = start;
    let mut best = (f64::NEG_INFINITY, Vec::new());
    for _ in 0..MAX_STEPS.min(count.saturating_sub(1)) {
        // Two passes suffice for orthogonality.
        for _ in 0..2 {
            for vector in &basis {
                let along = dot(&next, vector);
                next.iter_mut().zip(vector).for_each(|(x, v)| *x -= along * v);
            }
        }
        let length = dot(&next, &next).sqrt();
        if length < 1e-10 {
            break;
        }
        next.iter_mut().for_each(|x| *x /= length);
        if !diagonal.is_empty() {
            off_diagonal.push(length);
        }
        let product = multiply(&next);
        diagonal.push(dot(&product, &next));
        basis.push(std::mem::replace(&mut next, product));

        let size = diagonal.len();
        let eigen = SymmetricEigen::new(DMatrix::from_fn(size, size, |i, j| match i.abs_diff(j) {
            0 => diagonal[i],
            1 => off_diagonal[i.min(j)],
            _ => 0.0,
        }));
        let (largest, value) = eigen.eigenvalues.argmax();
        let has_converged = (value - best.0).abs() <= TOLERANCE * value.abs();
        best = (value, eigen.eigenvectors.column(largest).iter().copied().collect());
        if has_converged && size > 5 {
            break;
        }
    }
    let mut vector = vec![0.0; count];
    for (coefficient, member) in best.1.iter().zip(&basis[1..]) {
        vector.iter_mut().zip(member).for_each(|(x, v)| *x += coefficient * v);
    }
    vector
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use nalgebra::DVector;
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn agrees_with_a_dense_solver(values in prop::collection::vec(-1.0..1.0_f64, 36..37)) {
            let half = DMatrix::from_vec(6, 6, values);
            let matrix = &half * half.transpose();
            let eigen = SymmetricEigen::new(matrix.clone());
            let mut order: Vec<usize> = (0..6).collect();
            order.sort_by(|&a, &b| eigen.eigenvalues[b].total_cmp(&eigen.eigenvalues[a]));
            let value = |index: usize| eigen.eigenvalues[order[index]];
            prop_assume!(value(1) - value(2) > 1e-3 && value(0) - value(1) > 1e-3);
            let first: Vec<f64> = eigen.eigenvectors.column(order[0]).iter().copied().collect();
            let found = leading_eigenvector(|x| (&matrix * DVector::from_column_slice(x)).iter().copied().collect(), &first);
            let second: Vec<f64> = eigen.eigenvectors.column(order[1]).iter().copied().collect();
            prop_assert!((dot(&found, &second).abs() - 1.0).abs() < 1e-6);
        }
    }
}
