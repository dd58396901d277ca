//! Maximum variance unfolding as a semidefinite program, solved by a primal–dual interior-point
//! method.
//!
//! Finds the centred inner products K of points that preserve the squared distances b of their edges
//! and have the largest trace:
//!
//! > max tr K, K ⪰ 0, K·1 = 0, K_ii + K_jj − 2 K_ij = b_ij on the edges
//!
//! The dual problem has a weight y per edge, the stiffness of a spring:
//!
//! > min bᵀy, S = Σ y_ij (e_i − e_j)(e_i − e_j)ᵀ − (I − J) ⪰ 0
//!
//! where J = 11ᵀ/n is the projection onto the constant vector. K and S have that vector in their
//! kernel, and J is added for factorisation. Search directions are those of Helmberg, Kojima and
//! Monteiro with Mehrotra's predictor–corrector method.

use std::ops::Range;

use nalgebra::{DMatrix, DVector};

use crate::segments::methods::mvu::bands::{Bands, Factor, Quad, WIDTH};
use crate::segments::methods::mvu::neighbours::Edge;
use crate::segments::progress::{Cancelled, Checkpoint};

/// Relative duality gap of a solution.
const TOLERANCE: f64 = 5e-6;
/// Maximum violation of an edge constraint, relative to the mean squared distance.
const FEASIBILITY: f64 = 5e-7;
/// Maximum number of iterations; about twelve suffice, and eight from the previous window.
const MAX_ITERATIONS: usize = 40;
/// Fraction of the distance to the boundary of the cone in a step.
const STEP_FRACTION: f64 = 0.97;
/// Factor by which a step out of the cone is shortened …
const STEP_REDUCTION: f64 = 0.92;
/// … in the predictor step, which needs less accuracy …
const PREDICTOR_REDUCTION: f64 = 0.84;
/// … and the maximum number of trials.
const MAX_TRIALS: usize = 60;
/// Minimum target for the complementarity while the constraints are farther from their tolerance
/// than the gap: full steps satisfy the constraints, and greedy steps are not full.
const MIN_CENTRING: f64 = 0.1;
/// Duality gap, relative to the trace, of the iterate from which the next window starts. Iterates
/// closer to the solution are too close to the boundary of the cone.
const WARM_START_GAP: f64 = 0.1;
/// Relative stiffness added to the springs until they balance a window that has grown …
const ADDED_STIFFNESS: [f64; 8] = [0.0, 0.02, 0.05, 0.1, 0.2, 0.4, 0.8, 1.6];
/// … and the factor by which they are then stiffened, to be well inside the cone.
const STIFFNESS_MARGIN: f64 = 1.2;

/// Solution of the program.
pub(crate) struct Unfolded {
    /// K: inner products of the unfolded points about their centre, in the unit of the squared
    /// distances.
    pub products: DMatrix<f64>,
    /// Relative duality gap.
    pub gap: f64,
    /// Maximum violation of an edge constraint, relative to the mean squared distance.
    pub violation: f64,
    /// Interior point from which the next window may start.
    pub interior: InteriorPoint,
}

impl Unfolded {
    fn is_solved(&self) -> bool {
        self.gap < TOLERANCE && self.violation < FEASIBILITY
    }
}

/// Iterate well inside the cone.
#[derive(Debug, Default)]
pub(crate) struct InteriorPoint {
    products: DMatrix<f64>,
    /// Weights of the edges, in the order of their ends.
    weights: Vec<((usize, usize), f64)>,
}

impl InteriorPoint {
    /// Returns the number of points.
    pub fn count(&self) -> usize {
        self.products.nrows()
    }

    /// Removes the first `removed` points.
    pub fn without_first(self, removed: usize) -> InteriorPoint {
        let remaining = self.count() - removed;
        let weights = self.weights.into_iter().filter(|((from, _), _)| *from >= removed);
        InteriorPoint {
            products: self.products.view((removed, removed), (remaining, remaining)).into_owned(),
            weights: weights.map(|((from, to), weight)| ((from - removed, to - removed), weight)).collect(),
        }
    }
}

