//! Height and speed of a part of the foot: what is clustered.

pub(crate) mod motion_segments;
pub(crate) mod resampling;
pub(crate) mod samples;
pub(crate) mod velocity;

use std::collections::VecDeque;
use std::ops::Range;

use nalgebra::Vector3;

use crate::kinematics::Track;
use crate::plants::signal::resampling::Refined;
use crate::plants::{Feet, FootTracks};
use crate::skeleton::Up;

/// Height and speed per frame of one effector of one foot.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Signal {
    /// In file units.
    pub height: Vec<f64>,
    /// In file units per second.
    pub speed: Vec<f64>,
}

/// The same effector of both feet, left first.
pub(crate) type Signals = [Signal; 2];

/// Half the time window of speeds, in seconds.
const SPEED_WINDOW: f64 = 0.05;
/// Half the time window in which the ground is looked for, in seconds: longer than
/// the flight of a run, shorter than a stride.
const GROUND_WINDOW: f64 = 0.5;

impl Signal {
    /// Heights and speeds of a track, piece by piece.
    pub fn of(
        track: &Track,
        up: Up,
        pieces: &[Range<usize>],
        velocity: impl Fn(&[Vector3<f64>]) -> Vec<Vector3<f64>>,
    ) -> Signal {
        let mut speed = vec![0.0; track.len()];
        for piece in pieces {
            let velocities = velocity(&track[piece.clone()]);
            for (speed, velocity) in speed[piece.clone()].iter_mut().zip(velocities) {
                *speed = velocity.norm();
            }
        }
        Signal { height: track.iter().map(|position| up.height(position)).collect(), speed }
    }

    /// Height and speed of `frame`.
    pub fn at(&self, frame: usize) -> [f64; 2] {
        [self.height[frame], self.speed[frame]]
    }
}

/// Signals of one effector by central differences over the whole clip (paper, section 2.1).
pub(crate) fn plain(feet: &Feet, effector: impl Fn(&FootTracks) -> &Track) -> Signals {
    let pieces = [0..feet.frame_count()];
    let velocity = |track: &[Vector3<f64>]| velocity::central_difference(track, feet.frame_time);
    let mut signals =
        feet.tracks.each_ref().map(|foot| Signal::of(effector(foot), feet.up, &pieces, velocity));
    ground(&mut signals, &pieces);
    signals
}

/// Signals of one effector without spikes, refined, their speed smoothed over a window of time.
pub(crate) fn smooth(feet: &Feet, refined: &Refined, effector: impl Fn(&FootTracks) -> &Track) -> Signals {
    let Refined { pieces, frame_time, .. } = refined;
    // Rates such as 0.033333 and 0.033334 s must give the same window.
    let half = |seconds: f64| (seconds / frame_time + 0.55).floor() as usize;
    let velocity = |track: &[Vector3<f64>]| velocity::edge_preserving(track, half(SPEED_WINDOW), *frame_time);
    // One track after the other: between its frames it may take many times the memory.
    let mut signals = feet.tracks.each_ref().map(|foot| {
        let mut track = refined.between(effector(foot));
        mend_spikes(&mut track, pieces, feet.leg);
        Signal::of(&track, feet.up, pieces, velocity)
    });
    local_ground(&mut signals, pieces, half(GROUND_WINDOW));
    signals
}

/// Takes from each height the lowest that either foot comes within `half` frames to either side.
///
/// On slopes and stairs the ground is not the same throughout, but under a step it is.
fn local_ground(signals: &mut Signals, pieces: &[Range<usize>], half: usize) {
    for piece in pieces {
        let lower = |frame: usize| signals[0].height[frame].min(signals[1].height[frame]);
        let ground = sliding_minimum(piece.clone().map(lower).collect(), half);
        for signal in signals.iter_mut() {
            for (height, ground) in signal.height[piece.clone()].iter_mut().zip(&ground) {
                *height -= ground;
            }
        }
    }
}

/// The least of the values within `half` places to either side, in linear time.
fn sliding_minimum(values: Vec<f64>, half: usize) -> Vec<f64> {
    // Places whose values may still become the least, in ascending order of both.
    let mut candidates: VecDeque<usize> = VecDeque::new();
    let mut next = 0;
    (0..values.len())
        .map(|place| {
            while next < values.len().min(place + half + 1) {
                while candidates.back().is_some_and(|&last| values[last] >= values[next]) {
                    candidates.pop_back();
                }
                candidates.push_back(next);
                next += 1;
            }
            while candidates.front().is_some_and(|&first| first + half < place) {
                candidates.pop_front();
            }
            values[candidates[0]]
        })
        .collect()
}

