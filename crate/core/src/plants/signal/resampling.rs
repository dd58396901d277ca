//! Resampling of clips with a low frame rate.

use std::ops::Range;

use crate::kinematics::Track;
use crate::numeric::interpolate;
use crate::plants::Feet;

/// Minimum rate after resampling, in Hz.
const MIN_RATE: f64 = 120.0;
/// Maximum upsampling factor, that of 12 Hz. Without it, memory and time of a detection would grow with the frame
/// time, to 120 times the frames at 1 Hz.
const MAX_FACTOR: f64 = 10.0;

/// Resamples clips of low rates to about 120 Hz, or to ten times their rate, span by span; faster clips are not
/// changed.
pub(crate) struct Resampler {
    /// Spans of the clip, in frames.
    spans: Vec<Range<usize>>,
    /// The same spans in resampled frames.
    pub fine_spans: Vec<Range<usize>>,
    /// Upsampling factor: frame n of the clip is frame n × factor after resampling.
    pub factor: usize,
    /// Time between resampled frames, in seconds.
    pub frame_time: f64,
}

impl Resampler {
    /// Creates a resampler for these feet with the given spans.
    pub fn new(feet: &Feet, spans: &[Range<usize>]) -> Resampler {
        let factor = (MIN_RATE * feet.frame_time).round().clamp(1.0, MAX_FACTOR) as usize;
        let to_fine = |span: &Range<usize>| span.start * factor..(span.end - 1) * factor + 1;
        Resampler {
            spans: spans.to_vec(),
            fine_spans: spans.iter().map(to_fine).collect(),
            factor,
            frame_time: feet.frame_time / factor as f64,
        }
    }

    /// Returns the resampled track.
    pub fn resample(&self, track: &Track) -> Track {
        if self.factor == 1 { track.clone() } else { interpolate_track(track, &self.spans, self.factor) }
    }
}

/// Interpolates a track by Catmull–Rom splines, which pass through its frames.
fn interpolate_track(track: &Track, spans: &[Range<usize>], factor: usize) -> Track {
    let last = track.len() - 1;
    let mut fine = Track::with_capacity(last * factor + 1);
    for frame in 0..last {
        // Beyond the end of a span its last position is repeated; a jump between spans is not
        // motion.
        let span = spans.get(spans.partition_point(|span| span.end <= frame));
        let span = span.filter(|span| span.contains(&frame)).cloned().unwrap_or(frame..frame + 1);
        let at = |frame: usize| track[frame.clamp(span.start, span.end - 1)];
        let points = [at(frame.saturating_sub(1)), at(frame), at(frame + 1), at(frame + 2)];
        fine.extend((0..factor).map(|step| interpolate::catmull_rom(points, step as f64 / factor as f64)));
    }
    fine.push(track[last]);
    fine
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;

    use super::*;

    #[test]
    fn frames_and_parabolas_are_reproduced() {
        let position_at = |t: f64| Vector3::new(t, 3.0 * t * t - t, 0.0);
        let track: Track = (0..8).map(|frame| position_at(f64::from(frame))).collect();
        let fine = interpolate_track(&track, &[0..8], 4);
        assert_eq!(fine.len(), 29);
        for (index, position) in fine.iter().enumerate() {
            let t = index as f64 / 4.0;
            // At the ends there is no neighbour that determines the slope.
            if (1.0..=6.0).contains(&t) {
                assert!((position - position_at(t)).norm() < 1e-12, "{t}");
            }
        }
    }

    #[test]
    fn jumps_between_pieces_are_not_smoothed() {
        let track: Track = (0..6).map(|frame| Vector3::x() * if frame < 3 { 0.0 } else { 9.0 }).collect();
        let fine = interpolate_track(&track, &[0..3, 3..6], 2);
        assert!(fine.iter().all(|position| position.x == 0.0 || position.x == 9.0), "{fine:?}");
    }
}
