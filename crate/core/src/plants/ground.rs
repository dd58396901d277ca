//! The ground on which the feet stand: plane, levels and belt, as the plants define them.

use std::ops::Range;

use nalgebra::{Matrix2, SymmetricEigen, Vector2, Vector3};

use crate::intervals::intervals;
use crate::kinematics::Track;
use crate::numeric::{sort, stats};
use crate::plants::{Feet, FootTracks};
use crate::skeleton::Up;

/// Maximum difference of neighbouring heights within one level, in leg lengths, as feet float and sink.
const MAX_GAP: f64 = 0.03;
/// Maximum range of heights that clean-up moves to one level, in leg lengths.
const MAX_RANGE: f64 = 0.04;
/// Minimum standard deviation of the positions of plants along a direction whose slope they determine, in
/// leg lengths. Feet side by side are closer than that.
const MIN_EXTENT: f64 = 0.3;
/// Minimum tilt of the ground, as a slope: 1°. Smaller ones are within the error of the heights.
const MIN_SLOPE: f64 = 0.0175;
/// Maximum tilt of the ground, as a slope: 27°. Stairs are steeper.
const MAX_SLOPE: f64 = 0.5;
/// Maximum root mean square of the distances of plants from a tilted plane, in leg lengths.
const MAX_RESIDUAL: f64 = 0.02;
/// Maximum of the same as a fraction of the distances from a level plane.
const MAX_RESIDUAL_FRACTION: f64 = 0.4;
/// Minimum speed of a belt, in leg lengths per second; planted feet that roll are slower.
const MIN_BELT_SPEED: f64 = 0.15;
/// Minimum fraction of plants that move with the belt.
const MIN_AGREEMENT: f64 = 0.75;
/// Maximum difference of their velocity from that of the belt, as a fraction of its speed.
const MAX_DEVIATION: f64 = 0.25;
/// Maximum distance between the first and the last position of the hips on a belt, as a fraction of the
/// distance that the belt moves. Feet that slide along with a walk are foot skate.
const MAX_TRAVEL: f64 = 0.5;
/// Minimum number of plants that determine a plane or a belt.
const MIN_PLANTS: usize = 4;

/// Ground of a clip, in file units and axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Ground {
    /// Unit normal of the plane: the up axis unless the ground is tilted.
    pub normal: Vector3<f64>,
    /// Point of the plane, whose height is that of the most frequent level.
    pub origin: Vector3<f64>,
    /// Heights of the levels above the plane, ascending; one of them is 0. A level is the median height of
    /// plants whose neighbours in height are less than 0.03 leg lengths apart. Stairs have several levels.
    pub levels: Vec<f64>,
    /// Velocity of a treadmill belt, per second; `None` if the ground is at rest.
    pub belt: Option<Vector3<f64>>,
}

impl Ground {
    /// Estimates the ground from the frames in which the left foot and the right foot are planted.
    ///
    /// The height of a plant is the median of its lowest joint in its middle half.
    pub fn new(feet: &Feet, planted: [&[bool]; 2]) -> Ground {
        let plants = complete_plants(planted);
        let tracks = |foot: usize| &feet.tracks[foot];
        let points: Vec<Vector3<f64>> = plants
            .iter()
            .map(|(foot, plant)| plant_position(tracks(*foot), feet.up, middle_half(plant)))
            .collect();
        let up = feet.up.vector();
        let toes = plants.iter().map(|(foot, plant)| (&tracks(*foot).toe, middle_half(plant)));
        let belt = belt(toes, feet).map(|velocity| velocity - up * up.dot(&velocity));
        let Some(centre) =
            (!points.is_empty()).then(|| points.iter().sum::<Vector3<f64>>() / points.len() as f64)
        else {
            return Ground { normal: up, origin: Vector3::zeros(), levels: vec![0.0], belt };
        };
        let slope = slope(&points, &centre, feet).unwrap_or_default();
        let mut ground =
            Ground { normal: (up - slope).normalize(), origin: centre, levels: Vec::new(), belt };
        let heights: Vec<f64> = points.iter().map(|point| ground.height_above(point, feet.up)).collect();
        let groups = groups_of_height(&heights, feet.leg);
        let medians = groups.iter().map(|group| median_of_group(&heights, group));
        // Of equally frequent levels, the lowest one.
        let largest = groups.iter().map(Vec::len).max();
        let first = groups.iter().position(|group| Some(group.len()) == largest);
        let most_frequent = first.map_or(0.0, |index| median_of_group(&heights, &groups[index]));
        ground.origin += up * most_frequent;
        ground.levels = medians.map(|level| level - most_frequent).collect();
        ground
    }

