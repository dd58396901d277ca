//! A scale for each sample (Zelnik-Manor and Perona, *Self-tuning spectral
//! clustering*, NIPS 2005), which the paper rejects (section 2.2).

use crate::foot::Part;
use crate::plants::methods::toes::Toes;
use crate::plants::methods::{Entry, Family, Found, Task};
use crate::plants::signal::samples::Samples;

pub(crate) const METHOD: Entry = Entry {
    name: "local",
    title: "Local scale",
    about: "The published method with a scale for each sample: the distance of its seventh neighbour.",
    family: Family::Spectral,
    parts: &[Part::Toe],
    detect,
};

/// Which neighbour's distance is a sample's scale.
const NEIGHBOUR: usize = 7;

fn detect(task: &Task) -> Found {
    let toes = Toes::of(task);
    let (scale, sigma) = toes.scale(task);
    let roots = roots(&toes.samples);
    toes.parted_by(roots, scale, sigma)
}

/// Roots of the degrees with likeness exp(−d² / (σᵢ σⱼ)).
fn roots(samples: &Samples) -> Vec<f64> {
    let count = samples.len();
    let square = |i: usize, j: usize| samples.square(i, j);
    let scales: Vec<f64> = (0..count)
        .map(|i| {
            let mut squares: Vec<f64> = (0..count).map(|j| square(i, j)).collect();
            let place = NEIGHBOUR.min(count - 1);
            // Copies of a sample would have no scale at all.
            squares.select_nth_unstable_by(place, f64::total_cmp).1.sqrt().max(1e-9)
        })
        .collect();
    let mut degrees = vec![0.0; count];
    for i in 0..count {
        for j in i + 1..count {
            let likeness = (-square(i, j) / (scales[i] * scales[j])).exp();
            degrees[i] += likeness;
            degrees[j] += likeness;
        }
    }
    degrees.into_iter().map(f64::sqrt).collect()
}
