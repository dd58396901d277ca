//! Affinity graph of the samples and its products, of which degrees are a special case.
//!
//! The paper uses the eigenvector of the largest eigenvalue of D^-½ A D^-½. A has no negative
//! entry, so by the Perron–Frobenius theorem that eigenvector is √d, the square root of the
//! degrees, with eigenvalue 1. No eigensolver is needed. If the graph is numerically disconnected,
//! √d is still the answer, whereas a solver returns an arbitrary mixture.
//!
//! Every pair of samples is evaluated once, in blocks that the compiler vectorises: single
//! precision within a block, double precision across blocks. The relative error is below 1e-5 of
//! double precision.

use std::cell::OnceCell;
use std::ops::Range;

use crate::plants::signal::samples::Samples;

/// Kernel: affinity as a function of the distance x in units of σ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kernel {
    /// exp(−x²), the kernel of the paper (section 2.2).
    Gaussian,
    /// 1 / (1 + x²), whose heavy tail finds the edges of contact earlier.
    Cauchy,
}

/// Number of samples compared with one other at a time.
const LANES: usize = 16;
/// Number of samples in a block, whose sums are in single precision.
const BLOCK: usize = 128;

/// Maximum number of samples whose blocks are stored between products; they occupy up to 5 MB.
const MAX_KEPT_SAMPLES: usize = 200_000;

type Lanes = [f32; LANES];

/// Graph of the affinities of samples. Its matrix A is multiplied but never stored.
pub(crate) struct AffinityGraph<'a> {
    kernel: Kernel,
    /// Factor of the coordinates.
    factor: f64,
    samples: &'a Samples,
    /// The samples of each block, if there are few enough to keep them.
    blocks: OnceCell<Vec<Columns>>,
}

