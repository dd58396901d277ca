//! What methods that label toes share: the published signals and samples.

use std::cell::OnceCell;

use crate::foot::Part;
use crate::plants::methods::{Found, Task};
use crate::plants::postprocess::confidence;
use crate::plants::signal::samples::{Ranges, Samples};
use crate::plants::signal::{Signal, Signals};
use crate::plants::spectral::affinity::Kernel;
use crate::plants::spectral::bandwidth::Scale;
use crate::plants::spectral::cells::Grouped;
use crate::plants::spectral::degree::{Among, Pairs};
use crate::plants::spectral::field::Field;
use crate::plants::spectral::threshold::{Between, Evidence};
use crate::plants::spectral::{bandwidth, threshold};
use crate::plants::{Feet, FootLabels, PartLabels, signal};

/// Half the window over which confidence is averaged, in seconds.
const CONFIDENCE_WINDOW: f64 = 0.04;

/// The toes of a clip as the published method sees them (paper, section 2.3, steps 1 to 4).
pub(crate) struct Toes<'a> {
    feet: &'a Feet,
    pub signals: Signals,
    /// Those of the clip: left frames, then right ones; those of a standing clip after them.
    pub samples: Samples,
    /// What their heights and speeds were divided by.
    ranges: Ranges,
}

impl<'a> Toes<'a> {
    pub fn of(task: &Task<'a>) -> Toes<'a> {
        let window = task.params.window();
        let signals = toe_signals(task.feet);
        let pieces = [0..task.feet.frame_count()];
        let mut ranges = Ranges::of(&signals, &pieces);
        let Some(still) = task.still else {
            let samples = Samples::of(&signals, &pieces, ranges, window, 1);
            return Toes { feet: task.feet, signals, samples, ranges };
        };
        // One character, two recordings: what is long or fast in one is so in both.
        let scale = still.leg / task.feet.leg;
        let still_signals = toe_signals(still).map(|signal| Signal {
            height: signal.height.iter().map(|height| height / scale).collect(),
            speed: signal.speed.iter().map(|speed| speed / scale).collect(),
        });
        let still_pieces = [0..still.frame_count()];
        let still_ranges = Ranges::of(&still_signals, &still_pieces);
        ranges.height = ranges.height.max(still_ranges.height);
        ranges.speed = ranges.speed.max(still_ranges.speed);
        let mut samples = Samples::of(&signals, &pieces, ranges, window, 1);
        samples.append(Samples::of(&still_signals, &still_pieces, ranges, window, 1));
        Toes { feet: task.feet, signals, samples, ranges }
    }

    /// σ by the knee of the norms, unless set by hand.
    pub fn scale(&self, task: &Task) -> (Scale, f64) {
        let scale = Scale::find(bandwidth::sorted(&self.samples.norms), task.params.tolerance());
        let sigma = task.params.scale().unwrap_or(scale.sigma());
        (scale, sigma)
    }

    /// Labels by a value that each sample has, parted at the gap (paper, section 2.3, steps 10 to 12).
    pub fn parted_by(self, values: Vec<f64>, scale: Scale, sigma: f64) -> Found {
        let frames = (0..self.feet.frame_count()).collect();
        let parted = threshold::divide(frames, &self.samples, scale, sigma, values, Between::Gap);
        self.parted(parted)
    }

    /// Labels by the roots of the degrees (paper, section 2.3, steps 6 to 12).
    pub fn parted_by_degree(mut self, scale: Scale, sigma: f64, pairs: Pairs) -> Found {
        let frames = (0..self.feet.frame_count()).collect();
        let weights = vec![1.0; self.samples.len()];
        let (kernel, expansion) = (Kernel::Gaussian, OnceCell::new());
        let grouped = Grouped::from(std::mem::take(&mut self.samples));
        let among = Among { samples: &grouped, weights: &weights, sigma, kernel, pairs, expansion };
        let (mut evidence, planted) =
            threshold::divide(frames, &grouped.samples, scale, sigma, among.own(), Between::Gap);
        evidence.field = Some(Field::of(&among, self.ranges));
        self.parted((evidence, planted))
    }

    fn parted(self, (mut evidence, planted): (Evidence, Vec<bool>)) -> Found {
        // A standing clip has had its say.
        evidence.roots.truncate(2 * self.feet.frame_count());
        evidence.norms.truncate(2 * self.feet.frame_count());
        let half = self.feet.frames_in(CONFIDENCE_WINDOW);
        let probability = [0, 1].map(|foot| {
            let count = self.feet.frame_count();
            confidence::planted_probability(
                &evidence.roots[foot * count..(foot + 1) * count],
                &evidence,
                half,
            )
        });
        self.labelled(Part::Toe, &planted, Some(probability), Some(evidence))
    }

    /// Labels of samples; sure of each where there is no probability of being planted.
    pub fn labelled(
        self,
        part: Part,
        planted: &[bool],
        probability: Option<[Vec<f64>; 2]>,
        evidence: Option<Evidence>,
    ) -> Found {
        let count = self.feet.frame_count();
        let [left, right] = self.signals;
        let labels = |foot: usize, signal: Signal| {
            let planted = planted[foot * count..(foot + 1) * count].to_vec();
            let confidence = match &probability {
                Some(both) => planted
                    .iter()
                    .zip(&both[foot])
                    .map(|(&label, &p)| confidence::of_label(label, p))
                    .collect(),
                None => vec![1.0; count],
            };
            let (height, speed) = (threshold::single(&signal.height), threshold::single(&signal.speed));
            FootLabels { planted, confidence, height, speed }
        };
        let feet = [labels(0, left), labels(1, right)];
        Found { parts: vec![PartLabels { part, feet, evidence }], notices: Vec::new() }
    }

    /// Labels by a rule on height and speed in metres and metres per second.
    pub fn by_rule(self, rule: impl Fn(f64, f64) -> bool) -> Found {
        let metres = self.feet.metres_per_unit;
        let planted: Vec<bool> = self
            .signals
            .iter()
            .flat_map(|signal| signal.height.iter().zip(&signal.speed))
            .map(|(height, speed)| rule(height * metres, speed * metres))
            .collect();
        self.labelled(Part::Toe, &planted, None, None)
    }
}

fn toe_signals(feet: &Feet) -> Signals {
    signal::plain(feet, |foot| &foot.toe)
}
