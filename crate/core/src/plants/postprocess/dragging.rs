//! Dragged feet: low and slow like planted feet, but moving along the ground.
//!
//! In a single frame a dragged foot looks like a planted foot with noise; the difference is the
//! distance it travels. Planted feet stand on the same ground (a floor, a treadmill or a moving platform), so the
//! distance between them is constant. If both feet are labelled as planted and separate
//! steadily and without a step, the foot that moves is dragged.

use std::ops::Range;

use nalgebra::Vector3;

use crate::kinematics::Track;
use crate::plants::{Feet, FootLabels};

/// Speed of a step, in leg lengths per second: a foot that is not planted and faster takes a step.
const STEP_SPEED: f64 = 1.0;
/// Separation that indicates dragging, in leg lengths; planted feet slide less.
const SEPARATION: f64 = 0.4;
/// Minimum and maximum duration of the separation, in seconds with both feet planted. Landings and
/// slips are shorter; slower separation is drift.
const MIN_DURATION: f64 = 0.6;
const MAX_DURATION: f64 = 3.0;
/// Minimum fraction of [`SEPARATION`] in either half of the time: a slip ends, a dragged foot
/// continues.
const MIN_HALF_SEPARATION: f64 = 0.25;

/// Minimum slack, as a fraction of [`SEPARATION`], that allows skipping samples of feet that are
/// far from separated.
const MIN_SLACK: f64 = 0.25;

/// Removes the contact of dragged feet within one span of motion.
pub(crate) fn drop_dragged(feet: &Feet, span: &Range<usize>, contact: &mut [FootLabels; 2]) {
    let both_planted = |frame: &usize| contact.iter().all(|labels| labels.planted[*frame]);
    let both_planted_frames: Vec<usize> = span.clone().filter(both_planted).collect();
    let stance_ids = contact.each_ref().map(|labels| stance_ids(labels, span, STEP_SPEED * feet.leg));
    let both = BothPlanted::new(feet, &both_planted_frames);
    for foot in 0..2 {
        let stance_id = |index: usize| stance_ids[foot][both_planted_frames[index] - span.start];
        let labels = &mut contact[foot];
        // The ranges come from the last to the first and overlap within a stance, whose frames from `done` on
        // are processed already.
        let (mut stance, mut done) = (None, span.end);
        for (from, to) in both.separations(feet, foot, stance_id) {
            if stance.replace(stance_id(from)) != Some(stance_id(from)) {
                done = span.end;
            }
            // While the other foot is up, the frames take the label of their neighbours.
            let start = from.checked_sub(1).map_or(span.start, |before| both_planted_frames[before] + 1);
            let end = both_planted_frames.get(to + 1).copied().unwrap_or(span.end);
            for frame in start..end.min(done) {
                if labels.planted[frame] && stance_ids[foot][frame - span.start] == stance_id(from) {
                    labels.planted[frame] = false;
                    // The clustering disagrees.
                    labels.confidence[frame] = 0.5;
                }
            }
            done = start;
        }
    }
}

/// Returns a number per frame of a span that increases when the foot takes a step.
fn stance_ids(labels: &FootLabels, span: &Range<usize>, step_speed: f64) -> Vec<usize> {
    let is_step = labels.planted[span.clone()]
        .iter()
        .zip(&labels.speed[span.clone()])
        .map(|(planted, speed)| !planted && f64::from(*speed) > step_speed);
    is_step
        .scan(0, |count, is_step| {
            *count += usize::from(is_step);
            Some(*count)
        })
        .collect()
}

/// Both feet in the frames in which both are planted; its methods use indices into these frames.
struct BothPlanted {
    /// Paths of ankle and toe of each foot; motion in other frames is left out.
    paths: [[Track; 2]; 2],
    /// Maximum separation of two joints from one index to the next.
    max_step: f64,
}

impl BothPlanted {
    fn new(feet: &Feet, both_planted_frames: &[usize]) -> BothPlanted {
        let path = |track: &Track| {
            let mut position = Vector3::zeros();
            let step = |index: usize| {
                let frame = both_planted_frames[index];
                if index > 0 && both_planted_frames[index - 1] + 1 == frame {
                    position += track[frame] - track[frame - 1];
                }
                position
            };
            (0..both_planted_frames.len()).map(step).collect()
        };
        let paths = feet.tracks.each_ref().map(|foot| [path(&foot.ankle), path(&foot.toe)]);
        let [left, right] = &paths;
        let step =
            |a: &Track, b: &Track, to: usize| ((a[to] - a[to - 1]) - (b[to] - b[to - 1])).norm_squared();
        let max_step = (1..both_planted_frames.len())
            .flat_map(|to| left.iter().flat_map(move |a| right.iter().map(move |b| step(a, b, to))))
            .fold(0.0, |max, step| if step > max { step } else { max })
            .sqrt();
        BothPlanted { paths, max_step }
    }

