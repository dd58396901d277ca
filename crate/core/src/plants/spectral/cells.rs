//! Samples in cells of those that lie close together.

use std::borrow::Cow;
use std::cell::OnceCell;
use std::cmp::Ordering;
use std::collections::BinaryHeap;
use std::ops::Range;

use nalgebra::DMatrix;
use nalgebra::DVector;

use crate::plants::signal::samples::Samples;

use crate::numeric::sort;

/// Coordinates that are kept: those of a window of three frames.
pub(crate) const DIMS: usize = 6;
/// Cells of targets for each root of the number of samples, at least and at most: fewer are faster,
/// more are closer.
const TARGETS: (f64, usize, usize) = (4.5, 600, 4096);
/// Cells of sources: they can be fewer, as their errors are of either sign and hardly add up.
const SOURCES: (f64, usize, usize) = (3.0, 400, 2048);
/// More samples than about this would turn the axes by nothing that matters.
const AXES_FROM: usize = 16_384;

/// A sample, turned so that coordinates vary most first.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Point {
    pub place: [f32; DIMS],
    /// Squared length of what is not kept of it.
    pub rest: f32,
    /// Which sample it is.
    pub index: u32,
}

/// The turn that makes the coordinates of samples vary most first.
pub(crate) struct Axes {
    mean: DVector<f64>,
    axes: DMatrix<f64>,
}

impl Axes {
    /// The principal axes of samples.
    pub fn of(samples: &Samples) -> Axes {
        let dimension = samples.dimension;
        let points = samples.points().step_by(samples.len().div_ceil(AXES_FROM).max(1));
        let count = points.len() as f64;
        let mut mean = DVector::zeros(dimension);
        for point in points.clone() {
            mean.iter_mut().zip(point).for_each(|(sum, value)| *sum += f64::from(*value) / count);
        }
        let mut scatter = DMatrix::zeros(dimension, dimension);
        let mut off = DVector::zeros(dimension);
        for point in points {
            for (off, (value, mean)) in off.iter_mut().zip(point.iter().zip(&mean)) {
                *off = f64::from(*value) - mean;
            }
            scatter.syger(1.0, &off, &off, 1.0);
        }
        let eigen = scatter.symmetric_eigen();
        let mut order = sort::descending(eigen.eigenvalues.as_slice());
        order.truncate(DIMS);
        let rows: Vec<_> = order.iter().map(|&axis| eigen.eigenvectors.column(axis).transpose()).collect();
        Axes { mean, axes: DMatrix::from_rows(&rows) }
    }

    /// The samples as points.
    pub fn points(&self, samples: &Samples) -> Vec<Point> {
        samples.points().enumerate().map(|(index, values)| self.point(index, values)).collect()
    }

    /// One sample as a point.
    pub fn point(&self, index: usize, values: &[f32]) -> Point {
        let mut place = [0.0; DIMS];
        let mut whole = 0.0;
        for (axis, (value, mean)) in values.iter().zip(self.mean.iter()).enumerate() {
            let off = f64::from(*value) - mean;
            whole += off * off;
            for (place, along) in place.iter_mut().zip(self.axes.column(axis).iter()) {
                *place += along * off;
            }
        }
        let kept: f64 = place.iter().map(|place| place * place).sum();
        Point {
            place: place.map(|place| place as f32),
            rest: (whole - kept).max(0.0) as f32,
            index: index as u32,
        }
    }
}

/// Samples with their cells, which serve any scale.
pub(crate) struct Grouped {
    pub samples: Samples,
    axes: OnceCell<Axes>,
    /// Only where they are to be kept: they take more memory than the samples.
    cells: Option<OnceCell<Cells>>,
}

impl Grouped {
    /// Samples whose cells are made when first asked for, or each time.
    pub fn new(samples: Samples, keeps_cells: bool) -> Grouped {
        Grouped { samples, axes: OnceCell::new(), cells: keeps_cells.then(OnceCell::new) }
    }

    /// The axes along which the samples vary most.
    pub fn axes(&self) -> &Axes {
        self.axes.get_or_init(|| Axes::of(&self.samples))
    }

    /// The cells along `axes`: where they are kept, those that are asked for first, as samples are
    /// only ever compared with the same others.
    pub fn cells(&self, axes: &Axes) -> Cow<'_, Cells> {
        let cells = || {
            let root = (self.samples.len() as f64).sqrt();
            let [targets, sources] =
                [TARGETS, SOURCES].map(|(each, least, most)| ((each * root) as usize).clamp(least, most));
            Cells::of(axes.points(&self.samples), targets, sources)
        };
        match &self.cells {
            Some(kept) => Cow::Borrowed(kept.get_or_init(cells)),
            None => Cow::Owned(cells()),
        }
    }
}

impl From<Samples> for Grouped {
    fn from(samples: Samples) -> Grouped {
        Grouped::new(samples, false)
    }
}

/// Points in the order of their cells.
#[derive(Clone)]
pub(crate) struct Cells {
    pub points: Vec<Point>,
    /// Those on whose side sums are expanded.
    pub targets: Vec<Group>,
    /// Fewer and larger ones, that are summed over: their errors are of either sign.
    pub sources: Vec<Group>,
}

/// The places of a cell's points among all, and their mean.
pub(crate) type Group = (Range<usize>, [f32; DIMS]);

