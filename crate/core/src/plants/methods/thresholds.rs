//! Thresholds on height and speed: the baselines of the paper's table 3.

use crate::foot::Part;
use crate::plants::methods::toes::Toes;
use crate::plants::methods::{Entry, Family, Found, Task};

pub(crate) const HEIGHT: Entry = Entry {
    name: "height",
    title: "Height threshold",
    about: "Toes lower than a threshold in metres, the same for every clip.",
    family: Family::Threshold,
    parts: &[Part::Toe],
    detect: |task| by(task, true, false),
};

pub(crate) const SPEED: Entry = Entry {
    name: "speed",
    title: "Speed threshold",
    about: "Toes slower than a threshold in metres per second, the same for every clip.",
    family: Family::Threshold,
    parts: &[Part::Toe],
    detect: |task| by(task, false, true),
};

pub(crate) const DUAL: Entry = Entry {
    name: "dual",
    title: "Height and speed thresholds",
    about: "Toes both lower and slower than thresholds, the same for every clip.",
    family: Family::Threshold,
    parts: &[Part::Toe],
    detect: |task| by(task, true, true),
};

fn by(task: &Task, low: bool, slow: bool) -> Found {
    let (most_height, most_speed) = (task.params.height(), task.params.speed());
    Toes::of(task).by_rule(|height, speed| (!low || height < most_height) && (!slow || speed < most_speed))
}
