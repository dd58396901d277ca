//! Normalised cut: the second eigenvector (Shi and Malik, *Normalized cuts and image segmentation*,
//! PAMI 22(8), 2000).

use crate::foot::Part;
use crate::plants::methods::method_info::{Family, Input, MethodInfo, Output, Thresholds};
use crate::plants::methods::toes::Toes;
use crate::plants::signal::samples::Samples;
use crate::plants::spectral::affinity::{AffinityGraph, Kernel};
use crate::plants::spectral::lanczos;

pub(crate) const METHOD: MethodInfo = MethodInfo {
    name: "ncut",
    title: "Normalised cut",
    description: "Second eigenvector of the same graph, split by 2-means.",
    family: Family::Spectral,
    parts: &[Part::Toe],
    thresholds: |_, _| Thresholds::NONE,
    detect,
};

fn detect(input: &mut Input) -> Output {
    let toes = Toes::new(input);
    let (bandwidth, sigma) = toes.bandwidth(input);
    let (first, second) = leading_eigenvectors(&toes.samples, sigma);
    // D^-½ maps the eigenvector of the symmetric matrix to the indicator of the cut.
    let values =
        second.iter().zip(&first).map(|(second, first)| if *first > 0.0 { second / first } else { 0.0 });
    toes.split_by_value(values.collect(), bandwidth, sigma)
}

/// Returns the two leading eigenvectors of D^-½ A D^-½, with unit length.
pub(crate) fn leading_eigenvectors(samples: &Samples, sigma: f64) -> (Vec<f64>, Vec<f64>) {
    let count = samples.len();
    if sigma <= 1e-30 {
        return (vec![0.0; count], vec![0.0; count]);
    }
    let graph = AffinityGraph::new(samples, sigma, Kernel::Gaussian);
    let sqrt_degrees: Vec<f64> = graph.multiply(&vec![1.0; count]).into_iter().map(f64::sqrt).collect();
    let length = sqrt_degrees.iter().map(|value| value * value).sum::<f64>().sqrt();
    let first: Vec<f64> = sqrt_degrees.iter().map(|value| value / length).collect();
    // A sample without neighbours belongs to neither class.
    let scale = |x: &[f64]| -> Vec<f64> {
        x.iter().zip(&sqrt_degrees).map(|(x, value)| if *value > 1e-8 { x / value } else { 0.0 }).collect()
    };
    let multiply = |x: &[f64]| scale(&graph.multiply(&scale(x)));
    let second = lanczos::leading_eigenvector(multiply, &first);
    (first, second)
}