impl<'a> AffinityGraph<'a> {
    /// Creates the graph of `samples` with bandwidth `sigma`.
    pub fn new(samples: &'a Samples, sigma: f64, kernel: Kernel) -> AffinityGraph<'a> {
        let factor = match kernel {
            // exp(−x²) = 2^(−x² log₂ e): the factor is applied to the coordinates.
            Kernel::Gaussian => std::f64::consts::LOG2_E.sqrt() / sigma,
            Kernel::Cauchy => 1.0 / sigma,
        };
        AffinityGraph { kernel, factor, samples, blocks: OnceCell::new() }
    }

    /// Returns A·`weights`: for each i, the sum over j ≠ i of `weights[j]` × affinity of samples i
    /// and j.
    ///
    /// With weights of 1 the result is the degrees. The time is quadratic in the number of samples.
    pub fn multiply(&self, weights: &[f64]) -> Vec<f64> {
        let columns = Columns::new(self.samples, self.factor, 0, self.samples.len());
        match self.kernel {
            Kernel::Gaussian => columns.multiply(weights, power_of_two),
            Kernel::Cauchy => columns.multiply(weights, cauchy),
        }
    }

    /// Returns, for each query, the sum over j of `weights[j]` × affinity of the query and sample
    /// j.
    pub fn multiply_for(&self, queries: &Samples, weights: &[f64]) -> Vec<f64> {
        let queries = Columns::new(queries, self.factor, 0, queries.len());
        let mut sums = vec![0.0; queries.count];
        let mut add = |columns: &Columns, weights: &[f64]| match self.kernel {
            Kernel::Gaussian => columns.add_to(&mut sums, &queries, weights, power_of_two),
            Kernel::Cauchy => columns.add_to(&mut sums, &queries, weights, cauchy),
        };
        // Block by block, so that the samples of a block stay in the processor cache.
        if self.samples.len() <= MAX_KEPT_SAMPLES {
            let blocks = self.blocks.get_or_init(|| self.blocks().collect());
            blocks.iter().zip(weights.chunks(BLOCK)).for_each(|(block, weights)| add(block, weights));
        } else {
            self.blocks().zip(weights.chunks(BLOCK)).for_each(|(block, weights)| add(&block, weights));
        }
        sums
    }

    /// Returns the samples block by block.
    fn blocks(&self) -> impl Iterator<Item = Columns> {
        let count = self.samples.len();
        let block = move |start| Columns::new(self.samples, self.factor, start, BLOCK.min(count - start));
        (0..count).step_by(BLOCK).map(block)
    }
}

/// Returns 1 / (1 + x) for each x.
#[inline(always)]
fn cauchy(mut lanes: Lanes) -> Lanes {
    for lane in &mut lanes {
        *lane = 1.0 / (1.0 + *lane);
    }
    lanes
}

/// Returns 2^−x for each x ≥ 0 with a relative error of 2.5e-7; 2^−60 for x ≥ 60.
#[inline(always)]
pub(crate) fn power_of_two<const COUNT: usize>(mut lanes: [f32; COUNT]) -> [f32; COUNT] {
    // Subtracting from this constant rounds to an integer, which remains in the low bits.
    const ROUND: f32 = 1.5 * (1 << 23) as f32;
    for lane in &mut lanes {
        // A call to `min` is not vectorised in WebAssembly.
        let x = if *lane < 60.0 { *lane } else { 60.0 };
        let rounded = ROUND - x;
        let f = ROUND - rounded - x;
        // Minimax polynomial of degree 5 for 2^f, |f| ≤ ½, with the exact first two coefficients.
        let power = 1.0
            + f * (std::f32::consts::LN_2
                + f * (0.240_222_83 + f * (0.055_505_585 + f * (0.009_669_692 + f * 0.001_330_060_8))));
        *lane = f32::from_bits(power.to_bits().wrapping_add(rounded.to_bits() << 23));
    }
    lanes
}

/// Samples by coordinate, padded to whole lanes with samples of weight 0.
struct Columns {
    /// Number of samples.
    count: usize,
    /// Dimension × padded count.
    coordinates: Vec<f32>,
    padded: usize,
}

impl Columns {
    /// Arranges `count` samples from index `first`.
    fn new(samples: &Samples, factor: f64, first: usize, count: usize) -> Columns {
        let padded = count.next_multiple_of(LANES);
        let mut coordinates = vec![0.0; samples.dimension * padded];
        for index in 0..count {
            for (axis, value) in samples.point(first + index).iter().enumerate() {
                coordinates[axis * padded + index] = (f64::from(*value) * factor) as f32;
            }
        }
        Columns { count, coordinates, padded }
    }

    /// Returns single-precision weights with zeros for the padding.
    fn pad(&self, weights: &[f64]) -> Vec<f32> {
        let mut padded = vec![0.0; self.padded];
        for (index, weight) in padded.iter_mut().zip(weights) {
            *index = *weight as f32;
        }
        padded
    }

    /// Adds the weighted affinities of queries to the samples of one block.
    fn add_to(
        &self,
        sums: &mut [f64],
        queries: &Columns,
        weights: &[f64],
        affinity: impl Fn(Lanes) -> Lanes,
    ) {
        let weights = self.pad(weights);
        for (i, sum) in sums.iter_mut().enumerate() {
            let mut lanes: Lanes = [0.0; LANES];
            for (chunk, weights) in weights.chunks_exact(LANES).enumerate() {
                let affinities = affinity(self.squared_distances(queries, i, chunk * LANES));
                for (lane, (affinities, weight)) in lanes.iter_mut().zip(affinities.iter().zip(weights)) {
                    *lane += weight * affinities;
                }
            }
            *sum += f64::from(lanes.iter().sum::<f32>());
        }
    }

    fn multiply(&self, weights: &[f64], affinity: impl Fn(Lanes) -> Lanes + Copy) -> Vec<f64> {
        let padded_weights = self.pad(weights);
        let mut degrees = vec![0.0; self.padded];
        let blocks = || (0..self.padded).step_by(BLOCK).map(|start| start..self.padded.min(start + BLOCK));
        for (done, first) in blocks().enumerate() {
            for second in blocks().skip(done) {
                let sums = self.block(first.clone(), second.clone(), &padded_weights, affinity);
                // A block with itself contains both entries of each pair in its rows.
                let both = if first == second { 1 } else { 2 };
                for (index, sums) in [first.clone(), second].into_iter().zip(&sums).take(both) {
                    for (degree, sum) in degrees[index].iter_mut().zip(sums) {
                        *degree += f64::from(*sum);
                    }
                }
            }
        }
        degrees.truncate(self.count);
        degrees
    }

