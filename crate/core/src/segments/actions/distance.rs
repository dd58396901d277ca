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

#[cfg(test)]
mod tests {
    use super::*;

    fn rows(values: &[f32]) -> Vec<Row> {
        let mut row: Row = [0.0; size_of::<Row>() / size_of::<f32>()];
        let row = |value: &f32| {
            row[0] = *value;
            row
        };
        values.iter().map(row).collect()
    }

    #[test]
    fn order_and_transitions_do_not_matter() {
        let walk = rows(&[0.0, 1.0, 2.0, 3.0, 0.0, 1.0]);
        assert_eq!(distance(&walk, &rows(&[3.0, 2.0, 1.0, 0.0])), 0.0);
        // Up to half of a segment may be different.
        assert_eq!(distance(&walk, &rows(&[3.0, 2.0, 1.0, 0.0, 7.0, 8.0, 9.0])), 0.0);
    }

    #[test]
    fn a_part_differs_from_the_whole() {
        let (part, whole) = (rows(&[0.0; 4]), rows(&[0.0, 0.0, 3.0, 3.0, 3.0]));
        assert_eq!((distance(&part, &whole), distance(&whole, &part)), (3.0, 3.0));
    }
}
