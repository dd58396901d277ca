//! A rule of motion-learning code: low and slow, in metres.

use crate::foot::Part;
use crate::plants::Limits;
use crate::plants::methods::toes::Toes;
use crate::plants::methods::{Entry, Family, Found, Task};

pub(crate) const METHOD: Entry = Entry {
    name: "height-speed",
    title: "0.114 m and 0.93 m/s",
    about: "Toes lower than 0.114 m and slower than 0.93 m/s, as data sets for motion learning are labelled.",
    family: Family::Threshold,
    parts: &[Part::Toe],
    detect,
};

/// In metres and metres per second.
const HEIGHT: f64 = 0.114;
const SPEED: f64 = 0.93;

pub(crate) const LIMITS: Limits = Limits { height: Some(HEIGHT), speed: Some(SPEED) };

fn detect(task: &Task) -> Found {
    Toes::of(task).by_rule(|height, speed| height < HEIGHT && speed < SPEED)
}
