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

    /// Returns the number of resampled frames of a clip.
    pub fn fine_frame_count(&self, frames: usize) -> usize {
        (frames - 1) * self.factor + 1
    }

    /// Returns the resampled `frames` of a track, interpolated by Catmull–Rom splines, which pass through its
    /// frames.
    pub fn resample(&self, track: &Track, frames: Range<usize>) -> Track {
        if self.factor == 1 {
            return track[frames].to_vec();
        }
        let mut fine = Track::with_capacity(frames.len());
        for frame in frames.start / self.factor..frames.end.div_ceil(self.factor) {
            // Beyond the end of a span its last position is repeated; a jump between spans is not
            // motion.
            let span = self.spans.get(self.spans.partition_point(|span| span.end <= frame));
            let span = span.filter(|span| span.contains(&frame)).cloned().unwrap_or(frame..frame + 1);
            let at = |frame: usize| track[frame.clamp(span.start, span.end - 1)];
            let points = [at(frame.saturating_sub(1)), at(frame), at(frame + 1), at(frame + 2)];
            let start = frame * self.factor;
            let steps = start.max(frames.start)..(start + self.factor).min(frames.end);
            let at_step = |step| (step - start) as f64 / self.factor as f64;
            fine.extend(steps.map(|step| interpolate::catmull_rom(points, at_step(step))));
        }
        fine
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;

    use super::*;

    #[test]
    fn frames_and_parabolas_are_reproduced() {
        let position_at = |t: f64| Vector3::new(t, 3.0 * t * t - t, 0.0);
        let track: Track = (0..8).map(|frame| position_at(f64::from(frame))).collect();
        let resampler =
            |factor| Resampler { spans: vec![0..8], fine_spans: Vec::new(), factor, frame_time: 1.0 };
        let fine = resampler(4).resample(&track, 0..29);
        assert_eq!(fine.len(), 29);
        for (index, position) in fine.iter().enumerate() {
            let t = index as f64 / 4.0;
            // At the ends there is no neighbour that determines the slope.
            if (1.0..=6.0).contains(&t) {
                assert!((position - position_at(t)).norm() < 1e-12, "{t}");
            }
        }
        for factor in [1, 4] {
            let resampler = resampler(factor);
            let count = resampler.fine_frame_count(track.len());
            let fine = resampler.resample(&track, 0..count);
            for start in 0..count {
                for end in start + 1..=count {
                    assert_eq!(resampler.resample(&track, start..end), fine[start..end]);
                }
            }
        }
    }

    #[test]
    fn jumps_between_pieces_are_not_smoothed() {
        let track: Track = (0..6).map(|frame| Vector3::x() * if frame < 3 { 0.0 } else { 9.0 }).collect();
        let spans = vec![0..3, 3..6];
        let resampler = Resampler { spans, fine_spans: Vec::new(), factor: 2, frame_time: 1.0 };
        let fine = resampler.resample(&track, 0..11);
        assert!(fine.iter().all(|position| position.x == 0.0 || position.x == 9.0), "{fine:?}");
    }
}
