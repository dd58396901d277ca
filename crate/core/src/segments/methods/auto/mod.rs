//! Gaussian segments: the clip is cut where several distributions of poses describe it
//! so much better than fewer do that the Bayesian information criterion accepts the price.
//!
//! The cost of a segment is its negative log likelihood under a Gaussian of its own; each
//! segment costs a penalty besides, for the numbers that describe it. The cuts of least
//! cost are found exactly, by dynamic programming with pruning.

mod gaussian;
mod pelt;

use gaussian::DIMS;
use gaussian::Gaussians;

use crate::notice::{Code, Notice};
use crate::segments::body::Body;
use crate::segments::methods::Entry;
use crate::segments::pose::Poses;
use crate::segments::task::{Found, Task};
use crate::segments::{Curve, SegmentError};

/// Poses per second: more of them would only repeat each other, which a likelihood takes for evidence.
const RATE: f64 = 10.0;
/// The shortest segment, in seconds.
const SHORTEST: f64 = 1.2;

pub(crate) const METHOD: Entry = Entry {
    name: "auto",
    title: "Gaussian segments",
    about: "Cuts where several clouds of poses fit so much better than fewer that they are worth their price.",
    options: &[],
    segment,
};

fn segment(task: &mut Task) -> Result<Found, SegmentError> {
    let body = Body::turning(task.clip, task.skeleton)?;
    let mut notices = body.notices();
    let poses = Poses::of(task.clip, &body, &task.frames, RATE);
    (task.progress)(0.2)?;
    let shortest = (SHORTEST * RATE).round() as usize;
    if poses.count() < 2 * shortest {
        let text = format!("The clip is shorter than two actions of {SHORTEST} s: it is one.");
        notices.push(Notice::new(Code::ShortClip, text));
    }
    let gaussians = Gaussians::of(&poses.columns);
    let count = poses.count();
    let cost = |start: usize, end: usize| gaussians.cost(start, end);
    let cuts =
        pelt::cuts(count, shortest, penalty(count), cost, &mut |share| (task.progress)(0.2 + 0.8 * share))?;
    let frames: Vec<usize> = cuts.iter().map(|&cut| poses.frame(cut)).collect();
    let curve = curve(&poses, &gaussians, &cuts, shortest);
    Ok(Found::of_cuts(task.clip.frame_count(), &frames, curve, notices))
}

/// What a segment has to be worth: half the logarithm of the number of poses for each
/// number of its mean and covariance, and for its place.
fn penalty(count: usize) -> f64 {
    let numbers = DIMS + DIMS * (DIMS + 1) / 2 + 1;
    0.5 * numbers as f64 * (count as f64).ln()
}

/// What a cut at each place saves, or would save, between the cuts on both sides of the nearest one.
fn curve(poses: &Poses, gaussians: &Gaussians, cuts: &[usize], shortest: usize) -> Curve {
    let count = poses.count();
    let bounds: Vec<usize> = std::iter::once(0).chain(cuts.iter().copied()).chain([count]).collect();
    let mut nearest = 1;
    let mut saved = |place: usize| {
        while nearest + 2 < bounds.len()
            && bounds[nearest + 1] - place < place.saturating_sub(bounds[nearest])
        {
            nearest += 1;
        }
        let (start, end) = (bounds[nearest - 1], bounds[(nearest + 1).min(bounds.len() - 1)]);
        if place < start + shortest || end < place + shortest {
            return 0.0;
        }
        gaussians.cost(start, end) - gaussians.cost(start, place) - gaussians.cost(place, end)
    };
    let values: Vec<f64> = (0..count).map(&mut saved).collect();
    Curve {
        title: "Likelihood gained by a cut",
        frames: (0..count).map(|column| poses.place(column)).collect(),
        threshold: vec![penalty(count); count],
        values,
        extrema: Vec::new(),
    }
}
