//! Where in a transition one action goes over into the next (patent, section 4.3).

use std::ops::Range;

use crate::segments::methods::lsd::align::Shape;
use crate::segments::methods::lsd::stage::Stage;

/// What an action's poses are known by: so much of its end or beginning, in seconds.
const NEAR: f64 = 1.0;

/// Poses per second that are compared: the cut is as exact.
const RATE: f64 = 30.0;

/// The first frame of the second of two actions.
pub(crate) fn cut(stage: &mut Stage, rate: f64, before: Range<usize>, after: Range<usize>) -> usize {
    let between = before.end..after.start;
    if between.is_empty() {
        return between.end;
    }
    let step = ((rate / RATE).round() as usize).max(1);
    let near = ((rate * NEAR).round() as usize).max(1);
    let known_before = before.start.max(before.end.saturating_sub(near))..before.end;
    let known_after = after.start..after.end.min(after.start.saturating_add(near));
    let [known_before, shapes, known_after] = [known_before, between.clone(), known_after]
        .map(|frames| frames.step_by(step).map(|frame| stage.shape(frame)).collect::<Vec<_>>());
    let place = turn_over(&shapes, &known_before, &known_after);
    between.clone().step_by(step).nth(place).unwrap_or(between.end)
}

/// How many of the shapes belong to what is before, if each is to lie as near as can be to
/// any of the shapes of its side.
fn turn_over(between: &[Shape], before: &[Shape], after: &[Shape]) -> usize {
    let nearest = |shape: &Shape, side: &[Shape]| {
        side.iter().map(|other| shape.distance(other)).fold(f64::INFINITY, f64::min)
    };
    let (mut cost, mut least) = (0.0, (0.0, 0));
    for (place, shape) in between.iter().enumerate() {
        cost += nearest(shape, before) - nearest(shape, after);
        if cost < least.0 {
            least = (cost, place + 1);
        }
    }
    least.1
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
    fn each_shape_goes_to_the_side_that_it_is_like() {
        let (low, high) = (shapes(&[0.0, 0.3, 0.1]), shapes(&[2.0, 1.8]));
        assert_eq!(turn_over(&shapes(&[0.1, 0.2, 0.6, 1.5, 1.9]), &low, &high), 3);
        // One that strays is outvoted.
        assert_eq!(turn_over(&shapes(&[0.1, 1.2, 0.2, 1.9, 1.9]), &low, &high), 3);
        assert_eq!(turn_over(&shapes(&[1.5, 1.9]), &low, &high), 0);
        assert_eq!(turn_over(&shapes(&[0.1, 0.2]), &low, &high), 2);
        assert_eq!(turn_over(&[], &low, &high), 0);
    }
}
