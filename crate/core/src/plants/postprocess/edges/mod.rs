//! Instants at which contact begins and ends.
//!
//! The clustering determines which frames are in contact. Its boundaries depend on how the motion was
//! filtered: in unfiltered motion they are about 25 ms early at foot strike and 12 ms late at foot off.
//! The mechanics of the foot determine the instant: the impact at foot strike, the release of the
//! tip at foot off. Every edge is the median of several cues, so that a single cue that is misled by
//! noise does not matter; the spread of the cues yields the uncertainty.

mod cues;
mod off;
mod parts;
mod series;
mod strike;

pub(crate) use parts::refine_parts;

use std::ops::Range;

use crate::intervals::intervals;
use crate::kinematics::Track;
use crate::plants::postprocess::edges::cues::Cues;
use crate::plants::postprocess::edges::off::OffPeriods;
use crate::plants::postprocess::edges::series::{Kernels, TrackSpan};
use crate::plants::{Edge, Feet, FootLabels, FootTracks};

/// Times searched for a foot strike, before and after the boundary of the clustering, in seconds; half a
/// frame is added, by which the boundary is uncertain.
const STRIKE_SEARCH: [f64; 2] = [0.06, 0.09];
/// Maximum time by which an impact precedes the boundary of the clustering, in seconds. A foot that moves
/// longer after it was not stopped by the ground: it comes softly to rest.
const MAX_STRIKE_LEAD: f64 = 0.02;
/// Maximum time before and after the middle of a plant in which the foot is taken to rest, in seconds.
const MAX_REST: f64 = 0.15;
/// Time searched for a foot off, before and after the boundary of the clustering, likewise.
const OFF_SEARCH: f64 = 0.075;
/// Maximum time after foot off at which the peak speed of the swing is searched, in seconds.
const MAX_SWING: f64 = 0.6;
/// Fractions of the peak speed of the swing that toe and tip exceed at foot off.
const TOE_FRACTION: f64 = 0.2;
const TIP_FRACTION: f64 = 0.1;
/// Speeds of toe and tip that planted ones do not exceed, in leg lengths per second. The speed of the toe is
/// about 1.2 at the foot offs of walks, 1.1 at those of runs and 1.3 at those of jumps. Chosen on generated
/// motion (seeds 0 to 2), such that foot offs over force plates do not become less exact.
const MAX_TOE_SPEED: f64 = 1.5;
const MAX_TIP_SPEED: f64 = 1.1;
/// Uncertainty of boundaries of the clustering, which is the largest of any edge, and the least one, in seconds.
const ESTIMATE_UNCERTAINTY: f64 = 0.03;
const MIN_UNCERTAINTY: f64 = 0.001;
/// Uncertainty of cues above which the boundary of the clustering remains, in seconds. Up to this one, cues are
/// more exact than the boundary (generated motion, seeds 0 to 2).
const MAX_CUE_UNCERTAINTY: f64 = 0.05;
/// Rounding error of a time in frames. Without it, an off and the next strike at the middle of a swing may have one
/// frame.
const ROUNDING: f64 = 1e-9;
/// Frames nearer to an edge than this number of its standard deviations, or than this time in seconds,
/// have the confidence that follows from the edge.
const CONFIDENCE_REACH: f64 = 4.0;
const MIN_CONFIDENCE_REACH: f64 = 0.06;

/// Moves the boundaries of the plants of one foot within spans of continuous motion to the instants of
/// impact and release, and appends them to the edges of the labels.
///
/// Boundaries at the ends of a span are no edges. Where there are no cues, the boundary of the
/// clustering remains.
pub(crate) fn refine(feet: &Feet, foot: usize, spans: &[Range<usize>], labels: &mut FootLabels) {
    let kernels = Kernels::new(feet.frame_time);
    for span in spans {
        Refiner { feet, tracks: &feet.tracks[foot], span, kernels: &kernels }.refine(labels);
    }
}

/// Sets the confidence of the frames near edges: the probability that each edge is on its side of the
/// frame.
fn set_confidence(frame_time: f64, span: &Range<usize>, edges: &[Edge], confidence: &mut [f32]) {
    let near = |edge: &Edge| {
        let reach = (CONFIDENCE_REACH * edge.uncertainty).max(MIN_CONFIDENCE_REACH) / frame_time;
        let first = (edge.frame as f64 - reach).max(span.start as f64) as usize;
        first..((edge.frame as f64 + reach) as usize).min(span.end)
    };
    for edge in edges {
        confidence[near(edge)].fill(1.0);
    }
    for edge in edges {
        for frame in near(edge) {
            let deviations = (frame as f64 * frame_time - edge.time).abs() / edge.uncertainty;
            confidence[frame] = confidence[frame].min(normal_cdf(deviations) as f32);
        }
    }
}

