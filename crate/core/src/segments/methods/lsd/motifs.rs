//! Motifs, and which of them are alike (patent, section 4.2).

use crate::segments::methods::lsd::align::Shape;
use crate::segments::methods::lsd::cluster;
use crate::segments::task::Cancelled;

/// Points at which the curves of motifs are compared, however long the motifs are.
const POINTS: usize = 16;

/// Curves that differ by this share of the larger amplitude are too far apart to be alike ...
const CURVE: f64 = 0.6;

/// ... where amplitudes below this count as this, in units of distance: all motifs proper have more.
const AMPLITUDE: f64 = 10.0;

/// Poses at this distance are too far apart for the motifs that begin or end with them to be alike.
const POSE: f64 = 100.0;

/// The curve of a motif.
#[derive(Clone, Debug)]
pub(crate) struct Outline {
    points: [f64; POINTS],
}

/// The outlines between turning points.
pub(crate) fn outlines(values: &[f64], turns: &[usize]) -> Vec<Outline> {
    let outline = |ends: &[usize]| {
        let (start, length) = (ends[0], (ends[1] - ends[0]) as f64);
        let point = |index: usize| {
            let ahead = length * index as f64 / (POINTS - 1) as f64;
            let (before, share) = (start + ahead as usize, ahead.fract());
            let after = values[(before + 1).min(ends[1])];
            values[before] * (1.0 - share) + after * share
        };
        Outline { points: std::array::from_fn(point) }
    };
    turns.windows(2).map(outline).collect()
}

impl Outline {
    /// How far the curve rises from the first to the last point.
    pub fn rise(&self) -> f64 {
        self.points[POINTS - 1] - self.points[0]
    }

    /// Root of the mean squared difference from another, as a share of the larger amplitude.
    fn difference(&self, other: &Outline) -> f64 {
        let squares = self.points.iter().zip(&other.points).map(|(a, b)| (a - b).powi(2));
        let amplitude = AMPLITUDE.max(self.rise().abs()).max(other.rise().abs());
        (squares.sum::<f64>() / POINTS as f64).sqrt() / amplitude
    }
}

/// The class of each motif, counted from 1 as they first appear.
///
/// Motifs are alike whose curves and whose first and last poses are; `shapes` are the poses at
/// the turning points. Those that rise are never like those that fall. `alive` is asked now and
/// then whether to go on.
pub(crate) fn classes(
    outlines: &[Outline],
    shapes: &[Shape],
    alive: &mut impl FnMut() -> Result<(), Cancelled>,
) -> Result<Vec<usize>, Cancelled> {
    let distance = |a: usize, b: usize| {
        let pose = |ahead: usize| shapes[a + ahead].distance(&shapes[b + ahead]);
        (outlines[a].difference(&outlines[b]) / CURVE).max(pose(0).max(pose(1)) / POSE)
    };
    let (rising, falling): (Vec<usize>, Vec<usize>) =
        (0..outlines.len()).partition(|&motif| outlines[motif].rise() >= 0.0);
    let mut heads = vec![0; outlines.len()];
    for motifs in [rising, falling] {
        let groups = cluster::groups(motifs.len(), |a, b| distance(motifs[a], motifs[b]), 1.0, alive)?;
        for (&motif, head) in motifs.iter().zip(groups) {
            heads[motif] = motifs[head];
        }
    }
    // Heads come before all else of their group: when a motif is its own head, its class is new.
    let mut classes = Vec::with_capacity(heads.len());
    let mut known = 0;
    for (motif, &head) in heads.iter().enumerate() {
        known += usize::from(head == motif);
        classes.push(if head == motif { known } else { classes[head] });
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
            // Motifs of different lengths: 10, 17, 24, 11 ... samples.
            let length = 10 + values.len() % 17;
            values.extend((1..=length).map(|i| pair[0] + (pair[1] - pair[0]) * i as f64 / length as f64));
            turns.push(values.len() - 1);
        }
        let shapes: Vec<Shape> = bends.iter().map(|&bend| shape(bend)).collect();
        classes(&outlines(&values, &turns), &shapes, &mut || Ok(())).unwrap()
    }

    #[test]
    fn motifs_of_one_curve_and_the_same_poses_are_alike() {
        let heights = [60.0, 100.0, 62.0, 98.0, 0.0, 30.0, 1.0];
        assert_eq!(classes_of(&heights, &[0.0; 7]), [1, 2, 1, 2, 3, 4]);
    }

    #[test]
    fn motifs_of_other_poses_are_not() {
        let bends = [0.0, 2.0, 0.0, 2.5, 0.0, 40.0, 0.0];
        assert_eq!(classes_of(&[0.0, 30.0, 0.0, 30.0, 0.0, 30.0, 0.0], &bends), [1, 2, 1, 2, 3, 4]);
    }

    #[test]
    fn outlines_reach_from_end_to_end() {
        let outlines = outlines(&[4.0, 3.0, 5.0, 9.0], &[0, 1, 3]);
        assert_eq!((outlines[0].rise(), outlines[1].rise()), (-1.0, 6.0));
        assert!((outlines[1].points[3] - (3.0 + 2.0 * 0.4)).abs() < 1e-12);
    }
}
