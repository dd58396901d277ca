//! Segmentation by the curve of least-squares distances to a template pose.
//!
//! After Zhang, Liu and Wei, patent CN102819549 (2012). The distance of a pose to the template is
//! measured after optimal rotation. Turning points of that curve are extreme poses; between them
//! lie motifs. Similar motifs have the same class. Classes that repeat in a cycle form a periodic
//! action; motifs between periodic actions are split or form a transition.
//!
//! Data flow: [`PoseShapes`] → distances → [`wavelet`] → [`smooth`] → [`extrema`] → [`motifs`] →
//! [`actions`] → [`refine`]. Numbers that the patent leaves open were chosen on recorded motion
//! with published cuts. As published, each wavelet level has its own threshold, nothing is
//! smoothed, and motifs may be split even if one occurs on both sides.

mod action;
mod actions;
mod align;
mod extrema;
mod motifs;
mod periods;
mod pose_shapes;
mod refine;
mod smooth;
mod template;
#[cfg(test)]
mod tests;
mod wavelet;

use std::ops::Range;

use crate::segments::body::Body;
use crate::segments::grid::SampleGrid;
use crate::segments::methods::method_info::{Input, MethodInfo, MethodOption, Output};
use crate::segments::{Curve, Kind, Motif, Segment, SegmentError};
use action::Action;
use actions::Sequence;
use align::Shape;
use motifs::MotifCurve;
use pose_shapes::PoseShapes;

pub(crate) const METHOD: MethodInfo = MethodInfo {
    name: "lsd",
    title: "Distance to a template pose",
    description: "Motifs between the turning points of the least-squares distance to a template pose; \
            an action repeats its motifs or lies between such actions.",
    options: &[MethodOption::Template, MethodOption::Published],
    refines_cuts: false,
    segment,
};

/// Minimum change between turning points, in squared length units in which a leg is 15.94: the
/// threshold of the patent.
const MIN_CHANGE: f64 = 6.5;

/// Sample rate of the curve, in Hz; samples coincide with frames of clips at 30, 60 and 120 Hz.
const RATE: f64 = 30.0;

/// Number of wavelet levels: the five levels of the patent at 120 Hz (section 4.1, step 1) without
/// the two that a lower rate removes.
const LEVELS: usize = 3;

/// Standard deviation of the smoothing of curve and poses, in samples: 80 ms. The effect of noise
/// on a curve at 24 Hz is then small compared with [`MIN_CHANGE`].
const SMOOTHING: f64 = 0.08 * RATE;

/// Number of frames between progress reports.
const PROGRESS_INTERVAL: usize = 256;

/// Maximum number of motif classes in the label of an action that does not repeat.
const MAX_LABEL_CLASSES: usize = 12;

fn segment(input: &mut Input) -> Result<Output, SegmentError> {
    let body = Body::position_joints(input.clip, input.skeleton)?;
    let mut poses = PoseShapes::new(input.clip, input.skeleton, &body);
    let grid = SampleGrid::new(input.clip, &input.frames, RATE);
    let published = input.settings.published;
    let deviation = if published { 0.0 } else { SMOOTHING };

    let distances = distances(input, &mut poses)?;
    let values =
        smooth::curve(&wavelet::denoise(&grid.sample_curve(&distances), LEVELS, published), deviation);
    let mut turns = extrema::turning_points(&values, MIN_CHANGE);
    // A glitch may turn the curve twice between two frames.
    turns.dedup_by_key(|turn| grid.frame(*turn));

    let mut smoothed_shape =
        |turn| smooth::shape(turn, deviation, grid.count(), |sample| poses.shape(grid.frame(sample)));
    let shapes: Vec<Shape> = turns.iter().map(|&turn| smoothed_shape(turn)).collect();
    let curves = motifs::curves(&values, &turns);
    let classes = motifs::classes(&curves, &shapes, values.len(), &mut || (input.progress)(0.9))?;
    let sequence = Sequence {
        times: turns.iter().map(|&turn| grid.seconds(turn)).collect(),
        changes: curves.iter().map(MotifCurve::change).collect(),
        classes,
    };
    let actions = actions::actions(&sequence, published);

    // The first and the last turning point are the ends of the motion, independent of rounding.
    let mut frames: Vec<usize> = turns.iter().map(|&turn| grid.frame(turn)).collect();
    if let [_, .., last] = &mut frames[..] {
        *last = input.frames.end;
    }
    let transition = |pair: &[Action]| frames[pair[0].motifs.end]..frames[pair[1].motifs.start];
    let mut starts = vec![0];
    for pair in actions.windows(2) {
        (input.progress)(0.9)?;
        let [before, after] = [&pair[0], &pair[1]].map(|a| frames[a.motifs.start]..frames[a.motifs.end]);
        starts.push(refine::refine_cut(&mut poses, input.clip.rate(), before, after));
    }
    let ends = starts.iter().skip(1).copied().chain([input.clip.frame_count()]);
    let segments = actions.iter().zip(starts.iter().zip(ends));
    let segments = segments
        .map(|(action, (&start, end))| labelled_segment(action, start..end, &sequence.classes))
        .collect();

    Ok(Output {
        segments,
        transitions: actions.windows(2).map(transition).filter(|frames| !frames.is_empty()).collect(),
        motifs: frames
            .windows(2)
            .zip(sequence.classes.iter().zip(&sequence.changes))
            .map(|(ends, (&class, &amplitude))| Motif { frames: ends[0]..ends[1], class, amplitude })
            .collect(),
        curve: Curve {
            title: "Distance to the template",
            frames: (0..values.len()).map(|sample| grid.position(sample)).collect(),
            values,
            threshold: Vec::new(),
            extrema: turns,
        },
        notices: body.notices(),
    })
}

/// Returns the distance of each frame to the template (patent, step S3).
fn distances(input: &mut Input, poses: &mut PoseShapes) -> Result<Vec<f64>, SegmentError> {
    let template = template::template(input, poses)?;
    let mut distances = Vec::with_capacity(input.frames.len());
    for frame in input.frames.clone() {
        if distances.len().is_multiple_of(PROGRESS_INTERVAL) {
            (input.progress)(0.1 + 0.8 * distances.len() as f64 / input.frames.len() as f64)?;
        }
        distances.push(poses.shape(frame).distance(&template));
    }
    Ok(distances)
}

fn labelled_segment(action: &Action, frames: Range<usize>, classes: &[usize]) -> Segment {
    let (kind, classes) = match &action.cycle[..] {
        [] => (Kind::Aperiodic, &classes[action.motifs.clone()]),
        cycle => (Kind::Periodic, cycle),
    };
    let listed = classes.iter().take(MAX_LABEL_CLASSES).map(usize::to_string);
    let more = (classes.len() > MAX_LABEL_CLASSES).then(|| "…".to_owned());
    Segment::new(frames, kind, listed.chain(more).collect::<Vec<_>>().join(" "))
}
