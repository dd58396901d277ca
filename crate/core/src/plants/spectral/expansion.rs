//! Sums of affinities over many samples, by expansion about cells.
//!
//! The affinity f(|y − y′|²) of a sample and the samples of a cell is expanded in a series about
//! the centres of both cells. A source cell contributes its weight, centre and second moments; a
//! target cell uses value, gradient and Hessian. The error is of third order in the size of a cell,
//! in units of the bandwidth. The sum over all pairs of n samples takes time proportional to n and
//! to the product of the numbers of cells.
//!
//! Eight neighbouring source cells have a parent, which stands for them wherever the error of its own
//! expansion is small enough: most source cells are far from a target.
//!
//! The error of the target expansion differs for each target, while the errors of many source cells
//! almost cancel: a single sample evaluated without a target cell is close to exact.

use crate::plants::spectral::affinity::Kernel;
use crate::plants::spectral::cells::{Cells, DIMS, Point};
use crate::plants::spectral::source_cells::{
    LANES, LEADING_AXES, Lanes, Parents, Sources, TRIANGLE, ZEROS, entries, source_moments,
};

/// Samples farther from the centre of their cell than this, in units of the bandwidth, are
/// evaluated one by one because the series is short …
const FAR_DISTANCE: f32 = 0.3;
/// … but at most one in this many samples, the farthest first.
const SAMPLES_PER_FAR: usize = 100;

/// A parent stands for its cells if the estimated error is at most this fraction of the sum over all
/// parents. Chosen on generated motion (seeds 0 to 2), where two thirds of the cells are then left out and
/// no label differs from those without parents.
const PARENT_ERROR: f32 = 5e-4;
/// A parent is also divided if its squared extent times this exceeds 1 plus its squared distance, both in
/// units of the bandwidth: the series does not describe samples around the target.
const SURROUNDING: f32 = 4.0;

/// Returns the sum over all sources at a point with the squared distance `residual` from the
/// principal subspace.
#[inline(always)]
fn value_at(position: &[f32; DIMS], residual: f32, sources: &[Sources], kernel: Kernel) -> f32 {
    let mut value = ZEROS;
    for source in sources {
        let (offset, squared) = source.offsets(position, residual);
        let [f, f1, f2, _] = derivatives(kernel, squared);
        let product = source.moment_product(&offset);
        for lane in 0..LANES {
            let mut along = 0.0;
            for axis in 0..LEADING_AXES {
                along += offset[axis][lane] * product[axis][lane];
            }
            value[lane] +=
                source.weight[lane] * f[lane] + f1[lane] * source.trace[lane] + 2.0 * f2[lane] * along;
        }
    }
    value.iter().sum()
}

/// Sources that are summed over for one target.
#[derive(Default)]
struct Selection {
    /// Parents, without those that are divided.
    parents: Vec<Sources>,
    /// Indices of the sources whose parents are divided.
    divided: Vec<usize>,
    /// Estimated errors of the parents.
    errors: Vec<Lanes>,
}

impl Selection {
    /// Divides the parents whose estimated error is too large.
    ///
    /// The error is that of the terms of third order and the first ones of fourth order, with the standard
    /// deviation of the samples of a parent as its extent, and that of the second moments along the axes that
    /// have none. The derivatives are those at the nearest place that a cell of the parent can have, as in the
    /// remainder of a Taylor series: there may be a cell of small weight far from the centre.
    #[inline(always)]
    fn select(&mut self, parents: &Parents, position: &[f32; DIMS], residual: f32, kernel: Kernel) {
        let mut sums = ZEROS;
        self.errors.clear();
        for (parent, radius) in parents.cells.iter().zip(&parents.radii) {
            let (_, squared) = parent.offsets(position, residual);
            let [f, ..] = derivatives(kernel, squared);
            let nearest = std::array::from_fn(|lane| (squared[lane].sqrt() - radius[lane]).max(0.0).powi(2));
            let [_, _, f2, f3] = derivatives(kernel, nearest);
            let mut minor = parent.trace;
            for (moments, _) in
                parent.moments.iter().zip(entries()).filter(|(_, (row, column))| row == column)
            {
                minor.iter_mut().zip(moments).for_each(|(minor, moment)| *minor -= moment);
            }
            let mut errors = ZEROS;
            for lane in 0..LANES {
                let (weight, trace) = (parent.weight[lane], parent.trace[lane]);
                sums[lane] += weight * f[lane];
                // The trace is the weight times the square of the extent.
                let (square, curvature) = (trace / weight.max(f32::MIN_POSITIVE), f2[lane].abs());
                let change = f3[lane].abs() * squared[lane];
                let third_order = (squared[lane] * square).sqrt() * (2.0 * curvature + 4.0 / 3.0 * change);
                let fourth_order = square * (0.5 * curvature + 2.0 * change);
                let surrounds = SURROUNDING * square > 1.0 + squared[lane];
                let error =
                    trace * (third_order + fourth_order) + 2.0 * minor[lane] * curvature * squared[lane];
                errors[lane] = if surrounds { f32::INFINITY } else { error };
            }
            self.errors.push(errors);
        }
        let limit = PARENT_ERROR * sums.iter().sum::<f32>();
        self.parents.clear();
        self.parents.extend_from_slice(&parents.cells);
        self.divided.clear();
        for (block, (parents, errors)) in self.parents.iter_mut().zip(&self.errors).enumerate() {
            let is_divided = errors.map(|error| error > limit);
            parents.remove(is_divided);
            self.divided.extend((0..LANES).filter(|&lane| is_divided[lane]).map(|lane| block * LANES + lane));
        }
    }
}

