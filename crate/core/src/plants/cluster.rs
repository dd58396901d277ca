//! From samples to two classes: scale, degrees, threshold.

use super::degree::{self, Kernel};
use super::samples::Samples;
use super::scale::Scale;
use super::two_means;

/// How a clustering came about, for showing why a frame is planted.
#[derive(Clone, Debug, PartialEq)]
pub struct Evidence {
    /// The frames that were clustered; others belong to no motion.
    pub frames: Vec<usize>,
    /// Norms of all samples of both feet, ascending (paper, figure 4b).
    pub sorted_norms: Vec<f64>,
    /// Sample variance of the first norms up to each one (paper, figure 5).
    pub running_variance: Vec<f64>,
    /// Index into both of the knee.
    pub knee: usize,
    /// Scale of the kernel: the norm at the knee, unless set by hand.
    pub sigma: f64,
    /// u: the root of each sample's degree; the left foot's frames, then the right's.
    pub roots: Vec<f64>,
    /// Samples above this value of u are alike in being planted.
    pub threshold: f64,
    /// Median u of the planted class.
    pub planted_middle: f64,
}

/// How samples are compared and divided.
pub(super) struct Rule {
    pub kernel: Kernel,
    /// Whether samples near rest count for more, so that a foot held still in
    /// the air, dense as its samples are, is not taken for one on the ground.
    pub anchored: bool,
    /// Whether the threshold lies halfway between the classes' medians rather
    /// than at the gap between the classes.
    pub between_medians: bool,
}

/// A scale no larger than this is none: so many samples are at rest that the knee is among them.
const AT_REST: f64 = 1e-30;

/// The evidence and whether each sample is planted.
///
/// Two-means parts the roots of the degrees; the class of the lower mean norm
/// is planted. Where all samples are at rest or alike, all are planted.
pub(super) fn cluster(
    samples: &Samples,
    frames: Vec<usize>,
    r: f64,
    sigma: Option<f64>,
    window: usize,
    rule: &Rule,
) -> (Evidence, Vec<bool>) {
    let scale = Scale::find(&samples.norms, r);
    let sigma = sigma.unwrap_or(scale.sigma());
    let weights = rule.anchored.then(|| {
        let reach = (8.0 * sigma).min(0.5 * ((2 * window + 1) as f64).sqrt());
        samples.norms.iter().map(|norm| (-(norm / reach).powi(2)).exp()).collect::<Vec<_>>()
    });
    let roots: Vec<f64> = if sigma > AT_REST {
        let degrees = degree::degrees(samples, sigma, rule.kernel, weights.as_deref());
        degrees.into_iter().map(f64::sqrt).collect()
    } else {
        vec![0.0; samples.len()]
    };
    let mut evidence = Evidence {
        frames,
        sorted_norms: scale.sorted_norms,
        running_variance: scale.running_variance,
        knee: scale.knee,
        sigma,
        threshold: f64::NEG_INFINITY,
        planted_middle: 0.0,
        roots,
    };
    let planted = divide(&mut evidence, &samples.norms, rule.between_medians);
    (evidence, planted)
}

fn divide(evidence: &mut Evidence, norms: &[f64], between_medians: bool) -> Vec<bool> {
    let roots = &evidence.roots;
    let Some(gap) = two_means::threshold(roots) else {
        return vec![true; roots.len()];
    };
    let (high, low): (Vec<usize>, Vec<usize>) = (0..roots.len()).partition(|&sample| roots[sample] > gap);
    let mean_norm =
        |class: &[usize]| class.iter().map(|&sample| norms[sample]).sum::<f64>() / class.len() as f64;
    let middle = |class: &[usize]| median(class.iter().map(|&sample| roots[sample]).collect());
    let (low_middle, high_middle) = (middle(&low), middle(&high));
    let planted_is_high = mean_norm(&high) < mean_norm(&low);
    evidence.threshold = if between_medians { (low_middle + high_middle) / 2.0 } else { gap };
    evidence.planted_middle = if planted_is_high { high_middle } else { low_middle };
    roots.iter().map(|&root| (root > evidence.threshold) == planted_is_high).collect()
}

/// The middle value, or the mean of the two middle ones.
fn median(mut values: Vec<f64>) -> f64 {
    values.sort_unstable_by(f64::total_cmp);
    let upper = values.len() / 2;
    if values.len() % 2 == 1 { values[upper] } else { (values[upper - 1] + values[upper]) / 2.0 }
}
