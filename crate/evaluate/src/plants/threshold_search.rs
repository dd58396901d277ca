//! Threshold methods with thresholds tuned on the truth.

use plantigrade::foot::Part;
use plantigrade::plants::Method;
use plantigrade::score::Tally;
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

use super::trial::{Trial, default_params};

/// Height and speed per frame, left foot first.
pub struct Signals {
    /// Heights, in the unit of the caller.
    pub height: [Vec<f64>; 2],
    /// Speeds, in the unit of the caller per second.
    pub speed: [Vec<f64>; 2],
}

/// Returns the signals that a method compares with its thresholds, multiplied by `unit`.
pub fn signals(trial: &Trial, method: Method, unit: f64) -> Signals {
    let detection = trial.detect(default_params(method));
    let feet = &detection.principal().feet;
    let scaled = |values: &[f32]| values.iter().map(|&value| f64::from(value) * unit).collect();
    Signals {
        height: [scaled(&feet[0].height), scaled(&feet[1].height)],
        speed: [scaled(&feet[0].speed), scaled(&feet[1].speed)],
    }
}

/// Signals that are compared with thresholds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Height only.
    Height,
    /// Speed only.
    Speed,
    /// Both height and speed below their thresholds.
    Dual,
}

/// A height threshold and a speed threshold.
pub type Thresholds = (f64, f64);

impl Kind {
    /// Returns the labels for given thresholds.
    pub fn labels(self, signals: &Signals, (height, speed): Thresholds) -> [Vec<bool>; 2] {
        [0, 1].map(|foot| {
            let pairs = signals.height[foot].iter().zip(&signals.speed[foot]);
            pairs
                .map(|(&h, &v)| match self {
                    Kind::Height => h < height,
                    Kind::Speed => v < speed,
                    Kind::Dual => h < height && v < speed,
                })
                .collect()
        })
    }

    /// Returns the candidate thresholds: logarithmic steps over the range of the signals.
    pub fn grid(self, signals: &[&Signals]) -> Vec<Thresholds> {
        let steps = |values: fn(&Signals) -> &[Vec<f64>; 2], count: usize| -> Vec<f64> {
            let mut sorted: Vec<f64> =
                signals.iter().flat_map(|signals| values(signals).iter().flatten().copied()).collect();
            sorted.sort_unstable_by(f64::total_cmp);
            let quantile = |fraction: f64| sorted[(fraction * (sorted.len() - 1) as f64) as usize].max(1e-6);
            let (low, high) = (quantile(0.02), quantile(0.98));
            (0..count).map(|step| low * (high / low).powf(step as f64 / (count - 1) as f64)).collect()
        };
        let heights = |count| steps(|signals| &signals.height, count);
        let speeds = |count| steps(|signals| &signals.speed, count);
        match self {
            Kind::Height => heights(80).into_iter().map(|height| (height, f64::INFINITY)).collect(),
            Kind::Speed => speeds(80).into_iter().map(|speed| (f64::INFINITY, speed)).collect(),
            Kind::Dual => {
                let speeds = speeds(28);
                let pairs = |height: f64| speeds.iter().map(move |&speed| (height, speed));
                heights(28).into_iter().flat_map(pairs).collect()
            }
        }
    }

    /// Returns the lenient tally of a trial for given thresholds.
    pub fn tally(
        self,
        trial: &Trial,
        part: Part,
        signals: &Signals,
        thresholds: Thresholds,
        fuzzy: f64,
    ) -> Tally {
        let labels = self.labels(signals, thresholds);
        trial.tally(part, [&labels[0], &labels[1]], fuzzy)
    }

    /// Returns the thresholds with the highest accuracy pooled over the trials.
    pub fn best(self, trials: &[(&Trial, &Signals)], part: Part, fuzzy: f64) -> Thresholds {
        let signals: Vec<&Signals> = trials.iter().map(|(_, signals)| *signals).collect();
        let grid = self.grid(&signals);
        let correct_labels = |&thresholds: &Thresholds| {
            let mut pooled = Tally::default();
            for (trial, signals) in trials {
                pooled += self.tally(trial, part, signals, thresholds, fuzzy);
            }
            pooled.correct
        };
        let correct: Vec<usize> = grid.par_iter().map(correct_labels).collect();
        let highest = correct.iter().copied().max().unwrap_or(0);
        // The middle one of equally good thresholds.
        let best = grid.into_iter().zip(correct).filter(|(_, correct)| *correct == highest);
        let best: Vec<Thresholds> = best.map(|(thresholds, _)| thresholds).collect();
        best[best.len() / 2]
    }
}
