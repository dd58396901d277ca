//! Turning points (patent, section 4.2).

/// Returns the indices at which a curve turns by at least `min_change`, and both of its ends.
///
/// Smaller changes in between are ignored; of equal values the first counts.
pub(crate) fn turning_points(values: &[f64], min_change: f64) -> Vec<usize> {
    let mut points = vec![0];
    // Direction of the curve: 1 up, −1 down, 0 undecided.
    let mut direction = 0.0;
    let (mut low, mut high, mut farthest) = (0, 0, 0);
    for (index, &value) in values.iter().enumerate() {
        if direction == 0.0 {
            low = if value < values[low] { index } else { low };
            high = if value > values[high] { index } else { high };
            if values[high] - values[low] >= min_change {
                direction = if low < high { 1.0 } else { -1.0 };
                points.push(low.min(high));
                farthest = index;
            }
        } else if direction * (value - values[farthest]) > 0.0 {
            farthest = index;
        } else if direction * (values[farthest] - value) >= min_change {
            points.push(farthest);
            (direction, farthest) = (-direction, index);
        }
    }
    if direction != 0.0 {
        points.push(farthest);
    }
    points.push(values.len().saturating_sub(1));
    points.dedup();
    points
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn small_changes_are_ignored() {
        let curve = [0.0, 5.0, 4.0, 9.0, 8.0, 8.5, 2.0, 3.0, 1.0, 7.0];
        assert_eq!(turning_points(&curve, 4.0), [0, 3, 8, 9]);
        assert_eq!(turning_points(&curve, 1.0), [0, 1, 2, 3, 6, 7, 8, 9]);
        assert_eq!(turning_points(&curve, 20.0), [0, 9]);
    }

    #[test]
    fn ends_are_always_included() {
        assert_eq!(turning_points(&[2.0, 0.0, 9.0, 10.0, 8.0], 5.0), [0, 1, 3, 4]);
        assert_eq!(turning_points(&[8.0, 10.0, 0.0, 1.0], 5.0), [0, 1, 2, 3]);
    }

    #[test]
    fn the_first_of_equal_values_counts() {
        assert_eq!(turning_points(&[0.0, 9.0, 9.0, 9.0, 0.0, 0.0, 9.0], 5.0), [0, 1, 4, 6]);
    }

    #[test]
    fn constant_curves_have_no_turning_points() {
        assert_eq!(turning_points(&[1.0; 5], 1.0), [0, 4]);
        assert_eq!(turning_points(&[1.0], 1.0), [0]);
        assert_eq!(turning_points(&[], 1.0), [0]);
    }

    proptest! {
        #[test]
        fn inner_changes_are_large_and_alternate(
            values in prop::collection::vec(-20.0..20.0_f64, 1..200), min_change in 0.5..30.0_f64,
        ) {
            let points = turning_points(&values, min_change);
            prop_assert_eq!((points[0], points[points.len() - 1]), (0, values.len() - 1));
            prop_assert!(points.windows(2).all(|pair| pair[0] < pair[1]));
            let changes: Vec<f64> = points.windows(2).map(|pair| values[pair[1]] - values[pair[0]]).collect();
            prop_assert!(changes.windows(2).all(|pair| pair[0] * pair[1] <= 0.0), "{:?}", changes);
            let inner = changes.get(1..changes.len().saturating_sub(1)).unwrap_or_default();
            prop_assert!(inner.iter().all(|change| change.abs() >= min_change), "{:?}", changes);
        }
    }
}
