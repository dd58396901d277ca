//! Degrees: how much like all other samples each sample is.
//!
//! The paper takes the eigenvector of the largest eigenvalue of D^-½ A D^-½.
//! A has no negative entry, so by Perron and Frobenius that eigenvector is √d,
//! the square roots of the degrees, with eigenvalue 1: no eigensolver is
//! needed. Where the graph falls apart numerically, √d is still the answer
//! while a solver returns any mixture.
//!
//! Every pair of samples is looked at once, in blocks that the compiler turns
//! into SIMD: single precision within a block, double across blocks. Against
//! double precision throughout, the relative error stays below 1e-5.

use std::ops::Range;

use crate::plants::signal::samples::Samples;

/// How likeness falls off with distance x in units of σ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kernel {
    /// exp(−x²): the paper's (section 2.2).
    Gaussian,
    /// 1 / (1 + x²): its long tail finds the edges of contact sooner.
    Cauchy,
}

/// Samples that are compared with one other at a time.
const LANES: usize = 16;
/// Samples in a block: their sums stay in single precision.
const BLOCK: usize = 128;

type Lanes = [f32; LANES];

/// The graph of the likenesses of samples: its matrix A is never stored, only multiplied with.
pub(crate) struct Graph<'a> {
    kernel: Kernel,
    /// What coordinates are multiplied by.
    factor: f64,
    samples: &'a Samples,
}

impl<'a> Graph<'a> {
    /// The graph of `samples` for scale `sigma`.
    pub fn new(samples: &'a Samples, sigma: f64, kernel: Kernel) -> Graph<'a> {
        let factor = match kernel {
            // exp(−x²) = 2^(−x² log₂ e): the factor goes into the coordinates.
            Kernel::Gaussian => std::f64::consts::LOG2_E.sqrt() / sigma,
            Kernel::Cauchy => 1.0 / sigma,
        };
        Graph { kernel, factor, samples }
    }

    /// A·`weights`: Σ over j ≠ i of `weights[j]` × likeness of samples i and j, for each i.
    ///
    /// With weights of 1, these are the degrees. Takes time proportional to the
    /// square of the number of samples.
    pub fn times(&self, weights: &[f64]) -> Vec<f64> {
        let columns = Columns::of(self.samples, self.factor, 0, self.samples.len());
        match self.kernel {
            Kernel::Gaussian => columns.times(weights, power_of_two),
            Kernel::Cauchy => columns.times(weights, cauchy),
        }
    }

    /// Σ over j of `weights[j]` × likeness of each of `others` and sample j of the graph.
    pub fn towards(&self, others: &Samples, weights: &[f64]) -> Vec<f64> {
        let others = Columns::of(others, self.factor, 0, others.len());
        let mut sums = vec![0.0; others.count];
        // Block by block, so that what all others are compared with stays close at hand.
        for (block, weights) in weights.chunks(BLOCK).enumerate() {
            let columns = Columns::of(self.samples, self.factor, block * BLOCK, weights.len());
            match self.kernel {
                Kernel::Gaussian => columns.add_to(&mut sums, &others, weights, power_of_two),
                Kernel::Cauchy => columns.add_to(&mut sums, &others, weights, cauchy),
            }
        }
        sums
    }
}

/// 1 / (1 + x) for each x.
#[inline(always)]
fn cauchy(mut lanes: Lanes) -> Lanes {
    for lane in &mut lanes {
        *lane = 1.0 / (1.0 + *lane);
    }
    lanes
}

/// 2^−x for each x ≥ 0, with a relative error of 2.5e-7; from 60 on, 2^−60.
#[inline(always)]
pub(crate) fn power_of_two<const COUNT: usize>(mut lanes: [f32; COUNT]) -> [f32; COUNT] {
    // Taking away from this rounds to a whole number, which stays in the low bits.
    const ROUND: f32 = 1.5 * (1 << 23) as f32;
    for lane in &mut lanes {
        // A call to `min` would not become SIMD on wasm.
        let x = if *lane < 60.0 { *lane } else { 60.0 };
        let rounded = ROUND - x;
        let f = ROUND - rounded - x;
        // Of all polynomials of degree 5 that begin like 2^f, the closest to it for |f| ≤ ½.
        let power = 1.0
            + f * (std::f32::consts::LN_2
                + f * (0.240_222_83 + f * (0.055_505_585 + f * (0.009_669_692 + f * 0.001_330_060_8))));
        *lane = f32::from_bits(power.to_bits().wrapping_add(rounded.to_bits() << 23));
    }
    lanes
}

/// Samples by coordinate, filled up to whole lanes with samples that weigh nothing.
struct Columns {
    /// Number of samples.
    count: usize,
    /// Dimension × padded count.
    coordinates: Vec<f32>,
    padded: usize,
}

impl Columns {
    /// Of `count` samples from `first` on.
    fn of(samples: &Samples, factor: f64, first: usize, count: usize) -> Columns {
        let padded = count.next_multiple_of(LANES);
        let mut coordinates = vec![0.0; samples.dimension * padded];
        for place in 0..count {
            for (axis, value) in samples.point(first + place).iter().enumerate() {
                coordinates[axis * padded + place] = (f64::from(*value) * factor) as f32;
            }
        }
        Columns { count, coordinates, padded }
    }

