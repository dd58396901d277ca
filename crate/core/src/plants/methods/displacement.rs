//! A rule of motion-learning code: hardly moved since the frame before.

use crate::foot::Part;
use crate::plants::methods::toes::Toes;
use crate::plants::methods::{Entry, Family, Found, Task};

pub(crate) const METHOD: Entry = Entry {
    name: "displacement",
    title: "Squared displacement 0.002",
    about: "Toes whose squared displacement from the frame before is below 0.002 m², whatever the frame rate.",
    family: Family::Threshold,
    parts: &[Part::Toe],
    detect,
};

/// In square metres.
const SQUARE: f64 = 0.002;

fn detect(task: &Task) -> Found {
    let toes = Toes::of(task);
    let metres = task.feet.metres_per_unit;
    let planted: Vec<bool> = task
        .feet
        .tracks
        .iter()
        .flat_map(|foot| {
            (0..foot.toe.len()).map(|frame| {
                let step = (foot.toe[frame] - foot.toe[frame.saturating_sub(1)]) * metres;
                step.norm_squared() < SQUARE
            })
        })
        .collect();
    toes.labelled(Part::Toe, &planted, None, None)
}
