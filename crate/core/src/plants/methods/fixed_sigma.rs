//! The method of the paper with one bandwidth for all clips (paper, section 3.4).

use crate::foot::Part;
use crate::plants::methods::method_info::{Family, Input, MethodInfo, Output, Thresholds};
use crate::plants::methods::toes::Toes;

pub(crate) const METHOD: MethodInfo = MethodInfo {
    name: "sigma",
    title: "Fixed bandwidth",
    description: "The method of the paper with σ = 0.17 for every clip.",
    family: Family::Spectral,
    parts: &[Part::Toe],
    thresholds: |_, _| Thresholds::NONE,
    detect,
};

/// Best σ of the paper (figure 8).
const SIGMA: f64 = 0.17;

fn detect(input: &mut Input) -> Output {
    let toes = Toes::new(input);
    let (bandwidth, _) = toes.bandwidth(input);
    let sigma = input.settings.sigma.unwrap_or(SIGMA);
    toes.split_by_degree(bandwidth, sigma, input.settings.summation)
}
