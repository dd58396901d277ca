//! Comparison of cuts with reference cuts.

use std::ops::AddAssign;

use crate::numeric::sort;

/// Reference cut: anywhere in a frame range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrueCut {
    /// First frame of the range.
    pub earliest: f64,
    /// Last frame of the range.
    pub latest: f64,
}

impl TrueCut {
    /// Creates a cut at one frame.
    pub fn at(frame: f64) -> TrueCut {
        TrueCut { earliest: frame, latest: frame }
    }

    /// Returns the middle of the range.
    pub fn middle(&self) -> f64 {
        (self.earliest + self.latest) / 2.0
    }
}

/// Tolerance of a correct cut.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Tolerance {
    /// At most this many seconds from the middle of the reference cut.
    Seconds(f64),
    /// Within the range of the reference cut.
    Inside,
}

impl Tolerance {
    /// Tolerances that are reported: ±0.5 s, ±1 s and inside.
    pub const REPORTED: [Tolerance; 3] =
        [Tolerance::Seconds(0.5), Tolerance::Seconds(1.0), Tolerance::Inside];

    fn allows(self, detected: f64, truth: &TrueCut, frame_time: f64) -> bool {
        match self {
            // The margin is for frame times such as 0.0083333.
            Tolerance::Seconds(max) => (detected - truth.middle()).abs() * frame_time <= max + 1e-4,
            Tolerance::Inside => (truth.earliest..=truth.latest).contains(&detected),
        }
    }
}

/// Numbers of correct cuts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CutTally {
    /// Detected cuts that match a reference cut, one to one.
    pub correct: usize,
    /// Detected cuts.
    pub detected: usize,
    /// Reference cuts.
    pub total: usize,
}

impl CutTally {
    /// Returns the fraction of the detected cuts that are correct; 1 if there are none.
    pub fn precision(self) -> f64 {
        fraction(self.correct, self.detected)
    }

    /// Returns the fraction of the reference cuts that were detected; 1 if there are none.
    pub fn recall(self) -> f64 {
        fraction(self.correct, self.total)
    }

    /// Returns the harmonic mean of precision and recall; 1 if there are no cuts at all.
    pub fn f1(self) -> f64 {
        fraction(2 * self.correct, self.detected + self.total)
    }
}

fn fraction(part: usize, total: usize) -> f64 {
    if total == 0 { 1.0 } else { part as f64 / total as f64 }
}

impl AddAssign for CutTally {
    fn add_assign(&mut self, other: CutTally) {
        self.correct += other.correct;
        self.detected += other.detected;
        self.total += other.total;
    }
}

/// Matches cuts one to one within the tolerance, the nearest pair first.
///
/// `detected` and `truth` have the first frames of segments.
pub fn cuts(detected: &[usize], truth: &[TrueCut], frame_time: f64, tolerance: Tolerance) -> CutTally {
    let mut pairs = Vec::new();
    for (index, &detected) in detected.iter().enumerate() {
        for (true_index, truth) in truth.iter().enumerate() {
            if tolerance.allows(detected as f64, truth, frame_time) {
                pairs.push(((detected as f64 - truth.middle()).abs(), index, true_index));
            }
        }
    }
    let distances: Vec<f64> = pairs.iter().map(|pair| pair.0).collect();
    let (mut detected_matched, mut truth_matched) = (vec![false; detected.len()], vec![false; truth.len()]);
    let mut correct = 0;
    for (_, index, true_index) in sort::argsort(&distances).into_iter().map(|pair| pairs[pair]) {
        if !detected_matched[index] && !truth_matched[true_index] {
            (detected_matched[index], truth_matched[true_index]) = (true, true);
            correct += 1;
        }
    }
    CutTally { correct, detected: detected.len(), total: truth.len() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_cut_counts_once() {
        let truth = [TrueCut { earliest: 90.0, latest: 110.0 }, TrueCut::at(300.0)];
        let tally = cuts(&[80, 104, 400], &truth, 0.01, Tolerance::Seconds(0.5));
        assert_eq!(tally, CutTally { correct: 1, detected: 3, total: 2 });
        assert_eq!(cuts(&[80, 104, 400], &truth, 0.01, Tolerance::Seconds(1.0)).correct, 2);
        assert_eq!(cuts(&[111, 300], &truth, 0.01, Tolerance::Inside).correct, 1);
        assert_eq!(tally.f1(), 0.4);
        assert_eq!(cuts(&[], &[], 0.01, Tolerance::Inside).f1(), 1.0);
    }

    #[test]
    fn the_nearest_pair_is_matched_first() {
        let truth = [TrueCut::at(100.0), TrueCut::at(150.0)];
        // 140 matches 150, and 90 matches 100, although 140 is within a second of both.
        assert_eq!(cuts(&[90, 140], &truth, 0.01, Tolerance::Seconds(1.0)).correct, 2);
    }
}
