//! Feet that are dragged: low and slow like planted ones, but bound for somewhere.
//!
//! Frame by frame, a foot that creeps is a planted one with noise. What tells them
//! apart is where it gets to. Feet that stand, stand on the same ground, be it a
//! floor, a belt or a platform on the move: they do not part. So where both feet are
//! labelled planted and part all the same, steadily and without a step, the one that
//! moves is dragged.

use std::ops::Range;

use nalgebra::Vector3;

use crate::kinematics::Track;
use crate::plants::{Feet, FootLabels};

/// Off the ground and faster than this, in legs per second, a foot takes a step.
const STEP: f64 = 1.0;
/// How far feet part if one is dragged, in legs: further than plants slide.
const PARTED: f64 = 0.4;
/// The least and the most time that this takes, in seconds in which both are labelled
/// planted: landings and slips are over sooner, and what takes longer is drift.
const SHORTEST: f64 = 0.6;
const LONGEST: f64 = 3.0;
/// The least share of [`PARTED`] in either half of the time: a slip comes to rest, a dragged foot goes on.
const STEADY: f64 = 0.25;

/// What is left of [`PARTED`] where feet are far from parted, as a share: then places are passed over.
const ROOM: f64 = 0.25;

/// Takes the contact of dragged feet away, in one piece of the motion.
pub(crate) fn drop_dragged(feet: &Feet, piece: &Range<usize>, contact: &mut [FootLabels; 2]) {
    let both = |frame: &usize| contact.iter().all(|labels| labels.planted[*frame]);
    let shared: Vec<usize> = piece.clone().filter(both).collect();
    let steps = contact.each_ref().map(|labels| steps(labels, STEP * feet.leg));
    let stand = Stand::of(feet, &shared);
    for foot in 0..2 {
        let stay = |place: usize| steps[foot][shared[place]];
        let labels = &mut contact[foot];
        for (from, to) in stand.partings(feet, foot, stay) {
            // While the other foot is up there is no telling: those frames are as their neighbours.
            let start = from.checked_sub(1).map_or(piece.start, |before| shared[before] + 1);
            let end = shared.get(to + 1).copied().unwrap_or(piece.end);
            let is_dragged = |frame: &usize| labels.planted[*frame] && steps[foot][*frame] == stay(from);
            for frame in (start..end).filter(is_dragged).collect::<Vec<_>>() {
                labels.planted[frame] = false;
                // The clustering says otherwise.
                labels.confidence[frame] = 0.5;
            }
        }
    }
}

/// A number for each frame of the clip that is another one once a foot has taken a step.
fn steps(labels: &FootLabels, fast: f64) -> Vec<usize> {
    let is_step =
        labels.planted.iter().zip(&labels.speed).map(|(planted, speed)| !planted && f64::from(*speed) > fast);
    is_step
        .scan(0, |count, is_step| {
            *count += usize::from(is_step);
            Some(*count)
        })
        .collect()
}

/// Both feet in the frames in which both are labelled planted, which its methods count by place.
struct Stand {
    /// The ways of ankle and toe of each foot; what they move in other frames is left out.
    ways: [[Track; 2]; 2],
    /// The furthest that two joints part from one place to the next.
    fastest: f64,
}

impl Stand {
    fn of(feet: &Feet, shared: &[usize]) -> Stand {
        let way = |track: &Track| {
            let mut place = Vector3::zeros();
            let step = |index: usize| {
                let frame = shared[index];
                if index > 0 && shared[index - 1] + 1 == frame {
                    place += track[frame] - track[frame - 1];
                }
                place
            };
            (0..shared.len()).map(step).collect()
        };
        let ways = feet.tracks.each_ref().map(|foot| [way(&foot.ankle), way(&foot.toe)]);
        let [left, right] = &ways;
        let step =
            |a: &Track, b: &Track, to: usize| ((a[to] - a[to - 1]) - (b[to] - b[to - 1])).norm_squared();
        let fastest = (1..shared.len())
            .flat_map(|to| left.iter().flat_map(move |a| right.iter().map(move |b| step(a, b, to))))
            .fold(0.0, |most, step| if step > most { step } else { most })
            .sqrt();
        Stand { ways, fastest }
    }

