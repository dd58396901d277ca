//! Easing functions.

use std::f64::consts::PI;

use crate::math::lerp;

/// Smooth step (C²) from 0 before `start` to 1 after `end`.
pub fn smooth_rise(time: f64, start: f64, end: f64) -> f64 {
    if end <= start {
        return if time < start { 0.0 } else { 1.0 };
    }
    smooth_step((time - start) / (end - start))
}

/// Smooth step (C²) from 0 at `u` ≤ 0 to 1 at `u` ≥ 1.
pub fn smooth_step(u: f64) -> f64 {
    let u = u.clamp(0.0, 1.0);
    u * u * u * (10.0 + u * (6.0 * u - 15.0))
}

/// Rise from 0 to 1 that accelerates over the first fraction `start` of the interval, has constant
/// speed, and decelerates over the last fraction `end`.
pub fn ease_in_out(u: f64, start: f64, end: f64) -> f64 {
    let u = u.clamp(0.0, 1.0);
    // Integral of a raised-cosine ramp of the given length.
    let ramp = |x: f64, length: f64| (x - length / PI * libm::sin(PI * x / length)) / 2.0;
    let cruise = 1.0 / (1.0 - (start + end) / 2.0);
    if u < start {
        cruise * ramp(u, start)
    } else if u <= 1.0 - end {
        cruise * (u - start / 2.0)
    } else {
        1.0 - cruise * ramp(1.0 - u, end)
    }
}

/// Bump that is 0 with zero slope at 0 and 1, and 1 at `peak`.
pub fn bump(u: f64, peak: f64) -> f64 {
    let u = u.clamp(0.0, 1.0);
    // A rational warp of the interval moves the maximum to `peak`.
    let warped = u * (1.0 - peak) / (u * (1.0 - peak) + (1.0 - u) * peak);
    let half = 4.0 * warped * (1.0 - warped);
    half * half
}

/// Cubic Hermite interpolation over an interval of `length` seconds, at the fraction `u`; `from`
/// and `to` are pairs of value and slope.
pub fn hermite(from: (f64, f64), to: (f64, f64), length: f64, u: f64) -> f64 {
    let (start, start_slope) = (from.0, from.1 * length);
    let (end, end_slope) = (to.0, to.1 * length);
    let line = lerp(start, end, u);
    line + u * (1.0 - u) * ((1.0 - u) * (start_slope - end + start) - u * (end_slope - end + start))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn easing_functions_have_the_correct_end_values() {
        for shape in [smooth_step, |u| ease_in_out(u, 0.3, 0.2), |u| bump(u, 0.3) + u] {
            assert!(shape(0.0).abs() < 1e-12 && (shape(1.0) - 1.0).abs() < 1e-12);
        }
        assert!((bump(0.3, 0.3) - 1.0).abs() < 1e-12);
        assert!((hermite((0.0, 2.0), (1.0, 2.0), 0.5, 0.5) - 0.5).abs() < 1e-12);
    }

    #[test]
    fn hermite_reproduces_a_parabola() {
        let fall = |t: f64| 3.0 * t - 4.9 * t * t;
        let slope = |t: f64| 3.0 - 9.8 * t;
        let half_way = hermite((fall(0.1), slope(0.1)), (fall(0.5), slope(0.5)), 0.4, 0.5);
        assert!((half_way - fall(0.3)).abs() < 1e-12);
    }
}