    /// Returns the contributions of two blocks of samples to each other's degrees.
    #[inline(always)]
    fn block(
        &self,
        first: Range<usize>,
        second: Range<usize>,
        weights: &[f32],
        affinity: impl Fn(Lanes) -> Lanes,
    ) -> [[f32; BLOCK]; 2] {
        let (mut rows, mut columns) = ([0.0; BLOCK], [0.0; BLOCK]);
        for (i, sum) in first.zip(&mut rows) {
            let mut lanes: Lanes = [0.0; LANES];
            for (j, column_sums) in second.clone().step_by(LANES).zip(columns.chunks_exact_mut(LANES)) {
                let mut affinities = affinity(self.squared_distances(self, i, j));
                if (j..j + LANES).contains(&i) {
                    // A sample is not its own neighbour.
                    affinities[i - j] = 0.0;
                }
                let there = &weights[j..j + LANES];
                for lane in 0..LANES {
                    lanes[lane] += there[lane] * affinities[lane];
                    column_sums[lane] += weights[i] * affinities[lane];
                }
            }
            *sum = lanes.iter().sum();
        }
        [rows, columns]
    }

    /// Returns the squared distances from query i to samples j, j + 1, ….
    #[inline(always)]
    fn squared_distances(&self, queries: &Columns, i: usize, j: usize) -> Lanes {
        let mut distances = [0.0; LANES];
        let coordinates =
            self.coordinates.chunks_exact(self.padded).zip(queries.coordinates.chunks_exact(queries.padded));
        for (column, other) in coordinates {
            let here = other[i];
            for (square, there) in distances.iter_mut().zip(&column[j..j + LANES]) {
                let difference = here - there;
                *square += difference * difference;
            }
        }
        distances
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{DMatrix, DVector, SymmetricEigen};
    use proptest::prelude::*;

    use super::*;

    /// Product by the definition, in double precision.
    fn multiply_by_definition(samples: &Samples, sigma: f64, kernel: Kernel, weights: &[f64]) -> Vec<f64> {
        let affinity = affinity_matrix(samples, sigma, kernel);
        (affinity * DVector::from_column_slice(weights)).iter().copied().collect()
    }

    fn affinity_matrix(samples: &Samples, sigma: f64, kernel: Kernel) -> DMatrix<f64> {
        DMatrix::from_fn(samples.len(), samples.len(), |i, j| {
            let pairs = samples.point(i).iter().zip(samples.point(j));
            let square =
                pairs.map(|(&a, &b)| (f64::from(a) - f64::from(b)).powi(2)).sum::<f64>() / (sigma * sigma);
            match kernel {
                _ if i == j => 0.0,
                Kernel::Gaussian => (-square).exp(),
                Kernel::Cauchy => 1.0 / (1.0 + square),
            }
        })
    }

    /// Eigenvectors of Ω^½ D^-½ A D^-½ Ω^½, with D the weighted degrees, by a dense solver.
    fn eigen_by_dense_solver(
        samples: &Samples,
        sigma: f64,
        kernel: Kernel,
        weights: &[f64],
    ) -> SymmetricEigen<f64, nalgebra::Dyn> {
        let count = samples.len();
        let affinity = affinity_matrix(samples, sigma, kernel);
        let degree = &affinity * DVector::from_column_slice(weights);
        let scaling =
            DMatrix::from_diagonal(&DVector::from_fn(count, |i, _| (weights[i] / degree[i]).sqrt()));
        SymmetricEigen::new(&scaling * affinity * &scaling)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        /// Compares the closed form with a dense eigensolver if the graph is connected well enough
        /// for the eigenvector to be unique.
        #[test]
        fn the_leading_eigenvector_is_the_sqrt_of_the_degrees(
            points in prop::collection::vec(0.0..1.0_f64, 2 * 6..2 * 40),
            sigma in 0.05..0.5_f64,
            weighted in any::<bool>(),
        ) {
            let samples = Samples::new(2, points[..points.len() / 2 * 2].to_vec());
            let weights: Vec<f64> =
                samples.norms.iter().map(|norm| if weighted { (-norm * norm).exp() } else { 1.0 }).collect();
            for kernel in [Kernel::Gaussian, Kernel::Cauchy] {
                let eigen = eigen_by_dense_solver(&samples, sigma, kernel, &weights);
                let mut order: Vec<usize> = (0..samples.len()).collect();
                order.sort_by(|&a, &b| eigen.eigenvalues[b].total_cmp(&eigen.eigenvalues[a]));
                if 1.0 - eigen.eigenvalues[order[1]] <= 1e-8 {
                    continue;
                }
                prop_assert!((eigen.eigenvalues[order[0]] - 1.0).abs() < 1e-10);
                let found = multiply_by_definition(&samples, sigma, kernel, &weights);
                let closed_form = DVector::from_iterator(
                    samples.len(),
                    found.iter().zip(&weights).map(|(degree, weight)| (degree * weight).sqrt()),
                ).normalize();
                let solved = eigen.eigenvectors.column(order[0]).map(f64::abs);
                prop_assert!((closed_form - solved).amax() < 1e-6);
            }
        }
    }

    proptest! {
        #[test]
        fn products_agree_with_the_definition(
            seed in prop::collection::vec(0.0..1.0_f64, 6 * 3..6 * 40),
            copies in 1_usize..20,
            sigma in 0.05..2.0_f64,
            weighted in any::<bool>(),
        ) {
            // Many samples from few, each with a small offset from its original.
            let seed = &seed[..seed.len() / 6 * 6];
            let points = (0..copies).flat_map(|copy| seed.iter().map(move |x| x + copy as f64 * 1e-3)).collect();
            let samples = Samples::new(6, points);
            let weights: Vec<f64> =
                samples.norms.iter().map(|norm| if weighted { (-norm * norm).exp() } else { 1.0 }).collect();
            for kernel in [Kernel::Gaussian, Kernel::Cauchy] {
                let found = AffinityGraph::new(&samples, sigma, kernel).multiply(&weights);
                let expected = multiply_by_definition(&samples, sigma, kernel, &weights);
                let own = AffinityGraph::new(&samples, sigma, kernel).multiply_for(&samples, &weights);
                for ((own, weight), expected) in own.iter().zip(&weights).zip(&expected) {
                    // A query that is one of the samples includes its affinity to itself.
                    prop_assert!((own - weight - expected).abs() <= 1e-5 * own + 1e-12);
                }
                for (found, expected) in found.iter().zip(expected) {
                    prop_assert!((found - expected).abs() <= 1e-5 * expected + 1e-12, "{found} {expected}");
                }
            }
        }
    }

    #[test]
    fn powers_of_two_agree_with_the_standard_library() {
        for step in 0..600_000 {
            let x = step as f32 * 1e-4;
            let error = f64::from(power_of_two([x])[0]) * f64::from(x).exp2() - 1.0;
            assert!(error.abs() < 2.5e-7, "{x}: {error}");
        }
        assert_eq!(power_of_two([60.0, 1e9, f32::INFINITY]), [(-60_f32).exp2(); 3]);
    }

    #[test]
    fn a_sample_is_not_its_own_neighbour() {
        let distant = Samples::new(2, vec![0.0, 0.0, 9e9, 0.0]);
        assert!(
            AffinityGraph::new(&distant, 1.0, Kernel::Gaussian)
                .multiply(&[1.0; 2])
                .iter()
                .all(|degree| *degree < 1e-17)
        );
        let equal = Samples::new(2, vec![0.5, 0.0, 0.5, 0.0]);
        assert_eq!(AffinityGraph::new(&equal, 1.0, Kernel::Cauchy).multiply(&[2.0, 3.0]), [3.0, 2.0]);
    }
}
