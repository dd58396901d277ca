//! Reference methods for the classes of actions.

use std::ops::Range;

use nalgebra::{DMatrix, DVector, Rotation3, Vector3};
use plantigrade::bvh::Clip;
use plantigrade::kinematics::Kinematics;
use plantigrade::skeleton::{Overrides, Role, Skeleton};

/// Frame ranges with the names of their classes.
pub type Classes = Vec<(Range<usize>, String)>;

/// Rate of the poses, in Hz.
const RATE: f64 = 5.0;

/// Neighbour whose distance is the local bandwidth of an affinity (Zelnik-Manor and Perona 2004).
const LOCAL_NEIGHBOUR: usize = 7;

/// Maximum number of iterations of k-means.
const MAX_ITERATIONS: usize = 100;

/// Maximum number of classes that the eigenvalues of frames can give.
const MAX_CLASSES: usize = 20;

/// Poses at [`RATE`]: joint positions relative to the hips, with the heading turned away, in leg lengths.
struct Poses {
    rows: Vec<DVector<f64>>,
    /// Frames per pose.
    step: f64,
}

impl Poses {
    fn new(clip: &Clip) -> Poses {
        let skeleton = Skeleton::main(clip, &Overrides::default());
        let joint = |role| skeleton.roles.get(role).expect("a complete body");
        let [hips, left, right] = [Role::Hips, Role::LeftThigh, Role::RightThigh].map(joint);
        let joints = [
            Role::LeftShank,
            Role::RightShank,
            Role::LeftAnkle,
            Role::RightAnkle,
            Role::Head,
            Role::LeftForearm,
            Role::RightForearm,
            Role::LeftHand,
            Role::RightHand,
        ]
        .map(joint);
        let leg = skeleton.leg.expect("legs");
        let step = clip.rate() / RATE;
        let mut kinematics = Kinematics::new(clip);
        let mut row = |index: usize| {
            let pose = kinematics.pose((index as f64 * step).round() as usize);
            let side = skeleton.up.to_y_up(pose[left] - pose[right]);
            let turn = Rotation3::from_axis_angle(&Vector3::y_axis(), side.z.atan2(side.x));
            let values = joints.iter().flat_map(|&joint| {
                let position = turn * skeleton.up.to_y_up(pose[joint] - pose[hips]) / leg;
                [position.x, position.y, position.z]
            });
            DVector::from_iterator(3 * joints.len(), values)
        };
        let count = ((clip.frame_count() - 1) as f64 / step) as usize + 1;
        Poses { rows: (0..count).map(&mut row).collect(), step }
    }
}

/// Clusters the mean poses of frame ranges by k-means. Without a number of classes, it is the one with the largest
/// mean silhouette (Rousseeuw 1987), at least 2.
pub fn kmeans_of_segment_means(clip: &Clip, ranges: &[Range<usize>], count: Option<usize>) -> Classes {
    let poses = Poses::new(clip);
    let means: Vec<DVector<f64>> = ranges
        .iter()
        .map(|range| {
            let first = ((range.start as f64 / poses.step) as usize).min(poses.rows.len() - 1);
            let end = ((range.end as f64 / poses.step) as usize).clamp(first + 1, poses.rows.len());
            poses.rows[first..end].iter().sum::<DVector<f64>>() / (end - first) as f64
        })
        .collect();
    let clusters = match count {
        Some(count) => kmeans(&means, count),
        None => {
            let clusterings = (2..means.len().max(3)).map(|count| kmeans(&means, count));
            let rated = clusterings.map(|clusters| (mean_silhouette(&means, &clusters), clusters));
            rated.max_by(|a, b| a.0.total_cmp(&b.0)).expect("a number of classes").1
        }
    };
    ranges.iter().cloned().zip(clusters.iter().map(usize::to_string)).collect()
}

/// Returns the mean silhouette of a clustering: how much nearer each point is to its own cluster than to the next
/// one, from −1 to 1; 0 for clusters of one point.
fn mean_silhouette(points: &[DVector<f64>], clusters: &[usize]) -> f64 {
    let count = clusters.iter().max().map_or(0, |last| last + 1);
    let silhouette = |index: usize| {
        let mut distances = vec![(0.0, 0.0); count];
        for (other, &cluster) in clusters.iter().enumerate().filter(|(other, _)| *other != index) {
            let (sum, number) = &mut distances[cluster];
            *sum += (&points[index] - &points[other]).norm();
            *number += 1.0;
        }
        let mean = |cluster: usize| distances[cluster].0 / distances[cluster].1;
        let own = mean(clusters[index]);
        let others = (0..count).filter(|&cluster| cluster != clusters[index]).map(mean);
        let next = others.filter(|distance| !distance.is_nan()).fold(f64::INFINITY, f64::min);
        if own.is_nan() || next.is_infinite() { 0.0 } else { (next - own) / own.max(next).max(1e-12) }
    };
    (0..points.len()).map(silhouette).sum::<f64>() / points.len() as f64
}

