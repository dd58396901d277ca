//! Tilt of the ground against the up axis.
//!
//! Slopes, a wrong calibration and camera coordinates tilt the ground. The positions in which a foot rests on
//! it are then on a plane. A foot that is held in the air is not: it does not rest in several places, or not on
//! one plane.

use std::ops::Range;

use nalgebra::{Vector2, Vector3};

use crate::kinematics::Track;
use crate::plants::{Feet, FootTracks};

/// Duration of which the slowest position of a foot is used, if it is at rest, in seconds.
const REST_INTERVAL: f64 = 0.2;
/// Half-width of the differences that determine the speed, in seconds.
const SPEED_WINDOW: f64 = 0.03;
/// Maximum speed at rest, in leg lengths per second.
const REST_SPEED: f64 = 0.3;
/// Number of iterations of the weighted fit.
const ITERATIONS: usize = 12;
/// Height above the plane at which a position has a quarter of the weight, in leg lengths.
const FOOT_HEIGHT: f64 = 0.04;
/// Standard deviation of the positions along a direction below which its slope is unknown, in leg lengths.
const MIN_EXTENT: f64 = 0.03;
/// Minimum standard deviation of the heights of one foot, and maximum of their distances from the plane, in leg
/// lengths. The heights of level ground deviate by about 0.01 (generated motion, seeds 0 and 1), distances from
/// tilted ground by 0.004 to 0.012, and those of recorded dances on level floors by up to 0.02.
const MIN_DEVIATION: f64 = 0.015;
const MAX_RESIDUAL: f64 = 0.0125;
/// Maximum of these distances as a fraction of the deviation of the heights. Chosen on generated motion (seeds 0
/// and 1).
const MAX_RESIDUAL_FRACTION: f64 = 0.6;
/// Depth below the plane to which heights are limited, in leg lengths.
const MAX_DEPTH: f64 = 0.01;
/// Minimum slope: 4°. A smaller one raises a foot by less in one step than the swing does.
const MIN_SLOPE: f64 = 0.07;
/// Maximum slope: 27°. Stairs are steeper.
const MAX_SLOPE: f64 = 0.5;

/// Position of a toe at rest, in leg lengths.
struct Rest {
    foot: usize,
    position: Vector2<f64>,
    height: f64,
}

/// Plane of the ground, in leg lengths.
struct Plane {
    slope: Vector2<f64>,
    /// Height at the origin.
    height: f64,
}

/// Returns the feet with heights above the tilted ground; `None` if no tilt is found.
pub(crate) fn levelled(feet: &Feet, spans: &[Range<usize>]) -> Option<Feet> {
    let planes: Vec<Option<Plane>> = spans.iter().map(|span| plane(&rests(feet, span))).collect();
    if planes.iter().all(Option::is_none) {
        return None;
    }
    let mut tracks = feet.tracks.each_ref().map(|foot| FootTracks {
        ankle: foot.ankle.clone(),
        toe: foot.toe.clone(),
        tip: None,
    });
    let up = feet.up.vector();
    for (span, plane) in spans.iter().zip(planes) {
        let Some(plane) = plane else { continue };
        for track in tracks.iter_mut().flat_map(|foot| [&mut foot.ankle, &mut foot.toe]) {
            for position in &mut track[span.clone()] {
                let ground = plane.height * feet.leg + plane.slope.dot(&horizontal(feet, position));
                // A toe that swings through the ground is no lower ground.
                let above = (feet.up.height(position) - ground).max(-MAX_DEPTH * feet.leg);
                *position += up * (above - feet.up.height(position));
            }
        }
    }
    Some(Feet { tracks, hips: Track::new(), ..*feet })
}

fn horizontal(feet: &Feet, position: &Vector3<f64>) -> Vector2<f64> {
    let position = feet.up.to_y_up(*position);
    Vector2::new(position.x, position.z)
}

