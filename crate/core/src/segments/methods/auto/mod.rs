//! Gaussian segments: cuts a clip where several distributions of poses describe it better than
//! fewer by more than the penalty of the Bayesian information criterion.
//!
//! The cost of a segment is its negative log-likelihood under its own Gaussian plus a penalty for
//! the parameters of that Gaussian. The cuts of minimum total cost are found exactly, by dynamic
//! programming with pruning.

mod gaussian;
mod pelt;

use gaussian::{DIMS, Gaussians};

use crate::notice::{Code, Notice};
use crate::segments::body::Body;
use crate::segments::methods::method_info::{Input, MethodInfo, Output};
use crate::segments::pose::Poses;
use crate::segments::{Curve, SegmentError};

/// Pose rate, in Hz. Higher rates repeat poses, which a likelihood counts as evidence.
const RATE: f64 = 10.0;
/// Minimum duration of a segment, in seconds; slower clips than [`RATE`] need as many poses.
const MIN_DURATION: f64 = 1.2;

pub(crate) const METHOD: MethodInfo = MethodInfo {
    name: "auto",
    title: "Gaussian segments",
    description: "Cuts where extra pose clusters improve the fit enough (penalised likelihood).",
    options: &[],
    refines_cuts: true,
    segment,
};

fn segment(input: &mut Input) -> Result<Output, SegmentError> {
    let body = Body::rotation_joints(input.clip, input.skeleton)?;
    let mut notices = body.notices();
    let poses = Poses::new(input.clip, &body, &input.frames, RATE);
    (input.progress)(0.2)?;
    let min_length = (MIN_DURATION * RATE).round() as usize;
    if poses.count() < 2 * min_length {
        let seconds = poses.seconds(min_length);
        let text = format!("The clip is shorter than two actions of {seconds:.1} s; it is one segment.");
        notices.push(Notice::new(Code::ShortClip, text));
    }
    let gaussians = Gaussians::new(&poses.columns);
    let count = poses.count();
    let cost = |start: usize, end: usize| gaussians.cost(start, end);
    let cuts = pelt::optimal_cuts(count, min_length, penalty(count), cost, &mut |fraction| {
        (input.progress)(0.2 + 0.8 * fraction)
    })?;
    let frames: Vec<usize> = cuts.iter().map(|&cut| poses.frame(cut)).collect();
    let curve = curve(&poses, &gaussians, &cuts, min_length);
    Ok(Output::from_cuts(input.clip.frame_count(), &frames, curve, notices))
}

/// Returns the penalty of a segment: half the logarithm of the number of poses for each parameter
/// of its mean and covariance and for its cut.
fn penalty(count: usize) -> f64 {
    let parameters = DIMS + DIMS * (DIMS + 1) / 2 + 1;
    0.5 * parameters as f64 * (count as f64).ln()
}

/// Returns the likelihood gained by a cut at each pose, between the cuts on both sides of the
/// nearest one.
fn curve(poses: &Poses, gaussians: &Gaussians, cuts: &[usize], min_length: usize) -> Curve {
    let count = poses.count();
    let bounds: Vec<usize> = std::iter::once(0).chain(cuts.iter().copied()).chain([count]).collect();
    let mut nearest = 1;
    let mut gain = |pose: usize| {
        while nearest + 2 < bounds.len() && bounds[nearest + 1] - pose < pose.saturating_sub(bounds[nearest])
        {
            nearest += 1;
        }
        let (start, end) = (bounds[nearest - 1], bounds[(nearest + 1).min(bounds.len() - 1)]);
        if pose < start + min_length || end < pose + min_length {
            return 0.0;
        }
        gaussians.cost(start, end) - gaussians.cost(start, pose) - gaussians.cost(pose, end)
    };
    let values: Vec<f64> = (0..count).map(&mut gain).collect();
    Curve {
        title: "Cut score (log-likelihood gain)",
        frames: (0..count).map(|column| poses.position(column)).collect(),
        threshold: vec![penalty(count); count],
        values,
        extrema: Vec::new(),
    }
}
