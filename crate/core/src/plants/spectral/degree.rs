//! Square roots of the degrees of samples. They are exact if there are few samples; if there are
//! many, they are exact near the threshold and approximate elsewhere.
//!
//! Samples near the threshold are first evaluated one by one against the source cells. This takes a
//! fraction of the time of the exact sum, which then remains for few samples.

use std::cell::OnceCell;
use std::ops::RangeInclusive;

use crate::numeric::sort;
use crate::numeric::stats::mean;
use crate::plants::signal::samples::Samples;
use crate::plants::spectral::affinity::{AffinityGraph, Kernel};
use crate::plants::spectral::cells::{PartitionedSamples, PrincipalAxes};
use crate::plants::spectral::expansion::Expansion;

/// Bandwidths at or below this count as zero: most samples are at rest, and the variance knee lies
/// within them.
const MIN_BANDWIDTH: f64 = 1e-30;
/// Maximum number of samples for summation over all pairs.
const DIRECT_MAX: usize = 3000;
/// Size of the first refinement batch against cells; the exact batch has a quarter. Each further
/// batch doubles.
const FIRST_BATCH: usize = 64;
/// Number of value bins in which the bias of the approximation is estimated.
const CALIBRATION_BINS: usize = 8;
/// Number of samples per bin for that estimate.
const SAMPLES_PER_BIN: usize = 16;
/// Maximum number of coordinate pairs per refinement step, about half a second. It is reached by an
/// hour of motion with too small a bandwidth or too wide a window for its cells.
const WORK_BUDGET: usize = 4_000_000_000;
/// Cost of a cell, in coordinates.
const CELL_COST: usize = 24;
/// Samples farther from the threshold than this multiple of the largest correction are not refined.
const SAFETY_FACTOR: f64 = 2.0;

/// Method of summation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Summation {
    /// Sums over all pairs.
    AllPairs,
    /// Approximates by cells and computes exactly near the threshold, if there are many samples.
    Cells,
}

/// Square roots of weighted degrees, by sample.
pub(crate) struct SqrtDegrees<'a> {
    pub values: Vec<f64>,
    /// Data for refining the values, if they are approximate.
    approximation: Option<ApproxDegrees<'a>>,
}

struct ApproxDegrees<'a> {
    axes: &'a PrincipalAxes,
    expansion: &'a Expansion,
    graph: AffinityGraph<'a>,
    weights: &'a [f64],
    /// Samples whose degrees are approximated.
    queries: &'a Samples,
    /// True if the queried samples are the samples of the graph, so that each sample includes
    /// itself.
    includes_self: bool,
    /// Accuracy of each value.
    accuracy: Vec<Accuracy>,
    /// Largest relative correction so far of values with accuracy `CellToCell` and `PointToCell`.
    max_correction: [f64; 2],
    /// Number of samples that may still be refined from either accuracy.
    budget: [usize; 2],
}

/// Accuracy of a value, in ascending order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Accuracy {
    /// Expanded about the cell of the sample and the cells of the graph.
    CellToCell,
    /// Expanded about the cells of the graph only.
    PointToCell,
    /// Summed over all pairs.
    Exact,
}

/// Weighted samples with respect to which degrees are computed.
pub(crate) struct DegreeQuery<'a> {
    pub samples: &'a PartitionedSamples,
    pub weights: &'a [f64],
    pub sigma: f64,
    pub kernel: Kernel,
    pub summation: Summation,
    /// Expansion of the samples, once computed.
    pub expansion: OnceCell<Expansion>,
}

