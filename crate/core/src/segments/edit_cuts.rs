//! Corrections of cuts by a person.

use std::collections::BTreeSet;

use crate::segments::Segment;

/// A correction of a cut.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CutEdit {
    /// First frame of the segment that begins at the cut.
    pub frame: usize,
    /// True if there is a cut.
    pub present: bool,
}

/// Returns segments with cuts added and removed. Later edits override earlier ones; frames that no segment
/// contains, and the first frame, have no effect.
///
/// A new segment has the kind, the label and the action of the segment with which it has the most frames in
/// common. Its cycles are unknown.
pub fn edit_cuts(segments: &[Segment], edits: &[CutEdit]) -> Vec<Segment> {
    let (Some(first), Some(last)) = (segments.first(), segments.last()) else { return Vec::new() };
    let (start, end) = (first.frames.start, last.frames.end);
    let mut cuts = BTreeSet::new();
    // Collecting would sort, which is compiled for each type of items.
    cuts.extend(segments.iter().skip(1).map(|segment| segment.frames.start));
    for edit in edits.iter().filter(|edit| edit.frame > start && edit.frame < end) {
        if edit.present {
            cuts.insert(edit.frame);
        } else {
            cuts.remove(&edit.frame);
        }
    }
    let starts = std::iter::once(start).chain(cuts.iter().copied());
    let ends = cuts.iter().copied().chain([end]);
    starts
        .zip(ends)
        .map(|(start, end)| {
            let common = |segment: &Segment| {
                segment.frames.end.min(end).saturating_sub(segment.frames.start.max(start))
            };
            // Of equals, the first.
            let origin = segments.iter().rev().max_by_key(|segment| common(segment)).expect("segments");
            if origin.frames == (start..end) {
                return origin.clone();
            }
            Segment { frames: start..end, cycles: None, ..origin.clone() }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::segments::Kind;

    fn segments() -> Vec<Segment> {
        let segment = |frames, action: &str| Segment {
            action: action.into(),
            ..Segment::new(frames, Kind::Action, "")
        };
        vec![segment(0..40, "A"), segment(40..100, "B"), segment(100..120, "A")]
    }

    fn edited(edits: &[(usize, bool)]) -> Vec<(usize, usize, String)> {
        let edits: Vec<CutEdit> = edits.iter().map(|&(frame, present)| CutEdit { frame, present }).collect();
        let segments = edit_cuts(&segments(), &edits);
        segments
            .into_iter()
            .map(|segment| (segment.frames.start, segment.frames.end, segment.action))
            .collect()
    }

    #[test]
    fn cuts_are_added_removed_and_moved() {
        let text = |segments: Vec<(usize, usize, String)>| {
            let names = segments.iter().map(|(start, end, action)| format!("{action} {start}-{end}"));
            names.collect::<Vec<_>>().join(", ")
        };
        assert_eq!(text(edited(&[])), "A 0-40, B 40-100, A 100-120");
        assert_eq!(text(edited(&[(70, true)])), "A 0-40, B 40-70, B 70-100, A 100-120");
        assert_eq!(text(edited(&[(40, false)])), "B 0-100, A 100-120");
        assert_eq!(text(edited(&[(40, false), (30, true)])), "A 0-30, B 30-100, A 100-120");
        assert_eq!(text(edited(&[(70, true), (70, false)])), "A 0-40, B 40-100, A 100-120");
    }

    #[test]
    fn cuts_outside_of_the_clip_have_no_effect() {
        assert_eq!(edited(&[(0, true), (0, false), (120, true), (500, true), (7, false)]), edited(&[]));
        assert!(edit_cuts(&[], &[CutEdit { frame: 3, present: true }]).is_empty());
    }
}
