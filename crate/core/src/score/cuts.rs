//! Cuts between actions against the cuts that somebody made.

use std::ops::AddAssign;

use crate::numeric::sort;

/// A true cut: somewhere in a range of frames.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrueCut {
    /// The first frame that can be called the cut.
    pub earliest: f64,
    /// The last one.
    pub latest: f64,
}

impl TrueCut {
    /// A cut that is known to the frame.
    pub fn at(frame: f64) -> TrueCut {
        TrueCut { earliest: frame, latest: frame }
    }

    /// The frame in the middle of the range.
    pub fn middle(&self) -> f64 {
        (self.earliest + self.latest) / 2.0
    }
}

/// When a cut that was found is right.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Tolerance {
    /// At most this many seconds from the middle of the true cut.
    Seconds(f64),
    /// Within the range of the true cut.
    Inside,
}

impl Tolerance {
    /// What is usually reported: ±0.5 s, ±1 s and inside.
    pub const USUAL: [Tolerance; 3] = [Tolerance::Seconds(0.5), Tolerance::Seconds(1.0), Tolerance::Inside];

    fn allows(self, found: f64, truth: &TrueCut, frame_time: f64) -> bool {
        match self {
            // The margin is for frame times such as 0.0083333.
            Tolerance::Seconds(most) => (found - truth.middle()).abs() * frame_time <= most + 1e-4,
            Tolerance::Inside => (truth.earliest..=truth.latest).contains(&found),
        }
    }
}

/// How many cuts were right.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CutTally {
    /// Cuts that match a true one, each its own.
    pub right: usize,
    /// Cuts that were found.
    pub found: usize,
    /// True cuts.
    pub wanted: usize,
}

impl CutTally {
    /// Share of the found cuts that are right; 1 where none was found.
    pub fn precision(self) -> f64 {
        share(self.right, self.found)
    }

    /// Share of the true cuts that were found; 1 where there are none.
    pub fn recall(self) -> f64 {
        share(self.right, self.wanted)
    }

    /// Harmonic mean of precision and recall; 1 where there is nothing to find and nothing was found.
    pub fn f1(self) -> f64 {
        share(2 * self.right, self.found + self.wanted)
    }
}

fn share(part: usize, whole: usize) -> f64 {
    if whole == 0 { 1.0 } else { part as f64 / whole as f64 }
}

impl AddAssign for CutTally {
    fn add_assign(&mut self, other: CutTally) {
        self.right += other.right;
        self.found += other.found;
        self.wanted += other.wanted;
    }
}

/// Matches cuts one to one, the nearest pair first, as far as the tolerance allows.
///
/// `found` holds the first frames of segments, as frame indices, and so does `truth`.
pub fn cuts(found: &[usize], truth: &[TrueCut], frame_time: f64, tolerance: Tolerance) -> CutTally {
    let mut pairs = Vec::new();
    for (f, &found) in found.iter().enumerate() {
        for (t, truth) in truth.iter().enumerate() {
            if tolerance.allows(found as f64, truth, frame_time) {
                pairs.push(((found as f64 - truth.middle()).abs(), f, t));
            }
        }
    }
    let distances: Vec<f64> = pairs.iter().map(|pair| pair.0).collect();
    let (mut is_used, mut is_met) = (vec![false; found.len()], vec![false; truth.len()]);
    let mut right = 0;
    for (_, f, t) in sort::argsort(&distances).into_iter().map(|place| pairs[place]) {
        if !is_used[f] && !is_met[t] {
            (is_used[f], is_met[t]) = (true, true);
            right += 1;
        }
    }
    CutTally { right, found: found.len(), wanted: truth.len() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_cut_counts_once() {
        let truth = [TrueCut { earliest: 90.0, latest: 110.0 }, TrueCut::at(300.0)];
        let tally = cuts(&[80, 104, 400], &truth, 0.01, Tolerance::Seconds(0.5));
        assert_eq!(tally, CutTally { right: 1, found: 3, wanted: 2 });
        assert_eq!(cuts(&[80, 104, 400], &truth, 0.01, Tolerance::Seconds(1.0)).right, 2);
        assert_eq!(cuts(&[111, 300], &truth, 0.01, Tolerance::Inside).right, 1);
        assert_eq!(tally.f1(), 0.4);
        assert_eq!(cuts(&[], &[], 0.01, Tolerance::Inside).f1(), 1.0);
    }

    #[test]
    fn the_nearest_pair_is_matched_first() {
        let truth = [TrueCut::at(100.0), TrueCut::at(150.0)];
        // 140 belongs to 150, and 90 to 100, though 140 is within a second of both.
        assert_eq!(cuts(&[90, 140], &truth, 0.01, Tolerance::Seconds(1.0)).right, 2);
    }
}
