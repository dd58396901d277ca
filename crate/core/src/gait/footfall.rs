//! Time and location of every footfall.

use std::ops::Range;

use nalgebra::{Rotation3, Vector2, Vector3};

use crate::foot::Side;
use crate::gait::Contact;
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
    /// Time of foot strike and of foot off, in seconds from the first frame; at the ends of the clip,
    /// half a frame beyond it.
    pub times: Range<f64>,
    /// Location of the heel.
    pub heel: Vector2<f64>,
    /// Direction of the toes, of length 1; zero if the skeleton has no toes.
    pub heading: Vector2<f64>,
}

/// Plants of both feet with the ground on which they are.
pub(crate) struct Footfalls {
    /// In order of foot strike. If both feet are down when the clip begins, the one that leaves first
    /// comes first.
    pub list: Vec<Footfall>,
    /// Velocity of the belt of a treadmill, in file units per second.
    pub belt: Option<Vector3<f64>>,
    /// Rotation from coordinates with Y up to those with Y along the normal of the ground.
    pub to_level: Rotation3<f64>,
}

impl Footfalls {
    /// Returns the plants of the left foot's labels and the right's.
    pub fn new(feet: &Feet, contacts: [Contact; 2]) -> Footfalls {
        let ground = Ground::new(feet, contacts.map(|contact| contact.planted));
        let to_level = Rotation3::rotation_between(&feet.up.to_y_up(ground.normal), &Vector3::y());
        let to_level = to_level.unwrap_or_else(Rotation3::identity);
        let footfalls: Vec<Footfall> = Side::BOTH
            .into_iter()
            .flat_map(|side| plants_of_foot(feet, &ground, &to_level, side, contacts[side as usize]))
            .collect();
        let list = sort::sort_by_frames(footfalls, |footfall| (footfall.frames.start, footfall.frames.end));
        Footfalls { list, belt: ground.belt, to_level }
    }
}

/// Returns the plants of one foot.
///
/// The heel location is computed from the toe, which stays in place until foot off, and not from
/// the ankle, which moves as the foot rolls. A plant that the clip cuts off has a location too.
fn plants_of_foot(
    feet: &Feet,
    ground: &Ground,
    to_level: &Rotation3<f64>,
    side: Side,
    contact: Contact,
) -> Vec<Footfall> {
    let planted = contact.planted;
    let tracks = &feet.tracks[side as usize];
    let median = |values: &mut dyn Iterator<Item = f64>| stats::median_high(values).unwrap_or_default();
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
        let [strike, off] =
            [frames.start, frames.end].map(|frame| contact.boundary_time(frame, feet.frame_time));
        Footfall { side, frames, times: strike..off, heel: toe - length * heading, heading }
    };
    intervals(planted).into_iter().map(footfall).collect()
}
