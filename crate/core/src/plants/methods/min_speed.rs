//! Speed threshold on the slower of toe and ankle, the strongest simple rule for contact.

use crate::foot::Part;
use crate::plants::methods::method_info::{Family, Input, MethodInfo, Output, Thresholds};
use crate::plants::methods::toes::Toes;
use crate::plants::signal;

pub(crate) const METHOD: MethodInfo = MethodInfo {
    name: "min-speed",
    title: "Slower of toe and ankle",
    description: "Contact if toe or ankle is slower than a threshold in metres per second.",
    family: Family::Threshold,
    parts: &[Part::Contact],
    thresholds: |_, speed| Thresholds { height: None, speed: Some(speed) },
    detect,
};

fn detect(input: &mut Input) -> Output {
    let feet = input.feet;
    let [toe, ankle] = [signal::raw(feet, |foot| &foot.toe), signal::raw(feet, |foot| &foot.ankle)];
    let mut toes = Toes::new(input);
    toes.signals = signal::select(&ankle, &toe, &signal::weight_bearing(&ankle, &toe, 0.0));
    let max_speed = input.settings.speed;
    let max = max_speed / feet.metres_per_unit;
    let planted: Vec<bool> =
        toes.signals.iter().flat_map(|signal| signal.speed.iter().map(|&speed| speed < max)).collect();
    toes.into_output(Part::Contact, &planted, None, None)
}
