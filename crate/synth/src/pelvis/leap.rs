//! Flights: how high the pelvis leaves the ground and comes back to it.

use crate::character::Build;
use crate::feet::FootPath;
use crate::maths::GRAVITY;
use crate::plan::{Interval, Plan, Stance, flights};

/// A flight with the heights of the pelvis at its ends, in metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Leap {
    /// From the last foot's toe-off to the first foot's strike.
    pub time: Interval,
    /// Height at toe-off.
    pub off: f64,
    /// Height at the strike.
    pub land: f64,
}

impl Leap {
    /// Upward speed at toe-off, in m/s.
    pub fn off_speed(&self) -> f64 {
        let length = self.time.end - self.time.start;
        (self.land - self.off) / length + GRAVITY * length / 2.0
    }

    /// Upward speed at the strike, in m/s: negative.
    pub fn land_speed(&self) -> f64 {
        self.off_speed() - GRAVITY * (self.time.end - self.time.start)
    }

    /// Lowers the ends by so many metres.
    pub fn lower(&mut self, off: f64, land: f64) {
        self.off -= off;
        self.land -= land;
        self.level();
    }

    /// A short flight has no time for much of a fall.
    fn level(&mut self) {
        let length = self.time.end - self.time.start;
        self.off = self.off.min(self.land + 0.1 * GRAVITY * length * length);
    }
}

/// The flights of a plan, their heights estimated from the speed on the way.
pub fn leaps(plan: &Plan, build: &Build, paths: &[FootPath; 2]) -> Vec<Leap> {
    flights(plan).into_iter().map(|time| leap(time, build, paths)).collect()
}

fn leap(time: Interval, build: &Build, paths: &[FootPath; 2]) -> Leap {
    let found = |path: &FootPath, after: bool| {
        let next = path.stances().partition_point(|s| s.strike < time.end - 1e-6);
        path.stances()[next - usize::from(!after)..].first().copied()
    };
    let leaves = |s: &Stance| (s.off - time.start).abs() < 1e-6;
    let lands = |s: &Stance| (s.strike - time.end).abs() < 1e-6;
    let from = paths.iter().find_map(|path| found(path, false).filter(leaves)).expect("a foot leaves");
    let to = paths.iter().find_map(|path| found(path, true).filter(lands)).expect("a foot lands");

    let ground = |s: &Stance| (s.off - s.strike).clamp(0.1, 0.5);
    let way = (to.place.point() - from.place.point()).norm();
    let speed = way / (time.end - time.start + (ground(&from) + ground(&to)) / 2.0);
    let height = |s: &Stance, pitch: f64| {
        let raised = build.instep * libm::sin(pitch.max(0.0).to_radians());
        build.standing() + 0.8 * raised - dip(speed * 0.4 * ground(s), build) - 0.02 * build.leg()
    };
    let mut leap = Leap { time, off: height(&from, from.lift.pitch), land: height(&to, to.landing.pitch) };
    leap.level();
    leap
}

/// How much lower the hip is when the foot stands `across` metres from below it.
pub fn dip(across: f64, build: &Build) -> f64 {
    let leg = build.leg();
    let across = across.abs().min(0.6 * leg);
    leg - (leg * leg - across * across).sqrt()
}