    /// Ground at height 0 with Y up, for tests.
    #[cfg(test)]
    pub(crate) fn level() -> Ground {
        Ground { normal: Vector3::y(), origin: Vector3::zeros(), levels: vec![0.0], belt: None }
    }

    /// Returns the displacement of the belt from the first frame to a frame; `frame_time` is in seconds.
    pub(crate) fn displacement(&self, frame: usize, frame_time: f64) -> Vector3<f64> {
        self.belt.unwrap_or_default() * (frame as f64 * frame_time)
    }

    /// Returns the height of a point above the plane, along the up axis.
    pub fn height_above(&self, point: &Vector3<f64>, up: Up) -> f64 {
        (point - self.origin).dot(&self.normal) / self.normal.dot(&up.vector())
    }

    /// Returns the tilt against the up axis, in degrees.
    pub fn tilt_degrees(&self, up: Up) -> f64 {
        self.normal.dot(&up.vector()).clamp(-1.0, 1.0).acos().to_degrees()
    }
}

/// Returns the level for each of `heights`, in their unit; `leg` is the leg length.
///
/// Heights close together belong to one level at their median. Each step of stairs is a level; on a
/// slope the height of each plant is preserved.
pub(crate) fn levels(heights: &[f64], leg: f64) -> Vec<f64> {
    let mut levels = heights.to_vec();
    for group in groups_of_height(heights, leg) {
        let (low, high) = (heights[group[0]], heights[group[group.len() - 1]]);
        if high - low <= MAX_RANGE * leg {
            let level = median_of_group(heights, &group);
            group.iter().for_each(|&plant| levels[plant] = level);
        }
    }
    levels
}

/// Returns the indices of heights in groups that are farther than [`MAX_GAP`] apart, ascending.
fn groups_of_height(heights: &[f64], leg: f64) -> Vec<Vec<usize>> {
    let order = sort::argsort(heights);
    let groups = order.chunk_by(|&low, &high| heights[high] - heights[low] <= MAX_GAP * leg);
    groups.map(<[usize]>::to_vec).collect()
}

/// Returns the median of the heights of a group in ascending order.
fn median_of_group(heights: &[f64], group: &[usize]) -> f64 {
    (heights[group[(group.len() - 1) / 2]] + heights[group[group.len() / 2]]) / 2.0
}

/// Returns the velocity of the belt of a treadmill, in file units per second: that of planted toes, if most of
/// them have it and the hips do not travel.
fn belt<'a>(toes: impl Iterator<Item = (&'a Track, Range<usize>)>, feet: &Feet) -> Option<Vector3<f64>> {
    let velocities: Vec<Vector3<f64>> = toes
        .filter(|(_, frames)| frames.len() > 1)
        .map(|(toe, frames)| {
            let seconds = (frames.len() - 1) as f64 * feet.frame_time;
            (toe[frames.end - 1] - toe[frames.start]) / seconds
        })
        .collect();
    if velocities.len() < MIN_PLANTS {
        return None;
    }
    let velocity = Vector3::from_fn(|axis, _| {
        stats::median_high(velocities.iter().map(|velocity| velocity[axis])).unwrap_or_default()
    });
    let speed = velocity.norm();
    let agree = velocities.iter().filter(|other| (*other - velocity).norm() <= MAX_DEVIATION * speed).count();
    let travel = match (feet.hips.first(), feet.hips.last()) {
        (Some(first), Some(last)) => (last - first).norm(),
        _ => 0.0,
    };
    let belt_distance = speed * feet.hips.len() as f64 * feet.frame_time;
    let is_belt = speed >= MIN_BELT_SPEED * feet.leg
        && agree as f64 >= MIN_AGREEMENT * velocities.len() as f64
        && travel <= MAX_TRAVEL * belt_distance;
    is_belt.then_some(velocity)
}