    /// Single-precision weights, 0 for the samples that fill up.
    fn padded(&self, weights: &[f64]) -> Vec<f32> {
        let mut padded = vec![0.0; self.padded];
        for (place, weight) in padded.iter_mut().zip(weights) {
            *place = *weight as f32;
        }
        padded
    }

    /// Adds the likenesses of other samples to these of one block, weighted.
    fn add_to(&self, sums: &mut [f64], others: &Columns, weights: &[f64], likeness: impl Fn(Lanes) -> Lanes) {
        let weights = self.padded(weights);
        for (i, sum) in sums.iter_mut().enumerate() {
            let mut lanes: Lanes = [0.0; LANES];
            for (chunk, weights) in weights.chunks_exact(LANES).enumerate() {
                let alike = likeness(self.squares(others, i, chunk * LANES));
                for (lane, (alike, weight)) in lanes.iter_mut().zip(alike.iter().zip(weights)) {
                    *lane += weight * alike;
                }
            }
            *sum += f64::from(lanes.iter().sum::<f32>());
        }
    }

    fn times(&self, weights: &[f64], likeness: impl Fn(Lanes) -> Lanes + Copy) -> Vec<f64> {
        let padded_weights = self.padded(weights);
        let mut degrees = vec![0.0; self.padded];
        let blocks = || (0..self.padded).step_by(BLOCK).map(|start| start..self.padded.min(start + BLOCK));
        for (done, first) in blocks().enumerate() {
            for second in blocks().skip(done) {
                let sums = self.block(first.clone(), second.clone(), &padded_weights, likeness);
                // A block with itself has both of each pair among its rows.
                let both = if first == second { 1 } else { 2 };
                for (place, sums) in [first.clone(), second].into_iter().zip(&sums).take(both) {
                    for (degree, sum) in degrees[place].iter_mut().zip(sums) {
                        *degree += f64::from(*sum);
                    }
                }
            }
        }
        degrees.truncate(self.count);
        degrees
    }

    /// What two blocks of samples add to each other's degrees.
    #[inline(always)]
    fn block(
        &self,
        first: Range<usize>,
        second: Range<usize>,
        weights: &[f32],
        likeness: impl Fn(Lanes) -> Lanes,
    ) -> [[f32; BLOCK]; 2] {
        let (mut rows, mut columns) = ([0.0; BLOCK], [0.0; BLOCK]);
        for (i, sum) in first.zip(&mut rows) {
            let mut lanes: Lanes = [0.0; LANES];
            for (j, column_sums) in second.clone().step_by(LANES).zip(columns.chunks_exact_mut(LANES)) {
                let mut alike = likeness(self.squares(self, i, j));
                if (j..j + LANES).contains(&i) {
                    // A sample is not its own neighbour.
                    alike[i - j] = 0.0;
                }
                let there = &weights[j..j + LANES];
                for lane in 0..LANES {
                    lanes[lane] += there[lane] * alike[lane];
                    column_sums[lane] += weights[i] * alike[lane];
                }
            }
            *sum = lanes.iter().sum();
        }
        [rows, columns]
    }

