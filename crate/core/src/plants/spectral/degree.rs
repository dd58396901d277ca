//! The roots of the degrees of samples: exact for few samples, and for many wherever it matters.
//!
//! Samples near the threshold are looked at one by one, at first against the cells of all others:
//! that takes a fraction of the time, and leaves few that have to be compared with all.

use std::cell::OnceCell;
use std::ops::RangeInclusive;

use crate::plants::signal::samples::Samples;
use crate::plants::spectral::affinity::{Graph, Kernel};
use crate::plants::spectral::cells::{Axes, Grouped};
use crate::plants::spectral::expansion::Expansion;

/// A scale no larger than this is none: so many samples are at rest that the knee is among them.
const AT_REST: f64 = 1e-30;
/// Up to this many samples, all pairs are looked at.
const FEW: usize = 3000;
/// Samples that are found in a better way at first, and a quarter as many exactly; then twice as many, and so on.
const FIRST: usize = 64;
/// Ranges of values, for each of which is found out how far they are off, ...
const STRATA: usize = 8;
/// ... by so many samples.
const ALIKE: usize = 16;
/// Coordinates of pairs that are looked at in either of the better ways at most, which takes half a
/// second: reached by an hour with a scale too small or a window too wide for its cells.
const MOST_WORK: usize = 4_000_000_000;
/// Coordinates that take as long as a cell does.
const CELL_WORK: usize = 24;
/// How many times the largest correction so far a sample has to be from the threshold to stay as it is.
const SAFETY: f64 = 2.0;

/// Which pairs of samples are looked at one by one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Pairs {
    /// All of them.
    All,
    /// Where there are many samples, only those that decide.
    Few,
}

/// The roots of weighted degrees, by sample.
pub(crate) struct Roots<'a> {
    pub values: Vec<f64>,
    /// What it takes to make values exact, where they are only close.
    close: Option<Close<'a>>,
}

struct Close<'a> {
    axes: &'a Axes,
    expansion: &'a Expansion,
    graph: Graph<'a>,
    weights: &'a [f64],
    /// The samples whose roots they are.
    of: &'a Samples,
    /// Whether each sample is among those that it is compared with, and so meets itself.
    meets_itself: bool,
    /// What each sample's value is by now.
    state: Vec<By>,
    /// The largest correction so far by a better way, relative to the value: of those by cells, and
    /// of those by themselves.
    worst: [f64; 2],
    /// Samples whose values may still be found in each of the better ways.
    left: [usize; 2],
}

/// How a value was found, each way better than the one before.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum By {
    /// Expanded about the cell of the sample and those of all others.
    Cells,
    /// Expanded about the cells of the others alone.
    Itself,
    /// Summed over all pairs.
    Pairs,
}

/// Samples, weighted, among which others have degrees.
pub(crate) struct Among<'a> {
    pub samples: &'a Grouped,
    pub weights: &'a [f64],
    pub sigma: f64,
    pub kernel: Kernel,
    pub pairs: Pairs,
    /// What they add up to, once that has been asked for.
    pub expansion: OnceCell<Expansion>,
}

impl Among<'_> {
    /// The roots of the samples' own degrees; all 0 where the scale is none.
    pub fn own(&self) -> Roots<'_> {
        self.roots(self.samples, true)
    }

    /// The roots of what others would have for degrees; all 0 where the scale is none.
    pub fn of<'a>(&'a self, others: &'a Grouped) -> Roots<'a> {
        self.roots(others, false)
    }

    fn roots<'a>(&'a self, of: &'a Grouped, meets_itself: bool) -> Roots<'a> {
        let &Among { samples: among, weights, sigma, kernel, pairs, .. } = self;
        if sigma <= AT_REST {
            return vec![0.0; of.samples.len()].into();
        }
        let samples = &among.samples;
        let graph = Graph::new(samples, sigma, kernel);
        if pairs == Pairs::All || samples.len() <= FEW {
            let sums = if meets_itself { graph.times(weights) } else { graph.towards(&of.samples, weights) };
            return root(sums).into();
        }
        let cells = of.cells(among.axes());
        let expansion = self.expansion.get_or_init(|| {
            if meets_itself {
                Expansion::of(kernel, sigma, &cells, weights)
            } else {
                Expansion::of(kernel, sigma, &among.cells(among.axes()), weights)
            }
        });
        let mut sums = expansion.sums(&cells);
        if meets_itself {
            for (sum, weight) in sums.iter_mut().zip(weights) {
                *sum = (*sum - weight).max(0.0);
            }
        }
        let state = vec![By::Cells; sums.len()];
        let (axes, of) = (among.axes(), &of.samples);
        let left =
            [expansion.cells() * CELL_WORK, samples.len() * samples.dimension].map(|each| MOST_WORK / each);
        let close = Close { axes, expansion, graph, weights, of, meets_itself, state, worst: [0.0; 2], left };
        let mut values = root(sums);
        close.right(&mut values);
        Roots { values, close: Some(close) }
    }
}

