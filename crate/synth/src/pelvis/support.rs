//! Which foot carries how much, and where the weight presses.

use crate::character::Build;
use crate::curve::rise;
use crate::feet::FootPath;
use crate::grid::Grid;
use crate::maths::{Vec3, forward};
use crate::plan::Stance;

/// The support of the body at each point of a grid.
pub struct Support {
    /// Centre of pressure, on the ground; it rests where it was while nothing stands.
    pub pressure: Vec<Vec3>,
    /// Whether any foot stands.
    pub grounded: Vec<bool>,
    /// Load on the left foot less that on the right, as shares of their sum.
    pub balance: Vec<f64>,
}

/// Longest time over which weight moves on or off a foot, in seconds.
const LOADING: f64 = 0.16;

impl Support {
    /// The support that two feet give.
    pub fn new(paths: &[FootPath; 2], grid: &Grid, build: &Build) -> Support {
        let mut support = Support { pressure: Vec::new(), grounded: Vec::new(), balance: Vec::new() };
        let mut last = Vec3::zeros();
        for time in grid.times() {
            let feet = paths.each_ref().map(|path| {
                match (path.standing(time), path.step(time)) {
                    (Some(stance), _) => (load(stance, time), pressure(stance, time, build)),
                    // A foot that slides under load presses wherever it is.
                    (None, Some(step)) => (step.carry.load, flat(path.at(time).ankle)),
                    (None, None) => (0.0, Vec3::zeros()),
                }
            });
            let total = feet[0].0 + feet[1].0;
            if total > 0.0 {
                last = (feet[0].1 * feet[0].0 + feet[1].1 * feet[1].0) / total;
            }
            support.pressure.push(last);
            support.grounded.push(total > 0.0);
            support.balance.push(if total > 0.0 { (feet[0].0 - feet[1].0) / total } else { 0.0 });
        }
        support
    }
}

fn flat(point: Vec3) -> Vec3 {
    Vec3::new(point.x, 0.0, point.z)
}

/// The load on a standing foot: 0 at strike and toe-off, its weight between.
fn load(stance: &Stance, time: f64) -> f64 {
    let ramp = LOADING.min(0.45 * (stance.off - stance.strike));
    let on = if stance.strike.is_finite() { rise(time, stance.strike, stance.strike + ramp) } else { 1.0 };
    let off = if stance.off.is_finite() { 1.0 - rise(time, stance.off - ramp, stance.off) } else { 1.0 };
    (stance.weight * on * off).max(1e-6)
}

/// Where a standing foot presses on the ground: it comes down behind its middle and
/// leaves from its ball.
fn pressure(stance: &Stance, time: f64, build: &Build) -> Vec3 {
    let middle = -0.45 * build.instep;
    let (from, to) = (-0.9 * build.instep, 0.05 * build.instep);
    let landed = if stance.strike.is_finite() && stance.landing.pitch < 0.0 {
        rise(time, stance.strike, stance.strike + 0.2)
    } else {
        1.0
    };
    let leaving = if stance.off.is_finite() { rise(time, stance.off - 0.3, stance.off) } else { 0.0 };
    let ahead = middle + (from - middle) * (1.0 - landed) + (to - middle) * leaving;
    stance.place.point() + ahead * forward(stance.place.heading)
}
