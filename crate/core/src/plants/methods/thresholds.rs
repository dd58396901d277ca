//! Thresholds on height and speed: the baselines of table 3 of the paper.

use crate::foot::Part;
use crate::plants::methods::method_info::{Family, Input, MethodInfo, Output, Thresholds};
use crate::plants::methods::toes::Toes;

pub(crate) const HEIGHT: MethodInfo = MethodInfo {
    name: "height",
    title: "Height threshold",
    description: "Toes lower than a threshold in metres, the same for every clip.",
    family: Family::Threshold,
    parts: &[Part::Toe],
    thresholds: |height, _| Thresholds { height: Some(height), speed: None },
    detect: |input| by_thresholds(input, HEIGHT.thresholds),
};

pub(crate) const SPEED: MethodInfo = MethodInfo {
    name: "speed",
    title: "Speed threshold",
    description: "Toes slower than a threshold in metres per second, the same for every clip.",
    family: Family::Threshold,
    parts: &[Part::Toe],
    thresholds: |_, speed| Thresholds { height: None, speed: Some(speed) },
    detect: |input| by_thresholds(input, SPEED.thresholds),
};

pub(crate) const DUAL: MethodInfo = MethodInfo {
    name: "dual",
    title: "Height and speed thresholds",
    description: "Toes both lower and slower than thresholds, the same for every clip.",
    family: Family::Threshold,
    parts: &[Part::Toe],
    thresholds: |height, speed| Thresholds { height: Some(height), speed: Some(speed) },
    detect: |input| by_thresholds(input, DUAL.thresholds),
};

fn by_thresholds(input: &mut Input, thresholds: fn(f64, f64) -> Thresholds) -> Output {
    let Thresholds { height: max_height, speed: max_speed } =
        thresholds(input.settings.height, input.settings.speed);
    Toes::new(input).by_rule(|height, speed| {
        max_height.is_none_or(|max| height < max) && max_speed.is_none_or(|max| speed < max)
    })
}
