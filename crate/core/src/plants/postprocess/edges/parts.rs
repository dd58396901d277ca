//! Instants at which heel and toe land and lift during contact.
//!
//! The part that lands first does so at foot strike, and the part that lifts last at foot off. In between,
//! the foot pitches: the other part lands when the pitch comes to rest (foot flat), and the first part
//! lifts when the pitch begins to change again. The pitch is measured by the height of the ankle above
//! the toe, which does not depend on the ground.

use std::ops::Range;

use crate::foot::Part;
use crate::intervals::intervals;
use crate::kinematics::Track;
use crate::plants::postprocess::edges::MIN_UNCERTAINTY;
use crate::plants::postprocess::edges::series::{Kernels, Series, TrackSpan};
use crate::plants::{Edge, Feet, FootLabels};

/// Fraction of the peak rate of the pitch below which the foot is flat. Chosen, as the other constants
/// of this file, on generated motion (seeds 0 to 3).
const FLAT_FRACTION: f64 = 0.22;
/// Minimum peak of that rate, in leg lengths per second; a foot that pitches more slowly lands or lifts as a
/// whole.
const MIN_PEAK: f64 = 0.15;
/// Times searched before and after the boundary of the labels, in seconds: they begin early and end late.
const LANDING_SEARCH: [f64; 2] = [0.15, 0.2];
const LIFT_SEARCH: [f64; 2] = [0.3, 0.15];
/// Standard deviation of the error, as a fraction of the time in which the rate doubles and of the time
/// between frames, within which the error is uniform.
const ERROR_PER_DOUBLING: f64 = 0.5;
const ERROR_PER_FRAME: f64 = 0.29;

/// Appends the instants of heel and toe of one foot within spans of continuous motion to the edges of
/// their labels, which remain unchanged.
///
/// `contact` has its edges already. Parts that land or lift while the clip is cut off, and pitches that are
/// too small to measure, have no edge.
pub(crate) fn refine_parts(
    feet: &Feet,
    foot: usize,
    spans: &[Range<usize>],
    contact: &FootLabels,
    parts: [(Part, &mut FootLabels); 2],
) {
    let tracks = &feet.tracks[foot];
    let sole: Track = tracks.ankle.iter().zip(&tracks.toe).map(|(ankle, toe)| ankle - toe).collect();
    let Feet { frame_time, leg, .. } = *feet;
    let kernels = Kernels::new(frame_time);
    let planted = parts.each_ref().map(|(_, labels)| labels.planted.as_slice());
    let mut stances = Vec::new();
    for span in spans {
        let sole = TrackSpan { track: &sole, span, frame_time, leg, kernels: &kernels };
        for plant in intervals(&contact.planted[span.clone()]) {
            let plant = plant.start + span.start..plant.end + span.start;
            stances.push(Stance { feet, sole, contact, planted, plant });
        }
    }
    let edges = [0, 1].map(|part| {
        let (part, other) = ((parts[part].0, planted[part]), planted[1 - part]);
        stances.iter().flat_map(|stance| stance.edges(part, other)).collect::<Vec<Edge>>()
    });
    for ((_, labels), edges) in parts.into_iter().zip(edges) {
        labels.edges.extend(edges);
    }
}

/// One plant of a foot.
struct Stance<'a> {
    feet: &'a Feet,
    /// Position of the ankle relative to the toe.
    sole: TrackSpan<'a>,
    contact: &'a FootLabels,
    /// Labels of both parts.
    planted: [&'a [bool]; 2],
    /// Frames of contact.
    plant: Range<usize>,
}

/// Beginning or end of a change of pitch.
struct PitchChange {
    /// True if the ankle rises relative to the toe.
    is_rise: bool,
    /// In seconds.
    time: f64,
    uncertainty: f64,
}