/// Returns the plants of both feet, as index of the foot and frames. Those that the ends of the clip cut off are
/// left out if they are shorter than half the median plant.
fn complete_plants(planted: [&[bool]; 2]) -> Vec<(usize, Range<usize>)> {
    let plants = || {
        let of_foot = |foot: usize| intervals(planted[foot]).into_iter().map(move |plant| (foot, plant));
        [0, 1].into_iter().flat_map(of_foot)
    };
    let median = stats::median_high(plants().map(|(_, plant)| plant.len() as f64)).unwrap_or_default();
    let is_cut_off = |foot: usize, plant: &Range<usize>| plant.start == 0 || plant.end == planted[foot].len();
    plants().filter(|(foot, plant)| !is_cut_off(*foot, plant) || plant.len() as f64 >= median / 2.0).collect()
}

/// Returns the frames of a plant in which the foot is flat in most gaits.
fn middle_half(plant: &Range<usize>) -> Range<usize> {
    let quarter = plant.len() / 4;
    plant.start + quarter..plant.end - quarter
}

/// Returns the median position of the toe, at the median height of the lowest joint.
fn plant_position(tracks: &FootTracks, up: Up, frames: Range<usize>) -> Vector3<f64> {
    let median =
        |value: &dyn Fn(usize) -> f64| stats::median_high(frames.clone().map(value)).unwrap_or_default();
    let lowest = |frame: usize| {
        let tip = tracks.tip.as_ref().map_or(f64::INFINITY, |tip| up.height(&tip[frame]));
        up.height(&tracks.ankle[frame]).min(up.height(&tracks.toe[frame])).min(tip)
    };
    let toe = Vector3::from_fn(|axis, _| median(&|frame| tracks.toe[frame][axis]));
    toe + up.vector() * (median(&lowest) - up.height(&toe))
}

/// Returns the horizontal gradient of the height, if the positions lie on a tilted plane.
fn slope(points: &[Vector3<f64>], centre: &Vector3<f64>, feet: &Feet) -> Option<Vector3<f64>> {
    if points.len() < MIN_PLANTS {
        return None;
    }
    let count = points.len() as f64;
    let from_centre = |point: &Vector3<f64>| {
        let y_up = feet.up.to_y_up(point - centre) / feet.leg;
        (Vector2::new(y_up.x, y_up.z), y_up.y)
    };
    let (mut spread, mut rise, mut before) = (Matrix2::zeros(), Vector2::zeros(), 0.0);
    for (position, height) in points.iter().map(from_centre) {
        spread += position * position.transpose() / count;
        rise += position * height / count;
        before += height * height / count;
    }
    let SymmetricEigen { eigenvalues, eigenvectors } = SymmetricEigen::new(spread);
    let gradient: Vector2<f64> = (0..2)
        .filter(|&index| eigenvalues[index] > MIN_EXTENT * MIN_EXTENT)
        .map(|index| {
            eigenvectors.column(index) * (eigenvectors.column(index).dot(&rise) / eigenvalues[index])
        })
        .sum();
    let after = (before - gradient.dot(&rise)).max(0.0);
    let is_plane = (MIN_SLOPE..MAX_SLOPE).contains(&gradient.norm())
        && after.sqrt() <= MAX_RESIDUAL
        && after.sqrt() <= MAX_RESIDUAL_FRACTION * before.sqrt();
    let gradient = Vector3::new(gradient.x, 0.0, gradient.y);
    is_plane.then(|| feet.up.from_y_up() * gradient)
}

#[cfg(test)]
mod tests {
    use super::*;

    const RATE: f64 = 60.0;

    /// Feet with legs of one unit that walk along Z in steps of 0.7 in 0.6 s, on ground of the given height, and
    /// the frames in which they are planted.
    fn walk(up: Up, height: impl Fn(f64, f64) -> f64, belt: f64) -> (Feet, [Vec<bool>; 2]) {
        let frames = 600;
        let mut planted = [Vec::new(), Vec::new()];
        let tracks = [0.0, 0.5].map(|ahead| {
            let foot = if ahead > 0.0 { 1 } else { 0 };
            let x = 0.1 - 0.2 * ahead;
            let toe: Track = (0..frames)
                .map(|frame| {
                    let time = f64::from(frame) / RATE;
                    let cycles = time / 1.2 + ahead;
                    let swing = ((cycles.fract() - 0.6) / 0.4).max(0.0);
                    planted[foot].push(swing == 0.0);
                    let z = 1.4 * (cycles.floor() + swing * swing * (3.0 - 2.0 * swing) - ahead);
                    let y = height(x, z) + 0.02 + 0.3 * swing * (1.0 - swing);
                    let position = Vector3::new(x, y, z - belt * time);
                    Vector3::from_fn(|axis, _| up.to_y_up(Vector3::ith(axis, 1.0)).dot(&position))
                })
                .collect();
            let ankle = toe.iter().map(|toe| toe + 0.1 * up.vector()).collect();
            FootTracks { ankle, toe, tip: None }
        });
        let hips = (0..frames).map(|frame| {
            let time = f64::from(frame) / RATE;
            Vector3::new(0.0, 1.0, (1.4 / 1.2 - belt) * time)
        });
        let hips =
            hips.map(|hips| Vector3::from_fn(|axis, _| up.to_y_up(Vector3::ith(axis, 1.0)).dot(&hips)));
        let hips: Track = hips.collect();
        (Feet { tracks, hips, up, leg: 1.0, metres_per_unit: 1.0, frame_time: 1.0 / RATE }, planted)
    }

