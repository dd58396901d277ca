//! The slower of toe and ankle under a threshold: the strongest simple rule for contact.

use crate::foot::Part;
use crate::plants::methods::toes::Toes;
use crate::plants::methods::{Entry, Family, Found, Task};
use crate::plants::signal;

pub(crate) const METHOD: Entry = Entry {
    name: "min-speed",
    title: "Slower of toe and ankle",
    about: "Contact where toe or ankle is slower than a threshold in metres per second.",
    family: Family::Threshold,
    parts: &[Part::Contact],
    detect,
};

fn detect(task: &Task) -> Found {
    let feet = task.feet;
    let [toe, ankle] = [signal::plain(feet, |foot| &foot.toe), signal::plain(feet, |foot| &foot.ankle)];
    let mut toes = Toes::of(task);
    toes.signals = signal::either(&ankle, &toe, &signal::bearing(&ankle, &toe, 0.0));
    let most = task.params.speed() / feet.metres_per_unit;
    let planted: Vec<bool> =
        toes.signals.iter().flat_map(|signal| signal.speed.iter().map(|&speed| speed < most)).collect();
    toes.labelled(Part::Contact, &planted, None, None)
}
