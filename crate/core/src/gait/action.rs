//! Gait per action, so that a limp that becomes a run is not averaged.

use std::ops::Range;

use serde::{Deserialize, Serialize};

use crate::gait::GaitAnalysis;
use crate::segments::Segment;

/// Frame ranges in which one action is done.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ActionRanges {
    /// Name: that of the action, or the number of the segment, from 1, if actions are unknown.
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
/// Segments in which the same is done are one action. A segment whose action is unknown is an action of
/// its own, named by its label or its number.
pub fn action_ranges(segments: &[Segment]) -> Vec<ActionRanges> {
    let mut actions: Vec<ActionRanges> = Vec::new();
    for (index, segment) in segments.iter().enumerate() {
        let name = [&segment.action, &segment.label].into_iter().find(|name| !name.is_empty());
        let name = name.cloned().unwrap_or_else(|| (index + 1).to_string());
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
}
