//! Rule of motion-learning code: low and slow, in metres.

use crate::foot::Part;
use crate::plants::methods::method_info::{Family, Input, MethodInfo, Output, Thresholds};
use crate::plants::methods::toes::Toes;

pub(crate) const METHOD: MethodInfo = MethodInfo {
    name: "height-speed",
    title: "Fixed height and speed",
    description: "Toes lower than 0.114 m and slower than 0.93 m/s: a rule used to label motion-learning data sets.",
    family: Family::Threshold,
    parts: &[Part::Toe],
    thresholds: |_, _| Thresholds { height: Some(HEIGHT), speed: Some(SPEED) },
    detect,
};

/// Thresholds, in metres and metres per second.
const HEIGHT: f64 = 0.114;
const SPEED: f64 = 0.93;

fn detect(input: &mut Input) -> Output {
    Toes::new(input).by_rule(|height, speed| height < HEIGHT && speed < SPEED)
}
