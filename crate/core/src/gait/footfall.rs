//! Where and when each foot comes down.

use std::ops::Range;

use nalgebra::Vector2;
use nalgebra::Vector3;

use crate::foot::Side;
use crate::intervals::intervals;
use crate::numeric::sort;
use crate::plants::Feet;

/// One plant of one foot, with its place on the ground in metres: (x, z) of axes with Y up.
pub(crate) struct Footfall {
    pub side: Side,
    pub frames: Range<usize>,
    /// Where the heel stands.
    pub heel: Vector2<f64>,
    /// Where the toes point, of length 1; zero where the skeleton has no toes.
    pub heading: Vector2<f64>,
}

/// The plants of both feet in order of foot strike.
///
/// Of two feet that are down when the clip begins, the one that leaves first came first.
pub(crate) fn footfalls(feet: &Feet, planted: [&[bool]; 2]) -> Vec<Footfall> {
    let found: Vec<Footfall> =
        Side::BOTH.into_iter().flat_map(|side| of_foot(feet, side, planted[side as usize])).collect();
    sort::by_frames(found, |footfall| (footfall.frames.start, footfall.frames.end))
}

/// The plants of one foot.
///
/// The heel's place is found from the toe, which stays where it is until the foot leaves, and
/// not from the ankle, which moves as the foot rolls: a plant that the clip cuts has a place, too.
fn of_foot(feet: &Feet, side: Side, planted: &[bool]) -> Vec<Footfall> {
    let tracks = &feet.tracks[side as usize];
    let ground = |position: &Vector3<f64>| {
        let turned = feet.up.to_y_up(*position) * feet.metres_per_unit;
        Vector2::new(turned.x, turned.z)
    };
    let sole = |frame: usize| ground(&tracks.toe[frame]) - ground(&tracks.ankle[frame]);
    let frames = || (0..planted.len()).filter(|&frame| planted[frame]);
    // From ankle to toe over ground, as it is most of the time: the foot flat.
    let length = median(frames().map(|frame| sole(frame).norm()));
    let middle = |frames: Range<usize>, of: &dyn Fn(usize) -> Vector2<f64>| {
        Vector2::from_fn(|axis, _| median(frames.clone().map(|frame| of(frame)[axis])))
    };
    let footfall = |frames: Range<usize>| {
        let heading = middle(frames.clone(), &sole).try_normalize(f64::EPSILON).unwrap_or_default();
        let toe = middle(frames.clone(), &|frame| ground(&tracks.toe[frame]));
        Footfall { side, frames, heel: toe - length * heading, heading }
    };
    intervals(planted).into_iter().map(footfall).collect()
}

/// The middle value, the upper of two; 0 of none.
fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.collect();
    let middle = values.len() / 2;
    if values.is_empty() { 0.0 } else { *values.select_nth_unstable_by(middle, f64::total_cmp).1 }
}
