//! The largest eigenvalues of a matrix, by inverse iteration with a shift (Zhang and Wang, algorithm 1-1).
//!
//! A shift close to an eigenvalue makes the iteration fast; the growing window's matrix
//! changes little, so the eigenvalues of the window before are good ones. Without those,
//! Gershgorin's discs bound the largest (their equation 4).

use nalgebra::DMatrix;
use nalgebra::DVector;

/// Iterations after which a shift is given up.
const MOST_ITERATIONS: usize = 60;
/// Change of an eigenvalue, relative to it, at which it is found.
const TOLERANCE: f64 = 1e-10;

/// The `wanted` largest eigenvalues of a positive semidefinite matrix, largest first;
/// `guesses` are shifts to try, in the same order.
pub(crate) fn largest(mut matrix: DMatrix<f64>, wanted: usize, guesses: &[f64]) -> Vec<f64> {
    let mut found = Vec::new();
    for place in 0..wanted.min(matrix.nrows()) {
        let shifts = guesses.get(place).map(|guess| guess * 1.05).into_iter().chain([gershgorin(&matrix)]);
        let Some((value, vector)) =
            shifts.filter(|&shift| shift > 0.0).find_map(|shift| nearest(&matrix, shift))
        else {
            // No shift led to the largest one: the whole spectrum does.
            let mut rest = matrix.symmetric_eigenvalues().as_slice().to_vec();
            rest.sort_unstable_by(|a, b| b.total_cmp(a));
            found.extend(rest.into_iter().take(wanted - place));
            break;
        };
        // What is found is taken out, so that the next largest is the largest.
        matrix.syger(-value, &vector, &vector, 1.0);
        matrix.fill_upper_triangle_with_lower_triangle();
        found.push(value);
    }
    found
}

/// The largest eigenvalue with its vector, if iterating about `shift` leads to it.
fn nearest(matrix: &DMatrix<f64>, shift: f64) -> Option<(f64, DVector<f64>)> {
    let count = matrix.nrows();
    let shifted = |shift: f64| {
        let mut shifted = matrix.clone();
        for place in 0..count {
            shifted[(place, place)] -= shift;
        }
        shifted
    };
    let factors = shifted(shift).lu();
    // No symmetry of the motion is likely to be orthogonal to it.
    let mut vector = DVector::from_fn(count, |place, _| 1.0 + (place as f64 * 0.7).sin()).normalize();
    let mut value = f64::NAN;
    for _ in 0..MOST_ITERATIONS {
        vector = factors.solve(&vector)?.normalize();
        let last = value;
        value = vector.dot(&(matrix * &vector));
        if (value - last).abs() <= TOLERANCE * value.abs() {
            // Nothing is larger if what is a little larger outweighs the matrix.
            let is_largest = (-shifted(value + 1e-6 * value.abs())).cholesky().is_some();
            return is_largest.then_some((value, vector));
        }
    }
    None
}

/// The upper bound of all of Gershgorin's discs.
fn gershgorin(matrix: &DMatrix<f64>) -> f64 {
    let bound = |place: usize| {
        let row = matrix.column(place);
        row[place] + row.iter().map(|value| value.abs()).sum::<f64>() - row[place].abs()
    };
    (0..matrix.nrows()).map(bound).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn they_are_those_of_the_full_solver(
            values in prop::collection::vec(-1.0..1.0_f64, 5 * 12),
            guess in 0.0..30.0_f64,
            wanted in 1_usize..5,
        ) {
            let points = DMatrix::from_vec(12, 5, values);
            let matrix = &points * points.transpose();
            let mut expected = matrix.symmetric_eigenvalues().as_slice().to_vec();
            expected.sort_unstable_by(|a, b| b.total_cmp(a));
            for guesses in [vec![], vec![guess, guess / 2.0], vec![expected[0], expected[1]]] {
                let found = largest(matrix.clone(), wanted, &guesses);
                prop_assert_eq!(found.len(), wanted);
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
    fn nothing_comes_of_nothing() {
        assert_eq!(largest(DMatrix::zeros(4, 4), 2, &[]), [0.0, 0.0]);
    }
}
