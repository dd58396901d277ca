//! Cuts where the next poses are unlikely under the distribution of the previous ones.
//!
//! After Barbič, Safonova, Pan, Faloutsos, Hodgins and Pollard, *Segmenting Motion Capture Data
//! into Distinct Behaviors*, Graphics Interface 2004, section 3.2. A Gaussian with a few principal
//! dimensions and isotropic noise in the others (probabilistic PCA) is fitted to all poses since
//! the last cut. The mean Mahalanobis distance of the next poses is followed through a valley to
//! its peak.

use nalgebra::DMatrixView;

use crate::numeric::sort;
use crate::segments::body::Body;
use crate::segments::methods::growing_window::{Window, residual};
use crate::segments::methods::method_info::{Input, MethodInfo, MethodOption, Output};
use crate::segments::pose::{Poses, RECORDED_RATE};
use crate::segments::{Curve, Residual, SegmentError};

pub(crate) const METHOD: MethodInfo = MethodInfo {
    name: "ppca",
    title: "Probabilistic PCA",
    description: "Cuts where the next poses are least likely under the distribution of the previous ones.",
    options: &[MethodOption::Published],
    refines_cuts: false,
    segment,
};

/// Length of the first window and of the window ahead, in seconds; the 1.25 s of the paper is not a
/// whole number of poses.
const WINDOW: f64 = 1.5;
/// Fraction of the variance within the principal dimensions.
const VARIANCE_FRACTION: f64 = 0.95;
/// Minimum variance of the noise, in squared quaternion units.
const MIN_NOISE: f64 = 1e-3;
/// Minimum height of a peak, as a multiple of the valley.
const PEAK_FACTOR: f64 = 5.0;
/// Minimum height of a peak as published, independent of the valley; with these poses every window
/// exceeds it.
const PUBLISHED_PEAK: f64 = 15.0;

fn segment(input: &mut Input) -> Result<Output, SegmentError> {
    let body = Body::rotation_joints(input.clip, input.skeleton)?;
    let poses = Poses::new(input.clip, &body, &input.frames, RECORDED_RATE);
    let (count, length) = (poses.count(), (WINDOW * RECORDED_RATE).round() as usize);
    let mut curve = Curve { title: "Mahalanobis distance of the next poses", ..Curve::default() };
    let mut cuts = Vec::new();
    let mut start = 0;
    while start + 2 * length <= count {
        let mut window = Window::new(&poses.columns, start);
        let mut valley = f64::INFINITY;
        let mut peak: Option<(f64, usize)> = None;
        let mut next = count;
        for pose in start + length..=count - length {
            (input.progress)(pose as f64 / count as f64)?;
            window.grow_to(pose);
            let distance = distance(&window, poses.columns.columns(pose, length));
            // Expected distance of poses of the same distribution: the number of dimensions.
            let expected = poses.columns.nrows() as f64;
            let threshold =
                if input.settings.published { PUBLISHED_PEAK } else { (PEAK_FACTOR * valley).max(expected) };
            curve.frames.push(poses.position(pose));
            curve.values.push(distance);
            curve.threshold.push(if threshold.is_finite() { threshold } else { distance });
            match peak {
                Some((highest, at)) if distance < highest => {
                    next = at;
                    cuts.push(poses.frame(at));
                    break;
                }
                None if distance < threshold => {}
                _ => peak = Some((distance, pose)),
            }
            valley = valley.min(distance);
        }
        start = next;
    }
    Ok(Output::from_cuts(input.clip.frame_count(), &cuts, curve, body.notices()))
}

/// Returns the mean squared Mahalanobis distance of the poses `ahead` from the Gaussian of a window.
fn distance(window: &Window, ahead: DMatrixView<f64>) -> f64 {
    let (scatter, directions) = window.eigen();
    let variances = scatter / window.range().len() as f64;
    let values = variances.as_slice();
    let dims = (1..values.len())
        .find(|&dims| residual(values, dims, Residual::Ratio) <= 1.0 - VARIANCE_FRACTION)
        .unwrap_or(values.len());
    let rest = residual(values, dims, Residual::Absolute);
    let noise = (rest / (ahead.nrows() - dims).max(1) as f64).max(MIN_NOISE);
    let order = sort::argsort_descending(values);
    let mean = window.mean();
    let mut sum = 0.0;
    for next_pose in ahead.column_iter() {
        let difference = next_pose - &mean;
        // The whole difference counts as noise; the principal dimensions are then corrected.
        sum += difference.norm_squared() / noise;
        for &index in &order[..dims] {
            let along = directions.column(index).dot(&difference);
            sum += along * along * (values[index].max(MIN_NOISE).recip() - noise.recip());
        }
    }
    sum / ahead.ncols() as f64
}
