//! Motifs and their classes (patent, section 4.2).

use crate::segments::linkage;
use crate::segments::methods::lsd::align::Shape;
use crate::segments::progress::Cancelled;

/// Number of points at which the curves of motifs are compared, independent of their duration.
const POINTS: usize = 16;

/// Difference of curves, as a fraction of the larger amplitude, from which motifs are not similar …
const MAX_CURVE_DIFFERENCE: f64 = 0.6;

/// … where smaller amplitudes count as this amplitude, in units of distance; complete motifs exceed
/// it.
const MIN_AMPLITUDE: f64 = 10.0;

/// Distance of poses from which motifs that begin or end with them are not similar.
const MAX_POSE_DISTANCE: f64 = 100.0;

/// Maximum number of motifs with a full distance matrix, which limits the memory, …
const MAX_COMPARED: usize = 2048;
/// … and the maximum number of entries of the matrix per sample of the curve. People turn at most a few times per
/// second, so that it only applies to noise at low frame rates.
const MAX_DISTANCES_PER_SAMPLE: usize = 20;

/// Curve of a motif.
#[derive(Clone, Debug)]
pub(crate) struct MotifCurve {
    points: [f64; POINTS],
}

/// Returns the curves between turning points.
pub(crate) fn curves(values: &[f64], turns: &[usize]) -> Vec<MotifCurve> {
    let curve = |ends: &[usize]| {
        let (start, length) = (ends[0], (ends[1] - ends[0]) as f64);
        let point = |index: usize| {
            let ahead = length * index as f64 / (POINTS - 1) as f64;
            let (before, fraction) = (start + ahead as usize, ahead.fract());
            let after = values[(before + 1).min(ends[1])];
            values[before] * (1.0 - fraction) + after * fraction
        };
        MotifCurve { points: std::array::from_fn(point) }
    };
    turns.windows(2).map(curve).collect()
}

impl MotifCurve {
    /// Returns the change of the curve from the first to the last point.
    pub fn change(&self) -> f64 {
        self.points[POINTS - 1] - self.points[0]
    }

    /// Returns the root-mean-square difference of two curves, as a fraction of the larger
    /// amplitude.
    fn difference(&self, other: &MotifCurve) -> f64 {
        let squares = self.points.iter().zip(&other.points).map(|(a, b)| (a - b).powi(2));
        let amplitude = MIN_AMPLITUDE.max(self.change().abs()).max(other.change().abs());
        (squares.sum::<f64>() / POINTS as f64).sqrt() / amplitude
    }
}

/// Returns the class of each motif, from 1 in order of first appearance.
///
/// Motifs are similar if their curves and their first and last poses are; `shapes` are the poses at
/// the turning points. Rising and falling motifs are never similar. `samples` is the number of samples of the
/// curve. `checkpoint` is called regularly and may cancel.
pub(crate) fn classes(
    curves: &[MotifCurve],
    shapes: &[Shape],
    samples: usize,
    checkpoint: &mut impl FnMut() -> Result<(), Cancelled>,
) -> Result<Vec<usize>, Cancelled> {
    let distance = |a: usize, b: usize| {
        let pose = |ahead: usize| shapes[a + ahead].distance(&shapes[b + ahead]);
        (curves[a].difference(&curves[b]) / MAX_CURVE_DIFFERENCE)
            .max(pose(0).max(pose(1)) / MAX_POSE_DISTANCE)
    };
    let (rising, falling): (Vec<usize>, Vec<usize>) =
        (0..curves.len()).partition(|&motif| curves[motif].change() >= 0.0);
    let max_compared = MAX_COMPARED.min((2 * MAX_DISTANCES_PER_SAMPLE * samples).isqrt());
    let mut first_members = vec![0; curves.len()];
    for motifs in [rising, falling] {
        let distance = |a: usize, b: usize| distance(motifs[a], motifs[b]);
        let groups = linkage::groups(motifs.len(), max_compared, &distance, 1.0, checkpoint)?;
        for (&motif, first) in motifs.iter().zip(groups) {
            first_members[motif] = motifs[first];
        }
    }
    // The first member of a group precedes the others, so its class is known when they are visited.
    let mut classes = Vec::with_capacity(first_members.len());
    let mut class_count = 0;
    for (motif, &first) in first_members.iter().enumerate() {
        class_count += usize::from(first == motif);
        classes.push(if first == motif { class_count } else { classes[first] });
    }
    Ok(classes)
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;

    use super::*;

    fn shape(bend: f64) -> Shape {
        let points = [[0.0, 0.0], [10.0, 0.0], [20.0, bend]];
        Shape::new(points.into_iter().map(|[x, y]| Vector3::new(x, y, 0.0)).collect::<Vec<_>>().into_iter())
    }

    fn classes_of(heights: &[f64], bends: &[f64]) -> Vec<usize> {
        let mut values = vec![heights[0]];
        let mut turns = vec![0];
        for pair in heights.windows(2) {
            // Motifs of different lengths: 10, 17, 24, 11 … samples.
            let length = 10 + values.len() % 17;
            values.extend((1..=length).map(|i| pair[0] + (pair[1] - pair[0]) * i as f64 / length as f64));
            turns.push(values.len() - 1);
        }
        let shapes: Vec<Shape> = bends.iter().map(|&bend| shape(bend)).collect();
        classes(&curves(&values, &turns), &shapes, values.len(), &mut || Ok(())).unwrap()
    }

    #[test]
    fn motifs_with_equal_curves_and_poses_are_similar() {
        let heights = [60.0, 100.0, 62.0, 98.0, 0.0, 30.0, 1.0];
        assert_eq!(classes_of(&heights, &[0.0; 7]), [1, 2, 1, 2, 3, 4]);
    }

    #[test]
    fn motifs_with_other_poses_are_not_similar() {
        let bends = [0.0, 2.0, 0.0, 2.5, 0.0, 40.0, 0.0];
        assert_eq!(classes_of(&[0.0, 30.0, 0.0, 30.0, 0.0, 30.0, 0.0], &bends), [1, 2, 1, 2, 3, 4]);
    }

    #[test]
    fn curves_reach_from_end_to_end() {
        let curves = curves(&[4.0, 3.0, 5.0, 9.0], &[0, 1, 3]);
        assert_eq!((curves[0].change(), curves[1].change()), (-1.0, 6.0));
        assert!((curves[1].points[3] - (3.0 + 2.0 * 0.4)).abs() < 1e-12);
    }
}
