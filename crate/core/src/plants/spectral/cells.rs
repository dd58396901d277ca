//! Partition of samples into cells of nearby samples.

use std::borrow::Cow;
use std::cell::OnceCell;
use std::cmp::Ordering;
use std::collections::BinaryHeap;
use std::ops::Range;

use nalgebra::DMatrix;

use crate::numeric::sort;
use crate::plants::signal::samples::Samples;

/// Number of principal coordinates: the dimension of a window of three frames.
pub(crate) const DIMS: usize = 6;
/// Target cells per square root of the number of samples, and the minimum and maximum number. More
/// cells are more accurate and slower.
const TARGET_CELLS: (f64, usize, usize) = (4.5, 600, 4096);
/// The same for source cells, which can be fewer: their errors differ in sign and almost cancel.
const SOURCE_CELLS: (f64, usize, usize) = (3.0, 400, 2048);
/// Maximum number of samples for the principal axes; more would not change them noticeably.
const MAX_PCA_SAMPLES: usize = 16_384;

/// Sample in principal coordinates.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Point {
    pub coords: [f32; DIMS],
    /// Squared distance from the principal subspace.
    pub residual: f32,
    /// Index of the sample.
    pub index: u32,
}

/// Principal axes of samples.
pub(crate) struct PrincipalAxes {
    mean: Vec<f64>,
    /// For each coordinate of a sample its component along each axis; 0 along axes beyond the
    /// dimension of the samples.
    components: Vec<[f64; DIMS]>,
}

impl PrincipalAxes {
    /// Computes the principal axes of samples.
    pub fn new(samples: &Samples) -> PrincipalAxes {
        let dimension = samples.dimension;
        let points = samples.points().step_by(samples.len().div_ceil(MAX_PCA_SAMPLES).max(1));
        let count = points.len() as f64;
        let mut mean = vec![0.0; dimension];
        for point in points.clone() {
            mean.iter_mut().zip(point).for_each(|(sum, value)| *sum += f64::from(*value) / count);
        }
        // The lower triangle; nalgebra's update by an outer product is ten times slower for few rows.
        let mut scatter = vec![0.0; dimension * dimension];
        let mut difference = vec![0.0; dimension];
        for point in points {
            for (difference, (value, mean)) in difference.iter_mut().zip(point.iter().zip(&mean)) {
                *difference = f64::from(*value) - mean;
            }
            for (row, sums) in scatter.chunks_exact_mut(dimension).enumerate() {
                for (sum, other) in sums.iter_mut().zip(&difference[..=row]) {
                    *sum += difference[row] * other;
                }
            }
        }
        let eigen = DMatrix::from_row_slice(dimension, dimension, &scatter).symmetric_eigen();
        let order = sort::argsort_descending(eigen.eigenvalues.as_slice());
        let component = |coordinate: usize, axis: usize| {
            order.get(axis).map_or(0.0, |&axis| eigen.eigenvectors[(coordinate, axis)])
        };
        let components = (0..dimension)
            .map(|coordinate| std::array::from_fn(|axis| component(coordinate, axis)))
            .collect();
        PrincipalAxes { mean, components }
    }

    /// Returns the samples in principal coordinates.
    pub fn points(&self, samples: &Samples) -> Vec<Point> {
        samples.points().enumerate().map(|(index, values)| self.point(index, values)).collect()
    }

    /// Returns one sample in principal coordinates.
    pub fn point(&self, index: usize, values: &[f32]) -> Point {
        let mut coords = [0.0; DIMS];
        let mut total = 0.0;
        for ((value, mean), components) in values.iter().zip(&self.mean).zip(&self.components) {
            let difference = f64::from(*value) - mean;
            total += difference * difference;
            for (coord, component) in coords.iter_mut().zip(components) {
                *coord += component * difference;
            }
        }
        let projected: f64 = coords.iter().map(|coord| coord * coord).sum();
        Point {
            coords: coords.map(|coord| coord as f32),
            residual: (total - projected).max(0.0) as f32,
            index: index as u32,
        }
    }
}

/// Samples with their cells, which are valid for any bandwidth.
pub(crate) struct PartitionedSamples {
    pub samples: Samples,
    axes: OnceCell<PrincipalAxes>,
    /// Cached cells; `None` if cells are not cached, as they need more memory than the samples.
    cells: Option<OnceCell<Cells>>,
}

impl PartitionedSamples {
    /// Creates samples. Their cells are computed once if `cache_cells`, otherwise on each call.
    pub fn new(samples: Samples, cache_cells: bool) -> PartitionedSamples {
        PartitionedSamples { samples, axes: OnceCell::new(), cells: cache_cells.then(OnceCell::new) }
    }

    /// Returns the principal axes.
    pub fn axes(&self) -> &PrincipalAxes {
        self.axes.get_or_init(|| PrincipalAxes::new(&self.samples))
    }

    /// Returns the cells along `axes`. Cached cells are those of the first call, as samples are
    /// always queried with the same axes.
    pub fn cells(&self, axes: &PrincipalAxes) -> Cow<'_, Cells> {
        let cells = || {
            let root = (self.samples.len() as f64).sqrt();
            let [targets, sources] = [TARGET_CELLS, SOURCE_CELLS]
                .map(|(per_root, min, max)| ((per_root * root) as usize).clamp(min, max));
            Cells::new(axes.points(&self.samples), targets, sources)
        };
        match &self.cells {
            Some(cached) => Cow::Borrowed(cached.get_or_init(cells)),
            None => Cow::Owned(cells()),
        }
    }
}

