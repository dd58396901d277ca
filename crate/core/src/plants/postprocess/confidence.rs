//! Confidence of labels.

use crate::numeric;
use crate::plants::spectral::threshold::Evidence;

/// Slope and offset of the logistic curve, fitted on generated motion (seeds 0 to 2).
const SLOPE: f64 = 9.6;
const OFFSET: f64 = -5.2;

/// Returns the probability that each sample of a span is planted.
///
/// `values` are the u of the samples. Their distance to the threshold, relative to the median of
/// the planted class, is averaged over `half` frames on either side.
pub(crate) fn planted_probability(values: &[f32], evidence: &Evidence, half: usize) -> Vec<f64> {
    let scale = evidence.planted_median - evidence.threshold;
    // Equal samples have no threshold, and their labels are certain.
    if !scale.is_finite() {
        return vec![1.0; values.len()];
    }
    let margins: Vec<f64> = values
        .iter()
        .map(|&value| ((f64::from(value) - evidence.threshold) / scale).clamp(-1.0, 1.0))
        .collect();
    (0..margins.len())
        .map(|frame| {
            let window = numeric::around(&margins, frame, half);
            let mean = window.iter().sum::<f64>() / window.len() as f64;
            1.0 / (1.0 + (-(SLOPE * mean + OFFSET)).exp())
        })
        .collect()
}

/// Returns the probability that a label is right, at least 0.5, given the probability of being
/// planted.
pub(crate) fn label_confidence(planted: bool, probability: f64) -> f32 {
    (if planted { probability } else { 1.0 - probability }).max(0.5) as f32
}
