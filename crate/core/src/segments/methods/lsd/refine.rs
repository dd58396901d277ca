//! Refinement of a cut within its transition (patent, section 4.3).

use std::ops::Range;

use crate::segments::methods::lsd::align::Shape;
use crate::segments::methods::lsd::pose_shapes::PoseShapes;
use crate::segments::refine::least_prefix;

/// Duration of the end or beginning of an action that represents its poses, in seconds.
const REFERENCE_DURATION: f64 = 1.0;

/// Rate of the compared poses, in Hz: the resolution of the cut.
const RATE: f64 = 30.0;

/// Returns the first frame of the second of two actions.
pub(crate) fn refine_cut(
    poses: &mut PoseShapes,
    rate: f64,
    before: Range<usize>,
    after: Range<usize>,
) -> usize {
    let between = before.end..after.start;
    if between.is_empty() {
        return between.end;
    }
    let step = ((rate / RATE).round() as usize).max(1);
    let reference_frames = ((rate * REFERENCE_DURATION).round() as usize).max(1);
    let before_frames = before.start.max(before.end.saturating_sub(reference_frames))..before.end;
    let after_frames = after.start..after.end.min(after.start.saturating_add(reference_frames));
    let [before_frames, shapes, after_frames] = [before_frames, between.clone(), after_frames]
        .map(|frames| frames.step_by(step).map(|frame| poses.shape(frame)).collect::<Vec<_>>());
    let split = best_split(&shapes, &before_frames, &after_frames);
    between.clone().step_by(step).nth(split).unwrap_or(between.end)
}

/// Returns the number of shapes that belong to the first action, so that the total distance of the
/// shapes to the nearest shape of their action is minimal.
fn best_split(between: &[Shape], before: &[Shape], after: &[Shape]) -> usize {
    let nearest = |shape: &Shape, side: &[Shape]| {
        side.iter().map(|other| shape.distance(other)).fold(f64::INFINITY, f64::min)
    };
    least_prefix(between.iter().map(|shape| nearest(shape, before) - nearest(shape, after)))
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;

    use super::*;

    fn shapes(bends: &[f64]) -> Vec<Shape> {
        let arm = |&bend: &f64| {
            Shape::new(
                [[0.0, 0.0], [1.0, 0.0], [2.0, bend]].map(|[x, y]| Vector3::new(x, y, 0.0)).into_iter(),
            )
        };
        bends.iter().map(arm).collect()
    }

    #[test]
    fn shapes_belong_to_the_more_similar_action() {
        let (low, high) = (shapes(&[0.0, 0.3, 0.1]), shapes(&[2.0, 1.8]));
        assert_eq!(best_split(&shapes(&[0.1, 0.2, 0.6, 1.5, 1.9]), &low, &high), 3);
        // A single deviation does not change the result.
        assert_eq!(best_split(&shapes(&[0.1, 1.2, 0.2, 1.9, 1.9]), &low, &high), 3);
        assert_eq!(best_split(&shapes(&[1.5, 1.9]), &low, &high), 0);
        assert_eq!(best_split(&shapes(&[0.1, 0.2]), &low, &high), 2);
        assert_eq!(best_split(&[], &low, &high), 0);
    }
}