/// Expansion of the sum over all sources about the centre of a target cell.
struct LocalExpansion {
    value: f32,
    gradient: [f32; DIMS],
    /// Anisotropic part of the Hessian.
    hessian: [f32; TRIANGLE],
    /// Half of the isotropic part of the Hessian.
    isotropic: f32,
}

/// Expanded sources for one bandwidth.
pub(crate) struct Expansion {
    kernel: Kernel,
    /// Factor of lengths.
    scale: f32,
    sources: Vec<Sources>,
    parents: Parents,
}

impl Expansion {
    /// Creates the expansion of weighted samples; `sigma` is the bandwidth in the units of the
    /// cells.
    pub fn new(kernel: Kernel, sigma: f64, cells: &Cells, weights: &[f64]) -> Expansion {
        let sources = source_moments(cells, weights, 1.0 / sigma);
        let parents = Parents::new(&sources);
        Expansion { kernel, scale: (1.0 / sigma) as f32, sources, parents }
    }

    /// Returns the number of source cells, at least one.
    pub fn cells(&self) -> usize {
        LANES * self.sources.len().max(1)
    }

    /// Returns the weighted sum of affinities to all sources for each sample of `targets`.
    pub fn sums(&self, targets: &Cells) -> Vec<f64> {
        let scale = self.scale;
        let mut sums = vec![0.0; targets.points.len()];
        let mut far = Vec::new();
        let mut selected = Selection::default();
        for (range, centre) in &targets.targets {
            let points = &targets.points[range.clone()];
            let position = centre.map(|position| position * scale);
            let mean =
                points.iter().map(|point| point.residual).sum::<f32>() / points.len() as f32 * scale * scale;
            let local = self.local(&position, mean, &mut selected);
            for point in points {
                let offset: [f32; DIMS] =
                    std::array::from_fn(|axis| (point.coords[axis] - centre[axis]) * scale);
                let residual = point.residual * scale * scale - mean;
                sums[point.index as usize] = f64::from(local.at(offset, residual)).max(0.0);
                let square = offset.iter().map(|offset| offset * offset).sum::<f32>() + residual.abs();
                if square > FAR_DISTANCE * FAR_DISTANCE {
                    far.push((square, point));
                }
            }
        }
        let max = sums.len() / SAMPLES_PER_FAR;
        if far.len() > max {
            far.select_nth_unstable_by(max, |a, b| b.0.total_cmp(&a.0).then(a.1.index.cmp(&b.1.index)));
            far.truncate(max);
        }
        for (_, point) in far {
            sums[point.index as usize] = self.at(point);
        }
        sums
    }

    /// Returns the expansion about a target. Parents stand for their sources where that is accurate
    /// enough.
    #[inline(always)]
    fn local(&self, position: &[f32; DIMS], residual: f32, selected: &mut Selection) -> LocalExpansion {
        selected.select(&self.parents, position, residual, self.kernel);
        let Selection { parents, divided, .. } = &*selected;
        let sources = divided.iter().map(|&index| &self.sources[index]);
        LocalExpansion::new(position, residual, parents.iter().chain(sources), self.kernel)
    }

    /// Returns the sum for one sample, without a target expansion.
    pub fn at(&self, point: &Point) -> f64 {
        let position = point.coords.map(|position| position * self.scale);
        let residual = point.residual * self.scale * self.scale;
        let sum = value_at(&position, residual, &self.sources, self.kernel);
        f64::from(sum).max(0.0)
    }
}

