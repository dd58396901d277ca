//! Largest eigenvalues of a matrix by inverse iteration with a shift (Zhang and Wang, algorithm
//! 1-1).
//!
//! A shift close to an eigenvalue makes the iteration fast. The matrix of a growing window changes
//! little, so the eigenvalues of the previous window are good shifts. Without them, Gershgorin
//! discs bound the largest eigenvalue (their equation 4).

use nalgebra::{DMatrix, DVector};

/// Number of iterations after which a shift is abandoned.
const MAX_ITERATIONS: usize = 60;
/// Relative change of an eigenvalue at convergence.
const TOLERANCE: f64 = 1e-10;

/// Returns the `count` largest eigenvalues of a positive semidefinite matrix, largest first;
/// `guesses` are approximate eigenvalues in the same order.
pub(crate) fn largest_eigenvalues(mut matrix: DMatrix<f64>, count: usize, guesses: &[f64]) -> Vec<f64> {
    let mut eigenvalues = Vec::new();
    for index in 0..count.min(matrix.nrows()) {
        let shifts = guesses.get(index).map(|guess| guess * 1.05).into_iter().chain([gershgorin(&matrix)]);
        let Some((value, vector)) =
            shifts.filter(|&shift| shift > 0.0).find_map(|shift| converge(&matrix, shift))
        else {
            // No shift led to the largest eigenvalue; the full spectrum is computed.
            let mut rest = matrix.symmetric_eigenvalues().as_slice().to_vec();
            rest.sort_unstable_by(f64::total_cmp);
            eigenvalues.extend(rest.into_iter().rev().take(count - index));
            break;
        };
        // Deflation makes the next largest eigenvalue the largest.
        matrix.syger(-value, &vector, &vector, 1.0);
        matrix.fill_upper_triangle_with_lower_triangle();
        eigenvalues.push(value);
    }
    eigenvalues
}

/// Returns the largest eigenvalue with its eigenvector, if the iteration with `shift` converges to
/// it.
fn converge(matrix: &DMatrix<f64>, shift: f64) -> Option<(f64, DVector<f64>)> {
    let size = matrix.nrows();
    let shifted = |shift: f64| {
        let mut shifted = matrix.clone();
        for index in 0..size {
            shifted[(index, index)] -= shift;
        }
        shifted
    };
    let factors = shifted(shift).lu();
    // A start vector that is unlikely to be orthogonal to the eigenvector.
    let mut vector = DVector::from_fn(size, |index, _| 1.0 + (index as f64 * 0.7).sin()).normalize();
    let mut value = f64::NAN;
    for _ in 0..MAX_ITERATIONS {
        vector = factors.solve(&vector)?.normalize();
        let last = value;
        value = vector.dot(&(matrix * &vector));
        if (value - last).abs() <= TOLERANCE * value.abs() {
            // The value is the largest if the matrix minus a slightly larger multiple of the
            // identity is negative definite.
            let is_largest = (-shifted(value + 1e-6 * value.abs())).cholesky().is_some();
            return is_largest.then_some((value, vector));
        }
    }
    None
}

/// Returns the upper bound of the Gershgorin discs.
fn gershgorin(matrix: &DMatrix<f64>) -> f64 {
    let bound = |index: usize| {
        let row = matrix.column(index);
        row[index] + row.iter().map(|value| value.abs()).sum::<f64>() - row[index].abs()
    };
    (0..matrix.nrows()).map(bound).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn agrees_with_the_full_solver(
            values in prop::collection::vec(-1.0..1.0_f64, 5 * 12),
            guess in 0.0..30.0_f64,
            count in 1_usize..5,
        ) {
            let points = DMatrix::from_vec(12, 5, values);
            let matrix = &points * points.transpose();
            let mut expected = matrix.symmetric_eigenvalues().as_slice().to_vec();
            expected.sort_unstable_by(|a, b| b.total_cmp(a));
            for guesses in [vec![], vec![guess, guess / 2.0], vec![expected[0], expected[1]]] {
                let found = largest_eigenvalues(matrix.clone(), count, &guesses);
                prop_assert_eq!(found.len(), count);
                for (found, expected) in found.iter().zip(&expected) {
                    prop_assert!((found - expected).abs() < 1e-5 * expected_scale(&matrix), "{} {}", found, expected);
                }
            }
        }
    }

    fn expected_scale(matrix: &DMatrix<f64>) -> f64 {
        matrix.trace().max(1e-9)
    }

    #[test]
    fn the_zero_matrix_has_zero_eigenvalues() {
        assert_eq!(largest_eigenvalues(DMatrix::zeros(4, 4), 2, &[]), [0.0, 0.0]);
    }
}