/// Unfolds `count` points along their edges, which must connect all of them. The first points may
/// be those of `start`.
pub(crate) fn unfold(
    count: usize,
    edges: &[Edge],
    start: &InteriorPoint,
    checkpoint: &mut Checkpoint,
) -> Result<Unfolded, Cancelled> {
    let mean = edges.iter().map(|edge| edge.squared).sum::<f64>() / edges.len().max(1) as f64;
    if mean <= 0.0 {
        let products = DMatrix::zeros(count, count);
        return Ok(Unfolded { products, gap: 0.0, violation: 0.0, interior: InteriorPoint::default() });
    }
    let problem = Problem::new(Springs { count, edges }, mean);
    if let Some((k, y)) = problem.warm_start(start) {
        let unfolded = problem.solve(k, y, checkpoint)?;
        if unfolded.is_solved() {
            return Ok(unfolded);
        }
    }
    let (k, y) = problem.cold_start();
    problem.solve(k, y, checkpoint)
}

/// The program in units of the mean squared distance.
struct Problem<'a> {
    springs: Springs<'a>,
    mean: f64,
    /// b: squared distances of the edges.
    squared_distances: DVector<f64>,
    /// J.
    constant: DMatrix<f64>,
    /// I − J.
    centring: DMatrix<f64>,
    /// Dimension of the centred space.
    dims: f64,
}