/// Clusters frames by the eigenvectors of their normalised affinities (Ng, Jordan and Weiss 2002), with
/// local bandwidths. Without a number of classes, it is the one before the largest gap between eigenvalues
/// (von Luxburg 2007), at least 2.
pub fn spectral_clusters_of_frames(clip: &Clip, count: Option<usize>) -> Classes {
    let poses = Poses::new(clip);
    let size = poses.rows.len();
    let distances = DMatrix::from_fn(size, size, |a, b| (&poses.rows[a] - &poses.rows[b]).norm());
    let bandwidths: Vec<f64> = distances
        .column_iter()
        .map(|column| {
            let mut sorted: Vec<f64> = column.iter().copied().collect();
            sorted.sort_by(f64::total_cmp);
            sorted[LOCAL_NEIGHBOUR.min(size - 1)].max(1e-9)
        })
        .collect();
    let affinities = DMatrix::from_fn(size, size, |a, b| {
        if a == b { 0.0 } else { (-distances[(a, b)].powi(2) / (bandwidths[a] * bandwidths[b])).exp() }
    });
    let degrees = affinities.column_sum().map(|degree| degree.max(1e-12).sqrt().recip());
    let normalised = DMatrix::from_fn(size, size, |a, b| affinities[(a, b)] * degrees[a] * degrees[b]);
    let eigen = normalised.symmetric_eigen();
    let mut order: Vec<usize> = (0..size).collect();
    order.sort_by(|&a, &b| eigen.eigenvalues[b].total_cmp(&eigen.eigenvalues[a]));
    let gap = |&count: &usize| eigen.eigenvalues[order[count - 1]] - eigen.eigenvalues[order[count]];
    let count = count.unwrap_or_else(|| {
        let counts = 2..=MAX_CLASSES.min(size - 1);
        counts.max_by(|a, b| gap(a).total_cmp(&gap(b))).unwrap_or(size)
    });
    let rows: Vec<DVector<f64>> = (0..size)
        .map(|pose| {
            let values = order.iter().take(count).map(|&column| eigen.eigenvectors[(pose, column)]);
            let row = DVector::from_iterator(count.min(size), values);
            let norm = row.norm().max(1e-12);
            row / norm
        })
        .collect();
    let clusters = kmeans(&rows, count);
    let frame = |pose: usize| ((pose as f64 - 0.5) * poses.step).max(0.0) as usize;
    let range = |pose: usize| {
        let end = if pose + 1 == size { clip.frame_count() } else { frame(pose + 1) };
        frame(pose)..end
    };
    clusters.iter().enumerate().map(|(pose, cluster)| (range(pose), cluster.to_string())).collect()
}

/// Returns the cluster of each point. The first centre is the first point; each further one is the point
/// farthest from all centres.
fn kmeans(points: &[DVector<f64>], count: usize) -> Vec<usize> {
    let mut centres = vec![points[0].clone()];
    let nearest = |point: &DVector<f64>, centres: &[DVector<f64>]| {
        let distances = centres.iter().map(|centre| (point - centre).norm_squared());
        distances.enumerate().min_by(|a, b| a.1.total_cmp(&b.1)).expect("a centre")
    };
    while centres.len() < count.min(points.len()) {
        let distance = |point: &&DVector<f64>| nearest(point, &centres).1;
        let farthest = points.iter().max_by(|a, b| distance(a).total_cmp(&distance(b)));
        centres.push(farthest.expect("a point").clone());
    }
    let mut clusters = Vec::new();
    for _ in 0..MAX_ITERATIONS {
        let next: Vec<usize> = points.iter().map(|point| nearest(point, &centres).0).collect();
        if next == clusters {
            break;
        }
        clusters = next;
        for (cluster, centre) in centres.iter_mut().enumerate() {
            let members: Vec<&DVector<f64>> = points
                .iter()
                .zip(&clusters)
                .filter(|(_, other)| **other == cluster)
                .map(|(point, _)| point)
                .collect();
            if !members.is_empty() {
                *centre = members.iter().copied().sum::<DVector<f64>>() / members.len() as f64;
            }
        }
    }
    clusters
}
