//! What a person corrected by hand, laid over what was detected.

use serde::Deserialize;
use serde::Serialize;

use crate::foot::{Part, Side};
use crate::intervals::intervals;
use crate::plants::{Detection, FootLabels, PartLabels};

/// A plant is not shorter, in seconds: what an edit leaves of a detected one that is, is no plant.
const SHORTEST: f64 = 0.1;

/// A stretch of frames of which a person says whether a part of a foot is planted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Edit {
    /// The foot.
    pub side: Side,
    /// What of it.
    pub part: Part,
    /// The first frame.
    pub start: usize,
    /// The first frame after; a stretch past the clip's end is cut there.
    pub end: usize,
    /// Planted, or not.
    pub planted: bool,
}

/// A detection under `edits` of a person, who is believed entirely.
///
/// Later edits are laid over earlier ones. A foot without contact has neither heel nor toe
/// down, and one whose heel or toe is down has contact: an edit of one part takes the others
/// along as far as that demands. What is left of a detected plant beside a stretch that was
/// set free is dropped where it lasts less than 0.1 s, so that edits hold when the clip is
/// detected anew with other parameters. Edits of parts that were not detected have no effect.
/// `frame_time` is in seconds. The evidence stays with what was found: it speaks of nothing else.
pub fn edited(found: &Detection, edits: &[Edit], frame_time: f64) -> Detection {
    let parts = found.parts.iter().map(|labels| {
        let mut feet = labels.feet.clone();
        for (side, foot) in Side::BOTH.into_iter().zip(&mut feet) {
            let by_hand = lay(foot, edits, side, labels.part);
            drop_fragments(foot, &by_hand, SHORTEST / frame_time);
        }
        PartLabels { part: labels.part, feet, evidence: None }
    });
    Detection {
        params: found.params,
        parts: parts.collect(),
        floor: found.floor,
        notices: found.notices.clone(),
        edits: edits.to_vec(),
    }
}

/// What an edit of one part says of another; `None` where it leaves that open.
fn says(edit: &Edit, part: Part) -> Option<bool> {
    let follows = match (edit.part, part) {
        (Part::Contact, Part::Heel | Part::Toe) => !edit.planted,
        (Part::Heel | Part::Toe, Part::Contact) => edit.planted,
        (edited, part) => edited == part,
    };
    follows.then_some(edit.planted)
}

/// Lays edits over the labels of one part of one foot; gives back which frames are by hand.
fn lay(foot: &mut FootLabels, edits: &[Edit], side: Side, part: Part) -> Vec<bool> {
    let mut by_hand = vec![false; foot.planted.len()];
    for edit in edits.iter().filter(|edit| edit.side == side) {
        let Some(planted) = says(edit, part) else { continue };
        let end = edit.end.min(by_hand.len());
        let stretch = edit.start.min(end)..end;
        foot.planted[stretch.clone()].fill(planted);
        foot.confidence[stretch.clone()].fill(1.0);
        by_hand[stretch].fill(true);
    }
    by_hand
}

/// Sets free the detected runs shorter than `shortest` frames that an edit has left beside a free stretch.
fn drop_fragments(foot: &mut FootLabels, by_hand: &[bool], shortest: f64) {
    for run in intervals(&foot.planted) {
        let is_free_by_hand =
            |frame: Option<usize>| frame.and_then(|frame| by_hand.get(frame)) == Some(&true);
        let is_cut = is_free_by_hand(run.start.checked_sub(1)) || is_free_by_hand(Some(run.end));
        let is_detected = !by_hand[run.clone()].contains(&true);
        if is_cut && is_detected && (run.len() as f64) < shortest {
            foot.planted[run].fill(false);
        }
    }
}