impl Roots<'_> {
    /// Makes values exact from the threshold outwards, until the next is several times further from
    /// it than any was wrong; tells the band in which they were and are, if there were any to make.
    pub fn settle(&mut self, threshold: f64) -> Option<RangeInclusive<f64>> {
        let mut band = None;
        if threshold > 0.0 {
            // Few are left for the way that takes the time.
            for (from, to, first) in [(By::Cells, By::Itself, FIRST), (By::Itself, By::Pairs, FIRST / 4)] {
                self.better(threshold, from, to, first, &mut band);
            }
        }
        band
    }

    /// Finds those values near the threshold in a better way that were found in the one before.
    fn better(
        &mut self,
        threshold: f64,
        from: By,
        to: By,
        first: usize,
        band: &mut Option<RangeInclusive<f64>>,
    ) {
        let Some(close) = &mut self.close else { return };
        let mut most = first;
        loop {
            let off = |sample: usize| (self.values[sample] / threshold - 1.0).abs();
            let worst = close.worst[from as usize];
            // At first nobody knows how far off they are.
            let reach = if worst > 0.0 { SAFETY * worst } else { f64::INFINITY };
            let those = (0..self.values.len()).filter(|&sample| close.state[sample] == from);
            let left = close.left[from as usize];
            if left == 0 {
                return;
            }
            let near = nearest(those.map(|sample| (off(sample), sample)), reach, most.min(left));
            if near.is_empty() {
                return;
            }
            close.left[from as usize] -= near.len();
            for (&sample, value) in near.iter().zip(close.found(&near, to)) {
                let old = std::mem::replace(&mut self.values[sample], value);
                let (least, greatest) = band.take().map_or((old, old), RangeInclusive::into_inner);
                *band = Some(least.min(old).min(value)..=greatest.max(old).max(value));
                let off = (old / value.max(f64::MIN_POSITIVE) - 1.0).abs();
                let worst = &mut close.worst[from as usize];
                *worst = worst.max(off).max(f64::EPSILON);
                close.state[sample] = to;
            }
            most *= 2;
        }
    }
}

/// Of samples behind how far off they are, the nearest within reach.
fn nearest(samples: impl Iterator<Item = (f64, usize)>, reach: f64, most: usize) -> Vec<usize> {
    let keep = |near: &mut Vec<(f64, usize)>| {
        if most < near.len() {
            near.select_nth_unstable_by(most, |a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
            near.truncate(most);
        }
    };
    let mut near = Vec::new();
    for sample in samples.filter(|(off, _)| *off <= reach) {
        near.push(sample);
        // All within reach at once could be more than the samples take themselves.
        if near.len() == 2 * most {
            keep(&mut near);
        }
    }
    keep(&mut near);
    near.into_iter().map(|(_, sample)| sample).collect()
}

impl From<Vec<f64>> for Roots<'_> {
    fn from(values: Vec<f64>) -> Self {
        Roots { values, close: None }
    }
}

impl Close<'_> {
    /// Rights values by what others like them fall short of: cells leave out a little more than they
    /// add, and means of many values decide where the threshold lies.
    fn right(&self, values: &mut [f64]) {
        let every = values.len().div_ceil(STRATA * ALIKE);
        let mut some: Vec<usize> = (0..values.len()).step_by(every).collect();
        some.sort_unstable_by(|&a, &b| values[a].total_cmp(&values[b]));
        let by_itself = self.found(&some, By::Itself);
        // Those are so close that the middle one tells how far off all are.
        let middles: Vec<usize> = some.chunks(ALIKE).map(|alike| alike[alike.len() / 2]).collect();
        let exact = self.found(&middles, By::Pairs);
        let strata = some.chunks(ALIKE).zip(by_itself.chunks(ALIKE)).zip(exact);
        let shortfalls: Vec<(f64, f64)> = strata
            .map(|((alike, by_itself), exact)| {
                let own = mean(alike.iter().map(|&sample| values[sample]));
                let near = mean(by_itself.iter().copied());
                (own, near - own + exact - by_itself[alike.len() / 2])
            })
            .collect();
        for value in values {
            *value = (*value + between(&shortfalls, *value)).max(0.0);
        }
    }

    /// The roots of some samples, found in one of the better ways.
    fn found(&self, samples: &[usize], by: By) -> Vec<f64> {
        let mut sums = if by == By::Pairs {
            self.graph.towards(&self.of.some(samples.iter().copied()), self.weights)
        } else {
            let point = |&sample: &usize| self.axes.point(sample, self.of.point(sample));
            samples.iter().map(|sample| self.expansion.at(&point(sample))).collect()
        };
        if self.meets_itself {
            for (sum, &sample) in sums.iter_mut().zip(samples) {
                *sum = (*sum - self.weights[sample]).max(0.0);
            }
        }
        root(sums)
    }
}