    /// The shortest stretches in which a foot is dragged away from the other, as first and last
    /// place; `stay` numbers its stays between two steps.
    fn partings(&self, feet: &Feet, foot: usize, stay: impl Fn(usize) -> usize) -> Vec<(usize, usize)> {
        let count = self.ways[foot][0].len();
        let (shortest, longest) = (feet.frames_in(SHORTEST), feet.frames_in(LONGEST));
        let parted = PARTED * feet.leg;
        let mut earliest = count;
        let mut stay_end = count;
        let mut partings = Vec::new();
        let mut room = 0.0;
        for from in (0..count).rev() {
            if from + 1 < count && stay(from + 1) != stay(from) {
                stay_end = from + 1;
            }
            // One that holds a shorter one begins or ends at rest.
            let end = earliest.min(from + longest + 1).min(stay_end);
            // From the place after this one they parted by so much less.
            room -= self.fastest;
            if room > 0.0 {
                continue;
            }
            let to = match self.first_parted(from, end, parted) {
                Ok(to) => to,
                Err(left) => {
                    room = left;
                    continue;
                }
            };
            earliest = to;
            let middle = usize::midpoint(from, to);
            let is_steady = self.parted(from, middle).min(self.parted(middle, to)) > STEADY * parted;
            let is_mover = self.moved(foot, from, to) > self.moved(1 - foot, from, to);
            if to - from >= shortest && is_steady && is_mover {
                partings.push((from, to));
            }
        }
        partings
    }

    /// The first place after `from` and before `end` to which the feet part by more than `far`; if
    /// there is none, by how much less they part at least.
    fn first_parted(&self, from: usize, end: usize, far: f64) -> Result<usize, f64> {
        let mut least = ROOM * far;
        let mut to = from + 1;
        while to < end {
            let left = far - self.parted(from, to);
            if left < 0.0 {
                return Ok(to);
            }
            least = lesser(least, left / 2.0);
            // Sooner they cannot have less room than that.
            to = to.saturating_add(((left - least) / self.fastest) as usize).saturating_add(1);
        }
        Err(least)
    }

    /// How far the feet part between two places: by the joints that do least, as ankles turn about toes.
    fn parted(&self, from: usize, to: usize) -> f64 {
        let [left, right] = &self.ways;
        let pairs = left.iter().flat_map(|left| right.iter().map(move |right| (left, right)));
        pairs
            .map(|(left, right)| ((left[to] - left[from]) - (right[to] - right[from])).norm_squared())
            .fold(f64::INFINITY, lesser)
            .sqrt()
    }

    /// How far a foot moves between two places.
    fn moved(&self, foot: usize, from: usize, to: usize) -> f64 {
        self.ways[foot].iter().map(|way| (way[to] - way[from]).norm()).fold(f64::INFINITY, lesser)
    }
}