impl Cells {
    /// Parts points into at most so many cells, the most spread and most filled ones first.
    pub fn of(mut points: Vec<Point>, most_targets: usize, most_sources: usize) -> Cells {
        let mut open = BinaryHeap::from([Cell::of(&points, 0..points.len())]);
        let mut closed: Vec<Cell> = Vec::new();
        let groups = |open: &BinaryHeap<Cell>, closed: &[Cell]| -> Vec<Group> {
            open.iter().chain(closed).map(|cell| (cell.range.clone(), cell.mean)).collect()
        };
        let mut sources = None;
        while open.len() + closed.len() < most_targets {
            if open.len() + closed.len() == most_sources {
                sources = Some(groups(&open, &closed));
            }
            let Some(cell) = open.pop() else { break };
            let Cell { range, mean, axis, .. } = &cell;
            let middle =
                range.start + part(&mut points[range.clone()], |point| point.place[*axis] < mean[*axis]);
            if middle == range.start || middle == range.end {
                // Its points are one as far as can be told.
                closed.push(cell);
                continue;
            }
            open.extend([range.start..middle, middle..range.end].map(|range| Cell::of(&points, range)));
        }
        let targets = groups(&open, &closed);
        Cells { points, sources: sources.unwrap_or_else(|| targets.clone()), targets }
    }
}

/// Moves points that are `first` before the others, and tells how many they are.
fn part(points: &mut [Point], first: impl Fn(&Point) -> bool) -> usize {
    let mut count = 0;
    for place in 0..points.len() {
        if first(&points[place]) {
            points.swap(place, count);
            count += 1;
        }
    }
    count
}

/// A cell that may be parted.
struct Cell {
    range: Range<usize>,
    mean: [f32; DIMS],
    /// The axis along which its points are spread most.
    axis: usize,
    /// What it adds to the error: about its points' number times the cube of their spread, of which
    /// half the number is taken so that lone points get cells too.
    weight: f64,
}

impl Cell {
    fn of(points: &[Point], range: Range<usize>) -> Cell {
        let (mut sum, mut squares) = ([0.0; DIMS], [0.0; DIMS]);
        for point in &points[range.clone()] {
            for (axis, &place) in point.place.iter().enumerate() {
                sum[axis] += f64::from(place);
                squares[axis] += f64::from(place) * f64::from(place);
            }
        }
        let count = range.len().max(1) as f64;
        let mean = sum.map(|sum| sum / count);
        let spread: [f64; DIMS] =
            std::array::from_fn(|axis| (squares[axis] / count - mean[axis] * mean[axis]).max(0.0));
        let axis = (0..DIMS).max_by(|&a, &b| spread[a].total_cmp(&spread[b])).unwrap_or(0);
        let weight = spread.iter().sum::<f64>().powf(1.5) * count.sqrt();
        Cell { range, mean: mean.map(|mean| mean as f32), axis, weight }
    }
}

impl PartialEq for Cell {
    fn eq(&self, other: &Cell) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Cell {}

impl PartialOrd for Cell {
    fn partial_cmp(&self, other: &Cell) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Cell {
    fn cmp(&self, other: &Cell) -> Ordering {
        // Where weights are equal, the order must not depend on the heap.
        self.weight.total_cmp(&other.weight).then(other.range.start.cmp(&self.range.start))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn turned_points_are_as_far_apart(
            values in prop::collection::vec(0.0..1.0_f64, 10 * 8),
            dimension in prop_oneof![Just(2_usize), Just(5), Just(10)],
        ) {
            let samples = Samples::new(dimension, values);
            let points = Axes::of(&samples).points(&samples);
            for (i, a) in points.iter().enumerate() {
                for (j, b) in points.iter().enumerate() {
                    let own = samples.square(i, j);
                    let kept: f64 =
                        a.place.iter().zip(b.place).map(|(a, b)| f64::from(a - b).powi(2)).sum();
                    prop_assert!(kept <= own + 1e-4);
                    if dimension <= DIMS {
                        prop_assert!((kept - own).abs() < 1e-4);
                        prop_assert!(a.rest < 1e-4);
                    }
                }
            }
        }

        #[test]
        fn every_point_has_one_cell(values in prop::collection::vec(-1.0..1.0_f64, 2..120), most in 1_usize..40) {
            let samples = Samples::new(2, values[..values.len() / 2 * 2].to_vec());
            let cells = Cells::of(Axes::of(&samples).points(&samples), most, most);
            prop_assert!(cells.targets.len() <= most);
            let mut indices: Vec<u32> = cells.points.iter().map(|point| point.index).collect();
            indices.sort_unstable();
            prop_assert!(indices.iter().copied().eq(0..samples.len() as u32));
            let mut ranges: Vec<_> = cells.targets.iter().map(|(range, _)| range.clone()).collect();
            ranges.sort_by_key(|range| range.start);
            prop_assert!(ranges.iter().all(|range| !range.is_empty()));
            prop_assert!(ranges.windows(2).all(|pair| pair[0].end == pair[1].start));
        }
    }

    #[test]
    fn equal_points_stay_together() {
        let samples = Samples::new(2, [0.25, 0.75].repeat(50));
        let cells = Cells::of(Axes::of(&samples).points(&samples), 10, 5);
        assert_eq!(cells.targets.len(), 1);
    }
}
