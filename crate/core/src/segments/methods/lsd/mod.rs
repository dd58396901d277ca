//! The curve of least-squares distances to a template pose.
//!
//! After Zhang, Liu and Wei, patent CN102819549 (2012). Each pose is as far from the template
//! as its joints are when it is turned to lie best on it. Where that curve turns, extreme
//! poses are: between them lie motifs. Motifs that are alike have the same class; classes that
//! repeat in turn make a periodic action, what lies between is split or is a transition.
//!
//! The way of the data: [`Stage`] (shapes of the body) → distances → [`wavelet`] → [`blur`] →
//! [`extrema`] → [`motifs`] → [`actions`] → [`refine`]. Where the patent leaves numbers open, they
//! were chosen on recorded motion with published cuts. As published, thresholds of the wavelet are
//! each level's own, nothing is blurred, and a stretch may be split between motifs that come again
//! after the split.

mod actions;
mod align;
mod blur;
mod cluster;
mod extrema;
mod motifs;
mod periods;
mod refine;
mod stage;
mod template;
#[cfg(test)]
mod tests;
mod wavelet;

use std::ops::Range;

use crate::segments::body::Body;
use crate::segments::grid::Grid;
use crate::segments::methods::{Entry, MethodOption};
use crate::segments::task::{Found, Task};
use crate::segments::{Curve, Kind, Motif, Segment, SegmentError};
use actions::Action;
use actions::Sequence;
use align::Shape;
use motifs::Outline;
use stage::Stage;

pub(crate) const METHOD: Entry = Entry {
    name: "lsd",
    title: "Distance to a template pose",
    about: "Motifs between the turning points of the least-squares distance to a template pose: \
            what repeats its motifs is one action, and so is what lies between.",
    options: &[MethodOption::Template, MethodOption::Published],
    segment,
};

/// Least change between turning points, in units of squared length that make a leg 15.94:
/// the patent's threshold.
const LEAST_CHANGE: f64 = 6.5;

/// Samples of the curve per second: frames that clips of 30, 60 and 120 Hz share.
const RATE: f64 = 30.0;

/// Levels of the wavelet: with those that no longer are, the patent's five at 120 Hz (section 4.1, step 1).
const LEVELS: usize = 3;

/// Standard deviation, in samples, over which curve and poses are blurred: 80 ms. By then what noise
/// does to a curve of 24 Hz is small beside [`LEAST_CHANGE`].
const BLUR: f64 = 0.08 * RATE;

/// Frames from one report of progress to the next.
const REPORT: usize = 256;

/// Motif classes in the label of an action that does not repeat: more are not read.
const LONGEST_LABEL: usize = 12;

fn segment(task: &mut Task) -> Result<Found, SegmentError> {
    let body = Body::placed(task.clip, task.skeleton)?;
    let mut stage = Stage::of(task.clip, task.skeleton, &body);
    let grid = Grid::over(task.clip, &task.frames, RATE);
    let published = task.params.published();
    let deviation = if published { 0.0 } else { BLUR };

    let distances = distances(task, &mut stage)?;
    let values = blur::curve(&wavelet::denoised(&grid.sampled(&distances), LEVELS, published), deviation);
    let mut turns = extrema::turning_points(&values, LEAST_CHANGE);
    // A glitch may turn the curve twice between two frames.
    turns.dedup_by_key(|turn| grid.frame(*turn));

    let mut near =
        |turn| blur::shape(turn, deviation, grid.count(), |sample| stage.shape(grid.frame(sample)));
    let shapes: Vec<Shape> = turns.iter().map(|&turn| near(turn)).collect();
    let outlines = motifs::outlines(&values, &turns);
    let classes = motifs::classes(&outlines, &shapes, &mut || (task.progress)(0.9))?;
    let sequence = Sequence {
        times: turns.iter().map(|&turn| grid.seconds(turn)).collect(),
        rises: outlines.iter().map(Outline::rise).collect(),
        classes,
    };
    let actions = actions::actions(&sequence, published);

    // The first and the last turning point are the ends of the motion, whatever was rounded.
    let mut frames: Vec<usize> = turns.iter().map(|&turn| grid.frame(turn)).collect();
    if let [_, .., last] = &mut frames[..] {
        *last = task.frames.end;
    }
    let between = |pair: &[Action]| frames[pair[0].motifs.end]..frames[pair[1].motifs.start];
    let mut starts = vec![0];
    for pair in actions.windows(2) {
        (task.progress)(0.9)?;
        let [before, after] = [&pair[0], &pair[1]].map(|a| frames[a.motifs.start]..frames[a.motifs.end]);
        starts.push(refine::cut(&mut stage, task.clip.rate(), before, after));
    }
    let ends = starts.iter().skip(1).copied().chain([task.clip.frame_count()]);
    let segments = actions.iter().zip(starts.iter().zip(ends));
    let segments =
        segments.map(|(action, (&start, end))| named(action, start..end, &sequence.classes)).collect();

    Ok(Found {
        segments,
        transitions: actions.windows(2).map(between).filter(|frames| !frames.is_empty()).collect(),
        motifs: frames
            .windows(2)
            .zip(sequence.classes.iter().zip(&sequence.rises))
            .map(|(ends, (&class, &amplitude))| Motif { frames: ends[0]..ends[1], class, amplitude })
            .collect(),
        curve: Curve {
            title: "Distance to the template",
            frames: (0..values.len()).map(|sample| grid.place(sample)).collect(),
            values,
            threshold: Vec::new(),
            extrema: turns,
        },
        notices: body.notices(),
    })
}

/// The distance of each frame from the template (patent, step S3).
fn distances(task: &mut Task, stage: &mut Stage) -> Result<Vec<f64>, SegmentError> {
    let template = template::template(task, stage)?;
    let mut distances = Vec::with_capacity(task.frames.len());
    for frame in task.frames.clone() {
        if distances.len().is_multiple_of(REPORT) {
            (task.progress)(0.1 + 0.8 * distances.len() as f64 / task.frames.len() as f64)?;
        }
        distances.push(stage.shape(frame).distance(&template));
    }
    Ok(distances)
}

fn named(action: &Action, frames: Range<usize>, classes: &[usize]) -> Segment {
    let (kind, classes) = match &action.cycle[..] {
        [] => (Kind::Aperiodic, &classes[action.motifs.clone()]),
        cycle => (Kind::Periodic, cycle),
    };
    let shown = classes.iter().take(LONGEST_LABEL).map(usize::to_string);
    let more = (classes.len() > LONGEST_LABEL).then(|| "…".to_owned());
    Segment { frames, kind, label: shown.chain(more).collect::<Vec<_>>().join(" ") }
}
