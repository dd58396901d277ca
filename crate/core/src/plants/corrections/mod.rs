//! Corrections of a person, applied to similar motion.
//!
//! A person corrects a few plants. The corrected frames are constraints of the spectral clustering, as in
//! Kamvar, Klein and Manning, *Spectral learning* (IJCAI 2003): their labels are given, and other motion
//! takes part in a correction as far as its affinity to the corrected motion reaches. Motion without such
//! affinity retains the labels of the clustering.
//!
//! Two things can be wrong. The boundary of a plant can be early or late: [`edges`] moves similar boundaries
//! likewise. Or a run of frames has the wrong label, such as a foot that is held still in the air:
//! [`runs`] changes the label of similar runs. With several corrections, the nearest stated frames then vote for the
//! labels of similar frames, if cross-validation shows that this is better: [`votes`]. Affinities are those of windows of height and speed in leg
//! lengths, so that corrections apply to other clips of the same character as well. Affinities and limits were
//! chosen on generated hard cases (seeds 0 to 9).

mod edges;
mod example;
mod profile;
mod runs;
mod votes;

use std::ops::Range;
use std::sync::Arc;

use crate::foot::{Part, Side};
use crate::intervals::intervals;
use crate::notice::{Code, Notice};
use crate::plants::{Detection, Edge, Edit, Feet, FootLabels, Instant, PartLabels, apply_edits};
use edges::EdgeExample;
use example::{Example, edited_frames};
use profile::Profile;
use runs::RunExample;
use votes::{StatedFrame, Validation};

/// Corrections of a person, with the motion that was corrected.
#[derive(Clone, Debug, Default)]
pub struct Corrections {
    edges: Vec<EdgeExample>,
    runs: Vec<RunExample>,
    frames: Vec<StatedFrame>,
    validation: Validation,
}

/// Labels after corrections were applied to similar motion.
#[derive(Clone, Debug)]
pub struct Corrected {
    /// Detection with the corrections, and the edits of this clip, applied.
    pub detection: Detection,
    /// Changes of labels outside of the edits, as edits; in order of part, side, label and frame.
    pub changes: Vec<Edit>,
    /// Number of plants that were changed, added or removed outside of the edits.
    pub plants: usize,
    /// Instants of boundaries that the labels with `changes` as edits lack; in order of part, side and frame.
    pub instants: Vec<Instant>,
}

impl Corrected {
    /// Returns the notice that states to how many plants the corrections were applied.
    pub fn notice(&self) -> Notice {
        let text = match self.plants {
            0 => "The corrections change no other plants.".into(),
            1 => "The corrections were applied to 1 similar plant.".into(),
            count => format!("The corrections were applied to {count} similar plants."),
        };
        Notice::new(Code::Corrections, text)
    }
}

impl Corrections {
    /// Learns from the edits of a clip.
    ///
    /// `detection` has the labels of the method, without edits. Edits that agree with the detection count as
    /// well: they confirm its labels.
    pub fn learn(feet: &Feet, detection: &Detection, edits: &[Edit]) -> Corrections {
        let clip = Clip::new(feet, detection);
        let mut corrections = Corrections::from_edits(&clip, edits);
        if !corrections.is_empty() {
            corrections.validate(&clip, edits);
        }
        corrections
    }

    /// Learns without cross-validation.
    fn from_edits(clip: &Clip, edits: &[Edit]) -> Corrections {
        let edited = apply_edits(clip.detection, edits, clip.frame_time);
        let mut corrections = Corrections::default();
        for (before, after) in clip.detection.parts.iter().zip(&edited.parts) {
            for side in Side::BOTH {
                let example = Example::new(before.part, side, before.foot(side), after.foot(side), edits);
                if example.is_empty() {
                    continue;
                }
                let profile = &clip.profiles[side as usize];
                corrections.edges.extend(edges::learn(&example, profile));
                corrections.runs.extend(runs::learn(&example, profile));
                corrections.frames.extend(votes::learn(&example, profile));
            }
        }
        corrections
    }

