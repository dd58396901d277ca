//! Time and location of every footfall.

use std::ops::Range;

use nalgebra::{Rotation3, Vector2, Vector3};

use crate::foot::Side;
use crate::intervals::intervals;
use crate::kinematics::Track;
use crate::numeric::{sort, stats};
use crate::plants::{Feet, Ground};

/// One plant of one foot with its location on the ground.
///
/// Locations are (x, z) coordinates on the plane of the ground in metres, with Y along its normal; on a
/// treadmill they move with the belt.
pub(crate) struct Footfall {
    pub side: Side,
    pub frames: Range<usize>,
    /// Location of the heel.
    pub heel: Vector2<f64>,
    /// Direction of the toes, of length 1; zero if the skeleton has no toes.
    pub heading: Vector2<f64>,
}

/// Returns the plants of both feet in order of foot strike.
///
/// If both feet are down when the clip begins, the one that leaves first comes first.
pub(crate) fn footfalls(feet: &Feet, planted: [&[bool]; 2]) -> Vec<Footfall> {
    let ground = Ground::new(feet, planted);
    let footfalls: Vec<Footfall> = Side::BOTH
        .into_iter()
        .flat_map(|side| plants_of_foot(feet, &ground, side, planted[side as usize]))
        .collect();
    sort::sort_by_frames(footfalls, |footfall| (footfall.frames.start, footfall.frames.end))
}

/// Returns the plants of one foot.
///
/// The heel location is computed from the toe, which stays in place until foot off, and not from
/// the ankle, which moves as the foot rolls. A plant that the clip cuts off has a location too.
fn plants_of_foot(feet: &Feet, ground: &Ground, side: Side, planted: &[bool]) -> Vec<Footfall> {
    let tracks = &feet.tracks[side as usize];
    let median = |values: &mut dyn Iterator<Item = f64>| stats::median_high(values).unwrap_or_default();
    let to_level = Rotation3::rotation_between(&feet.up.to_y_up(ground.normal), &Vector3::y());
    let to_level = to_level.unwrap_or_else(Rotation3::identity);
    let on_ground = |track: &Track, frame: usize| {
        let position = track[frame] - ground.displacement(frame, feet.frame_time);
        let y_up = to_level * feet.up.to_y_up(position) * feet.metres_per_unit;
        Vector2::new(y_up.x, y_up.z)
    };
    let sole = |frame: usize| on_ground(&tracks.toe, frame) - on_ground(&tracks.ankle, frame);
    let frames = || (0..planted.len()).filter(|&frame| planted[frame]);
    // Most frames of stance are foot flat: the median is the distance of toe and ankle on the
    // ground.
    let length = median(&mut frames().map(|frame| sole(frame).norm()));
    let median_point = |frames: Range<usize>, point: &dyn Fn(usize) -> Vector2<f64>| {
        Vector2::from_fn(|axis, _| median(&mut frames.clone().map(|frame| point(frame)[axis])))
    };
    let footfall = |frames: Range<usize>| {
        let heading = median_point(frames.clone(), &sole).try_normalize(f64::EPSILON).unwrap_or_default();
        let toe = median_point(frames.clone(), &|frame| on_ground(&tracks.toe, frame));
        Footfall { side, frames, heel: toe - length * heading, heading }
    };
    intervals(planted).into_iter().map(footfall).collect()
}
