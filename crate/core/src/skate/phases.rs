//! Phases of a foot, and the plants they form.

use std::ops::Range;

use crate::intervals::intervals;
use crate::kinematics::Track;
use crate::numeric::stats::median_low;
use crate::skate::contacts::FootContacts;
use crate::skate::leg::Leg;
use crate::skeleton::Up;

/// Part of a foot that bears on the ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Phase {
    /// None.
    Free,
    /// Only the heel, about which the foot rolls.
    Heel,
    /// Heel and toe.
    Flat,
    /// Only the toe.
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

/// Maximum difference of the ankle's height above the toe from that of the flat foot, in leg
/// lengths.
const FLAT_TOLERANCE: f64 = 0.02;

/// Minimum step of a planted foot that counts as a jump, in leg lengths …
const MIN_JUMP: f64 = 0.03;
/// … and its minimum ratio to the steps before and after.
const JUMP_RATIO: f64 = 3.0;

/// Returns the phase of a foot in each frame; `length` is the leg length.
///
/// Heel and toe are used as labelled. If neither has a label during a contact, the pitch of the
/// foot determines the phase. If only toes are labelled, the phase is toe.
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
    let unlabelled: Vec<Range<usize>> = intervals(contact)
        .into_iter()
        .filter(|run| phases[run.clone()].iter().all(|&phase| phase == Phase::Free))
        .collect();
    if !unlabelled.is_empty() {
        let flat = flat_ankle_height(leg, contact, up);
        for frame in unlabelled.into_iter().flatten() {
            let difference = (ankle_height(leg, up, frame) - flat) / length;
            phases[frame] = match difference {
                _ if difference > FLAT_TOLERANCE => Phase::Toe,
                _ if difference < -FLAT_TOLERANCE => Phase::Heel,
                _ => Phase::Flat,
            };
        }
    }
    as_point(phases, leg)
}

/// A foot without toes has a single point of contact.
fn as_point(mut phases: Vec<Phase>, leg: &Leg) -> Vec<Phase> {
    if leg.is_point() {
        phases.iter_mut().filter(|phase| **phase != Phase::Free).for_each(|phase| *phase = Phase::Toe);
    }
    phases
}

/// Returns the height of the ankle above the toe.
fn ankle_height(leg: &Leg, up: Up, frame: usize) -> f64 {
    -up.height(&leg.sole(frame))
}

/// Returns that height of the flat foot: the median over the slower half of the frames in contact.
fn flat_ankle_height(leg: &Leg, contact: &[bool], up: Up) -> f64 {
    let step = |frame: usize| (leg.ankle[frame] - leg.ankle[frame.saturating_sub(1)]).norm();
    let planted = || (0..contact.len()).filter(|&frame| contact[frame]);
    let slow = median_low(planted().map(step)).unwrap_or(0.0);
    median_low(planted().filter(|&frame| step(frame) <= slow).map(|frame| ankle_height(leg, up, frame)))
        .unwrap_or(0.0)
}

/// Returns the plants: runs of frames with contact, split where the foot jumps.
pub(crate) fn plants(leg: &Leg, phases: &[Phase], length: f64) -> Vec<Range<usize>> {
    let planted: Vec<bool> = phases.iter().map(|&phase| phase != Phase::Free).collect();
    let step = |frame: usize| {
        let distance = |track: &Track| (track[frame] - track[frame - 1]).norm();
        distance(&leg.ankle).min(distance(&leg.toe))
    };
    let is_jump = |frame: usize| {
        let around = [frame - 1, frame + 1].into_iter().filter(|&frame| frame > 0 && frame < phases.len());
        step(frame) > MIN_JUMP * length && around.map(step).all(|other| step(frame) > JUMP_RATIO * other)
    };
    let mut plants = Vec::new();
    for run in intervals(&planted) {
        let mut start = run.start;
        for frame in run.start + 1..run.end {
            if is_jump(frame) {
                plants.push(start..frame);
                start = frame;
            }
        }
        plants.push(start..run.end);
    }
    plants
}

/// Returns the runs of frames within `frames` whose phase satisfies `condition`.
pub(crate) fn runs(
    phases: &[Phase],
    frames: &Range<usize>,
    condition: fn(Phase) -> bool,
) -> Vec<Range<usize>> {
    let labels: Vec<bool> = phases[frames.clone()].iter().map(|&phase| condition(phase)).collect();
    let shift = |run: Range<usize>| run.start + frames.start..run.end + frames.start;
    intervals(&labels).into_iter().map(shift).collect()
}
