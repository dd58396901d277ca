//! Gait events, as the formats write them.

use crate::foot::Side;
use crate::formats::csv::seconds;
use crate::formats::plants::document::Instant;
use crate::intervals::intervals;
use crate::numeric::sort;
use crate::plants::Detection;

/// Beginning or end of contact.
#[derive(Clone, Copy)]
pub(super) struct GaitEvent {
    /// First frame after the event.
    pub frame: usize,
    pub side: Side,
    pub kind: EventKind,
    /// Instant, if it is known more exactly than the frame.
    pub instant: Option<Instant>,
}

#[derive(Clone, Copy)]
pub(super) enum EventKind {
    Strike,
    Off,
}

impl EventKind {
    /// Returns the name: `strike` or `off`.
    pub fn name(self) -> &'static str {
        match self {
            EventKind::Strike => "strike",
            EventKind::Off => "off",
        }
    }

    /// Returns the name in gait analysis: `Foot Strike` or `Foot Off`.
    pub fn title(self) -> &'static str {
        match self {
            EventKind::Strike => "Foot Strike",
            EventKind::Off => "Foot Off",
        }
    }
}

impl GaitEvent {
    /// Returns the time of the instant, or else of the frame, in seconds.
    pub fn time(&self, frame_time: f64) -> f64 {
        self.instant.map_or(seconds(self.frame, frame_time), |instant| instant.time_s)
    }

    /// Returns the side as in C3D files: `Left` or `Right`.
    pub fn context(&self) -> &'static str {
        match self.side {
            Side::Left => "Left",
            Side::Right => "Right",
        }
    }
}

/// Returns the foot strikes and foot offs of a skeleton in order of time.
///
/// Contact that begins or ends with the clip is not an event.
pub(super) fn events(detection: &Detection) -> Vec<GaitEvent> {
    let mut events = Vec::new();
    for side in Side::BOTH {
        let labels = detection.principal().foot(side);
        let event = |frame: usize, kind: EventKind| {
            let is_event = frame > 0 && frame < labels.planted.len();
            is_event.then(|| GaitEvent { frame, side, kind, instant: labels.edge(frame).map(Instant::from) })
        };
        for range in intervals(&labels.planted) {
            events.extend(event(range.start, EventKind::Strike));
            events.extend(event(range.end, EventKind::Off));
        }
    }
    // Events known to the frame only follow those before the frame.
    let microseconds = |instant: Instant| (instant.time_s * 1e6) as usize;
    sort::sort_by_frames(events, |event| (event.frame, event.instant.map_or(usize::MAX, microseconds)))
}