    /// Returns the shortest ranges, as first and last index, in which a foot is dragged away from
    /// the other. `stance_id` numbers the periods between two steps of the foot.
    fn separations(
        &self,
        feet: &Feet,
        foot: usize,
        stance_id: impl Fn(usize) -> usize,
    ) -> Vec<(usize, usize)> {
        let count = self.paths[foot][0].len();
        let (min_frames, max_frames) = (feet.frames_in(MIN_DURATION), feet.frames_in(MAX_DURATION));
        let distance = SEPARATION * feet.leg;
        let mut earliest = count;
        let mut stance_end = count;
        let mut separations = Vec::new();
        let mut slack = 0.0;
        for from in (0..count).rev() {
            if from + 1 < count && stance_id(from + 1) != stance_id(from) {
                stance_end = from + 1;
            }
            // A range that contains a shorter one begins or ends at rest.
            let end = earliest.min(from + max_frames + 1).min(stance_end);
            // From the next index on the separation was larger by at most `max_step`.
            slack -= self.max_step;
            if slack > 0.0 {
                continue;
            }
            let to = match self.first_separated(from, end, distance) {
                Ok(to) => to,
                Err(remaining) => {
                    slack = remaining;
                    continue;
                }
            };
            earliest = to;
            let middle = usize::midpoint(from, to);
            let is_steady = self.separation(from, middle).min(self.separation(middle, to))
                > MIN_HALF_SEPARATION * distance;
            let is_mover = self.distance_moved(foot, from, to) > self.distance_moved(1 - foot, from, to);
            if to - from >= min_frames && is_steady && is_mover {
                separations.push((from, to));
            }
        }
        separations
    }

    /// Returns the first index between `from` and `end` at which the feet are separated by more
    /// than `distance`; otherwise a lower bound of the distance that is missing.
    fn first_separated(&self, from: usize, end: usize, distance: f64) -> Result<usize, f64> {
        let mut min_slack = MIN_SLACK * distance;
        let mut to = from + 1;
        while to < end {
            let remaining = distance - self.separation(from, to);
            if remaining < 0.0 {
                return Ok(to);
            }
            min_slack = fmin(min_slack, remaining / 2.0);
            // Until that index the slack cannot fall below `min_slack`.
            to = to.saturating_add(((remaining - min_slack) / self.max_step) as usize).saturating_add(1);
        }
        Err(min_slack)
    }

    /// Returns the separation of the feet between two indices: the minimum over the joints, as
    /// ankles rotate about toes.
    fn separation(&self, from: usize, to: usize) -> f64 {
        let [left, right] = &self.paths;
        let pairs = left.iter().flat_map(|left| right.iter().map(move |right| (left, right)));
        pairs
            .map(|(left, right)| ((left[to] - left[from]) - (right[to] - right[from])).norm_squared())
            .fold(f64::INFINITY, fmin)
            .sqrt()
    }

    /// Returns the distance that a foot moves between two indices.
    fn distance_moved(&self, foot: usize, from: usize, to: usize) -> f64 {
        self.paths[foot].iter().map(|path| (path[to] - path[from]).norm()).fold(f64::INFINITY, fmin)
    }
}

