//! Cuts where the variance outside of a linear subspace jumps.
//!
//! After Barbič, Safonova, Pan, Faloutsos, Hodgins and Pollard, *Segmenting Motion Capture Data
//! into Distinct Behaviors*, Graphics Interface 2004, section 3.1; and a simpler rule with better
//! results: jumps of the variance beyond two dimensions, detected like those of maximum variance
//! unfolding.

use std::ops::Range;

use crate::numeric::stats::{mean, standard_deviation};
use crate::segments::body::Body;
use crate::segments::methods::growing_window::{JumpDetector, Window, residual};
use crate::segments::methods::method_info::{Input, MethodInfo, MethodOption, Output};
use crate::segments::pose::{Poses, RECORDED_RATE};
use crate::segments::progress::Checkpoint;
use crate::segments::{Curve, Residual, SegmentError};

pub(crate) const PCA: MethodInfo = MethodInfo {
    name: "pca",
    title: "PCA, as published",
    description: "Cuts where the error of the subspace of the first poses grows faster than before.",
    options: &[],
    refines_cuts: false,
    segment: segment_pca,
};

pub(crate) const PCA_TAIL: MethodInfo = MethodInfo {
    name: "pca-tail",
    title: "PCA tail",
    description: "Cuts where the variance beyond two dimensions jumps.",
    options: &[MethodOption::Dims(2)],
    refines_cuts: false,
    segment: segment_pca_tail,
};

/// Length of the first window, in seconds.
const FIRST_WINDOW: f64 = 2.0;
/// Fraction of the energy within the subspace.
const ENERGY_FRACTION: f64 = 0.9;
/// Time between the compared errors, and duration of the differences before the first decision, in
/// seconds.
const LAG: f64 = 0.5;
/// Threshold of a difference above the mean of the previous ones, in standard deviations.
const THRESHOLD_DEVIATIONS: f64 = 3.0;

fn segment_pca(input: &mut Input) -> Result<Output, SegmentError> {
    let body = Body::rotation_joints(input.clip, input.skeleton)?;
    let poses = Poses::new(input.clip, &body, &input.frames, RECORDED_RATE);
    let count = poses.count();
    let (first, lag) = ((FIRST_WINDOW * RECORDED_RATE) as usize, (LAG * RECORDED_RATE) as usize);
    let mut curve = Curve { title: "Error of the subspace", ..Curve::default() };
    let mut cuts = Vec::new();
    let mut start = 0;
    while start + first <= count {
        let mut window = Window::new(&poses.columns, start);
        let mut dims = 0;
        let (mut errors, mut differences): (Vec<f64>, Vec<f64>) = (Vec::new(), Vec::new());
        let mut next = count;
        for pose in start + first - 1..count {
            let end = pose + 1;
            (input.progress)(end as f64 / count as f64)?;
            window.grow_to(end);
            let eigenvalues = window.eigenvalues();
            if errors.is_empty() {
                dims = (1..eigenvalues.len())
                    .find(|&dims| {
                        residual(eigenvalues.as_slice(), dims, Residual::Ratio) <= 1.0 - ENERGY_FRACTION
                    })
                    .unwrap_or(eigenvalues.len());
            }
            let error = residual(eigenvalues.as_slice(), dims, Residual::Absolute);
            errors.push(error);
            let before = errors.len().checked_sub(lag + 1).map(|index| errors[index]);
            let threshold = before.filter(|_| differences.len() >= lag).map(|before| {
                before
                    + mean(differences.iter().copied())
                    + THRESHOLD_DEVIATIONS * standard_deviation(&differences)
            });
            curve.frames.push(poses.position(pose));
            curve.values.push(error);
            curve.threshold.push(threshold.unwrap_or(error));
            if threshold.is_some_and(|threshold| error > threshold) {
                next = pose;
                cuts.push(poses.frame(pose));
                break;
            }
            differences.extend(before.map(|before| error - before));
        }
        start = next;
    }
    Ok(Output::from_cuts(input.clip.frame_count(), &cuts, curve, body.notices()))
}

/// Pose rate of the tail method, in Hz.
const TAIL_RATE: f64 = 10.0;
/// First window 2 s, differences over 0.6 s, cuts 0.3 s before detection, windows of at most 20 s.
const JUMP_DETECTOR: JumpDetector =
    JumpDetector { first: 20, step: 2, lag: 3, factor: 3.0, min_differences: 4, lead: 3, max_length: 200 };

fn segment_pca_tail(input: &mut Input) -> Result<Output, SegmentError> {
    let body = Body::rotation_joints(input.clip, input.skeleton)?;
    let poses = Poses::new(input.clip, &body, &input.frames, TAIL_RATE);
    let dims = input.settings.dims;
    let mut window = Window::new(&poses.columns, 0);
    let window_residual = |requested: Range<usize>, _: &mut Checkpoint| {
        if requested.start != window.range().start {
            window = Window::new(&poses.columns, requested.start);
        }
        window.grow_to(requested.end);
        Ok(residual(window.eigenvalues().as_slice(), dims, Residual::Absolute))
    };
    let trace = JUMP_DETECTOR.trace(poses.count(), window_residual, input.progress)?;
    let cuts: Vec<usize> = trace.cuts.iter().map(|&cut| poses.frame(cut)).collect();
    let curve = trace.curve("Variance beyond the first dimensions", &poses);
    Ok(Output::from_cuts(input.clip.frame_count(), &cuts, curve, body.notices()))
}
