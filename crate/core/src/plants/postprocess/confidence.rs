//! How sure a label is.

use crate::plants::spectral::threshold::Evidence;

/// Steepness and offset of the logistic curve, fitted on the generated set (seeds 0 to 2).
const SLOPE: f64 = 9.6;
const OFFSET: f64 = -5.2;

/// Probability that each sample of one run of frames is planted.
///
/// `roots` are the samples' u; the margin to the threshold is averaged over
/// `half` frames to either side.
pub(crate) fn planted_probability(roots: &[f32], evidence: &Evidence, half: usize) -> Vec<f64> {
    let span = evidence.planted_middle - evidence.threshold;
    // Samples that are all alike have no threshold: there is nothing to doubt.
    if !span.is_finite() {
        return vec![1.0; roots.len()];
    }
    let margins: Vec<f64> =
        roots.iter().map(|&root| ((f64::from(root) - evidence.threshold) / span).clamp(-1.0, 1.0)).collect();
    (0..margins.len())
        .map(|frame| {
            let window = &margins[frame.saturating_sub(half)..(frame + half + 1).min(margins.len())];
            let mean = window.iter().sum::<f64>() / window.len() as f64;
            1.0 / (1.0 + (-(SLOPE * mean + OFFSET)).exp())
        })
        .collect()
}

/// Probability that a label is right, given that of being planted; never worse than a coin.
pub(crate) fn of_label(planted: bool, probability: f64) -> f32 {
    (if planted { probability } else { 1.0 - probability }).max(0.5) as f32
}
