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

use std::collections::BTreeMap;
use std::ops::Range;

use nalgebra::DMatrix;
use nalgebra::DVector;

use crate::segments::methods::mvu::bands::{Bands, Factor, Quad, WIDTH};
use crate::segments::methods::mvu::neighbours::Edge;
use crate::segments::task::{Cancelled, Pause};

/// Largest gap between primal and dual, relative to their values, at which the solution is taken.
const TOLERANCE: f64 = 5e-6;
/// Largest violation of an edge, relative to the mean squared distance.
const FEASIBLE: f64 = 5e-7;
/// Iterations after which the best so far is taken; a dozen do, and eight from the window before.
const MOST_ITERATIONS: usize = 40;
/// How much of the way to the edge of the cone a step goes.
const STEP: f64 = 0.97;
/// How much shorter a step is tried where one led out of the cone, ...
const SHORTER: f64 = 0.92;
/// ... where it is only to say how far one might go, ...
const ROUGHLY: f64 = 0.84;
/// ... and how often.
const MOST_TRIALS: usize = 60;
/// Least share of the gap that is aimed at while the edges are further from right than the gap
/// is from closed: whole steps put the edges right, and greedy ones are not whole.
const UNHURRIED: f64 = 0.1;
/// The gap, relative to the trace, at which an iterate is kept for the next window to start from:
/// those nearer to the solution are too near to the edge of the cone.
const KEPT: f64 = 0.1;
/// Shares of stiffness added to springs until they hold a window that has grown, ...
const STIFFER: [f64; 8] = [0.0, 0.02, 0.05, 0.1, 0.2, 0.4, 0.8, 1.6];
/// ... and how many times as stiff they are then made, to be well inside the cone.
const MARGIN: f64 = 1.2;

/// The solution.
pub(crate) struct Unfolded {
    /// K: inner products of the unfolded points about their centre, in the unit of the squared distances.
    pub products: DMatrix<f64>,
    /// Relative gap between primal and dual.
    pub gap: f64,
    /// Largest violation of an edge, relative to the mean squared distance.
    pub violation: f64,
    /// Where the next window may start from.
    pub inside: Inside,
}

impl Unfolded {
    fn is_solved(&self) -> bool {
        self.gap < TOLERANCE && self.violation < FEASIBLE
    }
}

/// An iterate well inside the cone.
#[derive(Debug, Default)]
pub(crate) struct Inside {
    products: DMatrix<f64>,
    weights: BTreeMap<(usize, usize), f64>,
}

impl Inside {
    /// How many points it has.
    pub fn count(&self) -> usize {
        self.products.nrows()
    }

    /// Without the first few points.
    pub fn without_first(self, few: usize) -> Inside {
        let rest = self.count() - few;
        let weights = self.weights.into_iter().filter(|((from, _), _)| *from >= few);
        Inside {
            products: self.products.view((few, few), (rest, rest)).into_owned(),
            weights: weights.map(|((from, to), weight)| ((from - few, to - few), weight)).collect(),
        }
    }
}

/// Unfolds `count` points along their edges, which have to connect all of them; the first
/// points may be those of `start`.
pub(crate) fn unfold(
    count: usize,
    edges: &[Edge],
    start: &Inside,
    pause: &mut Pause,
) -> Result<Unfolded, Cancelled> {
    let mean = edges.iter().map(|edge| edge.squared).sum::<f64>() / edges.len().max(1) as f64;
    if mean <= 0.0 {
        let products = DMatrix::zeros(count, count);
        return Ok(Unfolded { products, gap: 0.0, violation: 0.0, inside: Inside::default() });
    }
    let problem = Problem::new(Springs { count, edges }, mean);
    if let Some((k, y)) = problem.warm(start) {
        let unfolded = problem.solve(k, y, pause)?;
        if unfolded.is_solved() {
            return Ok(unfolded);
        }
    }
    let (k, y) = problem.cold();
    problem.solve(k, y, pause)
}

/// What is to be solved, with the mean squared distance as unit.
struct Problem<'a> {
    springs: Springs<'a>,
    mean: f64,
    /// b.
    wanted: DVector<f64>,
    /// J.
    constant: DMatrix<f64>,
    /// I − J.
    centring: DMatrix<f64>,
    /// Dimensions of what is centred.
    dims: f64,
}