    /// Labels the stated frames of each fold by means of the others, without and with votes.
    fn validate(&mut self, clip: &Clip, edits: &[Edit]) {
        let edited = apply_edits(clip.detection, edits, clip.frame_time);
        let mut folds = Vec::new();
        for (before, after) in clip.detection.parts.iter().zip(&edited.parts) {
            for side in Side::BOTH {
                let example = Example::new(before.part, side, before.foot(side), after.foot(side), edits);
                folds.extend(votes::folds(&example).into_iter().map(|fold| (side, before.part, fold)));
            }
        }
        votes::retain_frequent(&mut folds);
        for (side, part, fold) in folds {
            let (Some(before), Some(after)) = (clip.detection.part(part), edited.part(part)) else {
                continue;
            };
            let others = without(edits, part, side, &fold.frames);
            let learnt = Corrections::from_edits(clip, &others);
            let mut labels = learnt.labels(clip, before, side, &others, &fold.frames);
            let wrong_frames = |labels: &FootLabels| {
                let is_wrong = |&frame: &usize| labels.planted[frame] != after.foot(side).planted[frame];
                fold.frames.clone().filter(is_wrong).count()
            };
            let without_votes = wrong_frames(&labels);
            learnt.vote(clip, (part, side), &others, (&fold.frames, [true; 3]), &mut labels);
            let wrong = [without_votes, wrong_frames(&labels)];
            self.validation.add_fold(&fold, wrong);
        }
    }

    /// Adds the corrections of another clip of the same character.
    pub fn extend(&mut self, other: Corrections) {
        self.edges.extend(other.edges);
        self.runs.extend(other.runs);
        self.frames.extend(other.frames);
        self.validation.extend(&other.validation);
    }

    /// True if no correction was learnt: the edits confirm the labels.
    pub fn is_empty(&self) -> bool {
        self.edges.iter().all(|edge| edge.offset() == 0.0) && self.runs.iter().all(|run| run.is_confirmed)
    }

    /// Applies the corrections to the similar motion of a clip, then the edits of that clip.
    ///
    /// `detection` has the labels of the method, without edits. Frames of `edits` are not changed otherwise.
    pub fn apply(&self, feet: &Feet, detection: &Detection, edits: &[Edit]) -> Corrected {
        let before = apply_edits(detection, edits, feet.frame_time);
        let mut corrected = detection.clone();
        let clip = Clip::new(feet, detection);
        let votes = self.validation.better();
        for side in Side::BOTH {
            for (before, part) in detection.parts.iter().zip(&mut corrected.parts) {
                let all = 0..before.foot(side).planted.len();
                let mut labels = self.labels(&clip, before, side, edits, &all);
                self.vote(&clip, (before.part, side), edits, (&all, votes), &mut labels);
                part.feet[side as usize] = labels;
            }
            keep_parts_within_contact(&mut corrected, side);
        }
        let detection = apply_edits(&corrected, edits, feet.frame_time);
        let changes = changes(&before, &detection);
        let plants = changed_plants(&before, &detection);
        let instants = instants(&before, &detection);
        Corrected { detection, changes, plants, instants }
    }

    /// Returns the labels of one foot with the corrected boundaries and runs applied to the frames of `scope`.
    fn labels(
        &self,
        clip: &Clip,
        before: &PartLabels,
        side: Side,
        edits: &[Edit],
        scope: &Range<usize>,
    ) -> FootLabels {
        let part = before.part;
        let mut labels = before.foot(side).clone();
        let profile = &clip.profiles[side as usize];
        let fixed = edited_frames(edits, part, side, labels.planted.len());
        let of_foot = |run: &&RunExample| run.part == part && run.side == side;
        let runs: Vec<&RunExample> = self.runs.iter().filter(of_foot).collect();
        runs::apply(&runs, profile, &fixed, scope, &mut labels);
        let edges: Vec<&EdgeExample> = self.edges.iter().filter(|edge| edge.part == part).collect();
        edges::apply(&edges, profile, &fixed, scope, &mut labels);
        labels
    }

