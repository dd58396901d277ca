//! Shared steps of methods that label toes: the signals and samples of the paper.

use std::cell::OnceCell;

use crate::foot::Part;
use crate::plants::methods::method_info::{Input, Output};
use crate::plants::postprocess::confidence;
use crate::plants::signal::samples::{Ranges, Samples};
use crate::plants::signal::{Signal, Signals};
use crate::plants::spectral::affinity::Kernel;
use crate::plants::spectral::bandwidth::Bandwidth;
use crate::plants::spectral::cells::PartitionedSamples;
use crate::plants::spectral::degree::{DegreeQuery, Summation};
use crate::plants::spectral::field::DegreeField;
use crate::plants::spectral::threshold::{CutRule, Evidence};
use crate::plants::spectral::{bandwidth, threshold};
use crate::plants::{Feet, FootLabels, PartLabels, signal};

/// Half-width of the window over which confidence is averaged, in seconds.
const CONFIDENCE_WINDOW: f64 = 0.04;

/// Toes of a clip with the samples of the paper (section 2.3, steps 1 to 4).
pub(crate) struct Toes<'a> {
    feet: &'a Feet,
    pub signals: Signals,
    /// Samples of the clip: frames of the left foot, then of the right foot; then those of a
    /// standing clip.
    pub samples: Samples,
    /// Ranges by which heights and speeds were divided.
    ranges: Ranges,
}

impl<'a> Toes<'a> {
    pub fn new(input: &Input<'a>) -> Toes<'a> {
        let window = input.settings.window;
        let signals = toe_signals(input.feet);
        let spans = [0..input.feet.frame_count()];
        let mut ranges = Ranges::new(&spans, values_of(&signals));
        let Some(standing) = input.standing else {
            let samples = Samples::from_signals(values_of(&signals), &spans, ranges, window, 1);
            return Toes { feet: input.feet, signals, samples, ranges };
        };
        // The two clips show one character, so ranges of either apply to both.
        let scale = standing.leg / input.feet.leg;
        let standing_signals = toe_signals(standing).map(|signal| Signal {
            height: signal.height.iter().map(|height| height / scale).collect(),
            speed: signal.speed.iter().map(|speed| speed / scale).collect(),
        });
        let standing_spans = [0..standing.frame_count()];
        let standing_ranges = Ranges::new(&standing_spans, values_of(&standing_signals));
        ranges.height = ranges.height.max(standing_ranges.height);
        ranges.speed = ranges.speed.max(standing_ranges.speed);
        let mut samples = Samples::from_signals(values_of(&signals), &spans, ranges, window, 1);
        samples.append(Samples::from_signals(
            values_of(&standing_signals),
            &standing_spans,
            ranges,
            window,
            1,
        ));
        Toes { feet: input.feet, signals, samples, ranges }
    }

    /// Returns the bandwidth by the knee of the norms, and σ, which may be given.
    pub fn bandwidth(&self, input: &Input) -> (Bandwidth, f64) {
        let bandwidth =
            Bandwidth::from_knee(bandwidth::sorted(&self.samples.norms), input.settings.tolerance);
        let sigma = input.settings.sigma.unwrap_or(bandwidth.sigma());
        (bandwidth, sigma)
    }

    /// Labels by one value per sample, split at the gap (paper, section 2.3, steps 10 to 12).
    pub fn split_by_value(self, values: Vec<f64>, bandwidth: Bandwidth, sigma: f64) -> Output {
        let frames = (0..self.feet.frame_count()).collect();
        let split = threshold::split(frames, &self.samples, bandwidth, sigma, values, CutRule::Gap);
        self.into_toe_labels(split)
    }

    /// Labels by the sqrt-degrees (paper, section 2.3, steps 6 to 12).
    pub fn split_by_degree(mut self, bandwidth: Bandwidth, sigma: f64, summation: Summation) -> Output {
        let frames = (0..self.feet.frame_count()).collect();
        let weights = vec![1.0; self.samples.len()];
        let (kernel, expansion) = (Kernel::Gaussian, OnceCell::new());
        let partitioned = PartitionedSamples::from(std::mem::take(&mut self.samples));
        let query =
            DegreeQuery { samples: &partitioned, weights: &weights, sigma, kernel, summation, expansion };
        let (mut evidence, planted) = threshold::split(
            frames,
            &partitioned.samples,
            bandwidth,
            sigma,
            query.sqrt_degrees(),
            CutRule::Gap,
        );
        evidence.field = Some(DegreeField::new(&query, self.ranges));
        self.into_toe_labels((evidence, planted))
    }

    fn into_toe_labels(self, (mut evidence, planted): (Evidence, Vec<bool>)) -> Output {
        // The samples of a standing clip take part in the clustering only.
        evidence.values.truncate(2 * self.feet.frame_count());
        evidence.norms.truncate(2 * self.feet.frame_count());
        let half = self.feet.frames_in(CONFIDENCE_WINDOW);
        let probability = [0, 1].map(|foot| {
            let count = self.feet.frame_count();
            confidence::planted_probability(
                &evidence.values[foot * count..(foot + 1) * count],
                &evidence,
                half,
            )
        });
        self.into_output(Part::Toe, &planted, Some(probability), Some(evidence))
    }

    /// Creates the labels of samples, with confidence 1 if no probability is given.
    pub fn into_output(
        self,
        part: Part,
        planted: &[bool],
        probability: Option<[Vec<f64>; 2]>,
        evidence: Option<Evidence>,
    ) -> Output {
        let count = self.feet.frame_count();
        let [left, right] = self.signals;
        let labels = |foot: usize, signal: Signal| {
            let planted = planted[foot * count..(foot + 1) * count].to_vec();
            let confidence = match &probability {
                Some(both) => planted
                    .iter()
                    .zip(&both[foot])
                    .map(|(&label, &p)| confidence::label_confidence(label, p))
                    .collect(),
                None => vec![1.0; count],
            };
            let (height, speed) = (threshold::to_single(&signal.height), threshold::to_single(&signal.speed));
            FootLabels { planted, confidence, height, speed, edges: Vec::new() }
        };
        let feet = [labels(0, left), labels(1, right)];
        Output { parts: vec![PartLabels { part, feet, evidence }], notices: Vec::new() }
    }

    /// Labels by a rule on height and speed, in metres and metres per second.
    pub fn by_rule(self, rule: impl Fn(f64, f64) -> bool) -> Output {
        let metres = self.feet.metres_per_unit;
        let planted: Vec<bool> = self
            .signals
            .iter()
            .flat_map(|signal| signal.height.iter().zip(&signal.speed))
            .map(|(height, speed)| rule(height * metres, speed * metres))
            .collect();
        self.into_output(Part::Toe, &planted, None, None)
    }
}

fn toe_signals(feet: &Feet) -> Signals {
    signal::raw(feet, |foot| &foot.toe)
}

/// Returns height and speed of a foot at a frame, for [`Samples::from_signals`].
fn values_of(signals: &Signals) -> impl Fn(usize, usize) -> [f64; 2] {
    |foot, frame| signals[foot].at(frame)
}
