//! Two eigenvectors with rows of unit length (Ng, Jordan and Weiss, *On spectral clustering:
//! analysis and an algorithm*, NIPS 2002).

use crate::foot::Part;
use crate::plants::methods::method_info::{Family, Input, MethodInfo, Output, Thresholds};
use crate::plants::methods::ncut;
use crate::plants::methods::toes::Toes;

pub(crate) const METHOD: MethodInfo = MethodInfo {
    name: "njw",
    title: "Ng–Jordan–Weiss",
    description: "Two eigenvectors with rows of unit length: the algorithm on which the paper builds.",
    family: Family::Spectral,
    parts: &[Part::Toe],
    thresholds: |_, _| Thresholds::NONE,
    detect,
};

fn detect(input: &mut Input) -> Output {
    let toes = Toes::new(input);
    let (bandwidth, sigma) = toes.bandwidth(input);
    let (first, second) = ncut::leading_eigenvectors(&toes.samples, sigma);
    // The first eigenvector has no negative entry, so the rows lie on a semicircle, and the angle
    // of a row is all that k-means needs.
    let angles = first.iter().zip(&second).map(|(first, second)| second.atan2(*first));
    toes.split_by_value(angles.collect(), bandwidth, sigma)
}
