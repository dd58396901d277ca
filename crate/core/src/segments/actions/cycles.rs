//! Period and number of the cycles of an action.

use crate::segments::movement::{Row, squared_pose_distance};
use crate::segments::segment::Cycles;

/// Shortest and longest period, in seconds.
const PERIODS: [f64; 2] = [0.3, 6.0];

/// Mean squared distance of poses one period apart, as a fraction of that of unrelated poses, below which
/// an action is periodic: an autocorrelation above 0.5.
const MAX_DIFFERENCE: f64 = 0.5;

/// Difference from the most similar period within which a shorter one is preferred: multiples of the
/// period differ by noise only.
const PREFERENCE: f64 = 0.1;

/// Returns the period of an action and the number of its cycles, if it repeats at least twice; `step` is
/// the time between samples, in seconds.
///
/// The difference function of the poses over the lag (as in de Cheveigné and Kawahara 2002, equation 6)
/// is divided by its expectation for unrelated poses. The period is at its first minimum that is nearly
/// as low as the lowest one.
pub(crate) fn cycles(rows: &[Row], step: f64) -> Option<Cycles> {
    let [shortest, longest] = PERIODS.map(|period| (period / step) as usize);
    let longest = longest.min(rows.len() / 2);
    let shortest = shortest.max(2);
    if longest <= shortest.saturating_add(1) {
        return None;
    }
    let unrelated = unrelated_difference(rows);
    // From one lag below the shortest to the longest.
    let first = shortest - 1;
    let differences: Vec<f64> = (first..=longest).map(|lag| mean_difference(rows, lag) / unrelated).collect();
    let is_minimum = |n: &usize| {
        differences[*n] < MAX_DIFFERENCE
            && differences[*n] <= differences[n - 1]
            && differences[*n] < differences[n + 1]
    };
    let minima: Vec<usize> = (1..differences.len() - 1).filter(is_minimum).collect();
    let lowest = minima.iter().map(|&n| differences[n]).fold(f64::INFINITY, f64::min);
    let n = minima.into_iter().find(|&n| differences[n] <= lowest + PREFERENCE)?;
    // The vertex of the parabola through the minimum and its neighbours.
    let [before, at, after] = [n - 1, n, n + 1].map(|n| differences[n]);
    let vertex = 0.5 * (before - after) / (before - 2.0 * at + after);
    let lag = first + n;
    let repeating = repeating_samples(rows, lag, MAX_DIFFERENCE * unrelated);
    let count = repeating as f64 / (lag as f64 + vertex);
    (count >= 2.0).then_some(Cycles { period_s: (lag as f64 + vertex) * step, count })
}

/// Returns the mean squared distance of two poses: twice the variance.
fn unrelated_difference(rows: &[Row]) -> f64 {
    let mut mean = [0.0; size_of::<Row>() / size_of::<f32>()];
    for row in rows {
        mean.iter_mut().zip(row).for_each(|(sum, value)| *sum += value / rows.len() as f32);
    }
    2.0 * rows.iter().map(|row| f64::from(squared_pose_distance(row, &mean))).sum::<f64>() / rows.len() as f64
}

/// Returns the mean squared distance of poses with a lag.
fn mean_difference(rows: &[Row], lag: usize) -> f64 {
    let pairs = rows.iter().zip(&rows[lag..]);
    pairs.map(|(a, b)| f64::from(squared_pose_distance(a, b))).sum::<f64>() / (rows.len() - lag) as f64
}

/// Returns the number of samples from the first to the last cycle: the windows of one period whose poses
/// recur one period later, and that period. Poses half a period apart must differ, as pauses recur, too.
fn repeating_samples(rows: &[Row], lag: usize, max_difference: f64) -> usize {
    let (mut recurring, mut opposite) = (0.0, 0.0);
    let (mut first, mut last) = (None, 0);
    let difference = |a: usize, b: usize| f64::from(squared_pose_distance(&rows[a], &rows[b]));
    for end in 1..=rows.len() - lag {
        recurring += difference(end - 1, end - 1 + lag);
        opposite += difference(end - 1, end - 1 + lag / 2);
        let Some(start) = end.checked_sub(lag) else { continue };
        if recurring <= max_difference * lag as f64 && opposite > max_difference * lag as f64 {
            first.get_or_insert(start);
            last = end;
        }
        recurring -= difference(start, start + lag);
        opposite -= difference(start, start + lag / 2);
    }
    first.map_or(0, |first| last - first + lag)
}

#[cfg(test)]
mod tests {
    use super::*;

    const STEP: f64 = 1.0 / 30.0;

    /// Poses of one joint that circles with a period in samples between pauses.
    fn circling(period: f64, pauses: usize, count: usize) -> Vec<Row> {
        let row = |sample: usize| {
            let sample = sample.clamp(pauses, pauses + count) - pauses;
            let phase = std::f64::consts::TAU * sample as f64 / period;
            let mut row: Row = [0.0; size_of::<Row>() / size_of::<f32>()];
            (row[0], row[1]) = (phase.sin() as f32, phase.cos() as f32);
            row
        };
        (0..count + 2 * pauses).map(row).collect()
    }

    #[test]
    fn period_and_number_are_those_of_the_repeated_part() {
        for period in [12.0, 15.4, 31.7] {
            let cycles = cycles(&circling(period, 20, 160), STEP).unwrap();
            assert!((cycles.period_s - period * STEP).abs() < 0.03 * period * STEP, "{period}: {cycles:?}");
            assert!((cycles.count - 160.0 / period).abs() < 1.0, "{period}: {cycles:?}");
        }
    }

    #[test]
    fn other_movements_have_no_cycles() {
        assert_eq!(cycles(&circling(30.0, 0, 50), STEP), None, "fewer than two cycles");
        assert_eq!(cycles(&circling(30.0, 90, 1), STEP), None, "almost motionless");
        for count in 0..20 {
            assert_eq!(cycles(&circling(8.0, 0, count), STEP), None, "{count} samples");
        }
        assert_eq!(cycles(&circling(30.0, 0, 100), 0.0), None);
    }
}