/// Returns the slowest position of each toe in every [`REST_INTERVAL`] if it is at rest.
fn rests(feet: &Feet, span: &Range<usize>) -> Vec<Rest> {
    let half = feet.frames_in(SPEED_WINDOW).max(1);
    let interval = feet.frames_in(REST_INTERVAL).max(1);
    let max_distance = REST_SPEED * feet.leg * (2 * half) as f64 * feet.frame_time;
    let mut rests = Vec::new();
    for start in (span.start + half..span.end.saturating_sub(half)).step_by(interval) {
        for (foot, tracks) in feet.tracks.iter().enumerate() {
            let mut least = max_distance * max_distance;
            let mut slowest = None;
            for frame in (start..(start + interval).min(span.end - half)).step_by(half) {
                let distance = (tracks.toe[frame + half] - tracks.toe[frame - half]).norm_squared();
                if distance < least {
                    (least, slowest) = (distance, Some(frame));
                }
            }
            rests.extend(slowest.map(|frame| {
                let toe = &tracks.toe[frame];
                let (position, height) = (horizontal(feet, toe) / feet.leg, feet.up.height(toe) / feet.leg);
                Rest { foot, position, height }
            }));
        }
    }
    rests
}

/// Returns the plane on which both feet rest, if it explains the heights at which each of them
/// rests in several places. Along a direction without extent, the slope is zero.
fn plane(rests: &[Rest]) -> Option<Plane> {
    let inertia = MIN_EXTENT * MIN_EXTENT;
    let mut weights = vec![1.0; rests.len()];
    let mut slope = Vector2::zeros();
    let mut height = 0.0;
    for _ in 0..ITERATIONS {
        let all = Moments::new(rests, &weights, |_| true)?;
        let [[a, b], [_, c]] = all.spread;
        let [a, c] = [a + inertia, c + inertia];
        slope =
            Vector2::new(c * all.rise.x - b * all.rise.y, a * all.rise.y - b * all.rise.x) / (a * c - b * b);
        height = all.height - slope.dot(&all.position);
        for (rest, weight) in rests.iter().zip(&mut weights) {
            let above = rest.height - height - slope.dot(&rest.position);
            // Nothing is below the ground.
            *weight = if above > 0.0 { (1.0 + (above / FOOT_HEIGHT).powi(2)).powi(-2) } else { 1.0 };
        }
    }
    let (mut total, mut before, mut after) = (0.0, 0.0, 0.0);
    for foot in 0..2 {
        let Some(of_foot) = Moments::new(rests, &weights, |rest| rest.foot == foot) else { continue };
        let [[a, b], [_, c]] = of_foot.spread;
        let explained = 2.0 * slope.dot(&of_foot.rise)
            - (a * slope.x * slope.x + 2.0 * b * slope.x * slope.y + c * slope.y * slope.y);
        total += of_foot.weight;
        before += of_foot.weight * of_foot.variance;
        after += of_foot.weight * (of_foot.variance - explained);
    }
    let is_plane = (MIN_SLOPE..MAX_SLOPE).contains(&slope.norm())
        && before > MIN_DEVIATION * MIN_DEVIATION * total
        && after < MAX_RESIDUAL * MAX_RESIDUAL * total
        && after < MAX_RESIDUAL_FRACTION * MAX_RESIDUAL_FRACTION * before;
    is_plane.then_some(Plane { slope, height })
}

/// Weighted moments of positions and heights.
struct Moments {
    weight: f64,
    position: Vector2<f64>,
    height: f64,
    /// Covariance of the positions.
    spread: [[f64; 2]; 2],
    /// Covariance of positions and heights.
    rise: Vector2<f64>,
    /// Variance of the heights.
    variance: f64,
}

