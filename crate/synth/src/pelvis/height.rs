//! Height of the pelvis: ballistic in flight, absorbing landings and pushing off on the ground,
//! rising over each standing leg in walking.

use super::flight::{FlightHeights, dip};
use crate::character::Proportions;
use crate::foot_path::FootPath;
use crate::math::{Keyframe, Track};
use crate::plan::Plan;

/// Maximum durations of landing absorption and push-off, in seconds.
const MAX_ABSORB_TIME: f64 = 0.24;
const MAX_PUSH_TIME: f64 = 0.34;

/// Minimum time between two walking keyframes, and between a walking keyframe and a keyframe of a
/// flight, in seconds.
const MIN_KEY_INTERVAL: f64 = 0.08;

/// Maximum ground time of a bounce without an intermediate keyframe, in seconds.
const MAX_BOUNCE_TIME: f64 = 0.36;

/// Distance travelled while decelerating or accelerating, as a fraction of speed × time.
const BRAKING_FRACTION: f64 = 0.42;

/// Returns the track of the pelvis height, in metres.
pub fn track(
    plan: &Plan,
    proportions: &Proportions,
    paths: &[FootPath; 2],
    flights: &[FlightHeights],
) -> Track<1> {
    let mut keys: Vec<Keyframe<1>> = Vec::new();
    let ends = |n: usize| (n.checked_sub(1).map(|n| &flights[n]), flights.get(n));
    for (before, after) in (0..=flights.len()).map(ends) {
        keys.extend(ground(before, after, proportions));
    }
    let mut walking = walking(plan, proportions, paths, flights);
    walking.retain(|walk| {
        let next = keys.partition_point(|key| key.time < walk.time - MIN_KEY_INTERVAL);
        keys.get(next).is_none_or(|key| key.time > walk.time + MIN_KEY_INTERVAL)
    });
    Track::from_keyframes(keys.into_iter().chain(walking))
}

fn key(time: f64, height: f64, slope: Option<f64>) -> Keyframe<1> {
    Keyframe { time, value: [height], slope: slope.map(|s| [s]) }
}

/// Returns the durations of landing absorption and push-off for a time on the ground, in seconds.
fn absorb_and_push_times(ground: f64) -> (f64, f64) {
    (MAX_ABSORB_TIME.min(ground / 2.0), MAX_PUSH_TIME.min(ground / 2.0))
}

/// Returns the keyframes of the ground time between two flights.
fn ground(
    before: Option<&FlightHeights>,
    after: Option<&FlightHeights>,
    proportions: &Proportions,
) -> Vec<Keyframe<1>> {
    let length = match (before, after) {
        (Some(before), Some(after)) => after.time.start - before.time.end,
        _ => f64::INFINITY,
    };
    let (absorb, push) = absorb_and_push_times(length);
    let landed = before.map(|flight| flight.landing + BRAKING_FRACTION * flight.landing_speed() * absorb);
    let crouched = after.map(|flight| flight.takeoff - BRAKING_FRACTION * flight.takeoff_speed() * push);
    let mut keys = Vec::new();
    keys.extend(before.map(|flight| key(flight.time.end, flight.landing, Some(flight.landing_speed()))));
    if let (Some(flight), Some(landed)) = (before, landed) {
        let merged_crouch = if length < absorb + push + 0.15 { crouched } else { None };
        let time = flight.time.end + if merged_crouch.is_some() { length / 2.0 } else { absorb };
        // Without this keyframe, for a short ground time, a single cubic connects landing and
        // push-off.
        if length > MAX_BOUNCE_TIME {
            keys.push(key(time, merged_crouch.map_or(landed, |crouched| crouched.min(landed)), Some(0.0)));
        }
        if length > 1.4 {
            keys.push(key(time + 0.45, proportions.standing_height(), None));
        }
    }
    if let (Some(flight), Some(crouched)) = (after, crouched) {
        if length >= absorb + push + 0.15 {
            keys.push(key(flight.time.start - push, crouched, Some(0.0)));
        }
        if length > 1.4 {
            keys.push(key(flight.time.start - push - 0.45, proportions.standing_height(), None));
        }
        keys.push(key(flight.time.start, flight.takeoff, Some(flight.takeoff_speed())));
    }
    keys
}

/// Returns keyframes that rise over the standing leg and dip between steps, away from flights.
fn walking(
    plan: &Plan,
    proportions: &Proportions,
    paths: &[FootPath; 2],
    flights: &[FlightHeights],
) -> Vec<Keyframe<1>> {
    let standing = proportions.standing_height();
    let mut keys = vec![key(plan.start, standing, None)];
    for (foot, other) in [(0, 1), (1, 0)] {
        let stances = paths[foot].stances();
        for pair in stances.windows(2) {
            let (off, strike) = (pair[0].toe_off, pair[1].strike);
            let step = (pair[1].placement.point() - pair[0].placement.point()).norm();
            if strike - off < 0.9 && step > 0.1 {
                keys.push(key((off + strike) / 2.0, standing - 0.2 * plan.body.vertical_excursion, None));
            }
            if off - pair[0].strike > 0.9 {
                keys.push(key(off - 0.35, standing, None));
            }
            let others = paths[other].stances();
            let next = others.get(others.partition_point(|s| s.toe_off <= strike)).map(|s| s.toe_off);
            let low = standing - plan.body.vertical_excursion - 0.5 * dip(0.25 * step, proportions);
            match next {
                Some(next) if next - strike < 0.4 => keys.push(key((strike + next) / 2.0, low, None)),
                _ if pair[1].toe_off - strike > 0.9 => {
                    keys.push(key(strike + 0.12, standing - plan.body.vertical_excursion, None));
                    keys.push(key(strike + 0.5, standing, None));
                }
                _ => {}
            }
        }
    }
    let (absorb, push) = (MAX_ABSORB_TIME + 0.3, MAX_PUSH_TIME + 0.3);
    keys.retain(|key| {
        let next = flights.partition_point(|flight| flight.time.end + absorb < key.time);
        flights.get(next).is_none_or(|flight| key.time < flight.time.start - push)
    });
    keys.sort_by(|a, b| a.time.total_cmp(&b.time));
    keys.dedup_by(|later, earlier| later.time - earlier.time < MIN_KEY_INTERVAL);
    keys
}