/// One quantity of both feet in all frames that belong to the motion.
pub(crate) fn kept(
    signals: &Signals,
    pieces: &[Range<usize>],
    quantity: fn(&Signal) -> &[f64],
) -> impl Iterator<Item = f64> {
    signals.iter().flat_map(move |signal| {
        pieces.iter().flat_map(move |piece| quantity(signal)[piece.clone()].iter().copied())
    })
}

/// Smallest and largest value.
pub(crate) fn extremes(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)))
}

/// Takes the lowest height of both feet from all heights.
fn ground(signals: &mut Signals, pieces: &[Range<usize>]) {
    let kept =
        pieces.iter().flat_map(|piece| signals.iter().flat_map(|signal| &signal.height[piece.clone()]));
    let lowest = kept.copied().fold(f64::INFINITY, f64::min);
    for height in signals.iter_mut().flat_map(|signal| &mut signal.height) {
        *height -= lowest;
    }
}

/// Puts single frames that jut out of their neighbours between them.
fn mend_spikes(track: &mut Track, pieces: &[Range<usize>], leg: f64) {
    for piece in pieces.iter().filter(|piece| piece.len() > 2) {
        // What is compared with is never mended.
        let mut before = track[piece.start];
        for frame in piece.start + 1..piece.end - 1 {
            let (here, after) = (track[frame], track[frame + 1]);
            let middle = (before + after) / 2.0;
            if (here - middle).norm() > 3.0 * (after - before).norm() + 0.05 * leg {
                track[frame] = middle;
            }
            before = here;
        }
    }
}

/// For each foot and frame whether the second of two effectors bears weight: whichever is slower.
///
/// Where both are slower than `still`, the lower one: on tiptoe the ankle stands
/// as still as the toe, but high.
pub(crate) fn bearing(a: &Signals, b: &Signals, still: f64) -> [Vec<bool>; 2] {
    [0, 1].map(|foot| {
        let rank = |signal: &Signal, frame: usize| (signal.speed[frame].max(still), signal.height[frame]);
        (0..a[foot].speed.len()).map(|frame| rank(&b[foot], frame) < rank(&a[foot], frame)).collect()
    })
}

/// The first of two effectors, or the second in the frames where that is told.
pub(crate) fn either(a: &Signals, b: &Signals, is_b: &[Vec<bool>; 2]) -> Signals {
    [0, 1].map(|foot| {
        let chosen = |a: &[f64], b: &[f64]| {
            let both = a.iter().zip(b).zip(&is_b[foot]);
            both.map(|((a, b), is_b)| if *is_b { *b } else { *a }).collect()
        };
        let (a, b) = (&a[foot], &b[foot]);
        Signal { height: chosen(&a.height, &b.height), speed: chosen(&a.speed, &b.speed) }
    })
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn one_frame_spikes_are_mended_and_motion_is_not() {
        let straight: Track = (0..20).map(|frame| Vector3::x() * f64::from(frame) * 0.1).collect();
        let mended = |track: &Track, pieces: &[Range<usize>]| {
            let mut track = track.clone();
            mend_spikes(&mut track, pieces, 1.0);
            track
        };
        assert_eq!(mended(&straight, &[0..20]), straight);
        let mut track = straight.clone();
        track[7].y = 1.0;
        assert!((mended(&track, &[0..20])[7] - straight[7]).norm() < 1e-12);
        // At the edge of a piece there is nothing to compare with.
        assert_eq!(mended(&track, &[0..8, 8..20])[7].y, 1.0);
    }

    proptest! {
        #[test]
        fn the_sliding_minimum_is_the_least_of_its_window(
            values in prop::collection::vec(-9.0..9.0_f64, 0..40),
            half in 0_usize..12,
        ) {
            let expected: Vec<f64> = (0..values.len())
                .map(|place| {
                    let window = &values[place.saturating_sub(half)..(place + half + 1).min(values.len())];
                    window.iter().copied().fold(f64::INFINITY, f64::min)
                })
                .collect();
            prop_assert_eq!(sliding_minimum(values, half), expected);
        }
    }

    #[test]
    fn the_slower_effector_bears_weight_or_the_lower_of_two_still_ones() {
        let signal = |height: f64, speed: [f64; 2]| Signal { height: vec![height; 2], speed: speed.into() };
        let ankle = [signal(1.0, [0.0, 2.0]), signal(1.0, [0.0, 2.0])];
        let toe = [signal(5.0, [1.0, 1.0]), signal(5.0, [1.0, 1.0])];
        let sole = either(&ankle, &toe, &bearing(&ankle, &toe, 0.5));
        assert_eq!(sole[0], Signal { height: vec![1.0, 5.0], speed: vec![0.0, 1.0] });
        // With both slower than 3, the ankle is the lower one throughout.
        assert_eq!(bearing(&toe, &ankle, 3.0), [[true, true], [true, true]]);
    }
}
