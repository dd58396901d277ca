//! Which part of a foot stands in each frame, and the plants that makes.

use std::ops::Range;

use crate::intervals::intervals;
use crate::kinematics::Track;
use crate::skate::contacts::FootContacts;
use crate::skate::leg::{Leg, median};
use crate::skeleton::Up;

/// What a foot stands on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Phase {
    /// Nothing.
    Free,
    /// The heel alone: the foot rolls about it.
    Heel,
    /// Heel and toe.
    Flat,
    /// The toe alone.
    Toe,
}

impl Phase {
    pub fn has_toe(self) -> bool {
        matches!(self, Phase::Flat | Phase::Toe)
    }

    pub fn has_heel(self) -> bool {
        matches!(self, Phase::Flat | Phase::Heel)
    }
}

/// How far the height of the ankle over the toe may be from that of a flat foot, in legs.
const FLAT: f64 = 0.02;

/// A planted foot that moves this far from one frame to the next was put elsewhere, in legs, ...
const JUMP: f64 = 0.03;
/// ... if it moves so many times less in the frames before and after.
const SUDDEN: f64 = 3.0;

/// The phase of a foot in each frame; `length` is the leg's.
///
/// Heel and toe as labelled. Where neither of them has a label throughout a contact, how the
/// foot is pitched tells which of them bears it. With toes alone labelled, toes alone stand.
pub(crate) fn phases(leg: &Leg, contacts: &FootContacts, up: Up, length: f64) -> Vec<Phase> {
    let count = leg.ankle.len();
    let at = |labels: &Option<Vec<bool>>, frame: usize| labels.as_ref().is_some_and(|labels| labels[frame]);
    let mut phases: Vec<Phase> = (0..count)
        .map(|frame| match (at(&contacts.heel, frame), at(&contacts.toe, frame)) {
            (false, false) => Phase::Free,
            (true, false) => Phase::Heel,
            (true, true) => Phase::Flat,
            (false, true) => Phase::Toe,
        })
        .collect();
    let Some(contact) = &contacts.contact else { return as_point(phases, leg) };
    let bare: Vec<Range<usize>> = intervals(contact)
        .into_iter()
        .filter(|run| phases[run.clone()].iter().all(|&phase| phase == Phase::Free))
        .collect();
    if !bare.is_empty() {
        let rest = flat_rise(leg, contact, up);
        for frame in bare.into_iter().flatten() {
            let over = (rise(leg, up, frame) - rest) / length;
            phases[frame] = match over {
                _ if over > FLAT => Phase::Toe,
                _ if over < -FLAT => Phase::Heel,
                _ => Phase::Flat,
            };
        }
    }
    as_point(phases, leg)
}

/// A foot without toes stands on its one point, whatever is labelled.
fn as_point(mut phases: Vec<Phase>, leg: &Leg) -> Vec<Phase> {
    if leg.is_point() {
        phases.iter_mut().filter(|phase| **phase != Phase::Free).for_each(|phase| *phase = Phase::Toe);
    }
    phases
}

/// Height of the ankle over the toe.
fn rise(leg: &Leg, up: Up, frame: usize) -> f64 {
    -up.height(&leg.sole(frame))
}

/// The same of the flat foot: the middle one of the slower half of the frames in contact.
fn flat_rise(leg: &Leg, contact: &[bool], up: Up) -> f64 {
    let step = |frame: usize| (leg.ankle[frame] - leg.ankle[frame.saturating_sub(1)]).norm();
    let planted = || (0..contact.len()).filter(|&frame| contact[frame]);
    let slow = median(planted().map(step)).unwrap_or(0.0);
    median(planted().filter(|&frame| step(frame) <= slow).map(|frame| rise(leg, up, frame))).unwrap_or(0.0)
}

/// The plants: runs of frames in which something stands, cut where the foot is all at once elsewhere.
pub(crate) fn plants(leg: &Leg, phases: &[Phase], length: f64) -> Vec<Range<usize>> {
    let standing: Vec<bool> = phases.iter().map(|&phase| phase != Phase::Free).collect();
    let step = |frame: usize| {
        let by = |track: &Track| (track[frame] - track[frame - 1]).norm();
        by(&leg.ankle).min(by(&leg.toe))
    };
    let jumps = |frame: usize| {
        let around = [frame - 1, frame + 1].into_iter().filter(|&frame| frame > 0 && frame < phases.len());
        step(frame) > JUMP * length && around.map(step).all(|other| step(frame) > SUDDEN * other)
    };
    let mut plants = Vec::new();
    for run in intervals(&standing) {
        let mut start = run.start;
        for frame in run.start + 1..run.end {
            if jumps(frame) {
                plants.push(start..frame);
                start = frame;
            }
        }
        plants.push(start..run.end);
    }
    plants
}

/// The runs of frames within `frames` whose phase is `wanted`.
pub(crate) fn runs(phases: &[Phase], frames: &Range<usize>, wanted: fn(Phase) -> bool) -> Vec<Range<usize>> {
    let labels: Vec<bool> = phases[frames.clone()].iter().map(|&phase| wanted(phase)).collect();
    let shift = |run: Range<usize>| run.start + frames.start..run.end + frames.start;
    intervals(&labels).into_iter().map(shift).collect()
}
