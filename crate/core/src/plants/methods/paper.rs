//! The published method (paper, section 2.3).

use crate::foot::Part;
use crate::plants::methods::toes::Toes;
use crate::plants::methods::{Entry, Family, Found, Task};

pub(crate) const METHOD: Entry = Entry {
    name: "paper",
    title: "Paper 2014",
    about: "The published method, word for word: toes only, and no answer for feet that never move.",
    family: Family::Spectral,
    parts: &[Part::Toe],
    detect,
};

fn detect(task: &Task) -> Found {
    let toes = Toes::of(task);
    let (scale, sigma) = toes.scale(task);
    toes.parted_by_degree(scale, sigma, task.params.pairs())
}
