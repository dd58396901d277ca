//! The published method (paper, section 2.3): toes only.

use super::cluster::{Rule, cluster};
use super::confidence;
use super::degree::Kernel;
use super::samples::{Ranges, Samples};
use super::signal;
use super::{Feet, FootLabels, PartLabels, ValidParams};
use crate::labels::Part;

const RULE: Rule = Rule { kernel: Kernel::Gaussian, anchored: false, between_medians: false };

pub(super) fn detect(feet: &Feet, params: ValidParams) -> Vec<PartLabels> {
    let frames = feet.frame_count();
    let pieces = [0..frames];
    let signals = signal::plain(feet, |foot| feet.tracks[foot].toe.clone());
    let ranges = Ranges::of(&signals, &pieces);
    let samples = Samples::of(&signals, &pieces, ranges, params.window());
    let (evidence, planted) =
        cluster(&samples, (0..frames).collect(), params.tolerance(), params.scale(), params.window(), &RULE);
    let labels = |foot: usize, signal: signal::Signal| {
        let own = foot * frames..(foot + 1) * frames;
        let planted = planted[own.clone()].to_vec();
        let probability =
            confidence::planted_probability(&evidence.roots[own], &evidence, feet.frames_in(0.04));
        let confidence =
            planted.iter().zip(probability).map(|(&planted, p)| confidence::of_label(planted, p));
        FootLabels { confidence: confidence.collect(), planted, height: signal.height, speed: signal.speed }
    };
    let [left, right] = signals;
    let toe = PartLabels {
        part: Part::Toe,
        feet: [labels(0, left), labels(1, right)],
        evidence: Some(evidence.clone()),
    };
    vec![toe]
}
