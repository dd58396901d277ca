//! Neighbourhood graph of the poses.

use nalgebra::{DMatrix, DMatrixView};

use crate::numeric::sort;

/// Pair of poses whose distance is preserved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Edge {
    pub from: usize,
    pub to: usize,
    /// Squared distance.
    pub squared: f64,
}

/// Minimum squared distance, as a fraction of the mean; without it, repeated poses would leave no
/// strictly feasible point.
const MIN_SQUARED_FRACTION: f64 = 1e-4;

/// Returns the squared distances between all poses, one per column.
pub(crate) fn squared_distances(poses: DMatrixView<f64>) -> DMatrix<f64> {
    let products = poses.tr_mul(&poses);
    let count = poses.ncols();
    DMatrix::from_fn(count, count, |i, j| {
        (products[(i, i)] + products[(j, j)] - 2.0 * products[(i, j)]).max(0.0)
    })
}

/// Returns the edges from each pose to its `k` nearest neighbours and to the next pose in time,
/// so that the graph is connected; each pair once.
pub(crate) fn edges(distances: &DMatrix<f64>, k: usize) -> Vec<Edge> {
    let count = distances.nrows();
    let mut is_edge = DMatrix::from_element(count, count, false);
    let mut nearest: Vec<(f64, usize)> = Vec::with_capacity(count);
    for pose in 0..count {
        nearest.clear();
        nearest
            .extend((0..count).filter(|&other| other != pose).map(|other| (distances[(other, pose)], other)));
        sort::truncate_to_smallest(&mut nearest, k);
        let nearest = nearest.iter().map(|(_, other)| *other);
        for other in nearest.chain((pose + 1 < count).then_some(pose + 1)) {
            is_edge[(pose.max(other), pose.min(other))] = true;
        }
    }
    let mut edges: Vec<Edge> = (0..count)
        .flat_map(|from| (from + 1..count).map(move |to| (from, to)))
        .filter(|&(from, to)| is_edge[(to, from)])
        .map(|(from, to)| Edge { from, to, squared: distances[(from, to)] })
        .collect();
    let mean = edges.iter().map(|edge| edge.squared).sum::<f64>() / edges.len().max(1) as f64;
    for edge in &mut edges {
        edge.squared = edge.squared.max(MIN_SQUARED_FRACTION * mean);
    }
    edges
}

/// Returns the inner products, about their centre, of points with these squared distances.
pub(crate) fn centred_products(distances: &DMatrix<f64>) -> DMatrix<f64> {
    let count = distances.nrows();
    let means = distances.row_mean();
    let mean = means.mean();
    DMatrix::from_fn(count, count, |i, j| 0.5 * (means[i] + means[j] - mean - distances[(i, j)]))
}
