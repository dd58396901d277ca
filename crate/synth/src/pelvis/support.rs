//! Load distribution between the feet and centre of pressure.

use crate::character::Proportions;
use crate::foot_path::FootPath;
use crate::math::TimeGrid;
use crate::math::smooth_rise;
use crate::math::{Vec3, forward};
use crate::plan::Stance;

/// Support of the body at each point of a grid.
pub struct Support {
    /// Centre of pressure on the ground; constant during flights.
    pub centre_of_pressure: Vec<Vec3>,
    /// True while any foot bears weight.
    pub grounded: Vec<bool>,
    /// Load on the left foot minus that on the right, as fractions of the total.
    pub balance: Vec<f64>,
}

/// Maximum duration of loading and unloading a foot, in seconds.
const LOADING_TIME: f64 = 0.16;

impl Support {
    /// Computes the support from the paths of both feet.
    pub fn new(paths: &[FootPath; 2], grid: &TimeGrid, proportions: &Proportions) -> Support {
        let mut support =
            Support { centre_of_pressure: Vec::new(), grounded: Vec::new(), balance: Vec::new() };
        let mut last = Vec3::zeros();
        for time in grid.times() {
            let feet = paths.each_ref().map(|path| {
                match (path.stance_at(time), path.step(time)) {
                    (Some(stance), _) => (load(stance, time), centre_of_pressure(stance, time, proportions)),
                    // A foot that slides under load acts at its current position.
                    (None, Some(step)) => (step.swing_path.load, project_to_ground(path.at(time).ankle)),
                    (None, None) => (0.0, Vec3::zeros()),
                }
            });
            let total = feet[0].0 + feet[1].0;
            if total > 0.0 {
                last = (feet[0].1 * feet[0].0 + feet[1].1 * feet[1].0) / total;
            }
            support.centre_of_pressure.push(last);
            support.grounded.push(total > 0.0);
            support.balance.push(if total > 0.0 { (feet[0].0 - feet[1].0) / total } else { 0.0 });
        }
        support
    }
}

fn project_to_ground(point: Vec3) -> Vec3 {
    Vec3::new(point.x, 0.0, point.z)
}

/// Returns the load of a standing foot: 0 at foot strike and toe-off, its weight between.
fn load(stance: &Stance, time: f64) -> f64 {
    let ramp = LOADING_TIME.min(0.45 * (stance.toe_off - stance.strike));
    let on =
        if stance.strike.is_finite() { smooth_rise(time, stance.strike, stance.strike + ramp) } else { 1.0 };
    let off = if stance.toe_off.is_finite() {
        1.0 - smooth_rise(time, stance.toe_off - ramp, stance.toe_off)
    } else {
        1.0
    };
    (stance.weight * on * off).max(1e-6)
}

/// Returns the centre of pressure under a standing foot: it lands behind the middle and leaves from
/// the ball.
fn centre_of_pressure(stance: &Stance, time: f64, proportions: &Proportions) -> Vec3 {
    let middle = -0.45 * proportions.instep;
    let (from, to) = (-0.9 * proportions.instep, 0.05 * proportions.instep);
    let landed = if stance.strike.is_finite() && stance.landing.pitch < 0.0 {
        smooth_rise(time, stance.strike, stance.strike + 0.2)
    } else {
        1.0
    };
    let leaving = if stance.toe_off.is_finite() {
        smooth_rise(time, stance.toe_off - 0.3, stance.toe_off)
    } else {
        0.0
    };
    let ahead = middle + (from - middle) * (1.0 - landed) + (to - middle) * leaving;
    stance.placement.point() + ahead * forward(stance.placement.heading)
}
