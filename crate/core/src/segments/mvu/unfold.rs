//! Maximum variance unfolding as a semidefinite programme, by a primal–dual interior-point method.
//!
//! Among all centred inner products K of points that keep the squared distances b of their
//! edges, the ones of largest trace:
//!
//! > max tr K, K ⪰ 0, K·1 = 0, K_ii + K_jj − 2 K_ij = b_ij on the edges
//!
//! The dual gives each edge a weight y, as of springs whose Laplacian has to outweigh the pull outwards:
//!
//! > min bᵀy, S = Σ y_ij (e_i − e_j)(e_i − e_j)ᵀ − (I − J) ⪰ 0
//!
//! where J = 11ᵀ/n projects on the constant vector. K and S have that vector in their kernel;
//! J is added where they are factored. Directions are those of Helmberg, Kojima and Monteiro
//! with Mehrotra's predictor and corrector.

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

use super::neighbours::Edge;

/// Largest gap between primal and dual, relative to their values, at which the solution is taken.
const TOLERANCE: f64 = 5e-6;
/// Largest violation of an edge, relative to the mean squared distance.
const FEASIBLE: f64 = 5e-7;
/// Iterations after which the best so far is taken; a dozen do.
const MOST_ITERATIONS: usize = 40;
/// How much of the way to the edge of the cone a step goes.
const STEP: f64 = 0.95;
/// How much shorter a step is tried where one led out of the cone, ...
const SHORTER: f64 = 0.92;
/// ... and how often.
const MOST_TRIALS: usize = 60;

/// The solution.
pub(super) struct Unfolded {
    /// K: inner products of the unfolded points about their centre, in the unit of the squared distances.
    pub products: DMatrix<f64>,
    /// Relative gap between primal and dual.
    #[cfg_attr(not(test), allow(dead_code))]
    pub gap: f64,
    /// Largest violation of an edge, relative to the mean squared distance.
    #[cfg_attr(not(test), allow(dead_code))]
    pub violation: f64,
}

/// Unfolds `count` points along their edges, which have to connect all of them.
pub(super) fn unfold(count: usize, edges: &[Edge]) -> Unfolded {
    let mean = edges.iter().map(|edge| edge.squared).sum::<f64>() / edges.len().max(1) as f64;
    if mean <= 0.0 {
        return Unfolded { products: DMatrix::zeros(count, count), gap: 0.0, violation: 0.0 };
    }
    let wanted = DVector::from_iterator(edges.len(), edges.iter().map(|edge| edge.squared / mean));
    let springs = Springs { count, edges };
    let constant = DMatrix::from_element(count, count, 1.0 / count as f64);
    let centring = DMatrix::identity(count, count) - &constant;
    let dims = (count - 1) as f64;

    let mut k = &centring * (wanted.sum() / dims).max(1.0);
    let stiffness = springs.laplacian(&DVector::from_element(edges.len(), 1.0)).symmetric_eigenvalues();
    let softest = smallest_but_zero(stiffness.as_slice());
    let mut y = DVector::from_element(edges.len(), 2.0 / softest);
    let mut s = springs.laplacian(&y) - &centring;
    let (mut gap, mut violation) = (f64::INFINITY, f64::INFINITY);
    for _ in 0..MOST_ITERATIONS {
        let missing = &wanted - springs.lengths(&k);
        let (primal, dual) = (k.trace(), wanted.dot(&y));
        gap = (dual - primal).abs() / (1.0 + primal.abs() + dual.abs());
        violation = missing.amax();
        if gap < TOLERANCE && violation < FEASIBLE {
            break;
        }
        let (k_full, s_full) = (&k + &constant, &s + &constant);
        let Some(s_factor) = s_full.clone().cholesky() else { break };
        let s_inverse = inverse(&s_factor);
        let Some(schur) = springs.schur(&k, &s_inverse).cholesky() else { break };
        let mu = k.dot(&s) / dims;
        let ahead = |aim: f64, correction: Option<&DMatrix<f64>>| {
            let mut right = springs.lengths(&s_inverse) * aim - &wanted;
            if let Some(correction) = correction {
                right -= springs.lengths(correction);
            }
            let dy = schur.solve(&right);
            let mut dk = (&s_inverse - &constant) * aim - &k - springs.times(&k, &dy) * &s_inverse;
            if let Some(correction) = correction {
                dk -= correction;
            }
            let dk = (&dk + dk.transpose()) * 0.5;
            (springs.laplacian(&dy), dy, dk)
        };
        let (ds, dy, dk) = ahead(0.0, None);
        let (to_k, to_s) = (room(&k_full, &dk, 1.0), room(&s_full, &ds, 1.0));
        let predicted = (&k + &dk * to_k).dot(&(&s + &ds * to_s)) / dims;
        let aim = mu * (predicted / mu).max(0.0).powi(3).min(1.0);
        let correction = springs.times(&dk, &dy) * &s_inverse;
        let (ds, dy, dk) = ahead(aim, Some(&correction));
        let (to_k, to_s) = (STEP * room(&k_full, &dk, 1.0 / STEP), STEP * room(&s_full, &ds, 1.0 / STEP));
        k += dk * to_k;
        y += dy * to_s;
        s += ds * to_s;
    }
    Unfolded { products: k * mean, gap, violation }
}

