//! Affinities truncated at a distance, which makes the matrix sparse (paper, section 3.3).

use crate::foot::Part;
use crate::numeric::sort;
use crate::plants::methods::method_info::{Family, Input, MethodInfo, Output, Thresholds};
use crate::plants::methods::toes::Toes;
use crate::plants::signal::samples::Samples;

pub(crate) const METHOD: MethodInfo = MethodInfo {
    name: "sparse",
    title: "Sparse",
    description: "The method of the paper with affinities beyond 2σ set to zero.",
    family: Family::Spectral,
    parts: &[Part::Toe],
    thresholds: |_, _| Thresholds::NONE,
    detect,
};

/// Distance beyond which the affinity is zero, in units of σ.
const CUTOFF: f64 = 2.0;

fn detect(input: &mut Input) -> Output {
    let toes = Toes::new(input);
    let (bandwidth, sigma) = toes.bandwidth(input);
    let values = sqrt_degrees(&toes.samples, sigma);
    toes.split_by_value(values, bandwidth, sigma)
}

/// Returns the sqrt-degrees. Samples are visited in the order of their norms, whose differences are
/// lower bounds of the distances.
fn sqrt_degrees(samples: &Samples, sigma: f64) -> Vec<f64> {
    let count = samples.len();
    let mut degrees = vec![0.0; count];
    let order = sort::argsort(&samples.norms);
    for (position, &i) in order.iter().enumerate() {
        let near = |&&j: &&usize| samples.norms[j] - samples.norms[i] <= CUTOFF * sigma;
        for &j in order[position + 1..].iter().take_while(near) {
            let squared = samples.squared_distance(i, j);
            if sigma > 0.0 && squared <= (CUTOFF * sigma).powi(2) {
                let affinity = (-squared / (sigma * sigma)).exp();
                degrees[i] += affinity;
                degrees[j] += affinity;
            }
        }
    }
    degrees.into_iter().map(f64::sqrt).collect()
}