impl Problem<'_> {
    fn new(springs: Springs, mean: f64) -> Problem {
        let count = springs.count;
        let squares = springs.edges.iter().map(|edge| edge.squared / mean);
        let constant = DMatrix::from_element(count, count, 1.0 / count as f64);
        Problem {
            wanted: DVector::from_iterator(springs.edges.len(), squares),
            centring: DMatrix::identity(count, count) - &constant,
            constant,
            dims: (count - 1) as f64,
            springs,
            mean,
        }
    }

    /// S of the weights y.
    fn slack(&self, y: &DVector<f64>) -> DMatrix<f64> {
        self.springs.laplacian(y) - &self.centring
    }

    /// K and y to start from where nothing is known.
    fn cold(&self) -> (DMatrix<f64>, DVector<f64>) {
        let even = DVector::from_element(self.wanted.len(), 1.0);
        let stiffness = self.springs.laplacian(&even).symmetric_eigenvalues();
        let softest = smallest_but_zero(stiffness.as_slice());
        let k = &self.centring * (self.wanted.sum() / self.dims).max(1.0);
        (k, even * (2.0 / softest))
    }

    /// K and y to start from where most points are known.
    fn warm(&self, start: &Inside) -> Option<(DMatrix<f64>, DVector<f64>)> {
        let (known, count) = (start.count(), self.springs.count);
        if 2 * known < count || known > count {
            return None;
        }
        let mut k = DMatrix::zeros(count, count);
        k.view_mut((0, 0), (known, known)).copy_from(&(&start.products / self.mean));
        for new in known..count {
            // Where the nearest is, and off into a direction of its own.
            let earlier = self.springs.edges.iter().filter(|edge| edge.to == new);
            let nearest = earlier.min_by(|a, b| a.squared.total_cmp(&b.squared))?;
            let place = k.column(nearest.from).into_owned();
            k.set_column(new, &place);
            k.set_row(new, &place.transpose());
            k[(new, new)] = place[nearest.from] + nearest.squared / self.mean;
        }
        let k = &self.centring * k * &self.centring;

        let usual = start.weights.values().sum::<f64>() / start.weights.len() as f64;
        let weight = |edge: &Edge| *start.weights.get(&(edge.from, edge.to)).unwrap_or(&usual);
        let weights = self.springs.edges.iter().map(weight);
        let y = DVector::from_iterator(self.wanted.len(), weights);
        let stiffer = STIFFER.iter().map(|more| (&y * (1.0 + more)).add_scalar(usual * more));
        let is_inside = |y: &DVector<f64>| Factor::of(Bands::of(&(self.slack(y) + &self.constant))).is_some();
        stiffer.into_iter().find(is_inside).map(|y| (k, y * MARGIN))
    }

    /// The solution that is found from K and y, or as near as it gets.
    fn solve(
        &self,
        mut k: DMatrix<f64>,
        mut y: DVector<f64>,
        pause: &mut Pause,
    ) -> Result<Unfolded, Cancelled> {
        let Problem { springs, mean, wanted, constant, dims, .. } = self;
        let mut s = self.slack(&y);
        let (mut gap, mut violation) = (f64::INFINITY, f64::INFINITY);
        let mut kept = (f64::INFINITY, k.clone(), y.clone());
        for _ in 0..MOST_ITERATIONS {
            let (primal, dual) = (k.trace(), wanted.dot(&y));
            gap = (dual - primal).abs() / (1.0 + primal.abs() + dual.abs());
            violation = (wanted - springs.lengths(&k)).amax();
            if gap < TOLERANCE && violation < FEASIBLE {
                break;
            }
            pause()?;
            let mu = k.dot(&s) / dims;
            let from_kept = (mu * dims / primal / KEPT).ln().abs();
            if from_kept < kept.0 {
                kept = (from_kept, k.clone(), y.clone());
            }
            let (k_full, s_full) = (&k + constant, &s + constant);
            let Some(s_factor) = Factor::of(Bands::of(&s_full)) else { break };
            let s_inverse = s_factor.inverse();
            let s_bands = Bands::of(&s_inverse);
            let Some(schur) = Factor::of(springs.schur(&k, &s_inverse)) else { break };
            // `second` is what of the products of both directions the linear equations leave out.
            let ahead = |aim: f64, second: Option<&DMatrix<f64>>| {
                let mut right = springs.lengths(&s_inverse) * aim - wanted;
                if let Some(second) = second {
                    right -= springs.lengths_of(second, &s_inverse);
                }
                let dy = schur.solve(&right);
                let mut change = springs.times(&k, &dy);
                if let Some(second) = second {
                    change += second;
                }
                let change = Bands::of(&change).times_transposed(&s_bands);
                let dk = (&s_inverse - constant) * aim - &k - (&change + change.transpose()) * 0.5;
                (springs.laplacian(&dy), dy, dk)
            };
            let (ds, dy, dk) = ahead(0.0, None);
            let (to_k, to_s) = (room(&k_full, &dk, 1.0, ROUGHLY), room(&s_full, &ds, 1.0, ROUGHLY));
            let predicted = (&k + &dk * to_k).dot(&(&s + &ds * to_s)) / dims;
            let is_behind = violation / FEASIBLE > gap / TOLERANCE;
            let least = if is_behind { UNHURRIED } else { 0.0 };
            let aim = mu * (predicted / mu).max(0.0).powi(3).clamp(least, 1.0);
            let (ds, dy, dk) = ahead(aim, Some(&springs.times(&dk, &dy)));
            let (to_k, to_s) =
                (room(&k_full, &dk, 1.0 / STEP, SHORTER), room(&s_full, &ds, 1.0 / STEP, SHORTER));
            if to_k.max(to_s) == 0.0 {
                break;
            }
            let (to_k, to_s) = (STEP * to_k, STEP * to_s);
            k += dk * to_k;
            y += dy * to_s;
            s += ds * to_s;
        }
        let (_, near, y) = kept;
        let ends = springs.edges.iter().map(|edge| (edge.from, edge.to));
        let inside = Inside { products: near * *mean, weights: ends.zip(y.iter().copied()).collect() };
        Ok(Unfolded { products: k * *mean, gap, violation, inside })
    }
}

