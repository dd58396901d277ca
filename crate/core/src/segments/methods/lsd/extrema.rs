//! The turning points that matter (patent, section 4.2).

/// The places at which a curve turns for at least `least`, with both its ends.
///
/// What goes up or down by less on the way is passed over; of equal values the first counts.
pub(crate) fn turning_points(values: &[f64], least: f64) -> Vec<usize> {
    let mut points = vec![0];
    // Where the curve is headed: up 1, down −1, not yet far enough to tell 0.
    let mut heading = 0.0;
    let (mut low, mut high, mut farthest) = (0, 0, 0);
    for (place, &value) in values.iter().enumerate() {
        if heading == 0.0 {
            low = if value < values[low] { place } else { low };
            high = if value > values[high] { place } else { high };
            if values[high] - values[low] >= least {
                heading = if low < high { 1.0 } else { -1.0 };
                points.push(low.min(high));
                farthest = place;
            }
        } else if heading * (value - values[farthest]) > 0.0 {
            farthest = place;
        } else if heading * (values[farthest] - value) >= least {
            points.push(farthest);
            (heading, farthest) = (-heading, place);
        }
    }
    if heading != 0.0 {
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
    fn small_turns_are_passed_over() {
        let curve = [0.0, 5.0, 4.0, 9.0, 8.0, 8.5, 2.0, 3.0, 1.0, 7.0];
        assert_eq!(turning_points(&curve, 4.0), [0, 3, 8, 9]);
        assert_eq!(turning_points(&curve, 1.0), [0, 1, 2, 3, 6, 7, 8, 9]);
        assert_eq!(turning_points(&curve, 20.0), [0, 9]);
    }

    #[test]
    fn ends_stay_whatever_the_curve_does_there() {
        assert_eq!(turning_points(&[2.0, 0.0, 9.0, 10.0, 8.0], 5.0), [0, 1, 3, 4]);
        assert_eq!(turning_points(&[8.0, 10.0, 0.0, 1.0], 5.0), [0, 1, 2, 3]);
    }

    #[test]
    fn the_first_of_equal_values_counts() {
        assert_eq!(turning_points(&[0.0, 9.0, 9.0, 9.0, 0.0, 0.0, 9.0], 5.0), [0, 1, 4, 6]);
    }

    #[test]
    fn there_may_be_nothing_to_turn() {
        assert_eq!(turning_points(&[1.0; 5], 1.0), [0, 4]);
        assert_eq!(turning_points(&[1.0], 1.0), [0]);
        assert_eq!(turning_points(&[], 1.0), [0]);
    }

    proptest! {
        #[test]
        fn what_is_within_goes_far_enough_and_back(
            values in prop::collection::vec(-20.0..20.0_f64, 1..200), least in 0.5..30.0_f64,
        ) {
            let points = turning_points(&values, least);
            prop_assert_eq!((points[0], points[points.len() - 1]), (0, values.len() - 1));
            prop_assert!(points.windows(2).all(|pair| pair[0] < pair[1]));
            let rises: Vec<f64> = points.windows(2).map(|pair| values[pair[1]] - values[pair[0]]).collect();
            prop_assert!(rises.windows(2).all(|pair| pair[0] * pair[1] <= 0.0), "{:?}", rises);
            let within = rises.get(1..rises.len().saturating_sub(1)).unwrap_or_default();
            prop_assert!(within.iter().all(|rise| rise.abs() >= least), "{:?}", rises);
        }
    }
}
