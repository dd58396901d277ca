//! From samples to two classes: degrees and threshold.

use super::degree::{Graph, Kernel};
use super::samples::Samples;
use super::scale::Scale;
use super::two_means;

/// How a clustering came about, for showing why a frame is planted.
#[derive(Clone, Debug, PartialEq)]
pub struct Evidence {
    /// The frames that were clustered; others belong to no motion.
    pub frames: Vec<usize>,
    /// Norm of each sample; the left foot's frames, then the right's (paper, figure 4a).
    pub norms: Vec<f64>,
    /// Norms of all samples of both feet, ascending (paper, figure 4b).
    pub sorted_norms: Vec<f64>,
    /// Sample variance of the first norms up to each one (paper, figure 5).
    pub running_variance: Vec<f64>,
    /// Index into both of the knee.
    pub knee: usize,
    /// Scale of the kernel: the norm at the knee, unless set by hand.
    pub sigma: f64,
    /// u: the value that parts the samples, the root of each one's degree unless the
    /// method has another; the left foot's frames, then the right's.
    pub roots: Vec<f64>,
    /// Samples above this value of u are alike in being planted.
    pub threshold: f64,
    /// Median u of the planted class.
    pub planted_middle: f64,
}

/// A scale no larger than this is none: so many samples are at rest that the knee is among them.
const AT_REST: f64 = 1e-30;

/// The roots of the weighted degrees of `samples`; all 0 where the scale is none.
pub(super) fn roots(samples: &Samples, sigma: f64, kernel: Kernel, weights: &[f64]) -> Vec<f64> {
    if sigma <= AT_REST {
        return vec![0.0; samples.len()];
    }
    let degrees = Graph::new(samples, sigma, kernel).times(weights);
    degrees.into_iter().map(f64::sqrt).collect()
}

/// The roots of what `others` would have for degrees among `samples`; all 0 where the scale is none.
pub(super) fn roots_towards(
    samples: &Samples,
    others: &Samples,
    sigma: f64,
    kernel: Kernel,
    weights: &[f64],
) -> Vec<f64> {
    if sigma <= AT_REST {
        return vec![0.0; others.len()];
    }
    let degrees = Graph::new(samples, sigma, kernel).towards(others, weights);
    degrees.into_iter().map(f64::sqrt).collect()
}

/// Where the threshold lies between two classes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Between {
    /// In the middle of the gap that two-means leaves: the paper's.
    Gap,
    /// Halfway between the medians of the classes.
    Medians,
}

/// Parts samples by a value that each has, and tells which are planted.
///
/// Two-means finds the classes; the one of the lower mean norm is planted.
/// Where all samples are at rest or alike, all are planted.
pub(super) fn divide(
    frames: Vec<usize>,
    samples: &Samples,
    scale: Scale,
    sigma: f64,
    values: Vec<f64>,
    between: Between,
) -> (Evidence, Vec<bool>) {
    let mut evidence = Evidence {
        frames,
        norms: samples.norms.clone(),
        sorted_norms: scale.sorted_norms,
        running_variance: scale.running_variance,
        knee: scale.knee,
        sigma,
        threshold: f64::NEG_INFINITY,
        planted_middle: 0.0,
        roots: values,
    };
    let values = &evidence.roots;
    let Some(gap) = two_means::threshold(values) else {
        let planted = vec![true; values.len()];
        return (evidence, planted);
    };
    let (high, low): (Vec<usize>, Vec<usize>) = (0..values.len()).partition(|&sample| values[sample] > gap);
    let mean_norm =
        |class: &[usize]| class.iter().map(|&sample| samples.norms[sample]).sum::<f64>() / class.len() as f64;
    let middle = |class: &[usize]| median(class.iter().map(|&sample| values[sample]).collect());
    let (low_middle, high_middle) = (middle(&low), middle(&high));
    let planted_is_high = mean_norm(&high) < mean_norm(&low);
    evidence.threshold = match between {
        Between::Gap => gap,
        Between::Medians => (low_middle + high_middle) / 2.0,
    };
    evidence.planted_middle = if planted_is_high { high_middle } else { low_middle };
    let planted = values.iter().map(|&value| (value > evidence.threshold) == planted_is_high).collect();
    (evidence, planted)
}

/// The middle value, or the mean of the two middle ones.
fn median(mut values: Vec<f64>) -> f64 {
    values.sort_unstable_by(f64::total_cmp);
    let upper = values.len() / 2;
    if values.len() % 2 == 1 { values[upper] } else { (values[upper - 1] + values[upper]) / 2.0 }
}
