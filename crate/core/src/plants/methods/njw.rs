//! Two eigenvectors with rows of unit length (Ng, Jordan and Weiss, *On spectral
//! clustering: analysis and an algorithm*, NIPS 2002).

use crate::foot::Part;
use crate::plants::methods::toes::Toes;
use crate::plants::methods::{Entry, Family, Found, Task, ncut};

pub(crate) const METHOD: Entry = Entry {
    name: "njw",
    title: "Ng–Jordan–Weiss",
    about: "Two eigenvectors with rows of unit length, as the algorithm that the paper builds on has them.",
    family: Family::Spectral,
    parts: &[Part::Toe],
    detect,
};

fn detect(task: &Task) -> Found {
    let toes = Toes::of(task);
    let (scale, sigma) = toes.scale(task);
    let (first, second) = ncut::leading_vectors(&toes.samples, sigma);
    // The first vector has no negative entry, so the rows lie on half a circle:
    // where along it a row lies says all that k-means needs.
    let angles = first.iter().zip(&second).map(|(first, second)| second.atan2(*first));
    toes.parted_by(angles.collect(), scale, sigma)
}
