//! Normalised cut: the second eigenvector (Shi and Malik, *Normalized cuts and
//! image segmentation*, PAMI 22(8), 2000).

use crate::foot::Part;
use crate::plants::methods::toes::Toes;
use crate::plants::methods::{Entry, Family, Found, Task};
use crate::plants::signal::samples::Samples;
use crate::plants::spectral::affinity::{Graph, Kernel};
use crate::plants::spectral::lanczos;

pub(crate) const METHOD: Entry = Entry {
    name: "ncut",
    title: "Normalised cut",
    about: "The second eigenvector of the same graph, parted by two-means.",
    family: Family::Spectral,
    parts: &[Part::Toe],
    detect,
};

fn detect(task: &Task) -> Found {
    let toes = Toes::of(task);
    let (scale, sigma) = toes.scale(task);
    let (first, second) = leading_vectors(&toes.samples, sigma);
    // D^-½ turns the symmetric matrix's vector into the cut's indicator.
    let values =
        second.iter().zip(&first).map(|(second, first)| if *first > 0.0 { second / first } else { 0.0 });
    toes.parted_by(values.collect(), scale, sigma)
}

/// The two leading eigenvectors of D^-½ A D^-½, of unit length.
pub(crate) fn leading_vectors(samples: &Samples, sigma: f64) -> (Vec<f64>, Vec<f64>) {
    let count = samples.len();
    if sigma <= 1e-30 {
        return (vec![0.0; count], vec![0.0; count]);
    }
    let graph = Graph::new(samples, sigma, Kernel::Gaussian);
    let roots: Vec<f64> = graph.times(&vec![1.0; count]).into_iter().map(f64::sqrt).collect();
    let length = roots.iter().map(|root| root * root).sum::<f64>().sqrt();
    let first: Vec<f64> = roots.iter().map(|root| root / length).collect();
    // A sample without neighbours is nobody's part.
    let over = |x: &[f64]| -> Vec<f64> {
        x.iter().zip(&roots).map(|(x, root)| if *root > 1e-8 { x / root } else { 0.0 }).collect()
    };
    let times = |x: &[f64]| over(&graph.times(&over(x)));
    let second = lanczos::leading(times, &first);
    (first, second)
}
