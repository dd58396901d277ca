//! Height and speed signals of the feet.

mod belt;
pub(crate) mod fixed_hips;
pub(crate) mod ground;
pub(crate) mod motion_segments;
pub(crate) mod moving_ground;
pub(crate) mod resampling;
pub(crate) mod samples;
pub(crate) mod tilt;
pub(crate) mod velocity;

use std::ops::Range;

use nalgebra::Vector3;

use crate::kinematics::Track;
use crate::plants::signal::resampling::Resampler;
use crate::plants::{Feet, FootTracks};
use crate::skeleton::Up;

/// Height and speed per frame of one part of one foot.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Signal {
    /// Height, in file units.
    pub height: Vec<f64>,
    /// Speed, in file units per second.
    pub speed: Vec<f64>,
}

/// Signals of the same part of both feet, left first.
pub(crate) type Signals = [Signal; 2];

/// Half-width of the window of the speed filter, in seconds.
const SPEED_WINDOW: f64 = 0.05;
/// Number of resampled frames that are filtered at a time: ten seconds at 120 Hz.
const PIECE: usize = 1200;

impl Signal {
    /// Computes height and speed of a track; spans are filtered separately.
    pub fn new(
        track: &Track,
        up: Up,
        spans: &[Range<usize>],
        velocity: impl Fn(&[Vector3<f64>]) -> Vec<Vector3<f64>>,
    ) -> Signal {
        let mut speed = vec![0.0; track.len()];
        for span in spans {
            let velocities = velocity(&track[span.clone()]);
            for (speed, velocity) in speed[span.clone()].iter_mut().zip(velocities) {
                *speed = velocity.norm();
            }
        }
        Signal { height: track.iter().map(|position| up.height(position)).collect(), speed }
    }

    /// Returns height and speed of `frame`.
    pub fn at(&self, frame: usize) -> [f64; 2] {
        [self.height[frame], self.speed[frame]]
    }
}

/// Returns unfiltered signals: central differences over the whole clip (paper, section 2.1).
pub(crate) fn raw(feet: &Feet, part: impl Fn(&FootTracks) -> &Track) -> Signals {
    let spans = [0..feet.frame_count()];
    let velocity = |track: &[Vector3<f64>]| velocity::central_difference(track, feet.frame_time);
    let mut signals = feet.tracks.each_ref().map(|foot| Signal::new(part(foot), feet.up, &spans, velocity));
    subtract_ground(&mut signals, &spans);
    signals
}

/// Returns filtered signals: without spikes, resampled, with smoothed speed and height along the up
/// axis. Between spans, the speed is 0.
pub(crate) fn filtered(feet: &Feet, resampler: &Resampler, part: impl Fn(&FootTracks) -> &Track) -> Signals {
    let Resampler { fine_spans: spans, frame_time, .. } = resampler;
    // Frame times such as 0.033333 and 0.033334 s must give the same window.
    let half = |seconds: f64| (seconds / frame_time + 0.55).floor() as usize;
    let half = half(SPEED_WINDOW);
    let count = resampler.fine_frame_count(feet.frame_count());
    feet.tracks.each_ref().map(|foot| {
        let track = part(foot);
        let mut signal = Signal { height: vec![0.0; count], speed: vec![0.0; count] };
        let mut end = 0;
        for span in spans.iter().chain([&(count..count)]) {
            for frame in end..span.start {
                signal.height[frame] = feet.up.height(&resampler.resample(track, frame..frame + 1)[0]);
            }
            // Piece by piece, because a resampled track may need many times the memory. A piece overlaps its
            // neighbours by all frames on which a speed depends.
            for start in span.clone().step_by(PIECE) {
                let frames = start..(start + PIECE).min(span.end);
                let overlap = half.max(1) + 1;
                let from = frames.start.saturating_sub(overlap).max(span.start);
                let mut piece = resampler.resample(track, from..(frames.end + overlap).min(span.end));
                remove_spikes(&mut piece, feet.leg);
                let velocities = velocity::edge_preserving(&piece, half, *frame_time);
                for frame in frames {
                    signal.height[frame] = feet.up.height(&piece[frame - from]);
                    signal.speed[frame] = velocities[frame - from].norm();
                }
            }
            end = span.end;
        }
        signal
    })
}

/// Returns heights and speeds in all frames within `spans`, the left foot first; `at` returns those of a foot at a
/// frame.
pub(crate) fn values_within(
    spans: &[Range<usize>],
    at: impl Fn(usize, usize) -> [f64; 2],
) -> impl Iterator<Item = [f64; 2]> {
    let frames = move |foot: usize| spans.iter().cloned().flatten().map(move |frame| (foot, frame));
    (0..2).flat_map(frames).map(move |(foot, frame)| at(foot, frame))
}

/// Returns the smallest and the largest value.
pub(crate) fn min_max(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)))
}

/// Subtracts the lowest height of both feet from all heights.
fn subtract_ground(signals: &mut Signals, spans: &[Range<usize>]) {
    let heights =
        spans.iter().flat_map(|span| signals.iter().flat_map(|signal| &signal.height[span.clone()]));
    let lowest = heights.copied().fold(f64::INFINITY, f64::min);
    for height in signals.iter_mut().flat_map(|signal| &mut signal.height) {
        *height -= lowest;
    }
}

