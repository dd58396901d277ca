//! From samples to two classes: the threshold.

use std::sync::Arc;

use crate::plants::signal::samples::Samples;
use crate::plants::spectral::bandwidth::Scale;
use crate::plants::spectral::degree::Roots;
use crate::plants::spectral::field::Field;
use crate::plants::spectral::two_means::Classes;
use crate::plants::spectral::{bandwidth, two_means};

/// How a clustering came about, for showing why a frame is planted.
#[derive(Clone, Debug, PartialEq)]
pub struct Evidence {
    /// The frames that were clustered; others belong to no motion.
    pub frames: Arc<[usize]>,
    /// Norm of each sample; the left foot's frames, then the right's (paper, figure 4a).
    pub norms: Vec<f32>,
    /// Norms of all samples of both feet, ascending (paper, figure 4b).
    pub sorted_norms: Arc<[f64]>,
    /// Index into them of the knee.
    pub knee: usize,
    /// What the variance was compared with: r, or more of it for a wider window.
    pub tolerance: f64,
    /// Scale of the kernel: the norm at the knee, unless set by hand.
    pub sigma: f64,
    /// u: the value that parts the samples, the root of each one's degree unless the
    /// method has another; the left foot's frames, then the right's.
    pub roots: Vec<f32>,
    /// Samples to either side of this value of u are alike in being planted or not.
    pub threshold: f64,
    /// Whether the planted ones are those above.
    pub planted_is_high: bool,
    /// Median u of the planted class.
    pub planted_middle: f64,
    /// u of any foot, where it is the root of a degree with the same scale for all samples.
    pub field: Option<Field>,
}

impl Evidence {
    /// Sample variance of the first norms up to each one (paper, figure 5).
    pub fn running_variance(&self) -> impl Iterator<Item = f64> {
        bandwidth::running_variance(&self.sorted_norms)
    }
}

/// Where the threshold lies between two classes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Between {
    /// In the middle of the gap that two-means leaves: the paper's.
    Gap,
    /// Halfway between the medians of the classes.
    Medians,
}

/// Parts samples by a value that each has, and tells which are planted.
///
/// Two-means finds the classes; the one of the lower mean norm is planted.
/// Where all samples are at rest or alike, all are planted. Values that are only close are made
/// exact where they decide.
pub(crate) fn divide<'a>(
    frames: Arc<[usize]>,
    samples: &Samples,
    scale: Scale,
    sigma: f64,
    values: impl Into<Roots<'a>>,
    between: Between,
) -> (Evidence, Vec<bool>) {
    let mut roots = values.into();
    let mut sorted = two_means::sorted(&roots.values);
    let mut classes = two_means::classes(&sorted);
    let part = |classes: &Option<Classes>, values: &[f64]| {
        classes.map(|classes| Parting::of(classes, values, &samples.norms, between))
    };
    let mut parting = part(&classes, &roots.values);
    while let Some(found) = &parting
        && let Some(band) = roots.settle(found.threshold)
    {
        two_means::sort_band(&mut sorted, &roots.values, band);
        classes = two_means::classes(&sorted);
        parting = part(&classes, &roots.values);
    }
    drop(sorted);
    let planted = match &parting {
        Some(found) => {
            roots.values.iter().map(|&value| (value > found.threshold) == found.planted_is_high).collect()
        }
        None => vec![true; samples.len()],
    };
    let evidence = Evidence {
        frames,
        norms: single(&samples.norms),
        sorted_norms: scale.sorted,
        knee: scale.knee,
        tolerance: scale.tolerance,
        sigma,
        roots: single(&roots.values),
        threshold: parting.as_ref().map_or(f64::NEG_INFINITY, |found| found.threshold),
        planted_is_high: parting.as_ref().is_none_or(|found| found.planted_is_high),
        planted_middle: parting.map_or(0.0, |found| found.planted_middle),
        field: None,
    };
    (evidence, planted)
}

/// In single precision: close enough to show.
pub(crate) fn single(values: &[f64]) -> Vec<f32> {
    values.iter().map(|&value| value as f32).collect()
}

/// Two classes of values.
struct Parting {
    threshold: f64,
    /// Whether the planted class is the one above.
    planted_is_high: bool,
    /// Its median.
    planted_middle: f64,
}

impl Parting {
    /// By two-means.
    fn of(classes: Classes, values: &[f64], norms: &[f64], between: Between) -> Parting {
        let Classes { threshold: gap, medians: [low_middle, high_middle] } = classes;
        let mean_norm = |is_high: bool| {
            let class = || values.iter().zip(norms).filter(|&(&value, _)| (value > gap) == is_high);
            class().map(|(_, norm)| norm).sum::<f64>() / class().count() as f64
        };
        let planted_is_high = mean_norm(true) < mean_norm(false);
        let threshold = match between {
            Between::Gap => gap,
            Between::Medians => (low_middle + high_middle) / 2.0,
        };
        let planted_middle = if planted_is_high { high_middle } else { low_middle };
        Parting { threshold, planted_is_high, planted_middle }
    }
}