/// Returns the smaller value. In WebAssembly, calling `min` costs more than the comparison.
fn fmin(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants::FootTracks;
    use crate::plants::signal::velocity;
    use crate::skeleton::Up;

    const RATE: f64 = 60.0;

    /// Position at a time, in leg lengths and seconds.
    type Path<'a> = &'a dyn Fn(f64) -> Vector3<f64>;

    /// Returns the contact that remains of two feet.
    fn remaining_contact(seconds: f64, rate: f64, toes: [Path; 2], ankles: [Path; 2]) -> [Vec<bool>; 2] {
        let (feet, mut contact) = labelled(seconds, rate, toes, ankles);
        drop_dragged(&feet, &(0..feet.frame_count()), &mut contact);
        contact.map(|labels| labels.planted)
    }

    /// Returns two feet, which are labelled as planted while their toes are slower than two leg lengths per
    /// second. Ankles are relative to toes.
    fn labelled(seconds: f64, rate: f64, toes: [Path; 2], ankles: [Path; 2]) -> (Feet, [FootLabels; 2]) {
        let frames = (seconds * rate) as usize;
        let track = |path: Path| -> Track { (0..frames).map(|frame| path(frame as f64 / rate)).collect() };
        let feet = Feet {
            tracks: [0, 1].map(|foot| FootTracks {
                ankle: track(&|time| toes[foot](time) + ankles[foot](time)),
                toe: track(toes[foot]),
                tip: None,
            }),
            hips: track(toes[0]),
            up: Up::Y,
            leg: 1.0,
            metres_per_unit: 1.0,
            frame_time: 1.0 / rate,
        };
        let contact = feet.tracks.each_ref().map(|foot| {
            let velocities = velocity::central_difference(&foot.toe, feet.frame_time);
            let speed: Vec<f32> = velocities.iter().map(|velocity| velocity.norm() as f32).collect();
            let planted = speed.iter().map(|&speed| speed < 2.0).collect();
            FootLabels {
                planted,
                confidence: vec![1.0; frames],
                height: vec![0.0; frames],
                speed,
                edges: Vec::new(),
            }
        });
        (feet, contact)
    }

    fn at_rest(_: f64) -> Vector3<f64> {
        Vector3::x()
    }

    fn rigid(_: f64) -> Vector3<f64> {
        Vector3::new(0.0, 0.08, -0.13)
    }

    /// True if nothing is removed from two feet that are planted in all frames.
    fn all_contact_remains(toes: [Path; 2]) -> bool {
        remaining_contact(30.0, RATE, toes, [&rigid; 2]).concat().iter().all(|&planted| planted)
    }

    #[test]
    fn a_foot_that_creeps_away_from_a_standing_foot_is_dragged() {
        for rate in [24.0, 60.0, 250.0] {
            let creeping = |time: f64| Vector3::z() * 0.25 * (time - 4.0).clamp(0.0, 6.0);
            let [creeping, standing] = remaining_contact(14.0, rate, [&creeping, &at_rest], [&rigid; 2]);
            assert!(standing.iter().all(|&planted| planted));
            for (frame, planted) in creeping.iter().enumerate() {
                let time = frame as f64 / rate;
                if (time - 4.0).abs() > 0.1 && (time - 10.0).abs() > 0.1 {
                    assert_eq!(*planted, !(4.0..10.0).contains(&time), "{time:.2} s at {rate} Hz");
                }
            }
        }
    }

    #[test]
    fn spans_are_independent() {
        let creeping = |time: f64| Vector3::z() * 0.25 * (time % 14.0 - 4.0).clamp(0.0, 6.0);
        let (feet, mut contact) = labelled(28.0, RATE, [&creeping, &at_rest], [&rigid; 2]);
        let half = feet.frame_count() / 2;
        for span in [0..half, half..2 * half] {
            drop_dragged(&feet, &span, &mut contact);
        }
        let (first, second) = contact[0].planted.split_at(half);
        // The speed of the frames at the jump is not that of the motion.
        let inner = |labels: &[bool]| labels[1..half - 1].to_vec();
        assert!(inner(first) == inner(second) && inner(first).contains(&false));
    }

    #[test]
    fn slips_drift_and_sway_are_not_dragging() {
        let slip = |time: f64| Vector3::z() * 0.5 * (time - 10.0).clamp(0.0, 0.6);
        let missed_step = |time: f64| Vector3::z() * (time - 10.0).clamp(0.0, 0.5);
        let drift = |time: f64| Vector3::x() * 0.06 * time;
        let sway = |time: f64| Vector3::z() * 0.15 * (2.0 * time).sin();
        for path in [&slip as Path, &missed_step, &drift, &sway] {
            assert!(all_contact_remains([path, &at_rest]) && all_contact_remains([&at_rest, path]));
        }
    }

    #[test]
    fn moving_ground_is_not_dragging() {
        for speed in [0.05, 0.3, 0.8, 1.3] {
            let belt = |time: f64| Vector3::z() * -speed * time;
            let accelerating = |time: f64| Vector3::z() * -speed * time * time / 60.0;
            let platform =
                |time: f64| Vector3::new((speed * time).sin(), 0.1 * time.cos(), speed * time.sin());
            for path in [&belt as Path, &accelerating, &platform] {
                assert!(all_contact_remains([path, &|time| path(time) + Vector3::x()]), "{speed}");
            }
        }
    }

    #[test]
    fn a_foot_that_rotates_about_its_toe_is_planted() {
        let turning = |time: f64| Vector3::new(-0.5 * (0.6 * time).sin(), 0.08, -0.5 * (0.6 * time).cos());
        let contact = remaining_contact(5.0, RATE, [&at_rest, &|_| Vector3::zeros()], [&turning, &rigid]);
        assert!(contact.concat().iter().all(|&planted| planted));
    }

    /// Steps of 0.6 leg lengths in 0.2 s, one per second; each foot rests during the other's steps.
    fn walk(time: f64, ahead: f64) -> f64 {
        let time = time + ahead;
        0.6 * (time.floor() + ((time.fract() - 0.8) / 0.2).max(0.0))
    }

    #[test]
    fn skating_between_steps_is_not_dragging() {
        // Skating moves each plant by a quarter of a leg length.
        let skating = |time: f64| Vector3::z() * (walk(time, 0.0) + 0.3 * time);
        let walking = |time: f64| Vector3::z() * walk(time, 0.5);
        let contact = remaining_contact(20.0, RATE, [&skating, &walking], [&rigid; 2]);
        let fraction =
            |labels: &[bool]| labels.iter().filter(|&&planted| planted).count() as f64 / labels.len() as f64;
        assert!(
            contact.iter().all(|labels| (fraction(labels) - 0.8).abs() < 0.05),
            "{:?}",
            contact.map(|l| fraction(&l))
        );
    }

    #[test]
    fn a_foot_that_never_steps_is_dragged() {
        let dragged = |time: f64| Vector3::z() * 0.6 * time;
        let walking = |time: f64| Vector3::z() * walk(time, 0.0);
        let [dragged, walking] = remaining_contact(20.0, RATE, [&dragged, &walking], [&rigid; 2]);
        assert!(dragged.iter().all(|planted| !planted));
        assert!(walking.iter().filter(|&&planted| planted).count() > 900);
    }
}