impl Problem<'_> {
    fn new(springs: Springs, mean: f64) -> Problem {
        let count = springs.count;
        let squared = springs.edges.iter().map(|edge| edge.squared / mean);
        let constant = DMatrix::from_element(count, count, 1.0 / count as f64);
        Problem {
            squared_distances: DVector::from_iterator(springs.edges.len(), squared),
            centring: DMatrix::identity(count, count) - &constant,
            constant,
            dims: (count - 1) as f64,
            springs,
            mean,
        }
    }

    /// Returns S for the weights y.
    fn slack(&self, y: &DVector<f64>) -> DMatrix<f64> {
        self.springs.laplacian(y) - &self.centring
    }

    /// Returns K and y to start from without a previous window.
    fn cold_start(&self) -> (DMatrix<f64>, DVector<f64>) {
        let uniform = DVector::from_element(self.squared_distances.len(), 1.0);
        let stiffness = self.springs.laplacian(&uniform).symmetric_eigenvalues();
        let softest = second_smallest(stiffness.as_slice());
        let k = &self.centring * (self.squared_distances.sum() / self.dims).max(1.0);
        (k, uniform * (2.0 / softest))
    }

    /// Returns K and y to start from a previous window with most of the points.
    fn warm_start(&self, start: &InteriorPoint) -> Option<(DMatrix<f64>, DVector<f64>)> {
        let (known, count) = (start.count(), self.springs.count);
        if 2 * known < count || known > count {
            return None;
        }
        let mut k = DMatrix::zeros(count, count);
        k.view_mut((0, 0), (known, known)).copy_from(&(&start.products / self.mean));
        for new in known..count {
            // The new point is placed at its nearest neighbour and moved along a new dimension.
            let earlier = self.springs.edges.iter().filter(|edge| edge.to == new);
            let nearest = earlier.min_by(|a, b| a.squared.total_cmp(&b.squared))?;
            let neighbour = k.column(nearest.from).into_owned();
            k.set_column(new, &neighbour);
            k.set_row(new, &neighbour.transpose());
            k[(new, new)] = neighbour[nearest.from] + nearest.squared / self.mean;
        }
        let k = &self.centring * k * &self.centring;

        let known = &start.weights;
        let mean_weight = known.iter().map(|(_, weight)| weight).sum::<f64>() / known.len() as f64;
        let weight = |edge: &Edge| {
            let place = known.binary_search_by_key(&(edge.from, edge.to), |(ends, _)| *ends);
            place.map_or(mean_weight, |place| known[place].1)
        };
        let weights = self.springs.edges.iter().map(weight);
        let y = DVector::from_iterator(self.squared_distances.len(), weights);
        let candidates =
            ADDED_STIFFNESS.iter().map(|added| (&y * (1.0 + added)).add_scalar(mean_weight * added));
        let is_interior =
            |y: &DVector<f64>| Factor::new(Bands::new(&(self.slack(y) + &self.constant))).is_some();
        candidates.into_iter().find(is_interior).map(|y| (k, y * STIFFNESS_MARGIN))
    }

    /// Returns the solution found from K and y, or the best iterate.
    fn solve(
        &self,
        mut k: DMatrix<f64>,
        mut y: DVector<f64>,
        checkpoint: &mut Checkpoint,
    ) -> Result<Unfolded, Cancelled> {
        let Problem { springs, mean, squared_distances, constant, dims, .. } = self;
        let mut s = self.slack(&y);
        let (mut gap, mut violation) = (f64::INFINITY, f64::INFINITY);
        let mut warm_start = (f64::INFINITY, k.clone(), y.clone());
        for _ in 0..MAX_ITERATIONS {
            let (primal, dual) = (k.trace(), squared_distances.dot(&y));
            gap = (dual - primal).abs() / (1.0 + primal.abs() + dual.abs());
            violation = (squared_distances - springs.squared_lengths(&k)).amax();
            if gap < TOLERANCE && violation < FEASIBILITY {
                break;
            }
            checkpoint()?;
            let mu = k.dot(&s) / dims;
            let log_distance = (mu * dims / primal / WARM_START_GAP).ln().abs();
            if log_distance < warm_start.0 {
                warm_start = (log_distance, k.clone(), y.clone());
            }
            let (k_full, s_full) = (&k + constant, &s + constant);
            let Some(s_factor) = Factor::new(Bands::new(&s_full)) else { break };
            let s_inverse = s_factor.inverse();
            let s_bands = Bands::new(&s_inverse);
            let Some(schur) = Factor::new(springs.schur(&k, &s_inverse)) else { break };
            // `second_order` is the product of both directions, which the linearised equations
            // omit.
            let direction = |target: f64, second_order: Option<&DMatrix<f64>>| {
                let mut right = springs.squared_lengths(&s_inverse) * target - squared_distances;
                if let Some(second_order) = second_order {
                    right -= springs.products_along_edges(second_order, &s_inverse);
                }
                let dy = schur.solve(&right);
                let mut change = springs.multiply_laplacian(&k, &dy);
                if let Some(second_order) = second_order {
                    change += second_order;
                }
                let change = Bands::new(&change).multiply_transposed(&s_bands);
                let dk = (&s_inverse - constant) * target - &k - (&change + change.transpose()) * 0.5;
                (springs.laplacian(&dy), dy, dk)
            };
            let (ds, dy, dk) = direction(0.0, None);
            let (step_k, step_s) = (
                max_step(&k_full, &dk, 1.0, PREDICTOR_REDUCTION),
                max_step(&s_full, &ds, 1.0, PREDICTOR_REDUCTION),
            );
            let predicted = (&k + &dk * step_k).dot(&(&s + &ds * step_s)) / dims;
            let is_behind = violation / FEASIBILITY > gap / TOLERANCE;
            let min_target = if is_behind { MIN_CENTRING } else { 0.0 };
            let target = mu * (predicted / mu).max(0.0).powi(3).clamp(min_target, 1.0);
            let (ds, dy, dk) = direction(target, Some(&springs.multiply_laplacian(&dk, &dy)));
            let (step_k, step_s) = (
                max_step(&k_full, &dk, 1.0 / STEP_FRACTION, STEP_REDUCTION),
                max_step(&s_full, &ds, 1.0 / STEP_FRACTION, STEP_REDUCTION),
            );
            if step_k.max(step_s) == 0.0 {
                break;
            }
            let (step_k, step_s) = (STEP_FRACTION * step_k, STEP_FRACTION * step_s);
            k += dk * step_k;
            y += dy * step_s;
            s += ds * step_s;
        }
        let (_, interior_k, y) = warm_start;
        let ends = springs.edges.iter().map(|edge| (edge.from, edge.to));
        let interior =
            InteriorPoint { products: interior_k * *mean, weights: ends.zip(y.iter().copied()).collect() };
        Ok(Unfolded { products: k * *mean, gap, violation, interior })
    }
}

/// Returns the step from `matrix` along `direction` that stays inside the cone, at most `max`.
/// A factorisation is so cheap that trial and error is the fastest test.
fn max_step(matrix: &DMatrix<f64>, direction: &DMatrix<f64>, max: f64, reduction: f64) -> f64 {
    let mut step = max;
    for _ in 0..MAX_TRIALS {
        if Factor::new(Bands::new(&(matrix + direction * step))).is_some() {
            return step;
        }
        step *= reduction;
    }
    0.0
}

