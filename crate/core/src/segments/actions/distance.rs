//! Distance of two sets of movements.

use crate::numeric::stats;
use crate::segments::movement::{Row, squared_distance};

/// Returns the median distance of the movements of one set to the nearest ones of the other, for the set
/// with the larger median.
///
/// The median ignores transitions and pauses that one of the segments has at its ends, up to half of its
/// duration. An action of several parts differs from one that consists of a single one of them.
pub(crate) fn distance(a: &[Row], b: &[Row]) -> f64 {
    let (mut nearest_a, mut nearest_b) = (vec![f32::INFINITY; a.len()], vec![f32::INFINITY; b.len()]);
    for (a, nearest_a) in a.iter().zip(&mut nearest_a) {
        for (b, nearest_b) in b.iter().zip(&mut nearest_b) {
            let squared = squared_distance(a, b);
            *nearest_a = nearest_a.min(squared);
            *nearest_b = nearest_b.min(squared);
        }
    }
    let median = |nearest: Vec<f32>| stats::median_high(nearest.into_iter().map(f64::from));
    let larger = median(nearest_a).unwrap_or(0.0).max(median(nearest_b).unwrap_or(0.0));
    larger.sqrt()
}
