//! The pose that all others are compared with.

use crate::segments::grid::Grid;
use crate::segments::methods::lsd::align::Shape;
use crate::segments::methods::lsd::stage::Stage;
use crate::segments::pose::RECORDED_RATE;
use crate::segments::task::Task;
use crate::segments::{SegmentError, Template};

/// Rounds of turning the poses onto their mean: no more change follows that would matter.
const ROUNDS: usize = 3;

/// The template as asked for.
pub(crate) fn template(task: &mut Task, stage: &mut Stage) -> Result<Shape, SegmentError> {
    let frames = task.clip.frame_count();
    match task.params.template() {
        Template::Mean => {
            let grid = Grid::over(task.clip, &task.frames, RECORDED_RATE);
            let shapes: Vec<Shape> = (0..grid.count()).map(|pose| stage.shape(grid.frame(pose))).collect();
            (task.progress)(0.1)?;
            Ok(mean(&shapes))
        }
        Template::TPose => Ok(stage.rest()),
        Template::Frame(frame) if frame < frames => Ok(stage.shape(frame)),
        Template::Frame(frame) => Err(SegmentError::NoFrame { frame, frames }),
    }
}

/// The mean of shapes that are turned to lie best on it.
fn mean(shapes: &[Shape]) -> Shape {
    let mut mean = shapes.first().cloned().unwrap_or_default();
    for _ in 0..ROUNDS {
        mean = Shape::mean(shapes.iter().map(|shape| (shape.turned_onto(&mean), 1.0)));
    }
    mean
}

#[cfg(test)]
mod tests {
    use nalgebra::Rotation3;
    use nalgebra::Vector3;

    use super::*;

    #[test]
    fn the_mean_does_not_know_headings() {
        let arm = |bend: f64, heading: f64| {
            let turn = Rotation3::from_euler_angles(0.2, 0.5, heading);
            let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, bend, 0.0], [2.0, bend, 1.0]];
            Shape::new(points.iter().map(|&point| turn * Vector3::from(point)))
        };
        let bends = [-0.3, 0.1, 0.2];
        let mean = mean(&bends.map(|bend| arm(bend, 20.0 * bend)));
        assert!(mean.distance(&arm(0.0, 3.0)) < 1e-2);
        let apart = bends.map(|bend| mean.distance(&arm(bend, 1.0)));
        assert!(apart[0] > 4.0 * apart[1] && apart[0] > 2.0 * apart[2], "{apart:?}");
    }

    #[test]
    fn no_shapes_have_a_mean_too() {
        assert_eq!(mean(&[]).distance(&Shape::default()), 0.0);
    }
}
