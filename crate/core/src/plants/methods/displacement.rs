//! Rule of motion-learning code: displacement since the previous frame.

use crate::foot::Part;
use crate::plants::methods::method_info::{Family, Input, MethodInfo, Output, Thresholds};
use crate::plants::methods::toes::Toes;

pub(crate) const METHOD: MethodInfo = MethodInfo {
    name: "displacement",
    title: "Fixed displacement",
    description: "Toes whose squared displacement since the previous frame is below 0.002 m², at any frame rate.",
    family: Family::Threshold,
    parts: &[Part::Toe],
    thresholds: |_, _| Thresholds::NONE,
    detect,
};

/// Squared displacement, in m².
const MAX_SQUARED_DISPLACEMENT: f64 = 0.002;

fn detect(input: &mut Input) -> Output {
    let toes = Toes::new(input);
    let metres = input.feet.metres_per_unit;
    let planted: Vec<bool> = input
        .feet
        .tracks
        .iter()
        .flat_map(|foot| {
            (0..foot.toe.len()).map(|frame| {
                let step = (foot.toe[frame] - foot.toe[frame.saturating_sub(1)]) * metres;
                step.norm_squared() < MAX_SQUARED_DISPLACEMENT
            })
        })
        .collect();
    toes.into_output(Part::Toe, &planted, None, None)
}
