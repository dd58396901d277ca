//! The height of the pelvis: ballistic in the air, giving way and pushing off on the
//! ground, rising over each standing leg in a walk.

use super::leap::{Leap, dip};
use crate::character::Build;
use crate::curve::{Key, Track};
use crate::feet::FootPath;
use crate::plan::Plan;

/// Longest times to give way after landing and to push off, in seconds.
const GIVE: f64 = 0.24;
const PUSH: f64 = 0.34;

/// Least time between two turns of the height that no flight asks for, in seconds.
const APART: f64 = 0.08;

/// Longest time on the ground that is one bounce, in seconds.
const BOUNCE: f64 = 0.36;

/// Share of speed × time that the pelvis travels while it is stopped or set off.
const YIELD: f64 = 0.42;

/// The height of the pelvis joint over time, in metres.
pub fn track(plan: &Plan, build: &Build, paths: &[FootPath; 2], leaps: &[Leap]) -> Track<1> {
    let mut keys: Vec<Key<1>> = Vec::new();
    let ends = |n: usize| (n.checked_sub(1).map(|n| &leaps[n]), leaps.get(n));
    for (before, after) in (0..=leaps.len()).map(ends) {
        keys.extend(ground(before, after, build));
    }
    let mut walking = walking(plan, build, paths, leaps);
    walking.retain(|walk| {
        let next = keys.partition_point(|key| key.time < walk.time - APART);
        keys.get(next).is_none_or(|key| key.time > walk.time + APART)
    });
    Track::through(keys.into_iter().chain(walking))
}

fn key(time: f64, height: f64, slope: Option<f64>) -> Key<1> {
    Key { time, value: [height], slope: slope.map(|s| [s]) }
}

/// Seconds after a landing, or before a jump, that belong to it when the body has time.
fn shares(ground: f64) -> (f64, f64) {
    (GIVE.min(ground / 2.0), PUSH.min(ground / 2.0))
}

/// The keys of the time on the ground between two leaps.
fn ground(before: Option<&Leap>, after: Option<&Leap>, build: &Build) -> Vec<Key<1>> {
    let length = match (before, after) {
        (Some(before), Some(after)) => after.time.start - before.time.end,
        _ => f64::INFINITY,
    };
    let (give, push) = shares(length);
    let landed = before.map(|leap| leap.land + YIELD * leap.land_speed() * give);
    let crouched = after.map(|leap| leap.off - YIELD * leap.off_speed() * push);
    let mut keys = Vec::new();
    keys.extend(before.map(|leap| key(leap.time.end, leap.land, Some(leap.land_speed()))));
    if let (Some(leap), Some(landed)) = (before, landed) {
        let shared = if length < give + push + 0.15 { crouched } else { None };
        let time = leap.time.end + if shared.is_some() { length / 2.0 } else { give };
        // In a short stance one cubic from landing to push-off does it all.
        if length > BOUNCE {
            keys.push(key(time, shared.map_or(landed, |crouched| crouched.min(landed)), Some(0.0)));
        }
        if length > 1.4 {
            keys.push(key(time + 0.45, build.standing(), None));
        }
    }
    if let (Some(leap), Some(crouched)) = (after, crouched) {
        if length >= give + push + 0.15 {
            keys.push(key(leap.time.start - push, crouched, Some(0.0)));
        }
        if length > 1.4 {
            keys.push(key(leap.time.start - push - 0.45, build.standing(), None));
        }
        keys.push(key(leap.time.start, leap.off, Some(leap.off_speed())));
    }
    keys
}

/// Rises over the standing leg and dips between the steps, where no leap is near.
fn walking(plan: &Plan, build: &Build, paths: &[FootPath; 2], leaps: &[Leap]) -> Vec<Key<1>> {
    let standing = build.standing();
    let mut keys = vec![key(plan.start, standing, None)];
    for (foot, other) in [(0, 1), (1, 0)] {
        let stances = paths[foot].stances();
        for pair in stances.windows(2) {
            let (off, strike) = (pair[0].off, pair[1].strike);
            let step = (pair[1].place.point() - pair[0].place.point()).norm();
            if strike - off < 0.9 && step > 0.1 {
                keys.push(key((off + strike) / 2.0, standing - 0.2 * plan.body.bob, None));
            }
            if off - pair[0].strike > 0.9 {
                keys.push(key(off - 0.35, standing, None));
            }
            let others = paths[other].stances();
            let next = others.get(others.partition_point(|s| s.off <= strike)).map(|s| s.off);
            let low = standing - plan.body.bob - 0.5 * dip(0.25 * step, build);
            match next {
                Some(next) if next - strike < 0.4 => keys.push(key((strike + next) / 2.0, low, None)),
                _ if pair[1].off - strike > 0.9 => {
                    keys.push(key(strike + 0.12, standing - plan.body.bob, None));
                    keys.push(key(strike + 0.5, standing, None));
                }
                _ => {}
            }
        }
    }
    let (give, push) = (GIVE + 0.3, PUSH + 0.3);
    keys.retain(|key| {
        let next = leaps.partition_point(|leap| leap.time.end + give < key.time);
        leaps.get(next).is_none_or(|leap| key.time < leap.time.start - push)
    });
    keys.sort_by(|a, b| a.time.total_cmp(&b.time));
    keys.dedup_by(|later, earlier| later.time - earlier.time < APART);
    keys
}