/// How far one may go from `matrix` along `direction` and stay inside the cone, at most `far`;
/// a factorisation costs so little that trying is the quickest way to know.
fn room(matrix: &DMatrix<f64>, direction: &DMatrix<f64>, far: f64, shorter: f64) -> f64 {
    let mut step = far;
    for _ in 0..MOST_TRIALS {
        if Factor::of(Bands::of(&(matrix + direction * step))).is_some() {
            return step;
        }
        step *= shorter;
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

    /// a_eᵀ A B a_e of every edge, where B is symmetric.
    fn lengths_of(&self, a: &DMatrix<f64>, b: &DMatrix<f64>) -> DVector<f64> {
        let rows = a.transpose();
        // As slices: iterators over columns are slow where little is inlined.
        let (rows, columns) = (rows.as_slice(), b.as_slice());
        let length = |&Edge { from, to, .. }: &Edge| {
            let (from, to) = (self.column(from), self.column(to));
            let in_a = rows[from.clone()].iter().zip(&rows[to.clone()]);
            let in_b = columns[from].iter().zip(&columns[to]);
            let products =
                in_a.zip(in_b).map(|((a_from, a_to), (b_from, b_to))| (a_from - a_to) * (b_from - b_to));
            products.sum::<f64>()
        };
        DVector::from_iterator(self.edges.len(), self.edges.iter().map(length))
    }

    /// M_ef = (a_eᵀ K a_f)(a_eᵀ S⁻¹ a_f) with a_e = e_i − e_j; its lower triangle.
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
        Bands::lower(self.edges.len(), self.edges.chunks(WIDTH).map(band))
    }

    /// Where a column of a matrix of points lies in memory.
    fn column(&self, point: usize) -> Range<usize> {
        self.count * point..self.count * (point + 1)
    }

    /// The differences between two rows of the symmetric `a` for each of a few edges.
    fn differences(&self, a: &DMatrix<f64>, edges: &[Edge]) -> Vec<Quad> {
        let mut differences = vec![Quad::default(); self.count];
        for (row, &Edge { from, to, .. }) in edges.iter().enumerate() {
            let (from, to) = (&a.as_slice()[self.column(from)], &a.as_slice()[self.column(to)]);
            for ((values, from), to) in differences.iter_mut().zip(from).zip(to) {
                values[row] = from - to;
            }
        }
        differences
    }
}
