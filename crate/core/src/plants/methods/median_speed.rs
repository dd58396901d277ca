//! A rule of motion-learning code: slow after a median filter.

use crate::foot::Part;
use crate::plants::Limits;
use crate::plants::methods::toes::Toes;
use crate::plants::methods::{Entry, Family, Found, Task};

pub(crate) const METHOD: Entry = Entry {
    name: "median-speed",
    title: "0.15 m/s, median filter",
    about: "Toes slower than 0.15 m/s, the labels smoothed by a median filter of seven frames.",
    family: Family::Threshold,
    parts: &[Part::Toe],
    detect,
};

/// In metres per second.
const SPEED: f64 = 0.15;

pub(crate) const LIMITS: Limits = Limits { height: None, speed: Some(SPEED) };

/// Frames to either side of the filter.
const HALF: usize = 3;

fn detect(task: &Task) -> Found {
    let toes = Toes::of(task);
    let metres = task.feet.metres_per_unit;
    let planted: Vec<bool> = toes.signals.iter().flat_map(|signal| filtered(&signal.speed, metres)).collect();
    toes.labelled(Part::Toe, &planted, None, None)
}

/// The majority of the labels around each frame.
fn filtered(speed: &[f64], metres: f64) -> Vec<bool> {
    let slow: Vec<bool> = speed.iter().map(|speed| speed * metres < SPEED).collect();
    (0..slow.len())
        .map(|frame| {
            let window = &slow[frame.saturating_sub(HALF)..(frame + HALF + 1).min(slow.len())];
            2 * window.iter().filter(|&&slow| slow).count() > window.len()
        })
        .collect()
}