/// The inverse of a factored matrix; solving for it takes three times as long.
fn inverse(factor: &Cholesky<f64, Dyn>) -> DMatrix<f64> {
    let lower = factor.l_dirty();
    let mut inverse = DMatrix::identity(lower.nrows(), lower.nrows());
    lower.solve_lower_triangular_mut(&mut inverse);
    inverse.transpose() * inverse
}

/// How far one may go from `matrix` along `direction` and stay inside the cone, at most `far`;
/// a factorisation costs so little that trying is the quickest way to know.
fn room(matrix: &DMatrix<f64>, direction: &DMatrix<f64>, far: f64) -> f64 {
    let mut step = far;
    for _ in 0..MOST_TRIALS {
        if (matrix + direction * step).cholesky().is_some() {
            return step;
        }
        step *= SHORTER;
    }
    0.0
}

/// The second smallest of the eigenvalues of a Laplacian; the smallest is zero.
fn smallest_but_zero(eigenvalues: &[f64]) -> f64 {
    let mut sorted = eigenvalues.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    sorted.get(1).copied().unwrap_or(1.0).max(1e-12)
}

/// The linear maps of the edges.
struct Springs<'a> {
    count: usize,
    edges: &'a [Edge],
}

impl Springs<'_> {
    /// Σ y (e_i − e_j)(e_i − e_j)ᵀ.
    fn laplacian(&self, y: &DVector<f64>) -> DMatrix<f64> {
        let mut laplacian = DMatrix::zeros(self.count, self.count);
        for (&Edge { from, to, .. }, &weight) in self.edges.iter().zip(y.iter()) {
            laplacian[(from, from)] += weight;
            laplacian[(to, to)] += weight;
            laplacian[(from, to)] -= weight;
            laplacian[(to, from)] -= weight;
        }
        laplacian
    }

    /// A·laplacian(y), column by column: far fewer steps than there are entries.
    fn times(&self, a: &DMatrix<f64>, y: &DVector<f64>) -> DMatrix<f64> {
        let mut product = DMatrix::zeros(self.count, self.count);
        for (&Edge { from, to, .. }, &weight) in self.edges.iter().zip(y.iter()) {
            for (sign, column) in [(weight, from), (-weight, to)] {
                product.column_mut(column).axpy(sign, &a.column(from), 1.0);
                product.column_mut(column).axpy(-sign, &a.column(to), 1.0);
            }
        }
        product
    }

    /// (e_i − e_j)ᵀ A (e_i − e_j) of every edge.
    fn lengths(&self, a: &DMatrix<f64>) -> DVector<f64> {
        let length =
            |&Edge { from, to, .. }: &Edge| a[(from, from)] + a[(to, to)] - a[(from, to)] - a[(to, from)];
        DVector::from_iterator(self.edges.len(), self.edges.iter().map(length))
    }

    /// M_ef = (a_eᵀ K a_f)(a_eᵀ S⁻¹ a_f) with a_e = e_i − e_j; its lower triangle.
    fn schur(&self, k: &DMatrix<f64>, s_inverse: &DMatrix<f64>) -> DMatrix<f64> {
        // Differences of rows first, so that those of columns run along memory.
        let (in_k, in_s) = (self.differences(k), self.differences(s_inverse));
        let mut schur = DMatrix::zeros(self.edges.len(), self.edges.len());
        for (place, &Edge { from, to, .. }) in self.edges.iter().enumerate() {
            let part = |column: usize| column * self.edges.len() + place..(column + 1) * self.edges.len();
            let (k_from, k_to) = (&in_k.as_slice()[part(from)], &in_k.as_slice()[part(to)]);
            let (s_from, s_to) = (&in_s.as_slice()[part(from)], &in_s.as_slice()[part(to)]);
            let values = &mut schur.as_mut_slice()[part(place)];
            for ((((value, k_from), k_to), s_from), s_to) in
                values.iter_mut().zip(k_from).zip(k_to).zip(s_from).zip(s_to)
            {
                *value = (k_from - k_to) * (s_from - s_to);
            }
        }
        schur
    }

    /// The difference of two rows of `a` for each edge.
    fn differences(&self, a: &DMatrix<f64>) -> DMatrix<f64> {
        DMatrix::from_fn(self.edges.len(), self.count, |edge, column| {
            let Edge { from, to, .. } = self.edges[edge];
            a[(from, column)] - a[(to, column)]
        })
    }
}
