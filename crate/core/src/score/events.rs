//! Comparison of plants as events: detected plants and the errors of their edges.

use std::ops::{AddAssign, Range};

use serde::Serialize;

use crate::intervals::intervals;
use crate::numeric::stats::nearest_percentile;

/// Plants of one foot, matched one to one.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Events {
    /// Detected plants that match a true plant.
    pub matched: usize,
    /// Detected plants.
    pub detected: usize,
    /// True plants.
    pub total: usize,
    /// Onset errors of matched plants with a known onset: detected minus true, in seconds.
    pub onset_errors: Vec<f64>,
    /// Offset errors of matched plants with a known end: detected minus true, in seconds.
    pub offset_errors: Vec<f64>,
}

/// Summary of [`Events`].
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct EventScore {
    /// Fraction of the detected plants that are true.
    pub precision: f64,
    /// Fraction of the true plants that were detected.
    pub recall: f64,
    /// Harmonic mean of precision and recall.
    pub f1: f64,
    /// Median onset error, in seconds; positive if late.
    pub onset: f64,
    /// Median offset error, in seconds; positive if late.
    pub offset: f64,
    /// 95th percentile of the absolute onset error, in seconds.
    pub onset_95: f64,
    /// 95th percentile of the absolute offset error, in seconds.
    pub offset_95: f64,
}

/// Matches plants that overlap by at least half of the longer one.
///
/// A plant counts if the truth of most of its frames is known. An edge counts if the truth next to
/// it is known and within the clip.
///
/// # Panics
/// If `labels` and `truth` differ in length.
pub fn events(labels: &[bool], truth: &[Option<bool>], frame_time: f64) -> Events {
    assert_eq!(labels.len(), truth.len(), "labels and truth must have the same length");
    let true_plants = runs(truth.len(), |frame| truth[frame] == Some(true));
    let is_known = |plant: &Range<usize>| 2 * truth[plant.clone()].iter().flatten().count() > plant.len();
    let mut detected = runs(labels.len(), |frame| labels[frame]);
    let mut events = Events {
        total: true_plants.len(),
        detected: detected.iter().filter(|plant| is_known(plant)).count(),
        ..Events::default()
    };
    for plant in true_plants {
        let overlap =
            |other: &Range<usize>| plant.end.min(other.end).saturating_sub(plant.start.max(other.start));
        let Some(best) = (0..detected.len()).max_by_key(|&index| overlap(&detected[index])) else { break };
        // Unknown frames do not count towards the length of a plant.
        let other = detected[best].clone();
        let known = truth[other.clone()].iter().flatten().count();
        if 2 * overlap(&other) < plant.len().max(known) || overlap(&other) == 0 {
            continue;
        }
        if !is_known(&other) {
            events.detected += 1;
        }
        detected.remove(best);
        events.matched += 1;
        let edge_known = |outside: Option<usize>| outside.and_then(|frame| *truth.get(frame)?) == Some(false);
        let error_s = |detected: usize, true_frame: usize| (detected as f64 - true_frame as f64) * frame_time;
        if edge_known(plant.start.checked_sub(1)) {
            events.onset_errors.push(error_s(other.start, plant.start));
        }
        if edge_known(Some(plant.end)) {
            events.offset_errors.push(error_s(other.end, plant.end));
        }
    }
    events
}

impl Events {
    /// Returns precision, recall, F1 and edge errors.
    pub fn score(&self) -> EventScore {
        let fraction = |total: usize| if total == 0 { 1.0 } else { self.matched as f64 / total as f64 };
        let (precision, recall) = (fraction(self.detected), fraction(self.total));
        let absolute = |errors: &[f64]| errors.iter().map(|error| error.abs()).collect::<Vec<_>>();
        EventScore {
            precision,
            recall,
            f1: if precision + recall > 0.0 { 2.0 * precision * recall / (precision + recall) } else { 0.0 },
            onset: nearest_percentile(self.onset_errors.clone(), 0.5),
            offset: nearest_percentile(self.offset_errors.clone(), 0.5),
            onset_95: nearest_percentile(absolute(&self.onset_errors), 0.95),
            offset_95: nearest_percentile(absolute(&self.offset_errors), 0.95),
        }
    }
}

impl AddAssign for Events {
    fn add_assign(&mut self, other: Events) {
        self.matched += other.matched;
        self.detected += other.detected;
        self.total += other.total;
        self.onset_errors.extend(other.onset_errors);
        self.offset_errors.extend(other.offset_errors);
    }
}

fn runs(frames: usize, planted: impl Fn(usize) -> bool) -> Vec<Range<usize>> {
    intervals(&(0..frames).map(planted).collect::<Vec<_>>())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn score(detected: &str, truth: &str) -> Events {
        let truth: Vec<_> = truth.chars().map(|c| (c != '?').then_some(c == '#')).collect();
        let labels: Vec<bool> = detected.chars().map(|c| c == '#').collect();
        events(&labels, &truth, 0.01)
    }

    #[test]
    fn plants_match_if_they_overlap_by_half() {
        let events = score("..###....#######", "..####......####");
        assert_eq!((events.matched, events.detected, events.total), (2, 2, 2));
        assert_eq!(events.onset_errors, [0.0, -0.03]);
        // The second plant ends with the clip, so its end is unknown.
        assert_eq!(events.offset_errors, [-0.01]);
        assert_eq!(score("..#.....", "..####..").matched, 0);
        let result = events.score();
        assert_eq!((result.precision, result.recall, result.f1), (1.0, 1.0, 1.0));
    }

    #[test]
    fn unknown_frames_do_not_count() {
        let events = score("####....####", "????....##??");
        assert_eq!((events.matched, events.detected, events.total), (1, 1, 1));
        assert_eq!((events.onset_errors.len(), events.offset_errors.len()), (1, 0));
        assert_eq!(score("####....", "........").score().precision, 0.0);
    }
}