/// Replaces single frames far from their neighbours by the mean of the neighbours.
pub(crate) fn remove_spikes(track: &mut [Vector3<f64>], leg: f64) {
    let Some(&first) = track.first() else { return };
    // The comparison uses the original positions.
    let mut before = first;
    for frame in 1..track.len() - 1 {
        let (here, after) = (track[frame], track[frame + 1]);
        let middle = (before + after) / 2.0;
        if (here - middle).norm() > 3.0 * (after - before).norm() + 0.05 * leg {
            track[frame] = middle;
        }
        before = here;
    }
}

/// Returns, for each foot and frame, true if the second part bears weight: if it is slower.
///
/// If both are slower than `still`, the lower one bears weight: on tiptoe the ankle is as still as
/// the toe, but higher.
pub(crate) fn weight_bearing(a: &Signals, b: &Signals, still: f64) -> [Vec<bool>; 2] {
    [0, 1].map(|foot| {
        let rank = |signal: &Signal, frame: usize| (signal.speed[frame].max(still), signal.height[frame]);
        (0..a[foot].speed.len()).map(|frame| rank(&b[foot], frame) < rank(&a[foot], frame)).collect()
    })
}

/// Selects the signals of the first part, or of the second where `is_b` is true.
pub(crate) fn select(a: &Signals, b: &Signals, is_b: &[Vec<bool>; 2]) -> Signals {
    [0, 1].map(|foot| {
        let selected = |a: &[f64], b: &[f64]| {
            let both = a.iter().zip(b).zip(&is_b[foot]);
            both.map(|((a, b), is_b)| if *is_b { *b } else { *a }).collect()
        };
        let (a, b) = (&a[foot], &b[foot]);
        Signal { height: selected(&a.height, &b.height), speed: selected(&a.speed, &b.speed) }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn single_frame_spikes_are_removed() {
        let straight: Track = (0..20).map(|frame| Vector3::x() * f64::from(frame) * 0.1).collect();
        let cleaned = |track: &[Vector3<f64>]| {
            let mut track = track.to_vec();
            remove_spikes(&mut track, 1.0);
            track
        };
        assert_eq!(cleaned(&straight), straight);
        let mut track = straight.clone();
        track[7].y = 1.0;
        assert!((cleaned(&track)[7] - straight[7]).norm() < 1e-12);
        // At an end there is nothing to compare with.
        assert_eq!(cleaned(&track[..8])[7].y, 1.0);
        assert!(cleaned(&[]).is_empty());
    }

    #[test]
    fn pieces_do_not_change_the_signals() {
        let position = |frame: usize| {
            let time = frame as f64 / 30.0;
            Vector3::new(time.sin(), (7.0 * time).cos().max(0.0), if frame % 97 == 5 { 3.0 } else { 0.0 })
        };
        let toe: Track = (0..900).map(position).collect();
        let foot = FootTracks { ankle: toe.clone(), toe, tip: None };
        let tracks = [foot.clone(), foot];
        let feet = |frame_time| Feet {
            tracks: tracks.clone(),
            hips: Track::new(),
            up: Up::Y,
            leg: 1.0,
            metres_per_unit: 1.0,
            frame_time,
        };
        for frame_time in [1.0 / 30.0, 1.0 / 120.0, 1.0 / 1000.0] {
            let feet = feet(frame_time);
            for spans in [vec![0..900], vec![3..310, 310..312, 350..896]] {
                let resampler = Resampler::new(&feet, &spans);
                let [filtered, _] = filtered(&feet, &resampler, |foot| &foot.toe);
                let mut track = resampler.resample(&feet.tracks[0].toe, 0..resampler.fine_frame_count(900));
                for span in &resampler.fine_spans {
                    remove_spikes(&mut track[span.clone()], 1.0);
                }
                let half = (SPEED_WINDOW / resampler.frame_time + 0.55).floor() as usize;
                let velocity =
                    |track: &[Vector3<f64>]| velocity::edge_preserving(track, half, resampler.frame_time);
                assert_eq!(filtered, Signal::new(&track, Up::Y, &resampler.fine_spans, velocity));
            }
        }
    }

    #[test]
    fn the_slower_part_bears_weight() {
        let signal = |height: f64, speed: [f64; 2]| Signal { height: vec![height; 2], speed: speed.into() };
        let ankle = [signal(1.0, [0.0, 2.0]), signal(1.0, [0.0, 2.0])];
        let toe = [signal(5.0, [1.0, 1.0]), signal(5.0, [1.0, 1.0])];
        let sole = select(&ankle, &toe, &weight_bearing(&ankle, &toe, 0.5));
        assert_eq!(sole[0], Signal { height: vec![1.0, 5.0], speed: vec![0.0, 1.0] });
        // With both slower than 3, the ankle is the lower one in all frames.
        assert_eq!(weight_bearing(&toe, &ankle, 3.0), [[true, true], [true, true]]);
    }
}