/// Returns the kernel and its first three derivatives, as functions of the squared distance.
#[inline(always)]
fn derivatives(kernel: Kernel, squared: Lanes) -> [Lanes; 4] {
    match kernel {
        Kernel::Gaussian => gaussian(squared),
        Kernel::Cauchy => cauchy(squared),
    }
}

/// Returns f, f′, f″ and f‴ of exp(−x) at squared distances x.
#[inline(always)]
fn gaussian(squared: Lanes) -> [Lanes; 4] {
    let value = crate::plants::spectral::affinity::power_of_two(
        squared.map(|square| square * std::f32::consts::LOG2_E),
    );
    let minus = value.map(|value| -value);
    [value, minus, value, minus]
}

/// Returns f, f′, f″ and f‴ of 1 / (1 + x) at squared distances x.
#[inline(always)]
fn cauchy(squared: Lanes) -> [Lanes; 4] {
    let value = squared.map(|square| 1.0 / (1.0 + square));
    let first = value.map(|value| -value * value);
    let second = value.map(|value| 2.0 * value * value * value);
    let third = value.map(|value| -6.0 * (value * value) * (value * value));
    [value, first, second, third]
}

impl LocalExpansion {
    #[inline(always)]
    fn new<'a>(
        centre: &[f32; DIMS],
        residual: f32,
        sources: impl Iterator<Item = &'a Sources>,
        kernel: Kernel,
    ) -> LocalExpansion {
        let mut value = ZEROS;
        let mut isotropic = ZEROS;
        let mut gradient = [ZEROS; DIMS];
        let mut hessian = [ZEROS; TRIANGLE];
        for source in sources {
            let (offset, squared) = source.offsets(centre, residual);
            let [f, f1, f2, f3] = derivatives(kernel, squared);
            let product = source.moment_product(&offset);
            let mut along = ZEROS;
            for axis in 0..LEADING_AXES {
                for lane in 0..LANES {
                    along[lane] += offset[axis][lane] * product[axis][lane];
                }
            }
            let (mut gradient_factor, mut moment_factor, mut hessian_factor) = (ZEROS, ZEROS, ZEROS);
            for lane in 0..LANES {
                let (weight, trace) = (source.weight[lane], source.trace[lane]);
                value[lane] += weight * f[lane] + f1[lane] * trace + 2.0 * f2[lane] * along[lane];
                isotropic[lane] += weight * f1[lane];
                gradient_factor[lane] =
                    2.0 * (weight * f1[lane] + f2[lane] * trace + 2.0 * f3[lane] * along[lane]);
                moment_factor[lane] = 4.0 * f2[lane];
                hessian_factor[lane] = 4.0 * weight * f2[lane];
            }
            let mut entry = 0;
            for row in 0..DIMS {
                for lane in 0..LANES {
                    gradient[row][lane] += gradient_factor[lane] * offset[row][lane];
                }
            }
            for row in 0..LEADING_AXES {
                let mut scaled = ZEROS;
                for lane in 0..LANES {
                    gradient[row][lane] += moment_factor[lane] * product[row][lane];
                    scaled[lane] = hessian_factor[lane] * offset[row][lane];
                }
                for along in &offset[..=row] {
                    for lane in 0..LANES {
                        hessian[entry][lane] += scaled[lane] * along[lane];
                    }
                    entry += 1;
                }
            }
        }
        let sum = |lanes: Lanes| lanes.iter().sum();
        LocalExpansion {
            value: sum(value),
            gradient: gradient.map(sum),
            hessian: hessian.map(sum),
            isotropic: sum(isotropic),
        }
    }

    /// Returns the sum at an offset from the centre; `residual` is relative to the mean of the
    /// cell.
    fn at(&self, offset: [f32; DIMS], residual: f32) -> f32 {
        let square: f32 = offset.iter().map(|offset| offset * offset).sum();
        let mut sum = self.value + self.isotropic * (residual + square);
        for (gradient, offset) in self.gradient.iter().zip(offset) {
            sum += gradient * offset;
        }
        for (hessian, (row, column)) in self.hessian.iter().zip(entries()) {
            let factor = if row == column { 0.5 } else { 1.0 };
            sum += factor * hessian * offset[row] * offset[column];
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::plants::signal::samples::Samples;
    use crate::plants::spectral::cells::PrincipalAxes;

    fn affinity(kernel: Kernel, square: f64) -> f64 {
        match kernel {
            Kernel::Gaussian => (-square).exp(),
            Kernel::Cauchy => 1.0 / (1.0 + square),
        }
    }

    fn sum_by_definition(
        kernel: Kernel,
        samples: &Samples,
        weights: &[f64],
        sigma: f64,
        query: usize,
    ) -> f64 {
        let affinity =
            |other: usize| affinity(kernel, samples.squared_distance(query, other) / (sigma * sigma));
        (0..samples.len()).map(|other| weights[other] * affinity(other)).sum()
    }

    fn cells(samples: &Samples, max: usize) -> Cells {
        Cells::new(PrincipalAxes::new(samples).points(samples), max, max)
    }

    fn sums_by_expansion(
        kernel: Kernel,
        samples: &Samples,
        weights: &[f64],
        sigma: f64,
        max: usize,
    ) -> Vec<f64> {
        let cells = cells(samples, max);
        Expansion::new(kernel, sigma, &cells, weights).sums(&cells)
    }

    #[test]
    fn samples_far_from_their_cell_are_evaluated_one_by_one() {
        let near = |index: u32| [f64::from(index % 25) * 1e-3, f64::from(index % 40) * 1e-3];
        let samples = Samples::new(2, (0..999).flat_map(near).chain([0.7, -0.6]).collect());
        let weights = vec![1.0; samples.len()];
        for kernel in [Kernel::Gaussian, Kernel::Cauchy] {
            let actual = sums_by_expansion(kernel, &samples, &weights, 1.0, 1)[999];
            let expected = sum_by_definition(kernel, &samples, &weights, 1.0, 999);
            assert!((actual / expected - 1.0).abs() < 5e-3, "{actual} {expected}");
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]

        #[test]
        fn cells_of_one_sample_are_exact(
            values in prop::collection::vec(0.0..1.0_f64, 6 * 20),
            weights in prop::collection::vec(0.0..1.0_f64, 20),
            sigma in 0.1..1.0_f64,
        ) {
            let samples = Samples::new(6, values);
            for kernel in [Kernel::Gaussian, Kernel::Cauchy] {
                let cells = cells(&samples, 20);
                let expansion = Expansion::new(kernel, sigma, &cells, &weights);
                let with_parents = expansion.sums(&cells);
                for point in &cells.points {
                    let query = point.index as usize;
                    let expected = sum_by_definition(kernel, &samples, &weights, sigma, query);
                    let actual = expansion.at(point);
                    prop_assert!((actual - expected).abs() < 1e-5 * (1.0 + expected), "{actual} {expected}");
                    let actual = with_parents[query];
                    prop_assert!((actual / expected - 1.0).abs() < 2e-3, "{actual} {expected}");
                }
            }
        }

        /// Third order: with cells of a tenth of the bandwidth the error is about a thousandth.
        #[test]
        fn small_cells_are_accurate(
            seeds in prop::collection::vec(0.0..1.0_f64, 6 * 8),
            offsets in prop::collection::vec(-0.0625..0.0625_f64, 6 * 8 * 12),
            sigma in 0.9..1.1_f64,
        ) {
            let points = (0..12 * 8 * 6).map(|index| seeds[index % 48] + offsets[index] * 0.5).collect();
            let samples = Samples::new(6, points);
            let weights = vec![1.0; samples.len()];
            for kernel in [Kernel::Gaussian, Kernel::Cauchy] {
                let cells = cells(&samples, 48);
                let expansion = Expansion::new(kernel, sigma, &cells, &weights);
                let with_parents = expansion.sums(&cells);
                for point in &cells.points {
                    let query = point.index as usize;
                    let expected = sum_by_definition(kernel, &samples, &weights, sigma, query);
                    let actual = expansion.at(point);
                    prop_assert!((actual / expected - 1.0).abs() < 2e-3, "{actual} {expected}");
                    // There are six parents.
                    let actual = with_parents[query];
                    prop_assert!((actual / expected - 1.0).abs() < 5e-3, "{actual} {expected}");
                }
            }
        }

        #[test]
        fn distances_from_the_principal_subspace_count(
            values in prop::collection::vec(0.0..1.0_f64, 10 * 24),
        ) {
            // The last four of ten coordinates are almost constant.
            let shrink = |(index, value): (usize, f64)| if index % 10 < 6 { value } else { value * 0.05 };
            let samples = Samples::new(10, values.into_iter().enumerate().map(shrink).collect());
            let weights = vec![1.0; 24];
            for kernel in [Kernel::Gaussian, Kernel::Cauchy] {
                let actual = sums_by_expansion(kernel, &samples, &weights, 1.0, 24);
                for (query, actual) in actual.iter().enumerate() {
                    let expected = sum_by_definition(kernel, &samples, &weights, 1.0, query);
                    prop_assert!((actual / expected - 1.0).abs() < 5e-3, "{actual} {expected}");
                }
            }
        }
    }
}