/// The smaller of two; a call to `min` costs more than the comparison on wasm.
fn lesser(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants::FootTracks;
    use crate::plants::signal::velocity;
    use crate::skeleton::Up;

    const RATE: f64 = 60.0;

    /// Where something is at a time, in legs and seconds.
    type Way<'a> = &'a dyn Fn(f64) -> Vector3<f64>;

    /// What is left of the contact of two feet, labelled planted where their toes are slower
    /// than two legs per second; ankles are given from the toes on.
    fn left_of(seconds: f64, rate: f64, toes: [Way; 2], ankles: [Way; 2]) -> [Vec<bool>; 2] {
        let frames = (seconds * rate) as usize;
        let track = |way: Way| -> Track { (0..frames).map(|frame| way(frame as f64 / rate)).collect() };
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
        let mut contact = feet.tracks.each_ref().map(|foot| {
            let velocities = velocity::central_difference(&foot.toe, feet.frame_time);
            let speed: Vec<f32> = velocities.iter().map(|velocity| velocity.norm() as f32).collect();
            let planted = speed.iter().map(|&speed| speed < 2.0).collect();
            FootLabels { planted, confidence: vec![1.0; frames], height: vec![0.0; frames], speed }
        });
        drop_dragged(&feet, &(0..frames), &mut contact);
        contact.map(|labels| labels.planted)
    }

    fn at_rest(_: f64) -> Vector3<f64> {
        Vector3::x()
    }

    fn rigid(_: f64) -> Vector3<f64> {
        Vector3::new(0.0, 0.08, -0.13)
    }

    /// Whether nothing is taken from two feet that are planted throughout.
    fn stay(toes: [Way; 2]) -> bool {
        left_of(30.0, RATE, toes, [&rigid; 2]).concat().iter().all(|&planted| planted)
    }

    #[test]
    fn a_foot_that_creeps_away_from_one_that_stands_is_dragged_from_where_it_sets_out() {
        for rate in [24.0, 60.0, 250.0] {
            let creeping = |time: f64| Vector3::z() * 0.25 * (time - 4.0).clamp(0.0, 6.0);
            let [creeping, standing] = left_of(14.0, rate, [&creeping, &at_rest], [&rigid; 2]);
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
    fn slips_drift_and_sway_are_none() {
        let slip = |time: f64| Vector3::z() * 0.5 * (time - 10.0).clamp(0.0, 0.6);
        let missed_step = |time: f64| Vector3::z() * (time - 10.0).clamp(0.0, 0.5);
        let drift = |time: f64| Vector3::x() * 0.06 * time;
        let sway = |time: f64| Vector3::z() * 0.15 * (2.0 * time).sin();
        for way in [&slip as Way, &missed_step, &drift, &sway] {
            assert!(stay([way, &at_rest]) && stay([&at_rest, way]));
        }
    }

    #[test]
    fn ground_that_moves_carries_both_feet() {
        for speed in [0.05, 0.3, 0.8, 1.3] {
            let belt = |time: f64| Vector3::z() * -speed * time;
            let quicker_and_quicker = |time: f64| Vector3::z() * -speed * time * time / 60.0;
            let platform =
                |time: f64| Vector3::new((speed * time).sin(), 0.1 * time.cos(), speed * time.sin());
            for way in [&belt as Way, &quicker_and_quicker, &platform] {
                assert!(stay([way, &|time| way(time) + Vector3::x()]), "{speed}");
            }
        }
    }

    #[test]
    fn a_foot_that_turns_about_its_toe_stands() {
        let turning = |time: f64| Vector3::new(-0.5 * (0.6 * time).sin(), 0.08, -0.5 * (0.6 * time).cos());
        let left = left_of(5.0, RATE, [&at_rest, &|_| Vector3::zeros()], [&turning, &rigid]);
        assert!(left.concat().iter().all(|&planted| planted));
    }

    /// Steps of 0.6 legs and 0.2 s, one a second, each foot at rest for the others'.
    fn walk(time: f64, ahead: f64) -> f64 {
        let time = time + ahead;
        0.6 * (time.floor() + ((time.fract() - 0.8) / 0.2).max(0.0))
    }

    #[test]
    fn between_two_steps_plants_may_skate() {
        // Skating takes every plant a quarter of a leg on.
        let skating = |time: f64| Vector3::z() * (walk(time, 0.0) + 0.3 * time);
        let walking = |time: f64| Vector3::z() * walk(time, 0.5);
        let left = left_of(20.0, RATE, [&skating, &walking], [&rigid; 2]);
        let share =
            |labels: &[bool]| labels.iter().filter(|&&planted| planted).count() as f64 / labels.len() as f64;
        assert!(
            left.iter().all(|labels| (share(labels) - 0.8).abs() < 0.05),
            "{:?}",
            left.map(|l| share(&l))
        );
    }

    #[test]
    fn a_foot_that_never_steps_is_dragged_after_one_that_does() {
        let dragged = |time: f64| Vector3::z() * 0.6 * time;
        let walking = |time: f64| Vector3::z() * walk(time, 0.0);
        let [dragged, walking] = left_of(20.0, RATE, [&dragged, &walking], [&rigid; 2]);
        assert!(dragged.iter().all(|planted| !planted));
        assert!(walking.iter().filter(|&&planted| planted).count() > 900);
    }
}
