//! The roots of the degrees of samples: exact for few samples, and for many wherever it matters.

use super::cells::Grouped;
use super::degree::{Graph, Kernel};
use super::expansion;
use super::samples::Samples;

/// A scale no larger than this is none: so many samples are at rest that the knee is among them.
const AT_REST: f64 = 1e-30;
/// Up to this many samples, all pairs are looked at.
const FEW: usize = 3000;
/// Samples that are made exact at first; then twice as many, and so on.
const FIRST: usize = 64;
/// How many times the largest correction so far a sample has to be from the threshold to stay as it is.
const SAFETY: f64 = 2.0;

/// Which pairs of samples are looked at one by one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Pairs {
    /// All of them.
    All,
    /// Where there are many samples, only those that decide.
    Few,
}

/// The roots of weighted degrees, by sample.
pub(super) struct Roots<'a> {
    pub values: Vec<f64>,
    /// What it takes to make values exact, where they are only close.
    close: Option<Close<'a>>,
}

struct Close<'a> {
    graph: Graph,
    weights: &'a [f64],
    /// The samples whose roots they are.
    of: &'a Samples,
    /// Whether each sample is among those that it is compared with, and so meets itself.
    meets_itself: bool,
    is_exact: Vec<bool>,
    /// The largest correction so far, relative to the value.
    worst: f64,
}

/// Samples, weighted, among which others have degrees.
#[derive(Clone, Copy)]
pub(super) struct Among<'a> {
    pub samples: &'a Grouped,
    pub weights: &'a [f64],
    pub sigma: f64,
    pub kernel: Kernel,
    pub pairs: Pairs,
}

impl<'a> Among<'a> {
    /// The roots of the samples' own degrees; all 0 where the scale is none.
    pub fn own(self) -> Roots<'a> {
        self.roots(self.samples, true)
    }

    /// The roots of what others would have for degrees; all 0 where the scale is none.
    pub fn of(self, others: &'a Grouped) -> Roots<'a> {
        self.roots(others, false)
    }

    fn roots(self, of: &'a Grouped, meets_itself: bool) -> Roots<'a> {
        let Among { samples: among, weights, sigma, kernel, pairs } = self;
        if sigma <= AT_REST {
            return vec![0.0; of.samples.len()].into();
        }
        let samples = &among.samples;
        let graph = Graph::new(samples, sigma, kernel);
        if pairs == Pairs::All || samples.len() <= FEW {
            let sums = if meets_itself { graph.times(weights) } else { graph.towards(&of.samples, weights) };
            return root(sums).into();
        }
        let axes = among.axes();
        let mut sums = expansion::sums(kernel, sigma, among.cells(axes), weights, of.cells(axes));
        if meets_itself {
            for (sum, weight) in sums.iter_mut().zip(weights) {
                *sum = (*sum - weight).max(0.0);
            }
        }
        let is_exact = vec![false; sums.len()];
        let close = Close { graph, weights, of: &of.samples, meets_itself, is_exact, worst: 0.0 };
        Roots { values: root(sums), close: Some(close) }
    }
}

impl Roots<'_> {
    /// Makes values exact from the threshold outwards, until the next is several times further from
    /// it than any was wrong; tells whether there were any to make.
    pub fn settle(&mut self, threshold: f64) -> bool {
        let Some(close) = &mut self.close else { return false };
        if threshold.is_nan() || threshold <= 0.0 {
            return false;
        }
        let mut most = FIRST;
        let mut is_changed = false;
        loop {
            let off = |sample: usize| (self.values[sample] / threshold - 1.0).abs();
            // At first nobody knows how far off they are.
            let reach = if close.worst > 0.0 { SAFETY * close.worst } else { f64::INFINITY };
            let is_near = |sample: &usize| !close.is_exact[*sample] && off(*sample) <= reach;
            let mut near: Vec<usize> = (0..self.values.len()).filter(is_near).collect();
            if near.is_empty() {
                return is_changed;
            }
            if most < near.len() {
                near.select_nth_unstable_by(most, |&a, &b| off(a).total_cmp(&off(b)).then(a.cmp(&b)));
                near.truncate(most);
            }
            for (&sample, value) in near.iter().zip(close.exact(&near)) {
                let old = std::mem::replace(&mut self.values[sample], value);
                let off = (old / value.max(f64::MIN_POSITIVE) - 1.0).abs();
                close.worst = close.worst.max(off).max(f64::EPSILON);
                close.is_exact[sample] = true;
            }
            is_changed = true;
            most *= 2;
        }
    }
}

