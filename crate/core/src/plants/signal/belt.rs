//! Velocity of the belt of a treadmill. Cycles of characters that walk or run in place are on such a belt, too.
//!
//! The body stays where it is, and a toe that is low moves with the belt: at one velocity, which both feet
//! have, and which they have more often than they rest. The contacts of a run are short, and toes in swing may
//! have a constant velocity, too, so that the velocity is taken from the lowest toes.
//!
//! The constants were chosen on generated treadmills (seeds 20 to 22), the maximum travel on a platform at 0.6 m/s
//! (seeds 10 and 11).

use nalgebra::Vector3;

use crate::numeric::{self, stats};

/// Interval at which the velocity is estimated, and half-width of the window, in seconds: at least one stride
/// of a slow walk.
const INTERVAL: f64 = 0.5;
const WINDOW: f64 = 1.4;
/// Half-width of the window in which feet on the belt and resting feet are counted, in seconds: a stride.
const COUNT_WINDOW: f64 = 0.6;
/// Speed of the ground that is as likely as rest, in leg lengths per second. The median speed of
/// planted feet is 0.04 to 0.2 (generated motion, seed 0).
pub(super) const REST_SPEED: f64 = 0.2;
/// Minimum speed of a belt, in leg lengths per second; the median of the slower foot finds slower ground.
const MIN_SPEED: f64 = 0.22;
/// Maximum difference of a velocity from that of the belt, as a fraction of its speed, …
const MAX_DEVIATION: f64 = 0.25;
/// … and if the velocities of low toes are as different because of noise. A circular movement has velocities
/// that differ as little near its lowest point, but for less time than [`MIN_FRACTION`].
const MAX_NOISY_DEVIATION: f64 = 0.4;
/// Minimum fraction of the time in which each foot has the velocity of the belt: 0.22 in a sprint, and 0.55 in
/// a walk (generated motion, seeds 20 to 22).
const MIN_FRACTION: f64 = 0.15;
/// Minimum fraction of that part of the time in which a toe is low.
const MIN_LOW_FRACTION: f64 = 0.5;
/// Fraction of the samples of a foot that count as low.
const LOW: f64 = 0.2;
/// Maximum mean velocity of the toes, which is that of the body, as a fraction of the speed of the belt.
const MAX_TRAVEL: f64 = 0.3;

/// Velocity and height of a toe, in file units and seconds.
#[derive(Clone, Copy)]
pub(super) struct ToeSample {
    pub(super) velocity: Vector3<f64>,
    pub(super) height: f64,
}

/// The velocity of a belt in a window, and the maximum difference of velocities from it.
#[derive(Clone, Copy)]
struct Belt {
    velocity: Vector3<f64>,
    max_deviation: f64,
}

impl Belt {
    /// Returns the velocity of the belt at a time between two estimates, at a fraction from 0 to 1.
    fn between(self, next: Belt, fraction: f64) -> Belt {
        Belt {
            velocity: self.velocity.lerp(&next.velocity, fraction),
            max_deviation: self.max_deviation.max(next.max_deviation),
        }
    }

    /// True if a toe has the velocity of the belt.
    fn carries(&self, toe: &ToeSample) -> bool {
        (toe.velocity - self.velocity).norm() < self.max_deviation
    }

    /// Returns the number of toes that have the velocity of the belt.
    fn carried(&self, toes: &[ToeSample]) -> usize {
        toes.iter().filter(|toe| self.carries(toe)).count()
    }

    /// True if the toes that have the velocity of the belt are lower than the others, on average.
    fn carries_low_toes(&self, toes: &[ToeSample]) -> bool {
        // By class: sum of heights, and number of toes.
        let mut classes = [(0.0, 0.0); 2];
        for toe in toes {
            let (height, count) = &mut classes[usize::from(self.carries(toe))];
            *height += toe.height;
            *count += 1.0;
        }
        let [others, carried] = classes.map(|(height, count)| height / count);
        carried < others
    }

    /// True if more toes have the velocity of the belt than rest.
    fn moves(&self, toes: &[ToeSample]) -> bool {
        let rest = Belt { velocity: Vector3::zeros(), ..*self };
        self.carried(toes) > rest.carried(toes)
    }
}

/// Returns the velocity of the belt at each sample of both toes; zero where there is none.
///
/// `sample_time` is the time between two samples, in seconds.
pub(super) fn velocities(toes: &[[ToeSample; 2]], leg: f64, sample_time: f64) -> Vec<Vector3<f64>> {
    let samples = |seconds: f64| (seconds / sample_time).round() as usize;
    let (interval, last) = (samples(INTERVAL).max(1), toes.len() - 1);
    let estimate =
        |index: usize| estimate(numeric::around(toes, (index * interval).min(last), samples(WINDOW)), leg);
    let estimates: Vec<Option<Belt>> = (0..=last.div_ceil(interval)).map(estimate).collect();
    let at = |sample: usize| {
        let (index, rest) = (sample / interval, sample % interval);
        let next = estimates[(index + 1).min(estimates.len() - 1)];
        let belt = match (estimates[index], next) {
            (Some(belt), Some(next)) => belt.between(next, rest as f64 / interval as f64),
            (belt, next) => belt.or(next)?,
        };
        let near = numeric::around(toes, sample, samples(COUNT_WINDOW)).as_flattened();
        belt.moves(near).then_some(belt.velocity)
    };
    (0..toes.len()).map(|sample| at(sample).unwrap_or_default()).collect()
}