impl Stance<'_> {
    /// Returns the edges of one part in order of time, given the labels of that part and of the other one.
    fn edges(&self, (part, own): (Part, &[bool]), other: &[bool]) -> Vec<Edge> {
        let mut edges = Vec::new();
        for run in intervals(&own[self.plant.clone()]) {
            let run = run.start + self.plant.start..run.end + self.plant.start;
            let Range { start, end } = *self.sole.span;
            // A part that is planted at an end of the motion does not land or lift there.
            if run.start > start {
                edges.extend(self.landing(part, run.start, other));
            }
            if run.end < end {
                edges.extend(self.lift(part, run.end, other));
            }
        }
        edges
    }

    /// Returns the edge at which a part lands that is planted from `start` on.
    fn landing(&self, part: Part, start: usize, other: &[bool]) -> Option<Edge> {
        let is_down = |frame: usize| self.planted.iter().any(|planted| planted[frame]);
        let lands_at_strike = !(self.plant.start..start).any(is_down);
        let strike = || self.contact.edge(self.plant.start).map(|edge| Edge { frame: start, ..*edge });
        if !other[start] {
            return strike().filter(|_| lands_at_strike);
        }
        let boundary = self.boundary_time(start);
        let [before, after] = LANDING_SEARCH;
        let from =
            (boundary - before).max(self.contact.boundary_time(self.plant.start, self.feet.frame_time));
        let flat = self.end_of_pitch(from..(boundary + after).min(self.middle_of_flat(start)));
        // The toe lands last if the ankle rises relative to it.
        let is_last = |pitch: &PitchChange| pitch.is_rise == (part == Part::Toe);
        match flat {
            Some(pitch) if !lands_at_strike || is_last(&pitch) => Some(pitch.edge(start)),
            _ => strike().filter(|_| lands_at_strike),
        }
    }

    /// Returns the edge at which a part lifts that is planted until `end`.
    fn lift(&self, part: Part, end: usize, other: &[bool]) -> Option<Edge> {
        let is_down = |frame: usize| self.planted.iter().any(|planted| planted[frame]);
        let lifts_at_off = !(end..self.plant.end).any(is_down);
        let off = || self.contact.edge(self.plant.end).map(|edge| Edge { frame: end, ..*edge });
        if !other[end - 1] {
            return off().filter(|_| lifts_at_off);
        }
        let boundary = self.boundary_time(end);
        let [before, after] = LIFT_SEARCH;
        let to = (boundary + after).min(self.contact.boundary_time(self.plant.end, self.feet.frame_time));
        let pitch = self.start_of_pitch((boundary - before).max(self.middle_of_flat(end - 1))..to);
        // The heel lifts first if the ankle rises relative to the toe.
        let is_first = |pitch: &PitchChange| pitch.is_rise == (part == Part::Heel);
        match pitch {
            Some(pitch) if !lifts_at_off || is_first(&pitch) => Some(pitch.edge(end)),
            _ => off().filter(|_| lifts_at_off),
        }
    }

    /// Returns the time in the middle of the frames around `frame` in which both parts are planted.
    fn middle_of_flat(&self, frame: usize) -> f64 {
        let is_flat = |frame: &usize| self.planted.iter().all(|planted| planted[*frame]);
        let first = (self.plant.start..frame).rev().take_while(is_flat).last().unwrap_or(frame);
        let last = (frame + 1..self.plant.end).take_while(is_flat).last().unwrap_or(frame);
        (first + last) as f64 / 2.0 * self.feet.frame_time
    }

    /// Returns the time of the boundary before a frame, in seconds.
    fn boundary_time(&self, frame: usize) -> f64 {
        (frame as f64 - 0.5) * self.feet.frame_time
    }

    /// Returns the instant at which the pitch comes to rest.
    fn end_of_pitch(&self, period: Range<f64>) -> Option<PitchChange> {
        let (rate, is_rise, peak) = self.pitch_rate(period)?;
        let after = |fraction: f64| {
            let level = fraction * rate.values[peak];
            let index = (peak..rate.values.len()).find(|&index| rate.values[index] < level)?;
            Some(rate.time(index as f64))
        };
        Some(self.pitch_change(is_rise, after(FLAT_FRACTION)?, after(2.0 * FLAT_FRACTION)?))
    }

    /// Returns the instant from which the foot pitches.
    fn start_of_pitch(&self, period: Range<f64>) -> Option<PitchChange> {
        let (rate, is_rise, peak) = self.pitch_rate(period)?;
        let before = |fraction: f64| {
            let level = fraction * rate.values[peak];
            let index = (0..peak).rev().find(|&index| rate.values[index] < level)?;
            Some(rate.time(index as f64))
        };
        Some(self.pitch_change(is_rise, before(FLAT_FRACTION)?, before(2.0 * FLAT_FRACTION)?))
    }

    /// Returns a change at `time`, which the rate doubles by `doubled`.
    fn pitch_change(&self, is_rise: bool, time: f64, doubled: f64) -> PitchChange {
        let uncertainty =
            (ERROR_PER_DOUBLING * (doubled - time)).hypot(ERROR_PER_FRAME * self.feet.frame_time);
        PitchChange { is_rise, time, uncertainty: uncertainty.max(MIN_UNCERTAINTY) }
    }

    /// Returns the rate of the pitch, positive in its main direction, whether that is a rise of the ankle
    /// relative to the toe, and the index of the peak; `None` if the foot hardly pitches.
    fn pitch_rate(&self, period: Range<f64>) -> Option<(Series, bool, usize)> {
        let [rate] = self.sole.derivatives(&period, [1], |sole| self.feet.up.height(sole));
        let is_rise = rate.values.iter().sum::<f64>() > 0.0;
        let rate = if is_rise { rate } else { rate.negated() };
        let values = &rate.values;
        let peak = (0..values.len()).max_by(|&a, &b| values[a].total_cmp(&values[b]))?;
        (values[peak] > MIN_PEAK * self.feet.leg).then_some((rate, is_rise, peak))
    }
}

