//! Who is next to whom, and how far.

use nalgebra::DMatrix;
use nalgebra::DMatrixView;

/// A pair of poses whose distance is kept.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Edge {
    pub from: usize,
    pub to: usize,
    /// The square of their distance.
    pub squared: f64,
}

/// Squared distances are no smaller than this share of their mean: poses that repeat would
/// otherwise leave the solver no room.
const LEAST: f64 = 1e-4;

/// The squared distances between all poses, one per column.
pub(crate) fn squared_distances(poses: DMatrixView<f64>) -> DMatrix<f64> {
    let products = poses.tr_mul(&poses);
    let count = poses.ncols();
    DMatrix::from_fn(count, count, |i, j| {
        (products[(i, i)] + products[(j, j)] - 2.0 * products[(i, j)]).max(0.0)
    })
}

/// Each pose with the `k` nearest others, as seen from either, and with the next in time,
/// without which the poses could fly apart; each pair once.
pub(crate) fn edges(distances: &DMatrix<f64>, k: usize) -> Vec<Edge> {
    let count = distances.nrows();
    let mut is_edge = DMatrix::from_element(count, count, false);
    let mut others: Vec<usize> = Vec::with_capacity(count);
    for pose in 0..count {
        others.clear();
        others.extend((0..count).filter(|&other| other != pose));
        let row = distances.column(pose);
        let nearer = |a: &usize, b: &usize| row[*a].total_cmp(&row[*b]).then(a.cmp(b));
        if k < others.len() {
            others.select_nth_unstable_by(k, nearer);
            others.truncate(k);
        }
        for &other in others.iter().chain((pose + 1 < count).then_some(&(pose + 1))) {
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
        edge.squared = edge.squared.max(LEAST * mean);
    }
    edges
}

/// The inner products of points with these squared distances about their centre.
pub(crate) fn centred_products(distances: &DMatrix<f64>) -> DMatrix<f64> {
    let count = distances.nrows();
    let means = distances.row_mean();
    let mean = means.mean();
    DMatrix::from_fn(count, count, |i, j| 0.5 * (means[i] + means[j] - mean - distances[(i, j)]))
}
