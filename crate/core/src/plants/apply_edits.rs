//! Application of edits to a detection.

use crate::foot::{Part, Side};
use crate::intervals::intervals;
use crate::plants::{Detection, Edit, FootLabels, Instant, PartLabels};

/// Minimum duration of a fragment, in seconds: of what an edit leaves of a detected plant. Shorter
/// fragments are removed.
const MIN_FRAGMENT_DURATION: f64 = 0.1;

/// Returns a detection with `edits` applied.
///
/// Later edits override earlier ones. Contact includes heel and toe: removing contact removes heel
/// and toe, and adding heel or toe adds contact. A fragment of a detected plant next to a removed
/// range is dropped if it is shorter than 0.1 s, so that edits persist when parameters change.
/// Edits of parts without labels have no effect. `frame_time` is in seconds. The evidence is
/// dropped, as it explains the labels of the method only.
pub fn apply_edits(detection: &Detection, edits: &[Edit], frame_time: f64) -> Detection {
    let parts = detection.parts.iter().map(|labels| {
        let mut feet = labels.feet.clone();
        for (side, foot) in Side::BOTH.into_iter().zip(&mut feet) {
            let edited = apply_to_foot(foot, edits, side, labels.part);
            drop_fragments(foot, &edited, MIN_FRAGMENT_DURATION / frame_time);
        }
        PartLabels { part: labels.part, feet, evidence: None }
    });
    Detection {
        params: detection.params,
        parts: parts.collect(),
        ground_height: detection.ground_height,
        ground: detection.ground.clone(),
        noise: detection.noise,
        notices: detection.notices.clone(),
        edits: edits.to_vec(),
    }
}

/// Applies edits to the labels of one part of one foot; returns which frames were edited.
fn apply_to_foot(foot: &mut FootLabels, edits: &[Edit], side: Side, part: Part) -> Vec<bool> {
    let mut edited = vec![false; foot.planted.len()];
    for edit in edits.iter().filter(|edit| edit.side == side) {
        let Some(planted) = edit.implied(part) else { continue };
        let end = edit.end.min(edited.len());
        let range = edit.start.min(end)..end;
        foot.planted[range.clone()].fill(planted);
        foot.confidence[range.clone()].fill(1.0);
        edited[range].fill(true);
    }
    edited
}

/// Removes detected runs shorter than `shortest` frames next to a range in which an edit removed
/// contact.
fn drop_fragments(foot: &mut FootLabels, edited: &[bool], shortest: f64) {
    for run in intervals(&foot.planted) {
        let was_removed = |frame: Option<usize>| frame.and_then(|frame| edited.get(frame)) == Some(&true);
        let is_cut = was_removed(run.start.checked_sub(1)) || was_removed(Some(run.end));
        let is_detected = !edited[run.clone()].contains(&true);
        if is_cut && is_detected && (run.len() as f64) < shortest {
            foot.planted[run].fill(false);
        }
    }
}

impl Detection {
    /// Sets instants of boundaries, as [`Corrected`](crate::plants::Corrected) lists them. Instants of other
    /// frames and of parts without labels have no effect.
    pub fn set_instants(&mut self, instants: &[Instant]) {
        for Instant { side, part, edge } in instants {
            let Some(labels) = self.parts.iter_mut().find(|labels| labels.part == *part) else { continue };
            let foot = &mut labels.feet[*side as usize];
            if !foot.is_boundary(edge.frame) {
                continue;
            }
            match foot.edges.binary_search_by_key(&edge.frame, |edge| edge.frame) {
                Ok(index) => foot.edges[index] = *edge,
                Err(index) => foot.edges.insert(index, *edge),
            }
        }
    }

