//! Rule of motion-learning code: slow after a median filter.

use crate::foot::Part;
use crate::plants::methods::method_info::{Family, Input, MethodInfo, Output, Thresholds};
use crate::plants::methods::toes::Toes;

pub(crate) const METHOD: MethodInfo = MethodInfo {
    name: "median-speed",
    title: "Fixed speed, median filter",
    description: "Toes slower than 0.15 m/s, the labels smoothed by a median filter of seven frames.",
    family: Family::Threshold,
    parts: &[Part::Toe],
    thresholds: |_, _| Thresholds { height: None, speed: Some(SPEED) },
    detect,
};

/// Speed threshold, in metres per second.
const SPEED: f64 = 0.15;

/// Half-width of the filter, in frames.
const HALF_WIDTH: usize = 3;

fn detect(input: &mut Input) -> Output {
    let toes = Toes::new(input);
    let metres = input.feet.metres_per_unit;
    let planted: Vec<bool> =
        toes.signals.iter().flat_map(|signal| median_filtered(&signal.speed, metres)).collect();
    toes.into_output(Part::Toe, &planted, None, None)
}

/// Returns the majority of the labels around each frame.
fn median_filtered(speed: &[f64], metres: f64) -> Vec<bool> {
    let slow: Vec<bool> = speed.iter().map(|speed| speed * metres < SPEED).collect();
    (0..slow.len())
        .map(|frame| {
            let window = &slow[frame.saturating_sub(HALF_WIDTH)..(frame + HALF_WIDTH + 1).min(slow.len())];
            2 * window.iter().filter(|&&slow| slow).count() > window.len()
        })
        .collect()
}