impl From<Vec<f64>> for Roots<'_> {
    fn from(values: Vec<f64>) -> Self {
        Roots { values, close: None }
    }
}

impl Close<'_> {
    /// The exact roots of some samples.
    fn exact(&self, samples: &[usize]) -> Vec<f64> {
        let points = samples.iter().flat_map(|&sample| self.of.point(sample)).copied().collect();
        let mut sums = self.graph.towards(&Samples::new(self.of.dimension, points), self.weights);
        if self.meets_itself {
            for (sum, &sample) in sums.iter_mut().zip(samples) {
                *sum = (*sum - self.weights[sample]).max(0.0);
            }
        }
        root(sums)
    }
}

fn root(mut sums: Vec<f64>) -> Vec<f64> {
    sums.iter_mut().for_each(|sum| *sum = sum.sqrt());
    sums
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Samples of feet that stand and swing in turn, never twice the same.
    fn gait(count: usize) -> Grouped {
        let points: Vec<f64> = (0..count)
            .flat_map(|index| {
                let time = index as f64 * 0.06;
                let swing = (time.sin() + 0.2 * (0.37 * time).sin()).max(0.0).powi(2);
                let noise = move |step: f64| 0.01 * (1.0 + (step * (index as f64 + 1.0)).sin());
                (0..3).flat_map(move |place| {
                    let shift = 0.02 * f64::from(place) * (time + 1.0).cos();
                    [0.6 * swing + noise(12.9898) + shift.abs(), 0.9 * swing + noise(78.233)]
                })
            })
            .collect();
        Samples::new(6, points).into()
    }

    #[test]
    fn what_decides_is_exact() {
        let (samples, others) = (gait(4000), gait(4100));
        let weights: Vec<f64> = samples.samples.norms.iter().map(|norm| (-norm * norm).exp()).collect();
        for kernel in [Kernel::Gaussian, Kernel::Cauchy] {
            let among = |pairs| Among { samples: &samples, weights: &weights, sigma: 0.15, kernel, pairs };
            let own = |pairs| among(pairs).own();
            let towards = |pairs| among(pairs).of(&others);
            for (all, mut few) in
                [(own(Pairs::All), own(Pairs::Few)), (towards(Pairs::All), towards(Pairs::Few))]
            {
                assert!(all.close.is_none() && few.close.is_some());
                let mut sorted = all.values.clone();
                sorted.sort_unstable_by(f64::total_cmp);
                for share in [0.2, 0.5, 0.7] {
                    let threshold = sorted[(share * sorted.len() as f64) as usize] * (1.0 + 1e-9);
                    few.settle(threshold);
                    assert!(!few.settle(threshold), "what is settled stays so");
                    for (all, few) in all.values.iter().zip(&few.values) {
                        assert!((all / few - 1.0).abs() < 0.02, "{all} {few}");
                        // Both have single precision within a block.
                        let is_tie = (all / threshold - 1.0).abs() < 1e-5;
                        assert!(
                            is_tie || (all > &threshold) == (few > &threshold),
                            "{all} {few} {threshold}"
                        );
                    }
                }
                let exact = few.close.as_ref().unwrap().is_exact.iter().filter(|exact| **exact).count();
                assert!(exact < samples.samples.len(), "not all had to be made exact");
            }
        }
    }

    #[test]
    fn nothing_is_asked_of_no_scale_or_threshold() {
        let samples = gait(4000);
        let weights = vec![1.0; 4000];
        let kernel = Kernel::Cauchy;
        let among = Among { samples: &samples, weights: &weights, sigma: 0.2, kernel, pairs: Pairs::Few };
        let mut none = Among { sigma: 0.0, ..among }.own();
        assert!(none.values.iter().all(|value| *value == 0.0));
        assert!(!none.settle(1.0));
        let mut some = among.own();
        assert!(!some.settle(f64::NAN) && !some.settle(f64::NEG_INFINITY) && !some.settle(0.0));
    }
}
