//! Gait events, as the formats write them.

use std::ops::Range;

use crate::foot::{Part, Side};
use crate::formats::csv::seconds;
use crate::formats::plants::document::Instant;
use crate::intervals::intervals;
use crate::numeric::sort;
use crate::plants::{Detection, Edge, FootLabels};

/// Beginning or end of the contact of a foot or a part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GaitEvent {
    /// First frame after the event.
    pub frame: usize,
    /// The foot.
    pub side: Side,
    /// Kind of the event.
    pub kind: EventKind,
    /// Instant, if it is known more exactly than the frame.
    pub instant: Option<Instant>,
}

/// Kind of a [`GaitEvent`], in the order of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EventKind {
    /// The foot touches the ground.
    Strike,
    /// The heel touches the ground.
    HeelStrike,
    /// The toe touches the ground.
    ToeStrike,
    /// Heel and toe are both on the ground for the first time.
    FootFlat,
    /// The heel leaves the ground.
    HeelOff,
    /// The toe leaves the ground.
    ToeOff,
    /// The foot leaves the ground.
    Off,
}

impl EventKind {
    /// Returns the name: `strike`, `heel_strike`, ….
    pub fn name(self) -> &'static str {
        match self {
            EventKind::Strike => "strike",
            EventKind::HeelStrike => "heel_strike",
            EventKind::ToeStrike => "toe_strike",
            EventKind::FootFlat => "foot_flat",
            EventKind::HeelOff => "heel_off",
            EventKind::ToeOff => "toe_off",
            EventKind::Off => "off",
        }
    }

    /// Returns the name in gait analysis: `Foot Strike`, `Heel Strike`, ….
    pub fn title(self) -> &'static str {
        match self {
            EventKind::Strike => "Foot Strike",
            EventKind::HeelStrike => "Heel Strike",
            EventKind::ToeStrike => "Toe Strike",
            EventKind::FootFlat => "Foot Flat",
            EventKind::HeelOff => "Heel Off",
            EventKind::ToeOff => "Toe Off",
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
pub fn events(detection: &Detection) -> Vec<GaitEvent> {
    let mut events = Vec::new();
    for side in Side::BOTH {
        let labels = detection.principal().foot(side);
        events.extend(edges(labels, side, [EventKind::Strike, EventKind::Off]));
    }
    // Events known to the frame only follow those before the frame.
    let microseconds = |instant: Instant| (instant.time_s * 1e6) as usize;
    sort::sort_by_frames(events, |event| (event.frame, event.instant.map_or(usize::MAX, microseconds)))
}

/// Returns the events of heels and toes of a skeleton in order of time, and those of contact between
/// them: foot strike, heel strike, toe strike, foot flat, heel off, toe off, foot off.
///
/// Parts without labels have no events; otherwise like [`events`].
pub fn part_events(detection: &Detection, frame_time: f64) -> Vec<GaitEvent> {
    let mut events = events(detection);
    for side in Side::BOTH {
        for (part, kinds) in [
            (Part::Heel, [EventKind::HeelStrike, EventKind::HeelOff]),
            (Part::Toe, [EventKind::ToeStrike, EventKind::ToeOff]),
        ] {
            let labels = detection.part(part).map(|labels| labels.foot(side));
            events.extend(labels.into_iter().flat_map(|labels| edges(labels, side, kinds)));
        }
        for plant in intervals(&detection.principal().foot(side).planted) {
            let flat = detection.foot_flat(side, &plant).filter(|(frame, _)| *frame > 0);
            let event = |(frame, edge): (usize, Option<&Edge>)| GaitEvent {
                frame,
                side,
                kind: EventKind::FootFlat,
                instant: edge.map(Instant::from),
            };
            events.extend(flat.map(event));
        }
    }
    for event in &mut events {
        // Labels of parts change some frames before or after the instant.
        let frame = |instant: Instant| (instant.time_s / frame_time - 1e-3).ceil().max(0.0) as usize;
        event.frame = event.instant.map_or(event.frame, frame);
    }
    let order = |event: &GaitEvent| ((event.time(frame_time) * 1e6).round() as usize, event.kind as usize);
    sort::sort_by_frames(events, order)
}

/// Returns the beginnings and ends of the plants of one foot.
fn edges(labels: &FootLabels, side: Side, [strike, off]: [EventKind; 2]) -> Vec<GaitEvent> {
    let event = |frame: usize, kind: EventKind| {
        let is_event = frame > 0 && frame < labels.planted.len();
        is_event.then(|| GaitEvent { frame, side, kind, instant: labels.edge(frame).map(Instant::from) })
    };
    let of_plant = |range: Range<usize>| [event(range.start, strike), event(range.end, off)];
    intervals(&labels.planted).into_iter().flat_map(of_plant).flatten().collect()
}