impl DegreeQuery<'_> {
    /// Returns the square roots of the degrees of the samples; zeros if the bandwidth is zero.
    pub fn sqrt_degrees(&self) -> SqrtDegrees<'_> {
        self.compute(self.samples, true)
    }

    /// Returns the sqrt-degrees of query samples with respect to these samples; zeros if the
    /// bandwidth is zero.
    pub fn sqrt_degrees_of<'a>(&'a self, queries: &'a PartitionedSamples) -> SqrtDegrees<'a> {
        self.compute(queries, false)
    }

    fn compute<'a>(&'a self, queries: &'a PartitionedSamples, includes_self: bool) -> SqrtDegrees<'a> {
        let &DegreeQuery { samples: reference, weights, sigma, kernel, summation, .. } = self;
        if sigma <= MIN_BANDWIDTH {
            return vec![0.0; queries.samples.len()].into();
        }
        let samples = &reference.samples;
        let graph = AffinityGraph::new(samples, sigma, kernel);
        if summation == Summation::AllPairs || samples.len() <= DIRECT_MAX {
            let sums = if includes_self {
                graph.multiply(weights)
            } else {
                graph.multiply_for(&queries.samples, weights)
            };
            return sqrt_all(sums).into();
        }
        let cells = queries.cells(reference.axes());
        let expansion = self.expansion.get_or_init(|| {
            if includes_self {
                Expansion::new(kernel, sigma, &cells, weights)
            } else {
                Expansion::new(kernel, sigma, &reference.cells(reference.axes()), weights)
            }
        });
        let mut sums = expansion.sums(&cells);
        if includes_self {
            for (sum, weight) in sums.iter_mut().zip(weights) {
                *sum = (*sum - weight).max(0.0);
            }
        }
        let accuracy = vec![Accuracy::CellToCell; sums.len()];
        let (axes, queries) = (reference.axes(), &queries.samples);
        let budget =
            [expansion.cells() * CELL_COST, samples.len() * samples.dimension].map(|cost| WORK_BUDGET / cost);
        let approximation = ApproxDegrees {
            axes,
            expansion,
            graph,
            weights,
            queries,
            includes_self,
            accuracy,
            max_correction: [0.0; 2],
            budget,
        };
        let mut values = sqrt_all(sums);
        approximation.correct_bias(&mut values);
        SqrtDegrees { values, approximation: Some(approximation) }
    }
}

impl SqrtDegrees<'_> {
    /// Refines values from the threshold outwards, until the next value is several times farther
    /// from the threshold than the largest correction. Returns the range of old and new values, or
    /// `None` if nothing was refined.
    pub fn refine_near(&mut self, threshold: f64) -> Option<RangeInclusive<f64>> {
        let mut band = None;
        if threshold > 0.0 {
            // The first step leaves few samples for the expensive second step.
            for (from, to, first_batch) in [
                (Accuracy::CellToCell, Accuracy::PointToCell, FIRST_BATCH),
                (Accuracy::PointToCell, Accuracy::Exact, FIRST_BATCH / 4),
            ] {
                self.refine_step(threshold, from, to, first_batch, &mut band);
            }
        }
        band
    }

    /// Refines the values near the threshold from one accuracy to the next.
    fn refine_step(
        &mut self,
        threshold: f64,
        from: Accuracy,
        to: Accuracy,
        first_batch: usize,
        band: &mut Option<RangeInclusive<f64>>,
    ) {
        let Some(approximation) = &mut self.approximation else { return };
        let mut batch = first_batch;
        loop {
            let distance = |sample: usize| (self.values[sample] / threshold - 1.0).abs();
            let max_correction = approximation.max_correction[from as usize];
            // The size of the errors is unknown before the first batch.
            let reach = if max_correction > 0.0 { SAFETY_FACTOR * max_correction } else { f64::INFINITY };
            let candidates = (0..self.values.len()).filter(|&sample| approximation.accuracy[sample] == from);
            let budget = approximation.budget[from as usize];
            if budget == 0 {
                return;
            }
            let near = nearest(candidates.map(|sample| (distance(sample), sample)), reach, batch.min(budget));
            if near.is_empty() {
                return;
            }
            approximation.budget[from as usize] -= near.len();
            for (&sample, value) in near.iter().zip(approximation.evaluate(&near, to)) {
                let old = std::mem::replace(&mut self.values[sample], value);
                let (low, high) = band.take().map_or((old, old), RangeInclusive::into_inner);
                *band = Some(low.min(old).min(value)..=high.max(old).max(value));
                let correction = (old / value.max(f64::MIN_POSITIVE) - 1.0).abs();
                let max_correction = &mut approximation.max_correction[from as usize];
                *max_correction = max_correction.max(correction).max(f64::EPSILON);
                approximation.accuracy[sample] = to;
            }
            batch *= 2;
        }
    }
}

