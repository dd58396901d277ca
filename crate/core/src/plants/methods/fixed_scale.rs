//! The published method with one scale for all clips (paper, section 3.4).

use crate::foot::Part;
use crate::plants::methods::toes::Toes;
use crate::plants::methods::{Entry, Family, Found, Task};

pub(crate) const METHOD: Entry = Entry {
    name: "sigma",
    title: "Fixed scale",
    about: "The published method with σ = 0.17 for every clip instead of each clip's own.",
    family: Family::Spectral,
    parts: &[Part::Toe],
    detect,
};

/// The best of the paper's σ (figure 8).
const SIGMA: f64 = 0.17;

fn detect(task: &Task) -> Found {
    let toes = Toes::of(task);
    let (scale, _) = toes.scale(task);
    let sigma = task.params.scale().unwrap_or(SIGMA);
    toes.parted_by_degree(scale, sigma, task.params.pairs())
}