impl Detection {
    /// Whether a run of planted frames of one part of one foot is as a person wants it.
    pub fn is_edited(&self, side: Side, part: Part, run: &std::ops::Range<usize>) -> bool {
        self.edits.iter().any(|edit| {
            edit.side == side
                && says(edit, part) == Some(true)
                && edit.start < run.end
                && run.start < edit.end
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants::ValidParams;

    const FRAME_TIME: f64 = 0.05;

    fn labels(text: &str) -> FootLabels {
        let planted: Vec<bool> = text.chars().map(|c| c == '#').collect();
        let zeros = vec![0.0; planted.len()];
        FootLabels { confidence: vec![0.75; planted.len()], height: zeros.clone(), speed: zeros, planted }
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
            floor: 0.0,
            notices: Vec::new(),
            edits: Vec::new(),
        }
    }

    fn edit(part: Part, start: usize, end: usize, planted: bool) -> Edit {
        Edit { side: Side::Left, part, start, end, planted }
    }

    fn shown(detection: &Detection, part: Part) -> String {
        let planted = &detection.part(part).unwrap().foot(Side::Left).planted;
        planted.iter().map(|&planted| if planted { '#' } else { '.' }).collect()
    }

    #[test]
    fn a_person_is_believed() {
        let found = detection("..####....", "..##......");
        let after = edited(&found, &[edit(Part::Contact, 5, 8, true)], FRAME_TIME);
        assert_eq!(shown(&after, Part::Contact), "..######..");
        assert_eq!(shown(&after, Part::Heel), "..##......");
        let foot = after.part(Part::Contact).unwrap().foot(Side::Left);
        assert_eq!(foot.confidence, [0.75, 0.75, 0.75, 0.75, 0.75, 1.0, 1.0, 1.0, 0.75, 0.75]);
        assert!(after.is_edited(Side::Left, Part::Contact, &(2..8)));
        assert!(!after.is_edited(Side::Left, Part::Heel, &(2..4)));
        assert!(!after.is_edited(Side::Right, Part::Contact, &(2..8)));
    }

    #[test]
    fn later_edits_lie_over_earlier_ones() {
        let found = detection("..........", "..........");
        let edits = [edit(Part::Contact, 1, 9, true), edit(Part::Contact, 4, 5, false)];
        assert_eq!(shown(&edited(&found, &edits, FRAME_TIME), Part::Contact), ".###.####.");
    }

    #[test]
    fn the_parts_of_a_foot_agree() {
        let found = detection("..######..", "..####....");
        let lifted = edited(&found, &[edit(Part::Contact, 2, 5, false)], FRAME_TIME);
        assert_eq!(shown(&lifted, Part::Contact), ".....###..");
        assert_eq!(shown(&lifted, Part::Heel), "..........", "what is left of the heel is too short");
        let down = edited(&found, &[edit(Part::Heel, 0, 4, true)], FRAME_TIME);
        assert_eq!(shown(&down, Part::Contact), "########..");
        let raised = edited(&found, &[edit(Part::Heel, 2, 6, false)], FRAME_TIME);
        assert_eq!(shown(&raised, Part::Contact), "..######..", "the toe may be down");
    }

    #[test]
    fn edits_hold_when_the_clip_is_detected_anew() {
        let edits = [
            edit(Part::Contact, 3, 6, true),
            edit(Part::Contact, 2, 3, false),
            edit(Part::Contact, 6, 7, false),
        ];
        assert_eq!(
            shown(&edited(&detection(".#######..", ".........."), &edits, FRAME_TIME), Part::Contact),
            "...###...."
        );
        // A plant that is long enough is not the rest of another.
        assert_eq!(
            shown(&edited(&detection("##.#######", ".........."), &edits, FRAME_TIME), Part::Contact),
            "##.###.###"
        );
    }

    #[test]
    fn edits_of_what_is_not_there_do_nothing() {
        let found = detection("..##", "....");
        let edits =
            [edit(Part::Toe, 2, 3, false), edit(Part::Contact, 9, 20, true), edit(Part::Contact, 3, 2, true)];
        assert_eq!(shown(&edited(&found, &edits, FRAME_TIME), Part::Contact), "..##");
        assert_eq!(edited(&found, &[], FRAME_TIME), found);
    }
}