    /// True if a run of planted frames overlaps an edit that plants this part.
    pub fn is_edited(&self, side: Side, part: Part, run: &std::ops::Range<usize>) -> bool {
        self.edits.iter().any(|edit| {
            edit.side == side
                && edit.implied(part) == Some(true)
                && edit.start < run.end
                && run.start < edit.end
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants::{Ground, ValidParams};

    const FRAME_TIME: f64 = 0.05;

    fn labels(text: &str) -> FootLabels {
        let planted: Vec<bool> = text.chars().map(|c| c == '#').collect();
        let zeros = vec![0.0; planted.len()];
        FootLabels {
            confidence: vec![0.75; planted.len()],
            height: zeros.clone(),
            speed: zeros,
            planted,
            edges: Vec::new(),
        }
    }

    fn detection(contact: &str, heel: &str) -> Detection {
        let part = |part, text: &str| PartLabels {
            part,
            feet: [labels(text), labels(&".".repeat(text.len()))],
            evidence: None,
        };
        Detection {
            params: ValidParams::default(),
            parts: vec![part(Part::Contact, contact), part(Part::Heel, heel)],
            ground_height: 0.0,
            ground: Ground::level(),
            noise: None,
            notices: Vec::new(),
            edits: Vec::new(),
        }
    }

    fn edit(part: Part, start: usize, end: usize, planted: bool) -> Edit {
        Edit { side: Side::Left, part, start, end, planted }
    }

    fn labels_as_text(detection: &Detection, part: Part) -> String {
        let planted = &detection.part(part).unwrap().foot(Side::Left).planted;
        planted.iter().map(|&planted| if planted { '#' } else { '.' }).collect()
    }

    #[test]
    fn edits_override_labels() {
        let detected = detection("..####....", "..##......");
        let after = apply_edits(&detected, &[edit(Part::Contact, 5, 8, true)], FRAME_TIME);
        assert_eq!(labels_as_text(&after, Part::Contact), "..######..");
        assert_eq!(labels_as_text(&after, Part::Heel), "..##......");
        let foot = after.part(Part::Contact).unwrap().foot(Side::Left);
        assert_eq!(foot.confidence, [0.75, 0.75, 0.75, 0.75, 0.75, 1.0, 1.0, 1.0, 0.75, 0.75]);
        assert!(after.is_edited(Side::Left, Part::Contact, &(2..8)));
        assert!(!after.is_edited(Side::Left, Part::Heel, &(2..4)));
        assert!(!after.is_edited(Side::Right, Part::Contact, &(2..8)));
    }

    #[test]
    fn later_edits_override_earlier_ones() {
        let detected = detection("..........", "..........");
        let edits = [edit(Part::Contact, 1, 9, true), edit(Part::Contact, 4, 5, false)];
        assert_eq!(labels_as_text(&apply_edits(&detected, &edits, FRAME_TIME), Part::Contact), ".###.####.");
    }

    #[test]
    fn heel_and_toe_stay_within_contact() {
        let detected = detection("..######..", "..####....");
        let lifted = apply_edits(&detected, &[edit(Part::Contact, 2, 5, false)], FRAME_TIME);
        assert_eq!(labels_as_text(&lifted, Part::Contact), ".....###..");
        assert_eq!(labels_as_text(&lifted, Part::Heel), "..........", "the rest of the heel is too short");
        let down = apply_edits(&detected, &[edit(Part::Heel, 0, 4, true)], FRAME_TIME);
        assert_eq!(labels_as_text(&down, Part::Contact), "########..");
        let raised = apply_edits(&detected, &[edit(Part::Heel, 2, 6, false)], FRAME_TIME);
        assert_eq!(labels_as_text(&raised, Part::Contact), "..######..", "the toe may be planted");
    }

    #[test]
    fn edits_persist_when_parameters_change() {
        let edits = [
            edit(Part::Contact, 3, 6, true),
            edit(Part::Contact, 2, 3, false),
            edit(Part::Contact, 6, 7, false),
        ];
        assert_eq!(
            labels_as_text(
                &apply_edits(&detection(".#######..", ".........."), &edits, FRAME_TIME),
                Part::Contact
            ),
            "...###...."
        );
        // A plant of sufficient length is not a remainder of another.
        assert_eq!(
            labels_as_text(
                &apply_edits(&detection("##.#######", ".........."), &edits, FRAME_TIME),
                Part::Contact
            ),
            "##.###.###"
        );
    }

    #[test]
    fn edits_without_labels_have_no_effect() {
        let detected = detection("..##", "....");
        let edits =
            [edit(Part::Toe, 2, 3, false), edit(Part::Contact, 9, 20, true), edit(Part::Contact, 3, 2, true)];
        assert_eq!(labels_as_text(&apply_edits(&detected, &edits, FRAME_TIME), Part::Contact), "..##");
        assert_eq!(apply_edits(&detected, &[], FRAME_TIME), detected);
    }
}
