//! Interpolation between samples.

use std::ops::{Add, Mul, Sub};

/// Returns the Catmull–Rom spline between the second point (t = 0) and the third (t = 1).
///
/// The cubic passes through both points; its slope at each is half the difference of the
/// neighbouring points (Catmull and Rom 1974).
pub(crate) fn catmull_rom<T>([a, b, c, d]: [T; 4], t: f64) -> T
where
    T: Copy + Add<Output = T> + Sub<Output = T> + Mul<f64, Output = T>,
{
    let (from, to) = ((c - a) * 0.5, (d - b) * 0.5);
    let rise = c - b;
    b + from * t + (rise * 3.0 - from * 2.0 - to) * (t * t) + (from + to - rise * 2.0) * (t * t * t)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reproduces_end_points_and_parabolas() {
        let parabola = |t: f64| 3.0 * t * t - t + 2.0;
        let points = [-1.0, 0.0, 1.0, 2.0].map(parabola);
        for t in [0.0, 0.25, 0.5, 1.0] {
            assert!((catmull_rom(points, t) - parabola(t)).abs() < 1e-12, "{t}");
        }
    }
}
