//! The height of the pelvis: ballistic in the air, giving way and pushing off on the
//! ground, rising over each standing leg in a walk.

use crate::character::Build;
use crate::curve::{Key, Track};
use crate::feet::FootPath;
use crate::maths::GRAVITY;
use crate::plan::{Interval, Plan, Stance, flights};

/// Longest times to give way after landing and to push off, in seconds.
const GIVE: f64 = 0.24;
const PUSH: f64 = 0.34;

/// Share of speed × time that the pelvis travels while it is stopped or set off.
const YIELD: f64 = 0.42;

/// A flight with the heights and the upward speeds at its ends.
struct Leap {
    time: Interval,
    off: (f64, f64),
    land: (f64, f64),
}

/// The height of the pelvis joint over time, in metres.
pub fn track(plan: &Plan, build: &Build, paths: &[FootPath; 2]) -> Track<1> {
    let leaps: Vec<Leap> = flights(plan).into_iter().map(|time| leap(time, build, paths)).collect();
    let mut keys = walking(plan, build, paths, &leaps);
    let ends = |n: usize| (n.checked_sub(1).map(|n| &leaps[n]), leaps.get(n));
    for (before, after) in (0..=leaps.len()).map(ends) {
        keys.extend(ground(before, after, build));
    }
    Track::through(keys)
}

fn key(time: f64, height: f64, slope: Option<f64>) -> Key<1> {
    Key { time, value: [height], slope: slope.map(|s| [s]) }
}

/// How much lower the hip is when the foot stands `across` metres from below it.
fn dip(across: f64, build: &Build) -> f64 {
    let leg = build.leg();
    let across = across.abs().min(0.6 * leg);
    leg - (leg * leg - across * across).sqrt()
}

fn leap(time: Interval, build: &Build, paths: &[FootPath; 2]) -> Leap {
    let ending = |s: &&Stance| (s.off - time.start).abs() < 1e-6;
    let starting = |s: &&Stance| (s.strike - time.end).abs() < 1e-6;
    let find = |wanted: &dyn Fn(&&Stance) -> bool| paths.iter().find_map(|p| p.stances().iter().find(wanted));
    let (from, to) = (find(&ending).expect("a foot leaves"), find(&starting).expect("a foot lands"));

    let length = time.end - time.start;
    let ground = |s: &Stance| (s.off - s.strike).clamp(0.1, 0.5);
    let speed = (to.place.point() - from.place.point()).norm() / (length + (ground(from) + ground(to)) / 2.0);
    let across = |s: &Stance| speed * 0.4 * ground(s);
    let raised = |pitch: f64| build.instep * libm::sin(pitch.max(0.0).to_radians());

    let off = build.standing() + 0.8 * raised(from.lift.pitch) - dip(across(from), build) - 0.025 * build.leg();
    let land =
        build.standing() + 0.8 * raised(to.landing.pitch) - dip(across(to), build) - 0.02 * build.leg();
    // A short flight has no time for much of a fall.
    let off = off.min(land + 0.1 * GRAVITY * length * length);
    let rising = (land - off) / length + GRAVITY * length / 2.0;
    Leap { time, off: (off, rising), land: (land, rising - GRAVITY * length) }
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
    let landed = before.map(|leap| leap.land.0 + YIELD * leap.land.1 * give);
    let crouched = after.map(|leap| leap.off.0 - YIELD * leap.off.1 * push);
    let mut keys = Vec::new();
    keys.extend(before.map(|leap| key(leap.time.end, leap.land.0, Some(leap.land.1))));
    if let (Some(leap), Some(landed)) = (before, landed) {
        let shared = if length < give + push + 0.15 { crouched } else { None };
        let time = leap.time.end + if shared.is_some() { length / 2.0 } else { give };
        keys.push(key(time, shared.map_or(landed, |crouched| crouched.min(landed)), Some(0.0)));
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
        keys.push(key(leap.time.start, leap.off.0, Some(leap.off.1)));
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
            let next = paths[other].stances().iter().map(|s| s.off).find(|&off| off > strike);
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
    keys.retain(|key| !leaps.iter().any(|l| (l.time.start - push..l.time.end + give).contains(&key.time)));
    keys.sort_by(|a, b| a.time.total_cmp(&b.time));
    keys.dedup_by(|later, earlier| later.time - earlier.time < 0.07);
    keys
}
