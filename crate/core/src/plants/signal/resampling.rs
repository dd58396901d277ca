//! Positions between frames, so that clips of low rates are measured as those of high ones.

use std::ops::Range;

use crate::kinematics::Track;
use crate::numeric::interpolate;
use crate::plants::Feet;

/// The rate that clips are brought to at least, in frames per second.
const RATE: f64 = 120.0;

/// How clips of low rates are brought to about 120 Hz, piece by piece; faster ones stay as they are.
pub(crate) struct Refined {
    /// The pieces of the clip.
    coarse: Vec<Range<usize>>,
    /// The same pieces once refined.
    pub pieces: Vec<Range<usize>>,
    /// Frame n of the clip is frame n × stride of what is refined.
    pub stride: usize,
    /// Seconds from one frame of what is refined to the next.
    pub frame_time: f64,
}

impl Refined {
    /// The feet's motion in `pieces`.
    pub fn of(feet: &Feet, pieces: &[Range<usize>]) -> Refined {
        let stride = (RATE * feet.frame_time).round().max(1.0) as usize;
        let fine = |piece: &Range<usize>| piece.start * stride..(piece.end - 1) * stride + 1;
        Refined {
            coarse: pieces.to_vec(),
            pieces: pieces.iter().map(fine).collect(),
            stride,
            frame_time: feet.frame_time / stride as f64,
        }
    }

    /// A track with what lies between its frames.
    pub fn between(&self, track: &Track) -> Track {
        if self.stride == 1 { track.clone() } else { between(track, &self.coarse, self.stride) }
    }
}

/// A track with cubics between its frames that pass through them.
fn between(track: &Track, pieces: &[Range<usize>], stride: usize) -> Track {
    let last = track.len() - 1;
    let mut fine = Track::with_capacity(last * stride + 1);
    for frame in 0..last {
        // Beyond a piece's end its last position stands; a jump between pieces is no motion.
        let piece = pieces.iter().find(|piece| piece.contains(&frame)).cloned().unwrap_or(frame..frame + 1);
        let at = |frame: usize| track[frame.clamp(piece.start, piece.end - 1)];
        let points = [at(frame.saturating_sub(1)), at(frame), at(frame + 1), at(frame + 2)];
        fine.extend((0..stride).map(|step| interpolate::cubic(points, step as f64 / stride as f64)));
    }
    fine.push(track[last]);
    fine
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;

    use super::*;

    #[test]
    fn frames_stay_and_parabolas_are_kept() {
        let place = |t: f64| Vector3::new(t, 3.0 * t * t - t, 0.0);
        let track: Track = (0..8).map(|frame| place(f64::from(frame))).collect();
        let fine = between(&track, &[0..8], 4);
        assert_eq!(fine.len(), 29);
        for (index, position) in fine.iter().enumerate() {
            let t = index as f64 / 4.0;
            // At the ends there is no neighbour to take the slope from.
            if (1.0..=6.0).contains(&t) {
                assert!((position - place(t)).norm() < 1e-12, "{t}");
            }
        }
    }

    #[test]
    fn jumps_between_pieces_are_not_smoothed() {
        let track: Track = (0..6).map(|frame| Vector3::x() * if frame < 3 { 0.0 } else { 9.0 }).collect();
        let fine = between(&track, &[0..3, 3..6], 2);
        assert!(fine.iter().all(|position| position.x == 0.0 || position.x == 9.0), "{fine:?}");
    }
}
