//! Cuts where what comes next is unlikely under the distribution of what has been.
//!
//! After Barbič, Safonova, Pan, Faloutsos, Hodgins and Pollard, *Segmenting Motion Capture
//! Data into Distinct Behaviors*, Graphics Interface 2004, section 3.2: a Gaussian with a few
//! full dimensions and noise in the others (probabilistic principal components) is fitted to
//! all poses since the last cut, and the mean Mahalanobis distance of the next ones followed
//! through a valley up to its peak.

use nalgebra::DMatrixView;

use crate::segments::body::Body;
use crate::segments::methods::growing_window::{Moments, residual};
use crate::segments::methods::{Entry, MethodOption};
use crate::segments::pose::{Poses, RECORDED_RATE};
use crate::segments::task::{Found, Task};
use crate::segments::{Curve, Residual, SegmentError};

use crate::numeric::sort;

pub(crate) const METHOD: Entry = Entry {
    name: "ppca",
    title: "Probabilistic PCA",
    about: "Cuts where the next poses are most unlikely under the distribution of those before.",
    options: &[MethodOption::Published],
    segment,
};

/// First window, and the stretch ahead that is judged, in seconds: the paper's 1.25 is no whole number of poses.
const STRETCH: f64 = 1.5;
/// Share of the variance that the full dimensions keep.
const KEPT: f64 = 0.95;
/// Least variance of the others, in squares of quaternion units.
const LEAST_NOISE: f64 = 1e-3;
/// How many times the valley's distance a peak has at least.
const PEAK: f64 = 5.0;
/// What a peak has at least as published, whatever the valley: with these poses every stretch has.
const PUBLISHED_PEAK: f64 = 15.0;

fn segment(task: &mut Task) -> Result<Found, SegmentError> {
    let body = Body::turning(task.clip, task.skeleton)?;
    let poses = Poses::of(task.clip, &body, &task.frames, RECORDED_RATE);
    let (count, stretch) = (poses.count(), (STRETCH * RECORDED_RATE).round() as usize);
    let mut curve = Curve { title: "Mahalanobis distance of what comes next", ..Curve::default() };
    let mut cuts = Vec::new();
    let mut start = 0;
    while start + 2 * stretch <= count {
        let mut moments = Moments::new(poses.columns.nrows());
        for place in start..start + stretch {
            moments.add(poses.columns.column(place));
        }
        let mut valley = f64::INFINITY;
        let mut peak: Option<(f64, usize)> = None;
        let mut next = count;
        for place in start + stretch..=count - stretch {
            (task.progress)(place as f64 / count as f64)?;
            let distance = distance(&moments, place - start, poses.columns.columns(place, stretch));
            // Poses of the same distribution have as many as it has dimensions.
            let usual = poses.columns.nrows() as f64;
            let limit = if task.params.published() { PUBLISHED_PEAK } else { (PEAK * valley).max(usual) };
            curve.frames.push(poses.place(place));
            curve.values.push(distance);
            curve.threshold.push(if limit.is_finite() { limit } else { distance });
            match peak {
                Some((highest, at)) if distance < highest => {
                    next = at;
                    cuts.push(poses.frame(at));
                    break;
                }
                None if distance < limit => {}
                _ => peak = Some((distance, place)),
            }
            valley = valley.min(distance);
            moments.add(poses.columns.column(place));
        }
        start = next;
    }
    Ok(Found::of_cuts(task.clip.frame_count(), &cuts, curve, body.notices()))
}

/// Mean squared Mahalanobis distance of `ahead` from the Gaussian of `count` poses.
fn distance(moments: &Moments, count: usize, ahead: DMatrixView<f64>) -> f64 {
    let eigen = (moments.scatter() / count as f64).symmetric_eigen();
    let values = eigen.eigenvalues.as_slice();
    let kept = (1..values.len())
        .find(|&dims| residual(values, dims, Residual::Ratio) <= 1.0 - KEPT)
        .unwrap_or(values.len());
    let rest = residual(values, kept, Residual::Absolute);
    let noise = (rest / (values.len() - kept).max(1) as f64).max(LEAST_NOISE);
    let order = sort::descending(values);
    let mean = moments.mean();
    let mut sum = 0.0;
    for pose in ahead.column_iter() {
        let difference = pose - &mean;
        // All of it as noise, then the full dimensions put right.
        sum += difference.norm_squared() / noise;
        for &index in &order[..kept] {
            let along = eigen.eigenvectors.column(index).dot(&difference);
            sum += along * along * (values[index].max(LEAST_NOISE).recip() - noise.recip());
        }
    }
    sum / ahead.ncols() as f64
}