impl From<Samples> for PartitionedSamples {
    fn from(samples: Samples) -> PartitionedSamples {
        PartitionedSamples::new(samples, false)
    }
}

/// Points in the order of their cells.
#[derive(Clone)]
pub(crate) struct Cells {
    pub points: Vec<Point>,
    /// Target cells, about which sums are expanded.
    pub targets: Vec<CellExtent>,
    /// Source cells, which are summed over. They are larger and fewer: their errors differ in sign.
    /// Neighbours in this order are near each other.
    pub sources: Vec<CellExtent>,
}

/// Index range of the points of a cell, and their mean.
pub(crate) type CellExtent = (Range<usize>, [f32; DIMS]);

impl Cells {
    /// Splits points into at most the given numbers of cells. The cells with the largest error are
    /// split first.
    pub fn new(mut points: Vec<Point>, max_targets: usize, max_sources: usize) -> Cells {
        let mut open = BinaryHeap::from([Cell::new(&points, 0..points.len())]);
        let mut closed: Vec<Cell> = Vec::new();
        let extents = |open: &BinaryHeap<Cell>, closed: &[Cell]| {
            let cells = open.iter().chain(closed).map(|cell| (cell.range.clone(), cell.mean)).collect();
            sort::sort_by_frames(cells, |(range, _): &CellExtent| (range.start, range.end))
        };
        let mut sources = None;
        while open.len() + closed.len() < max_targets {
            if open.len() + closed.len() == max_sources {
                sources = Some(extents(&open, &closed));
            }
            let Some(cell) = open.pop() else { break };
            let Cell { range, mean, axis, .. } = &cell;
            let middle = range.start
                + partition(&mut points[range.clone()], |point| point.coords[*axis] < mean[*axis]);
            if middle == range.start || middle == range.end {
                // The points are numerically equal.
                closed.push(cell);
                continue;
            }
            open.extend([range.start..middle, middle..range.end].map(|range| Cell::new(&points, range)));
        }
        let targets = extents(&open, &closed);
        Cells { points, sources: sources.unwrap_or_else(|| targets.clone()), targets }
    }
}

/// Moves the points that satisfy `first` to the front and returns their count.
fn partition(points: &mut [Point], first: impl Fn(&Point) -> bool) -> usize {
    let mut count = 0;
    for index in 0..points.len() {
        if first(&points[index]) {
            points.swap(index, count);
            count += 1;
        }
    }
    count
}

/// Cell that may be split.
struct Cell {
    range: Range<usize>,
    mean: [f32; DIMS],
    /// Axis with the largest variance.
    axis: usize,
    /// Estimated error: about the number of points times the cube of their deviation. The square
    /// root of the number is used so that isolated points get cells too.
    weight: f64,
}

impl Cell {
    fn new(points: &[Point], range: Range<usize>) -> Cell {
        let (mut sum, mut squares) = ([0.0; DIMS], [0.0; DIMS]);
        for point in &points[range.clone()] {
            for (axis, &coord) in point.coords.iter().enumerate() {
                sum[axis] += f64::from(coord);
                squares[axis] += f64::from(coord) * f64::from(coord);
            }
        }
        let count = range.len().max(1) as f64;
        let mean = sum.map(|sum| sum / count);
        let variance: [f64; DIMS] =
            std::array::from_fn(|axis| (squares[axis] / count - mean[axis] * mean[axis]).max(0.0));
        let axis = (0..DIMS).max_by(|&a, &b| variance[a].total_cmp(&variance[b])).unwrap_or(0);
        let weight = variance.iter().sum::<f64>().powf(1.5) * count.sqrt();
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
        // For equal weights the order must not depend on the heap.
        self.weight.total_cmp(&other.weight).then(other.range.start.cmp(&self.range.start))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn principal_coordinates_preserve_distances(
            values in prop::collection::vec(0.0..1.0_f64, 10 * 8),
            dimension in prop_oneof![Just(2_usize), Just(5), Just(10)],
        ) {
            let samples = Samples::new(dimension, values);
            let points = PrincipalAxes::new(&samples).points(&samples);
            for (i, a) in points.iter().enumerate() {
                for (j, b) in points.iter().enumerate() {
                    let full = samples.squared_distance(i, j);
                    let projected: f64 =
                        a.coords.iter().zip(b.coords).map(|(a, b)| f64::from(a - b).powi(2)).sum();
                    prop_assert!(projected <= full + 1e-4);
                    if dimension <= DIMS {
                        prop_assert!((projected - full).abs() < 1e-4);
                        prop_assert!(a.residual < 1e-4);
                    }
                }
            }
        }

        #[test]
        fn every_point_is_in_one_cell(values in prop::collection::vec(-1.0..1.0_f64, 2..120), max in 1_usize..40) {
            let samples = Samples::new(2, values[..values.len() / 2 * 2].to_vec());
            let cells = Cells::new(PrincipalAxes::new(&samples).points(&samples), max, max);
            prop_assert!(cells.targets.len() <= max);
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
        let cells = Cells::new(PrincipalAxes::new(&samples).points(&samples), 10, 5);
        assert_eq!(cells.targets.len(), 1);
    }
}
