//! Refinement of cuts: the instant within a transition at which the movement becomes more similar to the
//! next action than to the previous one (as the last step of Zhang, Liu and Wei 2012, section 4.3).

use std::ops::Range;

use crate::segments::movement::{Movement, Row, squared_distance};
use crate::segments::segment::Segment;

/// Maximum distance of a refined cut from the original one, in seconds …
///
/// Chosen with [`REFERENCE`] on seeds 0 to 3 of the generator, on which the accuracy of `auto` is about
/// equal for 1.5 to 2 s and references of 3 to 5 s.
const REACH: f64 = 1.5;

/// … and as a fraction of the adjacent segments.
const REACH_FRACTION: f64 = 1.0 / 3.0;

/// Duration of the parts of both actions with which the transition is compared, in seconds.
const REFERENCE: f64 = 4.0;

/// Number of samples per compared sample of the actions.
const STRIDE: usize = 3;

/// Moves the cuts between segments within their transitions.
pub(crate) fn refine_cuts(movement: &Movement, segments: &mut [Segment]) {
    let ranges: Vec<Range<usize>> =
        segments.iter().map(|segment| movement.samples(&segment.frames)).collect();
    for (index, pair) in ranges.windows(2).enumerate() {
        let cut = movement.frame(refined_cut(movement, &pair[0], &pair[1]));
        // At frame rates of a few Hz, cuts might meet.
        let cut = cut.clamp(segments[index].frames.start + 1, segments[index + 1].frames.end - 1);
        segments[index].frames.end = cut;
        segments[index + 1].frames.start = cut;
    }
}

/// Returns the first sample of the second of two adjacent segments.
fn refined_cut(movement: &Movement, before: &Range<usize>, after: &Range<usize>) -> usize {
    let (rows, cut) = (movement.all_rows(), after.start);
    // Casts saturate.
    let samples = |seconds: f64| (seconds / movement.step()) as usize;
    let reach = |segment: &Range<usize>| samples(REACH).min((segment.len() as f64 * REACH_FRACTION) as usize);
    let between = cut - reach(before)..cut + reach(after);
    let before = before.start.max(between.start.saturating_sub(samples(REFERENCE)))..between.start;
    let after = between.end..after.end.min(between.end.saturating_add(samples(REFERENCE)));
    between.start + best_split(&rows[between], &rows[before], &rows[after])
}

/// Returns the number of movements that belong to the first action, so that the total squared distance of
/// the movements to the nearest one of their action is minimal.
fn best_split(between: &[Row], before: &[Row], after: &[Row]) -> usize {
    let nearest = |row: &Row, action: &[Row]| {
        let distances = action.iter().step_by(STRIDE).map(|other| squared_distance(row, other));
        f64::from(distances.fold(f32::INFINITY, f32::min))
    };
    least_prefix(between.iter().map(|row| nearest(row, before) - nearest(row, after)))
}

/// Returns the length of the prefix with the least sum; the shortest one, if several have it.
pub(crate) fn least_prefix(values: impl Iterator<Item = f64>) -> usize {
    let (mut sum, mut best) = (0.0, (0.0, 0));
    for (index, value) in values.enumerate() {
        sum += value;
        if sum < best.0 {
            best = (sum, index + 1);
        }
    }
    best.1
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows(values: &[f32]) -> Vec<Row> {
        values.iter().map(|value| [*value; size_of::<Row>() / size_of::<f32>()]).collect()
    }

    #[test]
    fn movements_belong_to_the_more_similar_action() {
        let (low, high) = (rows(&[0.0; 9]), rows(&[2.0; 9]));
        assert_eq!(best_split(&rows(&[0.1, 0.2, 0.6, 1.5, 1.9]), &low, &high), 3);
        // A single deviation does not change the result.
        assert_eq!(best_split(&rows(&[0.1, 1.2, 0.2, 1.9, 1.9]), &low, &high), 3);
        assert_eq!(best_split(&rows(&[1.5, 1.9]), &low, &high), 0);
        assert_eq!(best_split(&rows(&[0.1, 0.2]), &low, &high), 2);
        assert_eq!(best_split(&[], &low, &high), 0);
    }
}
