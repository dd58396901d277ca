//! The leading eigenvector of a symmetric matrix that can only be multiplied with.

use nalgebra::DMatrix;
use nalgebra::SymmetricEigen;

/// Largest number of steps.
const STEPS: usize = 80;
/// Relative change of the eigenvalue at which it is taken for found.
const SETTLED: f64 = 1e-9;

/// The eigenvector of the largest eigenvalue among those orthogonal to `known`, a unit vector.
///
/// Lanczos' method with all vectors kept orthogonal; the start is fixed, so that
/// the answer is. Its sign has no meaning.
pub(crate) fn leading(times: impl Fn(&[f64]) -> Vec<f64>, known: &[f64]) -> Vec<f64> {
    let count = known.len();
    // Any start that no eigenvector is orthogonal to.
    let start: Vec<f64> = (0..count).map(|i| ((i as f64 + 1.0) * 0.618_033_988_75).fract() - 0.5).collect();
    let mut basis: Vec<Vec<f64>> = vec![known.to_vec()];
    let (mut diagonal, mut off) = (Vec::new(), Vec::new());
    let mut next = start;
    let mut best = (f64::NEG_INFINITY, Vec::new());
    for _ in 0..STEPS.min(count.saturating_sub(1)) {
        // Twice is enough.
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
            off.push(length);
        }
        let product = times(&next);
        diagonal.push(dot(&product, &next));
        basis.push(std::mem::replace(&mut next, product));

        let size = diagonal.len();
        let eigen = SymmetricEigen::new(DMatrix::from_fn(size, size, |i, j| match i.abs_diff(j) {
            0 => diagonal[i],
            1 => off[i.min(j)],
            _ => 0.0,
        }));
        let (largest, value) = eigen.eigenvalues.argmax();
        let settled = (value - best.0).abs() <= SETTLED * value.abs();
        best = (value, eigen.eigenvectors.column(largest).iter().copied().collect());
        if settled && size > 5 {
            break;
        }
    }
    let mut vector = vec![0.0; count];
    for (share, member) in best.1.iter().zip(&basis[1..]) {
        vector.iter_mut().zip(member).for_each(|(x, v)| *x += share * v);
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
            let value = |place: usize| eigen.eigenvalues[order[place]];
            prop_assume!(value(1) - value(2) > 1e-3 && value(0) - value(1) > 1e-3);
            let first: Vec<f64> = eigen.eigenvectors.column(order[0]).iter().copied().collect();
            let found = leading(|x| (&matrix * DVector::from_column_slice(x)).iter().copied().collect(), &first);
            let second: Vec<f64> = eigen.eigenvectors.column(order[1]).iter().copied().collect();
            prop_assert!((dot(&found, &second).abs() - 1.0).abs() < 1e-6);
        }
    }
}