/// The value at a place of a line through some, in ascending order of their places; level beyond its ends.
fn between(line: &[(f64, f64)], place: f64) -> f64 {
    let after = line.partition_point(|(start, _)| *start <= place);
    let (before, next) = (line[after.saturating_sub(1)], line[after.min(line.len() - 1)]);
    let way = next.0 - before.0;
    if way > 0.0 { before.1 + (next.1 - before.1) * (place - before.0) / way } else { before.1 }
}

fn mean(values: impl ExactSizeIterator<Item = f64>) -> f64 {
    let count = values.len() as f64;
    values.sum::<f64>() / count
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

    fn among<'a>(samples: &'a Grouped, weights: &'a [f64], kernel: Kernel, pairs: Pairs) -> Among<'a> {
        Among { samples, weights, sigma: 0.15, kernel, pairs, expansion: OnceCell::new() }
    }

    #[test]
    fn what_decides_is_exact() {
        let (samples, others) = (gait(4000), gait(4100));
        let weights: Vec<f64> = samples.samples.norms.iter().map(|norm| (-norm * norm).exp()).collect();
        for kernel in [Kernel::Gaussian, Kernel::Cauchy] {
            let [every, some] =
                [Pairs::All, Pairs::Few].map(|pairs| among(&samples, &weights, kernel, pairs));
            for (all, mut few) in [(every.own(), some.own()), (every.of(&others), some.of(&others))] {
                assert!(all.close.is_none() && few.close.is_some());
                let mut sorted = all.values.clone();
                sorted.sort_unstable_by(f64::total_cmp);
                for share in [0.2, 0.5, 0.7] {
                    let threshold = sorted[(share * sorted.len() as f64) as usize] * (1.0 + 1e-9);
                    few.settle(threshold);
                    assert!(few.settle(threshold).is_none(), "what is settled stays so");
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
                let exact = few.close.as_ref().unwrap().state.iter().filter(|by| **by == By::Pairs).count();
                assert!(exact < samples.samples.len(), "not all had to be made exact");
            }
        }
    }

    #[test]
    fn the_rest_is_right_on_average() {
        let samples = gait(4000);
        let weights = vec![1.0; 4000];
        for kernel in [Kernel::Gaussian, Kernel::Cauchy] {
            let [all, few] = [Pairs::All, Pairs::Few].map(|pairs| among(&samples, &weights, kernel, pairs));
            let [all, few] = [all.own().values, few.own().values];
            let usual = mean(all.iter().zip(&few).map(|(all, few)| (few - all).powi(2))).sqrt();
            let bias = mean(all.iter().zip(&few).map(|(all, few)| few - all)).abs();
            // Three standard errors of the mean of those that it was found by.
            let most = 3.0 * usual / ((STRATA * ALIKE) as f64).sqrt();
            assert!(usual > 0.0 && bias < most, "{bias} {most}");
        }
    }

    #[test]
    fn lines_go_from_one_value_to_the_next() {
        let line = [(1.0, 10.0), (2.0, 20.0), (2.0, 30.0), (4.0, 40.0)];
        for (place, value) in [(0.0, 10.0), (1.0, 10.0), (1.5, 15.0), (3.0, 35.0), (4.0, 40.0), (9.0, 40.0)] {
            assert_eq!(between(&line, place), value, "{place}");
        }
        assert_eq!(between(&line[..1], 7.0), 10.0);
    }

    #[test]
    fn nothing_is_asked_of_no_scale_or_threshold() {
        let samples = gait(4000);
        let weights = vec![1.0; 4000];
        let among = among(&samples, &weights, Kernel::Cauchy, Pairs::Few);
        let mut some = among.own();
        for threshold in [f64::NAN, f64::NEG_INFINITY, 0.0] {
            assert!(some.settle(threshold).is_none());
        }
        let none = Among { sigma: 0.0, expansion: OnceCell::new(), ..among };
        assert!(none.own().values.iter().all(|value| *value == 0.0));
        assert!(none.own().settle(1.0).is_none());
    }
}
