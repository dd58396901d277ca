//! Thresholds tuned on truth, which is what the detector does without.

use plantigrade::labels::Part;
use plantigrade::plants::Method;
use plantigrade::score::Tally;

use crate::parallel;
use crate::trial::{Trial, of};

/// Height and speed of both feet per frame, in the trial's units.
pub struct Signals {
    pub height: [Vec<f64>; 2],
    pub speed: [Vec<f64>; 2],
}

/// The signals that a method compares with its thresholds, times `unit`.
pub fn signals(trial: &Trial, method: Method, unit: f64) -> Signals {
    let detection = trial.detect(of(method));
    let feet = &detection.principal().feet;
    let times = |values: &[f32]| values.iter().map(|&value| f64::from(value) * unit).collect();
    Signals {
        height: [times(&feet[0].height), times(&feet[1].height)],
        speed: [times(&feet[0].speed), times(&feet[1].speed)],
    }
}

/// Which thresholds are compared with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Height,
    Speed,
    /// Lower and slower.
    Dual,
}

/// A height and a speed.
pub type Thresholds = (f64, f64);

impl Kind {
    /// Labels by thresholds.
    pub fn labels(self, signals: &Signals, (height, speed): Thresholds) -> [Vec<bool>; 2] {
        [0, 1].map(|foot| {
            let both = signals.height[foot].iter().zip(&signals.speed[foot]);
            both.map(|(&h, &v)| match self {
                Kind::Height => h < height,
                Kind::Speed => v < speed,
                Kind::Dual => h < height && v < speed,
            })
            .collect()
        })
    }

    /// All thresholds worth trying: even steps of the logarithm over what occurs.
    pub fn grid(self, signals: &[&Signals]) -> Vec<Thresholds> {
        let steps = |values: fn(&Signals) -> &[Vec<f64>; 2], count: usize| -> Vec<f64> {
            let mut all: Vec<f64> =
                signals.iter().flat_map(|signals| values(signals).iter().flatten().copied()).collect();
            all.sort_unstable_by(f64::total_cmp);
            let at = |share: f64| all[(share * (all.len() - 1) as f64) as usize].max(1e-6);
            let (low, high) = (at(0.02), at(0.98));
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

    /// The tally of a trial for thresholds.
    pub fn tally(self, trial: &Trial, part: Part, signals: &Signals, at: Thresholds, fuzzy: f64) -> Tally {
        let labels = self.labels(signals, at);
        trial.tally(part, [&labels[0], &labels[1]], fuzzy)
    }

    /// The thresholds that serve some trials best together.
    pub fn best(self, trials: &[(&Trial, &Signals)], part: Part, fuzzy: f64) -> Thresholds {
        let signals: Vec<&Signals> = trials.iter().map(|(_, signals)| *signals).collect();
        let grid = self.grid(&signals);
        let right = parallel::map(&grid, |&at| {
            let mut pooled = Tally::default();
            for (trial, signals) in trials {
                pooled += self.tally(trial, part, signals, at, fuzzy);
            }
            pooled.right
        });
        let most = right.iter().copied().max().unwrap_or(0);
        // Where several serve equally well, the one in the middle of them.
        let equal: Vec<Thresholds> =
            grid.into_iter().zip(right).filter(|(_, right)| *right == most).map(|(at, _)| at).collect();
        equal[equal.len() / 2]
    }
}