    /// Lets the stated frames vote for the labels of similar frames of `scope`, for the given kinds of changes.
    fn vote(
        &self,
        clip: &Clip,
        (part, side): (Part, Side),
        edits: &[Edit],
        scope_and_kinds: (&Range<usize>, [bool; 3]),
        labels: &mut FootLabels,
    ) {
        let fixed = edited_frames(edits, part, side, labels.planted.len());
        let frames: Vec<&StatedFrame> = self.frames.iter().filter(|frame| frame.part == part).collect();
        votes::apply(&frames, &clip.profiles[side as usize], &fixed, scope_and_kinds, labels);
    }
}

/// Labels of the method, with the motion of both feet.
struct Clip<'a> {
    detection: &'a Detection,
    profiles: [Arc<Profile>; 2],
    frame_time: f64,
}

impl<'a> Clip<'a> {
    fn new(feet: &Feet, detection: &'a Detection) -> Clip<'a> {
        let profiles = Side::BOTH.map(|side| Arc::new(Profile::new(feet, detection, side)));
        Clip { detection, profiles, frame_time: feet.frame_time }
    }
}

/// Returns edits without those of a range of frames of one part of one foot.
fn without(edits: &[Edit], part: Part, side: Side, range: &Range<usize>) -> Vec<Edit> {
    let mut others = Vec::new();
    for edit in edits {
        if (edit.part, edit.side) != (part, side) {
            others.push(*edit);
            continue;
        }
        let before = Edit { end: edit.end.min(range.start), ..*edit };
        let after = Edit { start: edit.start.max(range.end), ..*edit };
        others.extend([before, after].into_iter().filter(|edit| edit.start < edit.end));
    }
    others
}

/// Removes heel and toe where the foot is not in contact.
fn keep_parts_within_contact(detection: &mut Detection, side: Side) {
    let Some(contact) = detection.part(Part::Contact).map(|labels| labels.foot(side).planted.clone()) else {
        return;
    };
    for labels in detection.parts.iter_mut().filter(|labels| labels.part != Part::Contact) {
        let planted = &mut labels.feet[side as usize].planted;
        planted.iter_mut().zip(&contact).for_each(|(planted, contact)| *planted &= contact);
    }
}

/// Returns the differences of two detections as edits of the second one. Heel and toe are listed where
/// they do not follow from contact.
fn changes(before: &Detection, after: &Detection) -> Vec<Edit> {
    let mut changes: Vec<Edit> = Vec::new();
    for (old, new) in before.parts.iter().zip(&after.parts) {
        for side in Side::BOTH {
            let (old, now) = (&old.foot(side).planted, &new.foot(side).planted);
            // Removed contact removes heel and toe, too.
            let removed: Vec<Range<usize>> = changes
                .iter()
                .filter(|other| other.side == side && other.part == Part::Contact && !other.planted)
                .map(|other| other.start..other.end)
                .collect();
            for planted in [false, true] {
                let is_changed = |(old, now): (&bool, &bool)| old != now && *now == planted;
                for Range { start, end } in
                    intervals(&old.iter().zip(now).map(is_changed).collect::<Vec<_>>())
                {
                    let index = removed.partition_point(|range| range.end < end);
                    let follows = !planted && removed.get(index).is_some_and(|range| range.start <= start);
                    if !follows {
                        changes.push(Edit { side, part: new.part, start, end, planted });
                    }
                }
            }
        }
    }
    changes
}

/// Returns the instants of boundaries of the second detection that the first one lacks.
fn instants(before: &Detection, after: &Detection) -> Vec<Instant> {
    let mut instants = Vec::new();
    for (old, new) in before.parts.iter().zip(&after.parts) {
        for side in Side::BOTH {
            let (old, now) = (old.foot(side), new.foot(side));
            let is_new = |edge: &&Edge| now.is_boundary(edge.frame) && old.edge(edge.frame) != Some(edge);
            let new_edges = now.edges.iter().filter(is_new);
            instants.extend(new_edges.map(|&edge| Instant { side, part: new.part, edge }));
        }
    }
    instants
}

/// Returns the number of plants of the principal part that differ: those of either detection, of which
/// those that overlap count once.
fn changed_plants(before: &Detection, after: &Detection) -> usize {
    let count = |side: Side| {
        let [old, new] =
            [before, after].map(|detection| intervals(&detection.principal().foot(side).planted));
        let overlaps = |a: &Range<usize>, b: &Range<usize>| a.start < b.end && b.start < a.end;
        let changed = new.iter().filter(|plant| !old.contains(plant)).count();
        let removed = old.iter().filter(|plant| !new.iter().any(|other| overlaps(plant, other))).count();
        changed + removed
    };
    Side::BOTH.into_iter().map(count).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants::{FootTracks, Ground, ValidParams};
    use crate::skeleton::Up;

    const FRAME_TIME: f64 = 0.01;
    /// Frames of a step: 60 on the ground, 40 in the air.
    const STEP: usize = 100;
    const STEPS: usize = 8;

    fn feet() -> Feet {
        let track = vec![nalgebra::Vector3::zeros(); STEP * STEPS];
        let foot = || FootTracks { ankle: track.clone(), toe: track.clone(), tip: None };
        Feet {
            tracks: [foot(), foot()],
            hips: track.clone(),
            up: Up::Y,
            leg: 1.0,
            metres_per_unit: 1.0,
            frame_time: FRAME_TIME,
        }
    }

    /// A detection of a left foot that steps, and of a right foot at rest. `height` is the peak height of a
    /// step; the foot is planted where `planted` is true.
    fn detection(height: impl Fn(usize) -> f32, planted: impl Fn(usize) -> bool) -> Detection {
        let frames = STEP * STEPS;
        let phase = |frame: usize| (frame % STEP).saturating_sub(60) as f32 / 40.0;
        let swing = |frame: usize| (std::f32::consts::PI * phase(frame)).sin();
        let stepping = FootLabels {
            planted: (0..frames).map(planted).collect(),
            confidence: vec![0.9; frames],
            height: (0..frames).map(|frame| height(frame / STEP) * swing(frame)).collect(),
            speed: (0..frames).map(|frame| 10.0 * height(frame / STEP) * swing(frame)).collect(),
            edges: Vec::new(),
        };
        let resting = FootLabels {
            planted: vec![true; frames],
            height: vec![0.0; frames],
            speed: vec![0.0; frames],
            ..stepping.clone()
        };
        Detection {
            params: ValidParams::default(),
            parts: vec![PartLabels { part: Part::Contact, feet: [stepping, resting], evidence: None }],
            ground_height: 0.0,
            ground: Ground::level(),
            noise: None,
            notices: Vec::new(),
            edits: Vec::new(),
        }
    }

    fn edit(start: usize, end: usize, planted: bool) -> Edit {
        Edit { side: Side::Left, part: Part::Contact, start, end, planted }
    }

    fn plants(detection: &Detection) -> Vec<Range<usize>> {
        intervals(&detection.principal().foot(Side::Left).planted)
    }

    fn apply(detection: &Detection, edits: &[Edit]) -> Corrected {
        Corrections::learn(&feet(), detection, edits).apply(&feet(), detection, edits)
    }

    #[test]
    fn a_corrected_foot_off_moves_similar_ones() {
        // Plants end 10 frames late.
        let detected = detection(|_| 0.2, |frame| frame % STEP < 70);
        let edits = [edit(260, 270, false), edit(200, 260, true)];
        let corrected = apply(&detected, &edits);
        let expected: Vec<_> = (0..STEPS).map(|step| step * STEP..step * STEP + 60).collect();
        assert_eq!(plants(&corrected.detection), expected);
        assert_eq!(corrected.plants, STEPS - 1);
        assert!(corrected.changes.iter().all(|change| !change.planted && change.end - change.start == 10));
        // The changes are edits: added to those of the person, they give the same labels.
        let all: Vec<Edit> = edits.iter().chain(&corrected.changes).copied().collect();
        assert_eq!(plants(&apply_edits(&detected, &all, FRAME_TIME)), expected);
    }

    #[test]
    fn instants_complete_the_changes() {
        let mut detected = detection(|_| 0.2, |frame| frame % STEP < 70);
        detected.parts[0].feet[0].edges = (0..STEPS)
            .flat_map(|step| {
                let edge =
                    |frame: usize| Edge { frame, time: (frame as f64 - 0.2) * FRAME_TIME, uncertainty: 0.01 };
                [edge(step * STEP), edge(step * STEP + 70)]
            })
            .skip(1)
            .collect();
        let edits = [edit(260, 270, false), edit(200, 260, true)];
        let corrected = apply(&detected, &edits);
        assert_eq!(corrected.instants.len(), STEPS - 1);
        let all: Vec<Edit> = edits.iter().chain(&corrected.changes).copied().collect();
        let mut repeated = apply_edits(&detected, &all, FRAME_TIME);
        repeated.set_instants(&corrected.instants);
        let instants = |detection: &Detection| -> Vec<Option<Edge>> {
            let foot = detection.principal().foot(Side::Left);
            let boundaries = (0..STEP * STEPS).filter(|&frame| foot.is_boundary(frame));
            boundaries.map(|frame| foot.edge(frame).copied()).collect()
        };
        assert_eq!(instants(&repeated), instants(&corrected.detection));
        // Where there is no boundary, there is no instant.
        let mut other = apply_edits(&detected, &[edit(0, 800, true)], FRAME_TIME);
        other.set_instants(&corrected.instants);
        assert!(instants(&other).is_empty());
    }

    #[test]
    fn one_side_of_a_boundary_is_sufficient() {
        let detected = detection(|_| 0.2, |frame| frame % STEP < 70);
        assert_eq!(apply(&detected, &[edit(260, 270, false)]).plants, STEPS - 1);
    }

    #[test]
    fn other_motion_retains_its_labels() {
        // The last four steps are low, and their plants end in time.
        let is_low = |step: usize| step >= 4;
        let end = |step: usize| if is_low(step) { 60 } else { 70 };
        let height = |step: usize| if is_low(step) { 0.02 } else { 0.3 };
        let detected = detection(height, |frame| frame % STEP < end(frame / STEP));
        let corrected = apply(&detected, &[edit(160, 170, false), edit(100, 160, true)]);
        let expected: Vec<_> = (0..STEPS).map(|step| step * STEP..step * STEP + 60).collect();
        assert_eq!(plants(&corrected.detection), expected);
        assert_eq!(corrected.plants, 3);
    }

    #[test]
    fn a_correction_within_the_uncertainty_is_not_applied_elsewhere() {
        let detected = detection(|_| 0.2, |frame| frame % STEP < 62);
        let corrected = apply(&detected, &[edit(260, 262, false), edit(200, 260, true)]);
        assert_eq!((corrected.plants, corrected.changes.len()), (0, 0));
    }

    #[test]
    fn corrections_within_the_uncertainty_are_not_applied_elsewhere_either() {
        let detected = detection(|_| 0.2, |frame| frame % STEP < 62);
        let edits = [edit(260, 262, false), edit(360, 362, false), edit(460, 462, false)];
        assert_eq!(apply(&detected, &edits).plants, 0);
    }

    #[test]
    fn several_corrections_move_similar_boundaries_no_further_than_they_show() {
        // Plants end 10 and 12 frames late.
        let end = |frame: usize| 70 + 2 * (frame / STEP % 2);
        let detected = detection(|_| 0.2, |frame| frame % STEP < end(frame));
        let corrected = apply(&detected, &[edit(260, 270, false), edit(360, 372, false)]);
        for (step, plant) in plants(&corrected.detection).iter().enumerate().filter(|(step, _)| *step != 3) {
            assert!((60..=62).contains(&(plant.end - step * STEP)), "{plant:?}");
        }
    }

    #[test]
    fn confirmed_labels_change_nothing() {
        let detected = detection(|_| 0.2, |frame| frame % STEP < 60);
        let edits = [edit(200, 260, true), edit(260, 300, false)];
        let corrections = Corrections::learn(&feet(), &detected, &edits);
        assert!(corrections.is_empty());
        let corrected = corrections.apply(&feet(), &detected, &edits);
        assert_eq!(plants(&corrected.detection), plants(&detected));
    }

    #[test]
    fn similar_false_plants_are_removed_and_edited_frames_stay() {
        // A plant at the top of each swing.
        let detected = detection(|_| 0.2, |frame| frame % STEP < 60 || (75..90).contains(&(frame % STEP)));
        let stated = edit(575, 578, true);
        let corrected = apply(&detected, &[edit(175, 190, false), stated]);
        let mut expected: Vec<_> = (0..STEPS).map(|step| step * STEP..step * STEP + 60).collect();
        expected.insert(6, 575..590);
        assert_eq!(plants(&corrected.detection), expected);
    }

    #[test]
    fn similar_missed_plants_are_added() {
        // The method has missed the first half of each plant.
        let detected = detection(|_| 0.2, |frame| (30..60).contains(&(frame % STEP)));
        let corrected = apply(&detected, &[edit(299, 300, false), edit(300, 330, true)]);
        let found = plants(&corrected.detection);
        assert_eq!(found.len(), STEPS);
        for (step, plant) in found.iter().enumerate().skip(1) {
            assert!(plant.start.abs_diff(step * STEP) <= 3 && plant.end == step * STEP + 60, "{plant:?}");
        }
    }

    #[test]
    fn a_false_plant_that_is_stated_in_part_is_removed() {
        let detected = detection(|_| 0.2, |frame| frame % STEP < 60 || (75..90).contains(&(frame % STEP)));
        let corrected = apply(&detected, &[edit(175, 190, false), edit(588, 600, false)]);
        assert!(!corrected.detection.principal().foot(Side::Left).planted[575..600].contains(&true));
    }

    #[test]
    fn three_boundaries_within_the_uncertainty_show_what_similar_frames_are() {
        let detected = detection(|_| 0.2, |frame| frame % STEP < 62);
        let stated = |start: usize| [edit(start + 30, start + 60, true), edit(start + 60, start + 90, false)];
        let ends = |edits: &[Edit]| plants(&apply(&detected, edits).detection)[0].end;
        assert_eq!(ends(&[stated(200), stated(400)].concat()), 62);
        assert!(ends(&[stated(200), stated(400), stated(500)].concat()).abs_diff(60) <= 1);
    }

    #[test]
    fn votes_add_no_plants() {
        // The same motion without contact in the last steps.
        let detected = detection(|_| 0.2, |frame| frame < 600 && frame % STEP < 62);
        let stated = |start: usize| [edit(start + 30, start + 60, true), edit(start + 60, start + 90, false)];
        let corrected = apply(&detected, &[stated(100), stated(200), stated(400)].concat());
        assert!(!corrected.detection.principal().foot(Side::Left).planted[600..].contains(&true));
    }

    #[test]
    fn corrections_apply_to_another_clip() {
        let detected = detection(|_| 0.2, |frame| frame % STEP < 70);
        let corrections =
            Corrections::learn(&feet(), &detected, &[edit(260, 270, false), edit(200, 260, true)]);
        let other = detection(|_| 0.21, |frame| frame % STEP < 71);
        let found = corrections.apply(&feet(), &other, &[]);
        assert!(plants(&found.detection).iter().all(|plant| plant.len().abs_diff(60) <= 1));
    }
}
