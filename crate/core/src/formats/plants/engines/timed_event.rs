//! Events with times and names for engines.

use crate::foot::Side;
use crate::formats::plants::events::{EventKind, GaitEvent, part_events};
use crate::formats::plants::export::{DetectionRef, PlantExport};
use crate::formats::scripts::identifier;
use crate::numeric::sort;

/// An event of a foot at a time of the clip.
pub(super) struct TimedEvent {
    /// Seconds from the first frame.
    pub time: f64,
    /// Name: `FootStrike_L`, with several skeletons after the name of the root.
    pub name: String,
    pub kind: EventKind,
}

/// Returns the events of all skeletons in order of time.
pub(super) fn timed_events(export: &PlantExport) -> Vec<TimedEvent> {
    let frame_time = export.clip.frame_time();
    let of_skeleton = |labelled: &DetectionRef| {
        let event = |event: GaitEvent| TimedEvent {
            time: event_time(&event, frame_time),
            name: name(labelled.root, &event.kind.title().replace(' ', ""), event.side),
            kind: event.kind,
        };
        part_events(labelled.detection, frame_time).into_iter().map(event).collect::<Vec<_>>()
    };
    let events: Vec<TimedEvent> = export.labelled().iter().flat_map(of_skeleton).collect();
    sort::sort_by_number(events, |event| event.time)
}

/// Returns the time of an event: its instant, or else midway between the frames.
fn event_time(event: &GaitEvent, frame_time: f64) -> f64 {
    let boundary = (event.frame as f64 - 0.5) * frame_time;
    event.instant.map_or(boundary, |instant| instant.time_s).max(0.0)
}

/// Returns a name of letters, digits and underscores, such as `FootStrike_L`.
pub(super) fn name(root: Option<&str>, title: &str, side: Side) -> String {
    let suffix = match side {
        Side::Left => "L",
        Side::Right => "R",
    };
    let root = root.map(|root| format!("{}_", identifier(root))).unwrap_or_default();
    format!("{root}{title}_{suffix}")
}

/// Returns the time from the first frame to the last, in seconds.
pub(super) fn duration(export: &PlantExport) -> f64 {
    export.clip.frame_count().saturating_sub(1) as f64 * export.clip.frame_time()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_identifiers() {
        assert_eq!(name(None, "FootStrike", Side::Left), "FootStrike_L");
        assert_eq!(name(Some("B:Hips"), "HeelOff", Side::Right), "B_3aHips_HeelOff_R");
    }
}