/// Returns the nearest samples within `reach`, at most `max`, given pairs of distance and sample.
fn nearest(samples: impl Iterator<Item = (f64, usize)>, reach: f64, max: usize) -> Vec<usize> {
    let mut near = Vec::new();
    for sample in samples.filter(|(distance, _)| *distance <= reach) {
        near.push(sample);
        // Truncating in between bounds the memory.
        if near.len() == 2 * max {
            sort::truncate_to_smallest(&mut near, max);
        }
    }
    sort::truncate_to_smallest(&mut near, max);
    near.into_iter().map(|(_, sample)| sample).collect()
}

impl From<Vec<f64>> for SqrtDegrees<'_> {
    fn from(values: Vec<f64>) -> Self {
        SqrtDegrees { values, approximation: None }
    }
}

impl ApproxDegrees<'_> {
    /// Corrects the bias of approximate values. Cells underestimate slightly on average, and class
    /// means of many values determine the threshold.
    fn correct_bias(&self, values: &mut [f64]) {
        let step = values.len().div_ceil(CALIBRATION_BINS * SAMPLES_PER_BIN);
        let every: Vec<f64> = values.iter().step_by(step).copied().collect();
        let calibration: Vec<usize> = sort::argsort(&every).into_iter().map(|n| n * step).collect();
        let point_to_cell = self.evaluate(&calibration, Accuracy::PointToCell);
        // `PointToCell` values are so accurate that one sample per bin determines their error.
        let middles: Vec<usize> = calibration.chunks(SAMPLES_PER_BIN).map(|bin| bin[bin.len() / 2]).collect();
        let exact = self.evaluate(&middles, Accuracy::Exact);
        let bins = calibration.chunks(SAMPLES_PER_BIN).zip(point_to_cell.chunks(SAMPLES_PER_BIN)).zip(exact);
        let corrections: Vec<(f64, f64)> = bins
            .map(|((bin, point_to_cell), exact)| {
                let approximate = mean(bin.iter().map(|&sample| values[sample]));
                let refined = mean(point_to_cell.iter().copied());
                (approximate, refined - approximate + exact - point_to_cell[bin.len() / 2])
            })
            .collect();
        for value in values {
            *value = (*value + interpolate(&corrections, *value)).max(0.0);
        }
    }

    /// Computes the square roots of the degrees of some samples with the given accuracy.
    fn evaluate(&self, samples: &[usize], accuracy: Accuracy) -> Vec<f64> {
        let mut sums = if accuracy == Accuracy::Exact {
            self.graph.multiply_for(&self.queries.select(samples.iter().copied()), self.weights)
        } else {
            let point = |&sample: &usize| self.axes.point(sample, self.queries.point(sample));
            samples.iter().map(|sample| self.expansion.at(&point(sample))).collect()
        };
        if self.includes_self {
            for (sum, &sample) in sums.iter_mut().zip(samples) {
                *sum = (*sum - self.weights[sample]).max(0.0);
            }
        }
        sqrt_all(sums)
    }
}

/// Returns the value at `x` of a piecewise linear function, given by points in ascending order;
/// constant beyond its ends.
fn interpolate(line: &[(f64, f64)], x: f64) -> f64 {
    let after = line.partition_point(|(start, _)| *start <= x);
    let (before, next) = (line[after.saturating_sub(1)], line[after.min(line.len() - 1)]);
    let width = next.0 - before.0;
    if width > 0.0 { before.1 + (next.1 - before.1) * (x - before.0) / width } else { before.1 }
}

