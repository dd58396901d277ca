//! The method of the paper (section 2.3).

use crate::foot::Part;
use crate::plants::methods::method_info::{Family, Input, MethodInfo, Output, Thresholds};
use crate::plants::methods::toes::Toes;

pub(crate) const METHOD: MethodInfo = MethodInfo {
    name: "paper",
    title: "Paper 2014",
    description: "As published: toes only; fails if the feet never move.",
    family: Family::Spectral,
    parts: &[Part::Toe],
    thresholds: |_, _| Thresholds::NONE,
    detect,
};

fn detect(input: &mut Input) -> Output {
    let toes = Toes::new(input);
    let (bandwidth, sigma) = toes.bandwidth(input);
    toes.split_by_degree(bandwidth, sigma, input.settings.summation)
}