impl PitchChange {
    fn edge(&self, frame: usize) -> Edge {
        Edge { frame, time: self.time, uncertainty: self.uncertainty }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;

    use super::*;
    use crate::plants::FootTracks;
    use crate::skeleton::Up;

    const RATE: f64 = 120.0;
    const STRIKE: Edge = Edge { frame: 60, time: 0.496, uncertainty: 0.01 };
    const OFF: Edge = Edge { frame: 150, time: 1.244, uncertainty: 0.02 };
    /// Height of a part that falls from before the strike on and comes to rest at 0.6 s.
    fn falling(time: f64) -> f64 {
        5.0 * (0.6 - time).clamp(0.0, 0.2).powi(2)
    }

    /// Time at which its speed is 0.22 of that at the strike, in seconds.
    const FLAT: f64 = 0.6 - 0.22 * (0.6 - STRIKE.time);

    /// Height of a part that begins to rise at 1 s and rises fastest at 1.1 s.
    fn rising(time: f64) -> f64 {
        let ramp = |time: f64| 2.0 * time.max(0.0).powi(2);
        ramp(time - 1.0) - 2.0 * ramp(time - 1.1) + ramp(time - 1.2)
    }

    /// Time at which its speed is 0.22 of its peak, in seconds.
    const LIFT: f64 = 1.0 + 0.22 * 0.1;

    fn labels(planted: Range<usize>, edges: &[Edge]) -> FootLabels {
        let mut labels = FootLabels {
            planted: vec![false; 240],
            confidence: vec![1.0; 240],
            height: vec![0.0; 240],
            speed: vec![0.0; 240],
            edges: edges.to_vec(),
        };
        labels.planted[planted].fill(true);
        labels
    }

    /// Returns the edges of heel and toe of a stance, given the heights of ankle and toe and the planted
    /// frames of heel and toe.
    fn refined(
        heights: [&dyn Fn(f64) -> f64; 2],
        contact: &FootLabels,
        planted: [Range<usize>; 2],
    ) -> [Vec<Edge>; 2] {
        let [ankle, toe] = heights.map(|height| -> Track {
            (0..240).map(|frame| Vector3::y() * height(f64::from(frame) / RATE)).collect()
        });
        let foot = FootTracks { ankle, toe, tip: None };
        let feet = Feet {
            tracks: [foot.clone(), foot],
            hips: Track::new(),
            up: Up::Y,
            leg: 1.0,
            metres_per_unit: 1.0,
            frame_time: 1.0 / RATE,
        };
        let [mut heel, mut toe] = planted.map(|planted| labels(planted, &[]));
        let before = [heel.planted.clone(), toe.planted.clone()];
        refine_parts(&feet, 0, &[0..240], contact, [(Part::Heel, &mut heel), (Part::Toe, &mut toe)]);
        assert_eq!([heel.planted, toe.planted], before, "labels do not change");
        [heel.edges, toe.edges]
    }

    fn assert_near(edge: &Edge, frame: usize, time: f64) {
        assert!(edge.frame == frame && (edge.time - time).abs() < 0.006, "{edge:?}, not {time}");
        assert!((0.004..0.02).contains(&edge.uncertainty), "{edge:?}");
    }

    #[test]
    fn the_toe_lands_when_the_pitch_ends_and_the_heel_lifts_when_it_begins() {
        let contact = labels(60..150, &[STRIKE, OFF]);
        let ankle = |time| 0.1 + rising(time);
        let [heel, toe] = refined([&ankle, &falling], &contact, [62..124, 66..148]);
        assert_eq!((heel[0], toe[1]), (Edge { frame: 62, ..STRIKE }, Edge { frame: 148, ..OFF }));
        assert_near(&toe[0], 66, FLAT);
        assert_near(&heel[1], 124, LIFT);
    }

    #[test]
    fn the_order_of_heel_and_toe_follows_from_the_pitch() {
        // Both labels begin and end together; the toe lands first and lifts first.
        let contact = labels(60..150, &[STRIKE, OFF]);
        let ankle = |time| 0.1 + falling(time);
        let [heel, toe] = refined([&ankle, &rising], &contact, [62..130, 62..130]);
        assert_eq!((toe[0], heel[1]), (Edge { frame: 62, ..STRIKE }, Edge { frame: 130, ..OFF }));
        assert_near(&heel[0], 62, FLAT);
        assert_near(&toe[1], 130, LIFT);
    }

    #[test]
    fn a_foot_that_does_not_pitch_lands_and_lifts_as_a_whole() {
        let contact = labels(60..150, &[STRIKE, OFF]);
        let height = |_| 0.1;
        let edges = [Edge { frame: 60, ..STRIKE }, Edge { frame: 150, ..OFF }];
        assert_eq!(refined([&height, &height], &contact, [60..150, 60..150]), [edges, edges]);
        // A toe alone has the edges of contact, the other part none.
        assert_eq!(refined([&height, &height], &contact, [0..0, 60..150]), [vec![], edges.to_vec()]);
        // Contact that begins and ends with the clip has no edges.
        let contact = labels(0..240, &[]);
        assert_eq!(refined([&height, &height], &contact, [0..240, 0..240]), [vec![], vec![]]);
    }

    #[test]
    fn a_foot_that_pitches_at_the_ends_of_the_clip_does_not_land_or_lift_there() {
        let contact = labels(0..240, &[]);
        let ankle = |time| 0.1 + rising(time - 0.85) + falling(time + 0.5);
        assert_eq!(refined([&ankle, &|_| 0.1], &contact, [0..240, 0..240]), [vec![], vec![]]);
    }
}
