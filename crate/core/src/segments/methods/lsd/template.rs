//! Template pose.

use crate::segments::grid::SampleGrid;
use crate::segments::methods::lsd::align::Shape;
use crate::segments::methods::lsd::pose_shapes::PoseShapes;
use crate::segments::methods::method_info::Input;
use crate::segments::pose::RECORDED_RATE;
use crate::segments::{SegmentError, Template};

/// Number of rounds of alignment, after which the mean no longer changes noticeably.
const ROUNDS: usize = 3;

/// Returns the template pose.
pub(crate) fn template(input: &mut Input, poses: &mut PoseShapes) -> Result<Shape, SegmentError> {
    let frames = input.clip.frame_count();
    match input.settings.template {
        Template::Mean => {
            let grid = SampleGrid::new(input.clip, &input.frames, RECORDED_RATE.min(input.clip.rate()));
            let shapes: Vec<Shape> = (0..grid.count()).map(|pose| poses.shape(grid.frame(pose))).collect();
            (input.progress)(0.1)?;
            Ok(aligned_mean(&shapes))
        }
        Template::TPose => Ok(poses.rest_shape()),
        Template::Frame(frame) if frame < frames => Ok(poses.shape(frame)),
        Template::Frame(frame) => Err(SegmentError::NoFrame { frame, frames }),
    }
}

/// Returns the mean of shapes that are aligned with it.
fn aligned_mean(shapes: &[Shape]) -> Shape {
    let mut mean = shapes.first().cloned().unwrap_or_default();
    for _ in 0..ROUNDS {
        mean = Shape::mean(shapes.iter().map(|shape| (shape.rotated_onto(&mean), 1.0)));
    }
    mean
}

#[cfg(test)]
mod tests {
    use nalgebra::{Rotation3, Vector3};

    use super::*;

    #[test]
    fn the_mean_is_invariant_to_headings() {
        let arm = |bend: f64, heading: f64| {
            let rotation = Rotation3::from_euler_angles(0.2, 0.5, heading);
            let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, bend, 0.0], [2.0, bend, 1.0]];
            Shape::new(points.iter().map(|&point| rotation * Vector3::from(point)))
        };
        let bends = [-0.3, 0.1, 0.2];
        let mean = aligned_mean(&bends.map(|bend| arm(bend, 20.0 * bend)));
        assert!(mean.distance(&arm(0.0, 3.0)) < 1e-2);
        let distances = bends.map(|bend| mean.distance(&arm(bend, 1.0)));
        assert!(distances[0] > 4.0 * distances[1] && distances[0] > 2.0 * distances[2], "{distances:?}");
    }

    #[test]
    fn the_mean_of_no_shapes_is_empty() {
        assert_eq!(aligned_mean(&[]).distance(&Shape::default()), 0.0);
    }
}