/// Returns the cumulative distribution of the standard normal distribution to 0.0002 (Bowling et al. 2009).
fn normal_cdf(x: f64) -> f64 {
    1.0 / (1.0 + (-0.07056 * x.powi(3) - 1.5976 * x).exp())
}

/// Edges of one foot within a span of continuous motion.
struct Refiner<'a> {
    feet: &'a Feet,
    tracks: &'a FootTracks,
    span: &'a Range<usize>,
    kernels: &'a Kernels,
}

impl Refiner<'_> {
    /// Moves the boundaries of the plants within the span, and appends the edges.
    fn refine(&self, labels: &mut FootLabels) {
        let span = self.span;
        let mut plants: Vec<Range<usize>> = intervals(&labels.planted[span.clone()]);
        for plant in &mut plants {
            *plant = plant.start + span.start..plant.end + span.start;
        }
        let first_edge = labels.edges.len();
        let mut planted = vec![false; span.len()];
        for (index, plant) in plants.iter().enumerate() {
            let previous_end = index.checked_sub(1).map_or(span.start, |previous| plants[previous].end);
            let next_start = plants.get(index + 1).map_or(span.end, |next| next.start);
            let mut refined = plant.clone();
            if plant.start > span.start {
                let edge = self.strike(previous_end, plant);
                refined.start = edge.frame;
                labels.edges.push(edge);
            }
            if plant.end < span.end {
                let edge = self.off(plant, next_start);
                refined.end = edge.frame;
                labels.edges.push(edge);
            }
            planted[refined.start - span.start..refined.end - span.start].fill(true);
        }
        labels.planted[span.clone()].copy_from_slice(&planted);
        set_confidence(self.feet.frame_time, span, &labels.edges[first_edge..], &mut labels.confidence);
    }

    /// Returns the foot strike of a plant; `previous_end` is the first frame of the swing before it.
    fn strike(&self, previous_end: usize, plant: &Range<usize>) -> Edge {
        let estimate = self.boundary_time(plant.start);
        let [before, after] = STRIKE_SEARCH.map(|reach| reach + self.feet.frame_time / 2.0);
        let bounds = self.middle(&(previous_end..plant.start))..self.middle(plant);
        let search = (estimate - before).max(bounds.start)..(estimate + after).min(bounds.end);
        let rest = self.quarter(plant).min(MAX_REST);
        let stance = bounds.end - rest..bounds.end + rest;
        let parts = [&self.tracks.ankle, &self.tracks.toe].map(|track| self.track_span(track));
        // Without the fall before it, an impact cannot be told.
        let is_cut_off = estimate - before < self.span.start as f64 * self.feet.frame_time;
        let cues = (!is_cut_off).then(|| strike::cues(&parts, self.feet.up, &search, &stance));
        let is_impact = |cues: &Cues| cues.median().is_some_and(|median| estimate - median < MAX_STRIKE_LEAD);
        self.edge(cues.filter(is_impact), estimate, &bounds)
    }

    /// Returns the foot off of a plant; `next_start` is the first frame after the following swing.
    fn off(&self, plant: &Range<usize>, next_start: usize) -> Edge {
        let estimate = self.boundary_time(plant.end);
        let bounds = self.middle(plant)..self.middle(&(plant.end..next_start));
        let quarter = self.quarter(plant);
        let reach = OFF_SEARCH + self.feet.frame_time / 2.0;
        let periods = OffPeriods {
            stance: bounds.start - quarter..bounds.start + quarter,
            search: (estimate - reach).max(bounds.start)..(estimate + reach).min(bounds.end),
            swing: estimate..self.boundary_time(next_start).min(estimate + MAX_SWING),
            estimate,
        };
        let part = |track, fraction, max_planted_speed| off::Part {
            track: self.track_span(track),
            fraction,
            max_planted_speed,
        };
        let mut parts = vec![part(&self.tracks.toe, TOE_FRACTION, MAX_TOE_SPEED)];
        parts.extend(self.tracks.tip.as_ref().map(|tip| part(tip, TIP_FRACTION, MAX_TIP_SPEED)));
        let cues = off::cues(&parts, self.feet.up, &periods);
        self.edge(Some(cues), estimate, &bounds)
    }

    /// Returns the edge at the median of the cues, or at the estimate if there are none.
    fn edge(&self, cues: Option<Cues>, estimate: f64, bounds: &Range<f64>) -> Edge {
        let frame_time = self.feet.frame_time;
        let median = cues.and_then(|cues| Some((cues.median()?, cues.uncertainty)));
        let (time, uncertainty) = median
            .filter(|(_, uncertainty)| *uncertainty < MAX_CUE_UNCERTAINTY)
            .unwrap_or((estimate, ESTIMATE_UNCERTAINTY));
        // At least one frame remains on either side.
        let first = bounds.start + frame_time / 2.0;
        let time = time.clamp(first, (bounds.end - frame_time / 2.0).max(first));
        let uncertainty = uncertainty.clamp(MIN_UNCERTAINTY, ESTIMATE_UNCERTAINTY);
        Edge { frame: (time / frame_time - ROUNDING).ceil() as usize, time, uncertainty }
    }

    fn track_span<'a>(&'a self, track: &'a Track) -> TrackSpan<'a> {
        let Feet { frame_time, leg, .. } = *self.feet;
        TrackSpan { track, span: self.span, frame_time, leg, kernels: self.kernels }
    }

    /// Returns the time of the boundary before a frame, in seconds.
    fn boundary_time(&self, frame: usize) -> f64 {
        (frame as f64 - 0.5) * self.feet.frame_time
    }

    /// Returns a quarter of the duration of a plant, in seconds.
    fn quarter(&self, plant: &Range<usize>) -> f64 {
        (plant.end - plant.start) as f64 * self.feet.frame_time / 4.0
    }

    /// Returns the time in the middle of a run of frames, in seconds.
    fn middle(&self, frames: &Range<usize>) -> f64 {
        (frames.start + frames.end - 1) as f64 / 2.0 * self.feet.frame_time
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;
    use proptest::prelude::*;

    use super::*;
    use crate::skeleton::Up;

    /// Time by which the toe follows the ankle in a walk, in seconds.
    const TOE_DELAY: f64 = 0.02;

    /// Foot whose ankle is at these positions at a time in seconds; toe and tip follow it.
    fn feet(rate: f64, duration: f64, position: impl Fn(f64) -> Vector3<f64>) -> Feet {
        let frames = (duration * rate) as usize;
        let track = |delay: f64| -> Track {
            (0..frames).map(|frame| position(frame as f64 / rate - delay)).collect()
        };
        let foot = FootTracks { ankle: track(0.0), toe: track(TOE_DELAY), tip: Some(track(TOE_DELAY)) };
        let hips = foot.ankle.clone();
        Feet {
            tracks: [foot.clone(), foot],
            hips,
            up: Up::Y,
            leg: 1.0,
            metres_per_unit: 1.0,
            frame_time: 1.0 / rate,
        }
    }

    /// Returns labels that are planted in some frames, with the edges found in a whole clip.
    fn refined(feet: &Feet, planted: &[Range<usize>]) -> FootLabels {
        let frames = feet.frame_count();
        let mut labels = FootLabels {
            planted: vec![false; frames],
            confidence: vec![1.0; frames],
            height: vec![0.0; frames],
            speed: vec![0.0; frames],
            edges: Vec::new(),
        };
        for range in planted {
            labels.planted[range.clone()].fill(true);
        }
        refine(feet, 0, &[0..frames], &mut labels);
        labels
    }

    const STRIKE: f64 = 0.512;
    const OFF: f64 = 1.038;

    /// Falls at an increasing speed until the ground stops it, and swings forward from [`OFF`] on.
    fn step(time: f64) -> Vector3<f64> {
        let before = (STRIKE - time).max(0.0);
        let after = (time - OFF).max(0.0);
        let fall = 0.6 * before - 0.3 * before * before;
        // The speed grows to 4 leg lengths per second in 0.13 s and decreases as fast.
        let ramp = |time: f64| 15.0 * time.max(0.0).powi(2);
        let swing = ramp(after) - 2.0 * ramp(after - 0.13) + ramp(after - 0.26);
        Vector3::new(0.0, fall, swing - 1.2 * before.min(0.3))
    }

    #[test]
    fn impact_and_release_are_found_at_any_rate() {
        for rate in [24.0, 30.0, 60.0, 119.9, 150.0, 300.0] {
            let feet = feet(rate, 1.4, step);
            // Boundaries like those of the clustering: early at foot strike, late at foot off.
            let [start, end] = [STRIKE - 0.025, OFF + 0.02].map(|time| (time * rate).ceil() as usize);
            let labels = refined(&feet, &[start..end]);
            let [strike, off] = labels.edges[..] else { panic!("{:?}", labels.edges) };
            // The tip passes its fraction of the peak 13 ms after its release.
            let tolerance = 0.006_f64.max(0.9 / rate);
            assert!((strike.time - STRIKE).abs() < tolerance, "{rate} Hz: {strike:?}");
            let release = OFF + TOE_DELAY + 0.013;
            assert!((off.time - release).abs() < 0.004_f64.max(0.5 / rate), "{rate} Hz: {off:?}");
            assert!(off.uncertainty < ESTIMATE_UNCERTAINTY && strike.uncertainty < ESTIMATE_UNCERTAINTY);
            assert_eq!(intervals(&labels.planted), [strike.frame..off.frame]);
        }
    }

    #[test]
    fn spikes_do_not_move_edges() {
        let clean = feet(120.0, 1.4, step);
        let [start, end] = [STRIKE - 0.025, OFF + 0.02].map(|time| (time * 120.0).round() as usize);
        let expected = refined(&clean, &[start..end]).edges;
        for spike in [start - 2, start + 5, end - 5, end + 3] {
            let mut feet = clean.clone();
            for track in [&mut feet.tracks[0].ankle, &mut feet.tracks[0].toe] {
                track[spike].y += 0.3;
            }
            for (edge, expected) in refined(&feet, &[start..end]).edges.iter().zip(&expected) {
                assert!((edge.time - expected.time).abs() < 0.003, "{spike}: {edge:?} {expected:?}");
            }
        }
    }

    #[test]
    fn edges_without_motion_remain() {
        let feet = feet(100.0, 1.0, |_| Vector3::zeros());
        let labels = refined(&feet, &[20..60]);
        assert_eq!(intervals(&labels.planted), [20..60]);
        assert_eq!(labels.edges.iter().map(|edge| edge.frame).collect::<Vec<_>>(), [20, 60]);
        // Ends of a clip are no edges.
        assert!(refined(&feet, &[0..100]).edges.is_empty());
    }

    proptest! {
        #[test]
        fn edges_are_the_boundaries_of_the_labels(
            lengths in prop::collection::vec(1_usize..30, 1..12),
            steps in prop::collection::vec(prop::array::uniform3(-0.05..0.05_f64), 400),
            rate in 20.0..300.0_f64,
        ) {
            let mut position = Vector3::zeros();
            let track: Track = steps.iter().map(|step| { position += Vector3::from(*step); position }).collect();
            let frames: usize = lengths.iter().sum::<usize>().min(track.len());
            let feet = feet(rate, frames as f64 / rate + 1e-9, |time| track[(time * rate).round().max(0.0) as usize]);
            let mut planted = Vec::new();
            let mut start = 0;
            for (index, length) in lengths.iter().enumerate() {
                let end = (start + length).min(feet.frame_count());
                if index % 2 == 1 && end > start {
                    planted.push(start..end);
                }
                start = end;
            }
            let labels = refined(&feet, &planted);
            let runs = intervals(&labels.planted);
            prop_assert_eq!(runs.len(), planted.len());
            let boundaries: Vec<usize> = runs
                .iter()
                .flat_map(|run| [run.start, run.end])
                .filter(|&frame| frame > 0 && frame < feet.frame_count())
                .collect();
            let frames_of_edges: Vec<usize> = labels.edges.iter().map(|edge| edge.frame).collect();
            prop_assert_eq!(frames_of_edges, boundaries);
            for edge in &labels.edges {
                let frame = edge.time * rate;
                prop_assert!(frame <= edge.frame as f64 + 1e-6 && frame > edge.frame as f64 - 1.0 - 1e-6);
                prop_assert!((MIN_UNCERTAINTY..=ESTIMATE_UNCERTAINTY).contains(&edge.uncertainty));
            }
        }
    }
}
