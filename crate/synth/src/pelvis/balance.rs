//! Horizontal motion of the body: a linear inverted pendulum over the feet.
//!
//! With body position x, centre of pressure p and body height y, x″ = (x − p)(g + y″)/y. Solved as
//! a boundary value problem over the whole motion, the model produces the weight shift onto the
//! standing foot before the other lifts, the sway and surge of gait, the lean before a jump, and
//! straight flight.

use super::support::Support;
use crate::math::GRAVITY;
use crate::math::GRID_RATE;

/// Returns the positions of the body along x and z at the grid points of `support`.
pub fn horizontal_positions(support: &Support, heights: &[f64]) -> [Vec<f64>; 2] {
    let step = 1.0 / GRID_RATE as f64;
    let last = heights.len() - 1;
    // Divergence from the centre of pressure, per squared grid step.
    let stiffness: Vec<f64> = (0..heights.len())
        .map(|n| {
            let (before, after) = (heights[n.saturating_sub(1)], heights[(n + 1).min(last)]);
            let rising = (before - 2.0 * heights[n] + after) / (step * step);
            let push = if support.grounded[n] { (GRAVITY + rising).clamp(0.0, 6.0 * GRAVITY) } else { 0.0 };
            step * step * push / heights[n].max(0.3)
        })
        .collect();
    [0, 2].map(|axis| solve(&stiffness, |n| support.centre_of_pressure[n][axis]))
}

/// Solves x[n−1] − 2x[n] + x[n+1] = k[n](x[n] − p[n]) with zero end slopes (Thomas algorithm).
fn solve(stiffness: &[f64], centre_of_pressure: impl Fn(usize) -> f64) -> Vec<f64> {
    let count = stiffness.len();
    let mut ratios = vec![0.0; count];
    let mut x = vec![0.0; count];
    for n in 0..count {
        let neighbours = f64::from(u8::from(n > 0)) + f64::from(u8::from(n + 1 < count));
        let (ratio, before) = if n > 0 { (ratios[n - 1], x[n - 1]) } else { (0.0, 0.0) };
        let pivot = neighbours + stiffness[n] - ratio;
        ratios[n] = 1.0 / pivot;
        x[n] = (stiffness[n] * centre_of_pressure(n) + before) / pivot;
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
    fn body_rests_over_a_standing_foot_and_shifts_before_the_foot_moves() {
        let stiffness = vec![9.81 / (240.0 * 240.0); 2400];
        let x = solve(&stiffness, |n| if n < 1200 { 0.0 } else { 1.0 });
        assert!(x[0].abs() < 1e-3 && (x[2399] - 1.0).abs() < 1e-3);
        assert!((x[1200] - 0.5).abs() < 0.01, "halfway at the change");
    }
}
