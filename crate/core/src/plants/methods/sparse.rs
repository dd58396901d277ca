//! Likeness cut off at a distance, which makes the matrix sparse (paper, section 3.3).

use crate::foot::Part;
use crate::numeric::sort;
use crate::plants::methods::toes::Toes;
use crate::plants::methods::{Entry, Family, Found, Task};
use crate::plants::signal::samples::Samples;

pub(crate) const METHOD: Entry = Entry {
    name: "sparse",
    title: "Sparse",
    about: "The published method without the likeness of samples more than 2σ apart.",
    family: Family::Spectral,
    parts: &[Part::Toe],
    detect,
};

/// Distance in units of σ from which samples are not alike at all.
const REACH: f64 = 2.0;

fn detect(task: &Task) -> Found {
    let toes = Toes::of(task);
    let (scale, sigma) = toes.scale(task);
    let roots = roots(&toes.samples, sigma);
    toes.parted_by(roots, scale, sigma)
}

/// Roots of the degrees: samples in the order of their norms, which differ by less than any distance.
fn roots(samples: &Samples, sigma: f64) -> Vec<f64> {
    let count = samples.len();
    let mut degrees = vec![0.0; count];
    let order = sort::ascending(&samples.norms);
    for (place, &i) in order.iter().enumerate() {
        let near = |&&j: &&usize| samples.norms[j] - samples.norms[i] <= REACH * sigma;
        for &j in order[place + 1..].iter().take_while(near) {
            let square = samples.square(i, j);
            if sigma > 0.0 && square <= (REACH * sigma).powi(2) {
                let likeness = (-square / (sigma * sigma)).exp();
                degrees[i] += likeness;
                degrees[j] += likeness;
            }
        }
    }
    degrees.into_iter().map(f64::sqrt).collect()
}