    fn ground(up: Up, height: impl Fn(f64, f64) -> f64, belt: f64) -> Ground {
        let (feet, planted) = walk(up, height, belt);
        Ground::new(&feet, planted.each_ref().map(Vec::as_slice))
    }

    #[test]
    fn level_ground_has_one_level_and_no_tilt() {
        let ground = ground(Up::Y, |_, _| 0.5, 0.0);
        assert_eq!((ground.normal, &ground.levels[..], ground.belt), (Vector3::y(), &[0.0][..], None));
        assert!((ground.origin.y - 0.52).abs() < 1e-9);
    }

    #[test]
    fn tilted_ground_is_a_plane() {
        for up in [Up::Y, Up { axis: crate::bvh::Axis::Z, negative: false }] {
            for degrees in [3.0_f64, 10.0, 25.0] {
                let ground = ground(up, |_, z| z * degrees.to_radians().tan(), 0.0);
                assert!((ground.tilt_degrees(up) - degrees).abs() < 0.1, "{up} {degrees}: {ground:?}");
                let ahead = up.to_y_up(ground.normal);
                assert!(ahead.z < 0.0 && ground.levels.len() == 1, "{ground:?}");
            }
        }
    }

    #[test]
    fn platforms_and_stairs_are_levels() {
        let platform = ground(Up::Y, |_, z| if z > 3.0 { 0.3 } else { 0.0 }, 0.0);
        assert_eq!(platform.normal, Vector3::y());
        let expected = [vec![0.0, 0.3], vec![-0.3, 0.0]];
        let is_near =
            |levels: &Vec<f64>| levels.iter().zip(&platform.levels).all(|(a, b)| (a - b).abs() < 1e-9);
        assert!(platform.levels.len() == 2 && expected.iter().any(is_near), "{platform:?}");
        let stairs = ground(Up::Y, |_, z| 0.4 * (z / 0.7).round(), 0.0);
        assert!(stairs.normal == Vector3::y() && stairs.levels.len() > 8, "{stairs:?}");
    }

    #[test]
    fn feet_on_a_belt_have_its_velocity() {
        let ground = ground(Up::Y, |_, _| 0.0, 1.2);
        let belt = ground.belt.unwrap();
        assert!((belt + Vector3::z() * 1.2).norm() < 0.01, "{belt}");
        assert_eq!(ground.normal, Vector3::y());
    }

    #[test]
    fn feet_that_slide_with_a_walk_are_not_on_a_belt() {
        assert_eq!(ground(Up::Y, |_, _| 0.0, -0.4).belt, None);
    }

    #[test]
    fn uneven_ground_has_one_level() {
        let ground = ground(Up::Y, |_, z| 0.03 * (37.0 * z.round()).sin(), 0.0);
        assert_eq!((ground.normal, &ground.levels[..]), (Vector3::y(), &[0.0][..]));
    }

    #[test]
    fn levels_are_equalised_and_slopes_are_preserved() {
        assert_eq!(levels(&[0.010, -0.012, 0.002], 0.9), [0.002; 3]);
        assert_eq!(levels(&[0.0, 0.17, 0.34, 0.18], 0.9), [0.0, 0.175, 0.34, 0.175]);
        let slope: Vec<f64> = (0..9).map(|n| 0.02 * n as f64).collect();
        assert_eq!(levels(&slope, 0.9), slope);
        assert!(levels(&[], 0.9).is_empty());
    }
}
