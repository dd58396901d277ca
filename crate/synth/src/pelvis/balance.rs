//! The horizontal way of the body: a linear inverted pendulum over the feet.
//!
//! With x the body, p the centre of pressure and y the body's height,
//! x″ = (x − p)(g + y″)/y. Solved as a boundary value problem over the whole motion,
//! this gives the shift of weight onto the standing foot before the other lifts, the
//! sway and surge of gait, the lean before a jump, and straight flight.

use super::support::Support;
use crate::grid::GRID_RATE;
use crate::maths::GRAVITY;

/// The way of the body along x and along z, at the grid points of `support`.
pub fn ways(support: &Support, heights: &[f64]) -> [Vec<f64>; 2] {
    let step = 1.0 / GRID_RATE as f64;
    let last = heights.len() - 1;
    // How strongly the body falls away from the centre of pressure, per grid step squared.
    let stiffness: Vec<f64> = (0..heights.len())
        .map(|n| {
            let (before, after) = (heights[n.saturating_sub(1)], heights[(n + 1).min(last)]);
            let rising = (before - 2.0 * heights[n] + after) / (step * step);
            let push = if support.grounded[n] { (GRAVITY + rising).clamp(0.0, 6.0 * GRAVITY) } else { 0.0 };
            step * step * push / heights[n].max(0.3)
        })
        .collect();
    [0, 2].map(|axis| solve(&stiffness, |n| support.pressure[n][axis]))
}

/// Solves x[n−1] − 2x[n] + x[n+1] = k[n](x[n] − p[n]) with level ends (Thomas).
fn solve(stiffness: &[f64], pressure: impl Fn(usize) -> f64) -> Vec<f64> {
    let count = stiffness.len();
    let mut ratios = vec![0.0; count];
    let mut x = vec![0.0; count];
    for n in 0..count {
        let neighbours = f64::from(u8::from(n > 0)) + f64::from(u8::from(n + 1 < count));
        let (ratio, before) = if n > 0 { (ratios[n - 1], x[n - 1]) } else { (0.0, 0.0) };
        let pivot = neighbours + stiffness[n] - ratio;
        ratios[n] = 1.0 / pivot;
        x[n] = (stiffness[n] * pressure(n) + before) / pivot;
    }
    for n in (0..count - 1).rev() {
        x[n] += ratios[n] * x[n + 1];
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_body_rests_over_a_resting_foot_and_moves_before_the_foot_does() {
        let stiffness = vec![9.81 / (240.0 * 240.0); 2400];
        let x = solve(&stiffness, |n| if n < 1200 { 0.0 } else { 1.0 });
        assert!(x[0].abs() < 1e-3 && (x[2399] - 1.0).abs() < 1e-3);
        assert!((x[1200] - 0.5).abs() < 0.01, "half-way at the change");
    }
}