/// Returns the median velocity of low toes, if that of a belt.
fn estimate(toes: &[[ToeSample; 2]], leg: f64) -> Option<Belt> {
    let feet = [0, 1].map(|foot| toes.iter().map(|pair| pair[foot]).collect::<Vec<_>>());
    let low = feet.each_ref().map(|toes| low_toes(toes));
    let all_low = low.concat();
    let velocity = Vector3::from_fn(|axis, _| {
        stats::nearest_percentile(all_low.iter().map(|toe| toe.velocity[axis]).collect(), 0.5)
    });
    let speed = velocity.norm();
    let deviations = all_low.iter().map(|toe| (toe.velocity - velocity).norm()).collect();
    let noisy_deviation = (2.0 * stats::nearest_percentile(deviations, 0.5)).min(MAX_NOISY_DEVIATION * speed);
    let max_deviation = (MAX_DEVIATION * speed).max(noisy_deviation).max(REST_SPEED * leg);
    let belt = Belt { velocity, max_deviation };

    let has_belt = |(toes, low): (&Vec<ToeSample>, &Vec<ToeSample>)| {
        belt.carried(toes) as f64 > MIN_FRACTION * toes.len() as f64
            && belt.carried(low) as f64 > MIN_LOW_FRACTION * low.len() as f64
            && belt.moves(toes)
            && belt.carries_low_toes(toes)
    };
    let travel: Vector3<f64> = toes.as_flattened().iter().map(|toe| toe.velocity).sum();
    let is_belt = speed > MIN_SPEED * leg
        && travel.norm() < MAX_TRAVEL * speed * (2 * toes.len()) as f64
        && feet.iter().zip(&low).all(has_belt);
    is_belt.then_some(belt)
}

/// Returns the lowest samples of a toe.
fn low_toes(toes: &[ToeSample]) -> Vec<ToeSample> {
    let height = stats::nearest_percentile(toes.iter().map(|toe| toe.height).collect(), LOW);
    toes.iter().filter(|toe| toe.height <= height).copied().collect()
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    const RATE: f64 = 30.0;

    /// Returns samples of ten seconds of two toes with the same motion, half a cycle apart; `toe` returns velocity
    /// and height by the phase of the cycle.
    fn samples(cycle: f64, toe: impl Fn(f64) -> (Vector3<f64>, f64)) -> Vec<[ToeSample; 2]> {
        let at = |phase: f64| {
            let (velocity, height) = toe(phase.rem_euclid(1.0));
            ToeSample { velocity, height }
        };
        let phase = |sample: usize| sample as f64 / (RATE * cycle);
        (0..300).map(|sample| [at(phase(sample)), at(phase(sample) + 0.5)]).collect()
    }

    /// Velocity and height of a toe that is on a belt for a fraction of the cycle and then swings forward.
    fn gait(phase: f64, stance: f64, belt: f64) -> (Vector3<f64>, f64) {
        if phase < stance {
            return (Vector3::z() * -belt, 0.0);
        }
        let swing = (phase - stance) / (1.0 - stance);
        let peak = 2.0 * belt / (1.0 - stance);
        (Vector3::z() * (peak * (0.5 * TAU * swing).sin().powi(2) - belt), 0.1 * (0.5 * TAU * swing).sin())
    }

    fn belts(toes: &[[ToeSample; 2]]) -> Vec<f64> {
        velocities(toes, 1.0, 1.0 / RATE).iter().map(|velocity| -velocity.z).collect()
    }

    #[test]
    fn belts_of_walks_and_runs_are_found() {
        for (cycle, stance, belt) in [(2.0, 0.65, 0.25), (1.1, 0.6, 1.2), (0.7, 0.35, 3.0), (0.55, 0.25, 5.0)]
        {
            let found = belts(&samples(cycle, |phase| gait(phase, stance, belt)));
            assert!(found.iter().all(|found| (found - belt).abs() < 0.02 * belt), "{belt} m/s: {found:?}");
        }
    }

    #[test]
    fn one_cycle_in_place_is_on_a_belt() {
        let toes = samples(0.7, |phase| gait(phase, 0.35, 3.0));
        for start in (0..21).step_by(3) {
            let found = belts(&toes[start..start + 21]);
            assert!(found.iter().all(|found| (found - 3.0).abs() < 0.06), "from sample {start}: {found:?}");
        }
    }

    #[test]
    fn ground_at_rest_is_no_belt() {
        let overground = |phase| {
            let (velocity, height) = gait(phase, 0.6, 1.2);
            (velocity + Vector3::z() * 1.2, height)
        };
        assert!(belts(&samples(1.1, overground)).iter().all(|&belt| belt == 0.0));
        // Flat feet that are lowest in swing.
        let flat = |phase| {
            let (velocity, height) = overground(phase);
            (velocity, -0.1 * height)
        };
        assert!(belts(&samples(1.1, flat)).iter().all(|&belt| belt == 0.0));
    }

    #[test]
    fn feet_that_move_in_circles_are_not_on_a_belt() {
        let pedals = |phase: f64| {
            let (sin, cos) = (TAU * phase).sin_cos();
            (Vector3::new(0.0, sin, -cos) * 2.0, 0.3 - 0.3 * cos)
        };
        assert!(belts(&samples(1.0, pedals)).iter().all(|&belt| belt == 0.0));
    }

    #[test]
    fn a_belt_stops_when_the_feet_rest() {
        let mut toes = samples(1.1, |phase| gait(phase, 0.6, 1.2));
        toes[200..].fill([ToeSample { velocity: Vector3::zeros(), height: 0.0 }; 2]);
        let found = belts(&toes);
        assert!(found[..180].iter().all(|belt| (belt - 1.2).abs() < 0.05), "{found:?}");
        assert!(found[220..].iter().all(|&belt| belt == 0.0), "{found:?}");
    }
}
