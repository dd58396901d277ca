//! Gait per action, so that a limp that becomes a run is not averaged.

use std::collections::BTreeSet;
use std::ops::Range;

use serde::{Deserialize, Serialize};

use crate::gait::GaitAnalysis;
use crate::segments::Segment;

/// Frame ranges in which one action is done.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ActionRanges {
    /// Name: that of the action, or else the label, or else the number of the segment, from 1.
    pub name: String,
    /// Frame ranges of the segments, in order.
    pub frames: Vec<Range<usize>>,
}

/// Gait of one action.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ActionGait {
    /// The action.
    #[serde(flatten)]
    pub action: ActionRanges,
    /// Its gait.
    #[serde(flatten)]
    pub analysis: GaitAnalysis,
}

/// Returns the actions of segments in order of first appearance.
///
/// Segments in which the same is done are one action. If the action is unknown, segments with the same label
/// are one action, and a segment without label is an action of its own: it is named by its number, as in `3`,
/// or as in `segment 3` if another segment has this name.
pub fn action_ranges(segments: &[Segment]) -> Vec<ActionRanges> {
    let mut actions: Vec<ActionRanges> = Vec::new();
    let given_name = |segment: &Segment| {
        let name = if segment.action.is_empty() { &segment.label } else { &segment.action };
        Some(name.clone()).filter(|name| !name.is_empty())
    };
    let given_names: BTreeSet<String> = segments.iter().filter_map(given_name).collect();
    let unused_name = |index: usize| {
        let mut name = (index + 1).to_string();
        while given_names.contains(&name) {
            name.insert_str(0, "segment ");
        }
        name
    };
    for (index, segment) in segments.iter().enumerate() {
        let name = given_name(segment).unwrap_or_else(|| unused_name(index));
        match actions.iter_mut().find(|action| action.name == name) {
            Some(action) => action.frames.push(segment.frames.clone()),
            None => actions.push(ActionRanges { name, frames: vec![segment.frames.clone()] }),
        }
    }
    actions
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::segments::Kind;

    #[test]
    fn segments_of_one_action_are_joined() {
        let segment = |frames, label: &str, action: &str| Segment {
            action: action.into(),
            ..Segment::new(frames, Kind::Action, label)
        };
        let segments = [
            segment(0..10, "walk", "A"),
            segment(10..20, "", "B"),
            segment(20..30, "limp", "A"),
            segment(30..40, "kick", ""),
            segment(40..50, "", ""),
        ];
        let actions = action_ranges(&segments);
        let names: Vec<&str> = actions.iter().map(|action| action.name.as_str()).collect();
        assert_eq!(names, ["A", "B", "kick", "5"]);
        assert_eq!(actions[0].frames, [0..10, 20..30]);
    }

    #[test]
    fn a_segment_without_name_is_not_joined_with_a_numbered_label() {
        let segment = |frames, label: &str| Segment::new(frames, Kind::Action, label);
        let segments = [
            segment(0..10, ""),
            segment(10..20, "1"),
            segment(20..30, ""),
            segment(30..40, "5"),
            segment(40..50, ""),
            segment(50..60, "segment 5"),
        ];
        let actions = action_ranges(&segments);
        let names: Vec<&str> = actions.iter().map(|action| action.name.as_str()).collect();
        assert_eq!(names, ["segment 1", "1", "3", "5", "segment segment 5", "segment 5"]);
        assert!(actions.iter().all(|action| action.frames.len() == 1), "{actions:?}");
    }
}
