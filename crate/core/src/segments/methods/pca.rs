//! Cuts where what a linear subspace leaves over jumps.
//!
//! After Barbič, Safonova, Pan, Faloutsos, Hodgins and Pollard, *Segmenting Motion Capture
//! Data into Distinct Behaviors*, Graphics Interface 2004, section 3.1; and a simpler rule
//! that does better: the variance beyond two dimensions, judged as that of
//! maximum variance unfolding is.

use crate::segments::body::Body;
use crate::segments::methods::growing_window::{Jumps, Moments, residual};
use crate::segments::methods::{Entry, MethodOption};
use crate::segments::pose::{Poses, RECORDED_RATE};
use crate::segments::task::{Found, Pause, Task};
use crate::segments::{Curve, Residual, SegmentError};

pub(crate) const BARBIC: Entry = Entry {
    name: "pca",
    title: "PCA, as published",
    about: "Cuts where the error of the subspace that held the beginning grows faster than it did.",
    options: &[],
    segment: barbic,
};

pub(crate) const TAIL: Entry = Entry {
    name: "pca-tail",
    title: "PCA tail",
    about: "Cuts where the variance that two dimensions leave over jumps.",
    options: &[MethodOption::Dims(2)],
    segment: tail,
};

/// First window, in seconds.
const FIRST: f64 = 2.0;
/// Share of the energy that the subspace keeps.
const KEPT: f64 = 0.9;
/// Seconds from one error to the one it is compared with, and of differences before they are judged.
const LAG: f64 = 0.5;
/// Standard deviations by which a difference has to exceed the mean of those before.
const DEVIATIONS: f64 = 3.0;

fn barbic(task: &mut Task) -> Result<Found, SegmentError> {
    let body = Body::turning(task.clip, task.skeleton)?;
    let poses = Poses::of(task.clip, &body, &task.frames, RECORDED_RATE);
    let count = poses.count();
    let (first, lag) = ((FIRST * RECORDED_RATE) as usize, (LAG * RECORDED_RATE) as usize);
    let mut curve = Curve { title: "Error of the subspace", ..Curve::default() };
    let mut cuts = Vec::new();
    let mut start = 0;
    while start + first <= count {
        let mut moments = Moments::new(poses.columns.nrows());
        let mut dims = 0;
        let (mut errors, mut rises): (Vec<f64>, Vec<f64>) = (Vec::new(), Vec::new());
        let mut next = count;
        for place in start..count {
            moments.add(poses.columns.column(place));
            let end = place + 1;
            if end < start + first {
                continue;
            }
            (task.progress)(end as f64 / count as f64)?;
            let eigenvalues = moments.spread();
            if errors.is_empty() {
                dims = (1..eigenvalues.len())
                    .find(|&dims| residual(eigenvalues.as_slice(), dims, Residual::Ratio) <= 1.0 - KEPT)
                    .unwrap_or(eigenvalues.len());
            }
            let error = residual(eigenvalues.as_slice(), dims, Residual::Absolute);
            errors.push(error);
            let before = errors.len().checked_sub(lag + 1).map(|index| errors[index]);
            let limit = before
                .filter(|_| rises.len() >= lag)
                .map(|before| before + mean(&rises) + DEVIATIONS * deviation(&rises));
            curve.frames.push(poses.place(place));
            curve.values.push(error);
            curve.threshold.push(limit.unwrap_or(error));
            if limit.is_some_and(|limit| error > limit) {
                next = place;
                cuts.push(poses.frame(place));
                break;
            }
            rises.extend(before.map(|before| error - before));
        }
        start = next;
    }
    Ok(Found::of_cuts(task.clip.frame_count(), &cuts, curve, body.notices()))
}

/// Poses per second that the tail is judged by.
const TAIL_RATE: f64 = 10.0;
/// A first window of 2 s, differences over 0.6 s, cuts 0.3 s before they show, windows of at most 20 s.
const JUMPS: Jumps = Jumps { first: 20, step: 2, lag: 3, factor: 3.0, fewest: 4, early: 3, longest: 200 };

fn tail(task: &mut Task) -> Result<Found, SegmentError> {
    let body = Body::turning(task.clip, task.skeleton)?;
    let poses = Poses::of(task.clip, &body, &task.frames, TAIL_RATE);
    let dims = task.params.dims().unwrap_or_default();
    let mut window = 0..0;
    let mut moments = Moments::new(poses.columns.nrows());
    let of_window = |wanted: std::ops::Range<usize>, _: &mut Pause| {
        if wanted.start != window.start || window.end > wanted.end {
            moments = Moments::new(poses.columns.nrows());
            window = wanted.start..wanted.start;
        }
        for place in window.end..wanted.end {
            moments.add(poses.columns.column(place));
        }
        window = wanted;
        Ok(residual(moments.spread().as_slice(), dims, Residual::Absolute))
    };
    let traced = JUMPS.trace(poses.count(), of_window, task.progress)?;
    let cuts: Vec<usize> = traced.cuts.iter().map(|&cut| poses.frame(cut)).collect();
    let curve = traced.curve("Variance beyond the kept dimensions", &poses);
    Ok(Found::of_cuts(task.clip.frame_count(), &cuts, curve, body.notices()))
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// Standard deviation about the mean, with n.
fn deviation(values: &[f64]) -> f64 {
    let mean = mean(values);
    (values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / values.len() as f64).sqrt()
}
