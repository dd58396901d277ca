//! Flights: heights of the pelvis at take-off and landing.

use crate::character::Proportions;
use crate::foot_path::FootPath;
use crate::math::GRAVITY;
use crate::plan::{Interval, Plan, Stance, flights};

/// Flight with the heights of the pelvis at its ends, in metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlightHeights {
    /// Interval from the last toe-off to the first foot strike.
    pub time: Interval,
    /// Height at toe-off.
    pub takeoff: f64,
    /// Height at foot strike.
    pub landing: f64,
}

impl FlightHeights {
    /// Returns the upward speed at toe-off, in m/s.
    pub fn takeoff_speed(&self) -> f64 {
        let length = self.time.end - self.time.start;
        (self.landing - self.takeoff) / length + GRAVITY * length / 2.0
    }

    /// Returns the upward speed at foot strike, in m/s; negative.
    pub fn landing_speed(&self) -> f64 {
        self.takeoff_speed() - GRAVITY * (self.time.end - self.time.start)
    }

    /// Lowers the heights at toe-off and foot strike, in metres.
    pub fn lower(&mut self, off: f64, land: f64) {
        self.takeoff -= off;
        self.landing -= land;
        self.limit_drop();
    }

    /// Limits the drop of a short flight.
    fn limit_drop(&mut self) {
        let length = self.time.end - self.time.start;
        self.takeoff = self.takeoff.min(self.landing + 0.1 * GRAVITY * length * length);
    }
}

/// Returns the flights of a plan with heights estimated from the speed.
pub fn flights_with_heights(
    plan: &Plan,
    proportions: &Proportions,
    paths: &[FootPath; 2],
) -> Vec<FlightHeights> {
    flights(plan).into_iter().map(|time| flight(time, proportions, paths)).collect()
}

fn flight(time: Interval, proportions: &Proportions, paths: &[FootPath; 2]) -> FlightHeights {
    let adjacent_stance = |path: &FootPath, after: bool| {
        let next = path.stances().partition_point(|s| s.strike < time.end - 1e-6);
        path.stances()[next - usize::from(!after)..].first().copied()
    };
    let leaves = |s: &Stance| (s.toe_off - time.start).abs() < 1e-6;
    let lands = |s: &Stance| (s.strike - time.end).abs() < 1e-6;
    let from =
        paths.iter().find_map(|path| adjacent_stance(path, false).filter(leaves)).expect("a foot leaves");
    let to = paths.iter().find_map(|path| adjacent_stance(path, true).filter(lands)).expect("a foot lands");

    let ground = |s: &Stance| (s.toe_off - s.strike).clamp(0.1, 0.5);
    let distance = (to.placement.point() - from.placement.point()).norm();
    let speed = distance / (time.end - time.start + (ground(&from) + ground(&to)) / 2.0);
    let height = |s: &Stance, pitch: f64| {
        let raised = proportions.instep * libm::sin(pitch.max(0.0).to_radians());
        proportions.standing_height() + 0.8 * raised
            - dip(speed * 0.4 * ground(s), proportions)
            - 0.02 * proportions.leg_length()
    };
    let mut flight = FlightHeights {
        time,
        takeoff: height(&from, from.lift.pitch),
        landing: height(&to, to.landing.pitch),
    };
    flight.limit_drop();
    flight
}

/// Returns how much lower the hip is when the foot is `across` metres away horizontally.
pub fn dip(across: f64, proportions: &Proportions) -> f64 {
    let leg = proportions.leg_length();
    let across = across.abs().min(0.6 * leg);
    leg - (leg * leg - across * across).sqrt()
}
