//! Threshold that separates the samples into two classes.

use std::sync::Arc;

use crate::plants::signal::samples::Samples;
use crate::plants::spectral::bandwidth::Bandwidth;
use crate::plants::spectral::degree::SqrtDegrees;
use crate::plants::spectral::field::DegreeField;
use crate::plants::spectral::two_means::Classes;
use crate::plants::spectral::{bandwidth, two_means};

/// Evidence of a clustering: explains why a frame is planted.
#[derive(Clone, Debug, PartialEq)]
pub struct Evidence {
    /// Frames that were clustered; other frames do not belong to the motion.
    pub frames: Arc<[usize]>,
    /// Norm of each sample: the frames of the left foot, then of the right foot (paper, figure 4a).
    pub norms: Vec<f32>,
    /// Norms of all samples of both feet in ascending order (paper, figure 4b).
    pub sorted_norms: Arc<[f64]>,
    /// Index of the knee in `sorted_norms`.
    pub knee: usize,
    /// Upper bound of the running variance: r, or a multiple for a wider window.
    pub tolerance: f64,
    /// σ: bandwidth of the kernel; the norm at the knee within the limits of the method, unless given.
    pub sigma: f64,
    /// True if σ is a limit of the method rather than the norm at the knee.
    pub sigma_is_limited: bool,
    /// u: the value of each sample that is compared with the threshold, which is the sqrt-degree
    /// unless the method uses another; the frames of the left foot, then of the right foot.
    pub values: Vec<f32>,
    /// Threshold of u.
    pub threshold: f64,
    /// True if samples with u above the threshold are planted.
    pub planted_is_high: bool,
    /// Median u of the planted class.
    pub planted_median: f64,
    /// u as a function of height and speed; `None` if u is not a sqrt-degree with one bandwidth.
    pub field: Option<DegreeField>,
}

impl Evidence {
    /// Returns the sample variance of the first norms up to each norm (paper, figure 5).
    pub fn running_variance(&self) -> impl Iterator<Item = f64> {
        bandwidth::running_variance(&self.sorted_norms)
    }
}

/// Rule for the threshold between two classes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum CutRule {
    /// Middle of the gap between the classes (paper).
    Gap,
    /// Mean of the medians of the classes.
    Medians,
}

/// Splits samples into two classes by one value each and determines which class is planted.
///
/// Two-means finds the classes; the class with the lower mean norm is planted. If all samples are
/// at rest or equal, all are planted. Approximate values are refined near the threshold.
pub(crate) fn split<'a>(
    frames: Arc<[usize]>,
    samples: &Samples,
    bandwidth: Bandwidth,
    sigma: f64,
    values: impl Into<SqrtDegrees<'a>>,
    rule: CutRule,
) -> (Evidence, Vec<bool>) {
    let mut degrees = values.into();
    let mut sorted = two_means::sorted(&degrees.values);
    let mut classes = two_means::classes(&sorted);
    let find_split = |classes: &Option<Classes>, values: &[f64]| {
        classes.map(|classes| Split::new(classes, values, &samples.norms, rule))
    };
    let mut split = find_split(&classes, &degrees.values);
    while let Some(Split { threshold, .. }) = split
        && let Some(band) = degrees.refine_near(threshold)
    {
        two_means::sort_band(&mut sorted, &degrees.values, band);
        classes = two_means::classes(&sorted);
        split = find_split(&classes, &degrees.values);
    }
    drop(sorted);
    let planted = match &split {
        Some(split) => {
            degrees.values.iter().map(|&value| (value > split.threshold) == split.planted_is_high).collect()
        }
        None => vec![true; samples.len()],
    };
    let evidence = Evidence {
        frames,
        norms: to_single(&samples.norms),
        sorted_norms: bandwidth.sorted,
        knee: bandwidth.knee,
        tolerance: bandwidth.tolerance,
        sigma,
        sigma_is_limited: false,
        values: to_single(&degrees.values),
        threshold: split.as_ref().map_or(f64::NEG_INFINITY, |split| split.threshold),
        planted_is_high: split.as_ref().is_none_or(|split| split.planted_is_high),
        planted_median: split.map_or(0.0, |split| split.planted_median),
        field: None,
    };
    (evidence, planted)
}

/// Converts to single precision, which suffices for display.
pub(crate) fn to_single(values: &[f64]) -> Vec<f32> {
    values.iter().map(|&value| value as f32).collect()
}

/// Result of splitting samples into two classes.
#[derive(Clone, Copy)]
struct Split {
    threshold: f64,
    /// True if the planted class is above the threshold.
    planted_is_high: bool,
    /// Median of the planted class.
    planted_median: f64,
}

impl Split {
    /// Applies the cut rule to the classes of two-means.
    fn new(classes: Classes, values: &[f64], norms: &[f64], rule: CutRule) -> Split {
        let Classes { threshold: gap, medians: [low_median, high_median] } = classes;
        let mean_norm = |is_high: bool| {
            let class = || values.iter().zip(norms).filter(|&(&value, _)| (value > gap) == is_high);
            class().map(|(_, norm)| norm).sum::<f64>() / class().count() as f64
        };
        let planted_is_high = mean_norm(true) < mean_norm(false);
        let threshold = match rule {
            CutRule::Gap => gap,
            CutRule::Medians => (low_median + high_median) / 2.0,
        };
        let planted_median = if planted_is_high { high_median } else { low_median };
        Split { threshold, planted_is_high, planted_median }
    }
}
