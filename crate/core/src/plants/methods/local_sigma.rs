//! Local bandwidths (Zelnik-Manor and Perona, *Self-tuning spectral clustering*, NIPS 2005), which
//! the paper rejects (section 2.2).

use crate::foot::Part;
use crate::numeric::stats::nth_smallest;
use crate::plants::methods::method_info::{Family, Input, MethodInfo, Output, Thresholds};
use crate::plants::methods::toes::Toes;
use crate::plants::signal::samples::Samples;

pub(crate) const METHOD: MethodInfo = MethodInfo {
    name: "local",
    title: "Local bandwidth",
    description: "The method of the paper with one bandwidth per sample: the distance to its seventh neighbour.",
    family: Family::Spectral,
    parts: &[Part::Toe],
    thresholds: |_, _| Thresholds::NONE,
    detect,
};

/// Index of the neighbour whose distance is the bandwidth of a sample.
const NEIGHBOUR: usize = 7;

fn detect(input: &mut Input) -> Output {
    let toes = Toes::new(input);
    let (bandwidth, sigma) = toes.bandwidth(input);
    let values = sqrt_degrees(&toes.samples);
    toes.split_by_value(values, bandwidth, sigma)
}

/// Returns the sqrt-degrees with affinity exp(−d² / (σᵢ σⱼ)).
fn sqrt_degrees(samples: &Samples) -> Vec<f64> {
    let count = samples.len();
    let squared = |i: usize, j: usize| samples.squared_distance(i, j);
    let sigmas: Vec<f64> = (0..count)
        .map(|i| {
            let mut distances: Vec<f64> = (0..count).map(|j| squared(i, j)).collect();
            let neighbour = NEIGHBOUR.min(count - 1);
            // A lower bound, because duplicates of a sample would have bandwidth zero.
            nth_smallest(&mut distances, neighbour).sqrt().max(1e-9)
        })
        .collect();
    let mut degrees = vec![0.0; count];
    for i in 0..count {
        for j in i + 1..count {
            let affinity = (-squared(i, j) / (sigmas[i] * sigmas[j])).exp();
            degrees[i] += affinity;
            degrees[j] += affinity;
        }
    }
    degrees.into_iter().map(f64::sqrt).collect()
}