impl Moments {
    /// Returns the moments of some rests; `None` if there are none.
    fn new(rests: &[Rest], weights: &[f64], is_used: impl Fn(&Rest) -> bool) -> Option<Moments> {
        // Relative to the first one, so that the distance from the origin does not matter.
        let origin = rests.first()?;
        let mut weight = 0.0;
        let mut sums = [0.0; 9];
        for (rest, w) in rests.iter().zip(weights).filter(|(rest, _)| is_used(rest)) {
            let (x, z) = (rest.position.x - origin.position.x, rest.position.y - origin.position.y);
            let h = rest.height - origin.height;
            weight += w;
            for (sum, value) in sums.iter_mut().zip([x, z, h, x * x, x * z, z * z, x * h, z * h, h * h]) {
                *sum += w * value;
            }
        }
        if weight <= 0.0 {
            return None;
        }
        let [x, z, h, xx, xz, zz, xh, zh, hh] = sums.map(|sum| sum / weight);
        Some(Moments {
            weight,
            position: origin.position + Vector2::new(x, z),
            height: origin.height + h,
            spread: [[xx - x * x, xz - x * z], [xz - x * z, zz - z * z]],
            rise: Vector2::new(xh - x * h, zh - z * h),
            variance: hh - h * h,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bvh::Axis;
    use crate::skeleton::Up;

    const RATE: f64 = 60.0;

    /// Feet with legs of one unit whose toes have these positions above level ground, by time in seconds, on
    /// ground of the given height at a time and a position.
    fn feet(
        up: Up,
        toes: [&dyn Fn(f64) -> Vector3<f64>; 2],
        ground: impl Fn(f64, &Vector3<f64>) -> f64,
    ) -> Feet {
        let toe = |toe: &dyn Fn(f64) -> Vector3<f64>| -> Track {
            let position = |frame: u32| {
                let time = f64::from(frame) / RATE;
                let toe = toe(time);
                up.from_y_up() * (toe + ground(time, &toe) * Vector3::y())
            };
            (0..600).map(position).collect()
        };
        let tracks = toes.map(|path| FootTracks {
            ankle: toe(path).iter().map(|toe| toe + 0.1 * up.vector()).collect(),
            toe: toe(path),
            tip: None,
        });
        Feet { tracks, hips: Track::new(), up, leg: 1.0, metres_per_unit: 1.0, frame_time: 1.0 / RATE }
    }

    /// Steps of one leg length in 0.4 s, one per 1.1 s.
    fn step(time: f64, ahead: f64) -> Vector3<f64> {
        let cycles = time / 1.1 + ahead;
        let swing = ((cycles.fract() - 0.64) / 0.36).max(0.0);
        let lift = 0.1 * (std::f64::consts::PI * swing).sin();
        Vector3::new(0.2 * ahead, lift, cycles.floor() + swing * swing * (3.0 - 2.0 * swing))
    }

    fn walk(up: Up, ground: impl Fn(f64, &Vector3<f64>) -> f64) -> Feet {
        feet(up, [&|time| step(time, 0.0), &|time| step(time, 0.5)], ground)
    }

    /// Returns the largest difference of the heights of toes from those on level ground.
    fn error(feet: &Feet, level: &Feet) -> f64 {
        let heights = |feet: &Feet| -> Vec<f64> {
            feet.tracks.iter().flat_map(|foot| &foot.toe).map(|toe| feet.up.height(toe)).collect()
        };
        let [heights, expected] = [feet, level].map(heights);
        let differences = || heights.iter().zip(&expected).map(|(height, expected)| height - expected);
        // The height of the whole ground is unknown.
        let offset = differences().next().unwrap();
        differences().map(|difference| (difference - offset).abs()).fold(0.0, f64::max)
    }

    #[test]
    fn level_ground_is_not_changed() {
        assert_eq!(levelled(&walk(Up::Y, |_, _| 0.0), &[0..300, 300..600]), None);
    }

    #[test]
    fn tilted_ground_is_levelled() {
        for up in [Up::Y, Up { axis: Axis::Z, negative: false }] {
            let level = walk(up, |_, _| 0.0);
            for slope in [-0.3, 0.1, 0.4] {
                let tilted = walk(up, |_, toe| slope * toe.z);
                let levelled = levelled(&tilted, &[0..600]).unwrap();
                assert!(error(&levelled, &level) < 0.02, "{slope}: {}", error(&levelled, &level));
            }
        }
    }

    #[test]
    fn tilt_in_place_is_found_from_small_steps() {
        let foot = |time: f64, side: f64| {
            let stance = (time / 0.7 + 0.5 * side).floor();
            Vector3::new(0.4 * side + 0.08 * (2.0 * stance).sin(), 0.0, 0.3 * side + 0.08 * stance.cos())
        };
        let boxing = |slope: f64| {
            feet(Up::Y, [&|time| foot(time, 0.0), &|time| foot(time, 1.0)], |_, toe| {
                slope * (0.8 * toe.x + 0.6 * toe.z)
            })
        };
        let levelled = levelled(&boxing(0.3), &[0..600]).unwrap();
        assert!(error(&levelled, &boxing(0.0)) < 0.02, "{}", error(&levelled, &boxing(0.0)));
    }

    #[test]
    fn a_foot_that_is_held_in_the_air_is_no_tilt() {
        let held = |time: f64| Vector3::new(0.3, 0.15 + 0.01 * (3.0 * time).sin(), 0.01 * time.cos());
        let standing = |_: f64| Vector3::zeros();
        assert_eq!(levelled(&feet(Up::Y, [&held, &standing], |_, _| 0.0), &[0..600]), None);
    }
}
