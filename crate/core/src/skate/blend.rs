//! Blending of corrections between plants.

use std::ops::Range;

use nalgebra::Vector3;

/// Fraction of the window in which slopes fade, as a divisor.
const FADE_FRACTION: usize = 3;

/// Fills `values` outside of the `fixed` ranges.
///
/// Between two fixed ranges a quintic continues value and slope with zero acceleration at both ends. Slopes
/// fade within a third of the window. If the ranges are more than two windows apart, the blend passes through
/// zero. `fixed` must be in order, without empty or overlapping ranges.
pub(crate) fn fill(values: &mut [Vector3<f64>], fixed: &[Range<usize>], window: usize) {
    let window = window.max(1);
    let fade = window.div_ceil(FADE_FRACTION);
    let end_of = |values: &[Vector3<f64>], run: &Range<usize>| {
        let last = run.end - 1;
        let slope = if run.len() > 1 { values[last] - values[last - 1] } else { Vector3::zeros() };
        (values[last], slope)
    };
    let start_of = |values: &[Vector3<f64>], run: &Range<usize>| {
        let first = run.start;
        let slope = if run.len() > 1 { values[first + 1] - values[first] } else { Vector3::zeros() };
        (values[first], slope)
    };
    let zero = (Vector3::zeros(), Vector3::zeros());
    for n in 0..=fixed.len() {
        let before = n.checked_sub(1).map(|n| &fixed[n]);
        let after = fixed.get(n);
        let gap = before.map_or(0, |run| run.end)..after.map_or(values.len(), |run| run.start);
        values[gap.clone()].fill(Vector3::zeros());
        match (before, after) {
            (Some(from), Some(to)) if gap.len() < 2 * window => {
                let (start, end) = (end_of(values, from), start_of(values, to));
                for (n, frame) in gap.clone().enumerate() {
                    values[frame] = blend(start, end, gap.len() + 1, fade, n + 1);
                }
                continue;
            }
            _ => {}
        }
        if let Some(from) = before {
            let start = end_of(values, from);
            for (n, frame) in gap.clone().enumerate().take(window - 1) {
                values[frame] = blend(start, zero, window, fade, n + 1);
            }
        }
        if let Some(to) = after {
            let end = start_of(values, to);
            for (n, frame) in gap.rev().enumerate().take(window - 1) {
                values[frame] = blend(zero, end, window, fade, window - 1 - n);
            }
        }
    }
}

/// Returns the quintic from 0 at 0 to 1 at 1 with zero slope and curvature at both ends.
pub(crate) fn ease(u: f64) -> f64 {
    u * u * u * (10.0 + u * (6.0 * u - 15.0))
}

/// Returns the blend between two values with slopes per step, `length` steps apart, after `step` steps: a
/// quintic for the values, and one that fades each slope within `fade` steps. A slope that lasted longer
/// would carry the blend far beyond both values.
fn blend(
    (from, start_slope): (Vector3<f64>, Vector3<f64>),
    (to, end_slope): (Vector3<f64>, Vector3<f64>),
    length: usize,
    fade: usize,
    step: usize,
) -> Vector3<f64> {
    let rise = ease(step as f64 / length as f64);
    let fade = length.min(fade) as f64;
    // The quintic from 0 with slope 1 to 0 with slope 0, without curvature at both ends.
    let faded = |steps: usize| {
        let u = (steps as f64 / fade).min(1.0);
        fade * u * (1.0 + u * u * (-6.0 + u * (8.0 - 3.0 * u)))
    };
    from * (1.0 - rise) + to * rise + start_slope * faded(step) - end_slope * faded(length - step)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blends_are_smooth_and_reach_zero() {
        let mut values = vec![Vector3::zeros(); 100];
        (0..10).for_each(|n| values[40 + n].x = 1.0 + 0.01 * n as f64);
        values[60..70].iter_mut().for_each(|value| value.x = 2.0);
        fill(&mut values, &[40..50, 60..70], 20);
        assert_eq!((values[20].x, values[89].x + values[99].x), (0.0, 0.0));
        for window in values[..40].windows(3).chain(values[51..].windows(3)) {
            let second_difference = window[0] - 2.0 * window[1] + window[2];
            assert!(second_difference.norm() < 0.07, "{second_difference}");
        }
        assert!(values[50].x > values[49].x && values[39].x < values[40].x);
    }

    #[test]
    fn short_clips_are_blended() {
        let mut values = vec![Vector3::new(1.0, 0.0, 0.0); 6];
        fill(&mut values, &[2..4], 20);
        assert!(values.iter().all(|value| value.x > 0.9));
        fill(&mut values, &[], 20);
        assert!(values.iter().all(|value| value.x == 0.0));
    }
}