/// Returns the second smallest eigenvalue of a Laplacian; the smallest is zero.
fn second_smallest(eigenvalues: &[f64]) -> f64 {
    let mut sorted = eigenvalues.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    sorted.get(1).copied().unwrap_or(1.0).max(1e-12)
}

/// Linear maps of the edges.
struct Springs<'a> {
    count: usize,
    edges: &'a [Edge],
}

impl Springs<'_> {
    /// Returns Σ y (e_i − e_j)(e_i − e_j)ᵀ.
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

    /// Returns A·laplacian(y), computed by columns, as the Laplacian is sparse.
    fn multiply_laplacian(&self, a: &DMatrix<f64>, y: &DVector<f64>) -> DMatrix<f64> {
        let mut product = DMatrix::zeros(self.count, self.count);
        for (&Edge { from, to, .. }, &weight) in self.edges.iter().zip(y.iter()) {
            for (sign, column) in [(weight, from), (-weight, to)] {
                product.column_mut(column).axpy(sign, &a.column(from), 1.0);
                product.column_mut(column).axpy(-sign, &a.column(to), 1.0);
            }
        }
        product
    }

    /// Returns (e_i − e_j)ᵀ A (e_i − e_j) for every edge.
    fn squared_lengths(&self, a: &DMatrix<f64>) -> DVector<f64> {
        let length =
            |&Edge { from, to, .. }: &Edge| a[(from, from)] + a[(to, to)] - a[(from, to)] - a[(to, from)];
        DVector::from_iterator(self.edges.len(), self.edges.iter().map(length))
    }

    /// Returns a_eᵀ A B a_e for every edge, with symmetric B.
    fn products_along_edges(&self, a: &DMatrix<f64>, b: &DMatrix<f64>) -> DVector<f64> {
        let rows = a.transpose();
        // Slices are used because column iterators are slow without inlining.
        let (rows, columns) = (rows.as_slice(), b.as_slice());
        let length = |&Edge { from, to, .. }: &Edge| {
            let (from, to) = (self.column_range(from), self.column_range(to));
            let in_a = rows[from.clone()].iter().zip(&rows[to.clone()]);
            let in_b = columns[from].iter().zip(&columns[to]);
            let products =
                in_a.zip(in_b).map(|((a_from, a_to), (b_from, b_to))| (a_from - a_to) * (b_from - b_to));
            products.sum::<f64>()
        };
        DVector::from_iterator(self.edges.len(), self.edges.iter().map(length))
    }

    /// Returns the lower triangle of M_ef = (a_eᵀ K a_f)(a_eᵀ S⁻¹ a_f) with a_e = e_i − e_j.
    fn schur(&self, k: &DMatrix<f64>, s_inverse: &DMatrix<f64>) -> Bands {
        let mut ends = 0;
        let band = |edges: &[Edge]| {
            ends += WIDTH;
            let (in_k, in_s) = (self.differences(k, edges), self.differences(s_inverse, edges));
            let mut band = vec![Quad::default(); ends];
            for (values, &Edge { from, to, .. }) in band.iter_mut().zip(self.edges) {
                let (k_from, k_to, s_from, s_to) = (in_k[from], in_k[to], in_s[from], in_s[to]);
                for row in 0..WIDTH {
                    values[row] = (k_from[row] - k_to[row]) * (s_from[row] - s_to[row]);
                }
            }
            band
        };
        Bands::lower_triangle(self.edges.len(), self.edges.chunks(WIDTH).map(band))
    }

    /// Returns the index range of a column in memory.
    fn column_range(&self, point: usize) -> Range<usize> {
        self.count * point..self.count * (point + 1)
    }

    /// Returns the differences between two rows of the symmetric `a` for each of a few edges.
    fn differences(&self, a: &DMatrix<f64>, edges: &[Edge]) -> Vec<Quad> {
        let mut differences = vec![Quad::default(); self.count];
        for (row, &Edge { from, to, .. }) in edges.iter().enumerate() {
            let (from, to) = (&a.as_slice()[self.column_range(from)], &a.as_slice()[self.column_range(to)]);
            for ((values, from), to) in differences.iter_mut().zip(from).zip(to) {
                values[row] = from - to;
            }
        }
        differences
    }
}