    /// Squared distances from sample i of others to those from j on of these.
    #[inline(always)]
    fn squares(&self, others: &Columns, i: usize, j: usize) -> Lanes {
        let mut squares = [0.0; LANES];
        let both =
            self.coordinates.chunks_exact(self.padded).zip(others.coordinates.chunks_exact(others.padded));
        for (column, other) in both {
            let here = other[i];
            for (square, there) in squares.iter_mut().zip(&column[j..j + LANES]) {
                let off = here - there;
                *square += off * off;
            }
        }
        squares
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::DMatrix;
    use nalgebra::DVector;
    use nalgebra::SymmetricEigen;
    use proptest::prelude::*;

    use super::*;

    /// The definition, in double precision throughout.
    fn plain(samples: &Samples, sigma: f64, kernel: Kernel, weights: &[f64]) -> Vec<f64> {
        let affinity = affinity(samples, sigma, kernel);
        (affinity * DVector::from_column_slice(weights)).iter().copied().collect()
    }

    fn affinity(samples: &Samples, sigma: f64, kernel: Kernel) -> DMatrix<f64> {
        DMatrix::from_fn(samples.len(), samples.len(), |i, j| {
            let between = samples.point(i).iter().zip(samples.point(j));
            let square =
                between.map(|(&a, &b)| (f64::from(a) - f64::from(b)).powi(2)).sum::<f64>() / (sigma * sigma);
            match kernel {
                _ if i == j => 0.0,
                Kernel::Gaussian => (-square).exp(),
                Kernel::Cauchy => 1.0 / (1.0 + square),
            }
        })
    }

    /// Ω^½ D^-½ A D^-½ Ω^½ with D the weighted degrees, and its eigenvectors by a dense solver.
    fn dense(
        samples: &Samples,
        sigma: f64,
        kernel: Kernel,
        weights: &[f64],
    ) -> SymmetricEigen<f64, nalgebra::Dyn> {
        let count = samples.len();
        let affinity = affinity(samples, sigma, kernel);
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
            let samples = Samples::new(2, points[..points.len() / 2 * 2].to_vec());
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
                let found = plain(&samples, sigma, kernel, &weights);
                let ours = DVector::from_iterator(
                    samples.len(),
                    found.iter().zip(&weights).map(|(degree, weight)| (degree * weight).sqrt()),
                ).normalize();
                let theirs = eigen.eigenvectors.column(order[0]).map(f64::abs);
                prop_assert!((ours - theirs).amax() < 1e-6);
            }
        }
    }

    proptest! {
        #[test]
        fn blocks_add_up_to_the_definition(
            seed in prop::collection::vec(0.0..1.0_f64, 6 * 3..6 * 40),
            copies in 1_usize..20,
            sigma in 0.05..2.0_f64,
            anchored in any::<bool>(),
        ) {
            // Many samples from few, each a little off its original.
            let seed = &seed[..seed.len() / 6 * 6];
            let points = (0..copies).flat_map(|copy| seed.iter().map(move |x| x + copy as f64 * 1e-3)).collect();
            let samples = Samples::new(6, points);
            let weights: Vec<f64> =
                samples.norms.iter().map(|norm| if anchored { (-norm * norm).exp() } else { 1.0 }).collect();
            for kernel in [Kernel::Gaussian, Kernel::Cauchy] {
                let found = Graph::new(&samples, sigma, kernel).times(&weights);
                let expected = plain(&samples, sigma, kernel, &weights);
                let own = Graph::new(&samples, sigma, kernel).towards(&samples, &weights);
                for ((own, weight), expected) in own.iter().zip(&weights).zip(&expected) {
                    // Towards a graph that holds it, a sample meets itself.
                    prop_assert!((own - weight - expected).abs() <= 1e-5 * own + 1e-12);
                }
                for (found, expected) in found.iter().zip(expected) {
                    prop_assert!((found - expected).abs() <= 1e-5 * expected + 1e-12, "{found} {expected}");
                }
            }
        }
    }

    #[test]
    fn powers_of_two_are_those_of_the_standard_library() {
        for step in 0..600_000 {
            let x = step as f32 * 1e-4;
            let error = f64::from(power_of_two([x])[0]) * f64::from(x).exp2() - 1.0;
            assert!(error.abs() < 2.5e-7, "{x}: {error}");
        }
        assert_eq!(power_of_two([60.0, 1e9, f32::INFINITY]), [(-60_f32).exp2(); 3]);
    }

    #[test]
    fn a_sample_is_not_its_own_neighbour() {
        let alone = Samples::new(2, vec![0.0, 0.0, 9e9, 0.0]);
        assert!(
            Graph::new(&alone, 1.0, Kernel::Gaussian).times(&[1.0; 2]).iter().all(|degree| *degree < 1e-17)
        );
        let twins = Samples::new(2, vec![0.5, 0.0, 0.5, 0.0]);
        assert_eq!(Graph::new(&twins, 1.0, Kernel::Cauchy).times(&[2.0, 3.0]), [3.0, 2.0]);
    }
}
