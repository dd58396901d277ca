//! Plants as events: which were found, and how early or late.

use std::ops::{AddAssign, Range};

use serde::Serialize;

/// Plants of one foot, found and true, matched one to one.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Events {
    /// Plants that were found where there is one.
    pub matched: usize,
    /// Plants that were found.
    pub found: usize,
    /// Plants that there are.
    pub total: usize,
    /// For each matched plant whose beginning is known: found minus true, in seconds.
    pub onset_errors: Vec<f64>,
    /// For each matched plant whose end is known: found minus true, in seconds.
    pub offset_errors: Vec<f64>,
}

/// What [`Events`] come to.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct EventScore {
    /// Share of the plants found that there are.
    pub precision: f64,
    /// Share of the plants that were found.
    pub recall: f64,
    /// Harmonic mean of both.
    pub f1: f64,
    /// Median of the onset errors in seconds; positive is late.
    pub onset: f64,
    /// Median of the offset errors in seconds.
    pub offset: f64,
    /// 95th percentile of the onset errors' amounts.
    pub onset_95: f64,
    /// 95th percentile of the offset errors' amounts.
    pub offset_95: f64,
}

/// Matches plants that overlap by at least half of the longer.
///
/// A plant counts where most of its frames have known truth; an edge counts
/// where the truth beside it is known and within the clip.
///
/// # Panics
/// If `labels` and `truth` differ in length.
pub fn events(labels: &[bool], truth: &[Option<bool>], frame_time: f64) -> Events {
    assert_eq!(labels.len(), truth.len(), "labels and truth are of one clip");
    let true_plants = runs(truth.len(), |frame| truth[frame] == Some(true));
    let is_known = |plant: &Range<usize>| 2 * truth[plant.clone()].iter().flatten().count() > plant.len();
    let mut found = runs(labels.len(), |frame| labels[frame]);
    let mut events = Events {
        total: true_plants.len(),
        found: found.iter().filter(|plant| is_known(plant)).count(),
        ..Events::default()
    };
    for plant in true_plants {
        let overlap =
            |other: &Range<usize>| plant.end.min(other.end).saturating_sub(plant.start.max(other.start));
        let Some(best) = (0..found.len()).max_by_key(|&index| overlap(&found[index])) else { break };
        // What is not known of a plant cannot count against its length.
        let other = found[best].clone();
        let known = truth[other.clone()].iter().flatten().count();
        if 2 * overlap(&other) < plant.len().max(known) || overlap(&other) == 0 {
            continue;
        }
        if !is_known(&other) {
            events.found += 1;
        }
        found.remove(best);
        events.matched += 1;
        let edge_known = |outside: Option<usize>| outside.and_then(|frame| *truth.get(frame)?) == Some(false);
        let error = |found: usize, true_frame: usize| (found as f64 - true_frame as f64) * frame_time;
        if edge_known(plant.start.checked_sub(1)) {
            events.onset_errors.push(error(other.start, plant.start));
        }
        if edge_known(Some(plant.end)) {
            events.offset_errors.push(error(other.end, plant.end));
        }
    }
    events
}

impl Events {
    /// Precision, recall, F1 and errors.
    pub fn score(&self) -> EventScore {
        let share = |of: usize| if of == 0 { 1.0 } else { self.matched as f64 / of as f64 };
        let (precision, recall) = (share(self.found), share(self.total));
        let amounts = |errors: &[f64]| errors.iter().map(|error| error.abs()).collect::<Vec<_>>();
        EventScore {
            precision,
            recall,
            f1: if precision + recall > 0.0 { 2.0 * precision * recall / (precision + recall) } else { 0.0 },
            onset: percentile(&self.onset_errors, 0.5),
            offset: percentile(&self.offset_errors, 0.5),
            onset_95: percentile(&amounts(&self.onset_errors), 0.95),
            offset_95: percentile(&amounts(&self.offset_errors), 0.95),
        }
    }
}

impl AddAssign for Events {
    fn add_assign(&mut self, other: Events) {
        self.matched += other.matched;
        self.found += other.found;
        self.total += other.total;
        self.onset_errors.extend(other.onset_errors);
        self.offset_errors.extend(other.offset_errors);
    }
}

fn runs(frames: usize, planted: impl Fn(usize) -> bool) -> Vec<Range<usize>> {
    crate::intervals::intervals(&(0..frames).map(planted).collect::<Vec<_>>())
}

/// The value below which `share` of the values lie; 0 where there are none.
fn percentile(values: &[f64], share: f64) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    let place = (share * sorted.len().saturating_sub(1) as f64).round() as usize;
    sorted.get(place).copied().unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn score(found: &str, truth: &str) -> Events {
        let truth: Vec<_> = truth.chars().map(|c| (c != '?').then_some(c == '#')).collect();
        let labels: Vec<bool> = found.chars().map(|c| c == '#').collect();
        events(&labels, &truth, 0.01)
    }

    #[test]
    fn plants_match_by_half_of_the_longer() {
        let events = score("..###....#######", "..####......####");
        assert_eq!((events.matched, events.found, events.total), (2, 2, 2));
        assert_eq!(events.onset_errors, [0.0, -0.03]);
        // The second ends with the clip: nobody knows where.
        assert_eq!(events.offset_errors, [-0.01]);
        assert_eq!(score("..#.....", "..####..").matched, 0);
        let result = events.score();
        assert_eq!((result.precision, result.recall, result.f1), (1.0, 1.0, 1.0));
    }

    #[test]
    fn unknown_frames_count_for_nothing() {
        let events = score("####....####", "????....##??");
        assert_eq!((events.matched, events.found, events.total), (1, 1, 1));
        assert_eq!((events.onset_errors.len(), events.offset_errors.len()), (1, 0));
        assert_eq!(score("####....", "........").score().precision, 0.0);
    }
}