fn sqrt_all(mut sums: Vec<f64>) -> Vec<f64> {
    sums.iter_mut().for_each(|sum| *sum = sum.sqrt());
    sums
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Samples of feet that alternate stance and swing, without repetition.
    fn gait(count: usize) -> PartitionedSamples {
        let points: Vec<f64> = (0..count)
            .flat_map(|index| {
                let time = index as f64 * 0.06;
                let swing = (time.sin() + 0.2 * (0.37 * time).sin()).max(0.0).powi(2);
                let noise = move |step: f64| 0.01 * (1.0 + (step * (index as f64 + 1.0)).sin());
                (0..3).flat_map(move |x| {
                    let shift = 0.02 * f64::from(x) * (time + 1.0).cos();
                    [0.6 * swing + noise(12.9898) + shift.abs(), 0.9 * swing + noise(78.233)]
                })
            })
            .collect();
        Samples::new(6, points).into()
    }

    fn query<'a>(
        samples: &'a PartitionedSamples,
        weights: &'a [f64],
        kernel: Kernel,
        summation: Summation,
    ) -> DegreeQuery<'a> {
        DegreeQuery { samples, weights, sigma: 0.15, kernel, summation, expansion: OnceCell::new() }
    }

    #[test]
    fn values_near_the_threshold_are_exact() {
        let (samples, queries) = (gait(4000), gait(4100));
        let weights: Vec<f64> = samples.samples.norms.iter().map(|norm| (-norm * norm).exp()).collect();
        for kernel in [Kernel::Gaussian, Kernel::Cauchy] {
            let [exact_query, cell_query] = [Summation::AllPairs, Summation::Cells]
                .map(|summation| query(&samples, &weights, kernel, summation));
            for (all, mut approximate) in [
                (exact_query.sqrt_degrees(), cell_query.sqrt_degrees()),
                (exact_query.sqrt_degrees_of(&queries), cell_query.sqrt_degrees_of(&queries)),
            ] {
                assert!(all.approximation.is_none() && approximate.approximation.is_some());
                let mut sorted = all.values.clone();
                sorted.sort_unstable_by(f64::total_cmp);
                for fraction in [0.2, 0.5, 0.7] {
                    let threshold = sorted[(fraction * sorted.len() as f64) as usize] * (1.0 + 1e-9);
                    approximate.refine_near(threshold);
                    assert!(approximate.refine_near(threshold).is_none(), "refined values remain refined");
                    for (all, approximate) in all.values.iter().zip(&approximate.values) {
                        assert!((all / approximate - 1.0).abs() < 0.02, "{all} {approximate}");
                        // Both have single precision within a block.
                        let is_tie = (all / threshold - 1.0).abs() < 1e-5;
                        assert!(
                            is_tie || (all > &threshold) == (approximate > &threshold),
                            "{all} {approximate} {threshold}"
                        );
                    }
                }
                let exact = approximate
                    .approximation
                    .as_ref()
                    .unwrap()
                    .accuracy
                    .iter()
                    .filter(|accuracy| **accuracy == Accuracy::Exact)
                    .count();
                assert!(exact < samples.samples.len(), "only some values are exact");
            }
        }
    }

    #[test]
    fn other_values_are_unbiased() {
        let samples = gait(4000);
        let weights = vec![1.0; 4000];
        for kernel in [Kernel::Gaussian, Kernel::Cauchy] {
            let [all, approximate] = [Summation::AllPairs, Summation::Cells]
                .map(|summation| query(&samples, &weights, kernel, summation));
            let [all, approximate] = [all.sqrt_degrees().values, approximate.sqrt_degrees().values];
            let deviation =
                mean(all.iter().zip(&approximate).map(|(all, approximate)| (approximate - all).powi(2)))
                    .sqrt();
            let bias = mean(all.iter().zip(&approximate).map(|(all, approximate)| approximate - all)).abs();
            // Three standard errors of the mean of the samples of the estimate.
            let max = 3.0 * deviation / ((CALIBRATION_BINS * SAMPLES_PER_BIN) as f64).sqrt();
            assert!(deviation > 0.0 && bias < max, "{bias} {max}");
        }
    }

    #[test]
    fn interpolation_is_linear_between_points() {
        let line = [(1.0, 10.0), (2.0, 20.0), (2.0, 30.0), (4.0, 40.0)];
        for (x, value) in [(0.0, 10.0), (1.0, 10.0), (1.5, 15.0), (3.0, 35.0), (4.0, 40.0), (9.0, 40.0)] {
            assert_eq!(interpolate(&line, x), value, "{x}");
        }
        assert_eq!(interpolate(&line[..1], 7.0), 10.0);
    }

    #[test]
    fn zero_bandwidth_and_invalid_thresholds_are_accepted() {
        let samples = gait(4000);
        let weights = vec![1.0; 4000];
        let query = query(&samples, &weights, Kernel::Cauchy, Summation::Cells);
        let mut field = query.sqrt_degrees();
        for threshold in [f64::NAN, f64::NEG_INFINITY, 0.0] {
            assert!(field.refine_near(threshold).is_none());
        }
        let zero = DegreeQuery { sigma: 0.0, expansion: OnceCell::new(), ..query };
        assert!(zero.sqrt_degrees().values.iter().all(|value| *value == 0.0));
        assert!(zero.sqrt_degrees().refine_near(1.0).is_none());
    }
}
