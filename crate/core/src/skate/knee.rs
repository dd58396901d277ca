//! The leg's inverse kinematics: two bones in closed form.

use nalgebra::{Matrix3, Rotation3, Vector3};

use crate::skate::leg::{Leg, smallest_turn};

/// A knee may always be straightened up to this bend, in radians ...
const STRAIGHT: f64 = 0.15;

/// Bend of a knee that gives way easily, in radians.
const EASY: f64 = 0.5;

/// Share of the hinge in the axis that a knee is bent about: that of a nearly straight one says little.
const HINGE: f64 = 0.1;

/// Lengths of thigh and shank and the bend of the knee, 0 when straight, in one frame.
fn bones(leg: &Leg, frame: usize) -> (f64, f64, f64) {
    let thigh = leg.knee[frame] - leg.hip[frame];
    let shank = leg.ankle[frame] - leg.knee[frame];
    (thigh.norm(), shank.norm(), thigh.cross(&shank).norm().atan2(thigh.dot(&shank)))
}

/// Distance from hip to ankle of a knee bent by `bend`.
fn distance(thigh: f64, shank: f64, bend: f64) -> f64 {
    (thigh * thigh + shank * shank + 2.0 * thigh * shank * bend.cos()).max(0.0).sqrt()
}

/// How far from the hip joint the ankle may be put: with the knee as straight as it is, or nearly
/// so (Kovar et al. 2002, section 4.3: a straightening knee goes ever faster).
pub(crate) fn reach(leg: &Leg, frame: usize) -> f64 {
    let (thigh, shank, bend) = bones(leg, frame);
    distance(thigh, shank, bend.min(STRAIGHT))
}

/// How much the knee has to bend for the leg to become a little shorter, next to one bent by
/// [`EASY`]: the straighter it is, the more.
pub(crate) fn stiffness(leg: &Leg, frame: usize) -> f64 {
    let (_, _, bend) = bones(leg, frame);
    (EASY.sin() / bend.sin().max(STRAIGHT)).powi(2)
}

/// How thigh and shank have to turn, in the file's axes, for the ankle to be `apart` from the hip joint.
///
/// The knee bends about its own axis, then the leg swings the shortest way: the knee goes on
/// pointing where it did. Where the leg is too short or too long it gets as near as it can.
pub(crate) fn turns(leg: &Leg, frame: usize, hinge: Vector3<f64>, apart: Vector3<f64>) -> [Matrix3<f64>; 2] {
    let upper = leg.knee[frame] - leg.hip[frame];
    let lower = leg.ankle[frame] - leg.knee[frame];
    let own = upper.cross(&lower) / (upper.norm() * lower.norm());
    // A nearly straight knee bends forward, as knees do; one that is well bent backwards goes on so.
    let hinge = if own.dot(&hinge) < -HINGE { -hinge } else { hinge };
    let axis = (own + hinge * HINGE * 1.5).try_normalize(1e-9).unwrap_or_default();
    // As the shank turns by an angle about the axis, the product of thigh and shank, and with it
    // the distance, goes as `fixed` + `most` · cos(angle − `straight`).
    let fixed = upper.dot(&axis) * lower.dot(&axis);
    let (cosine, sine) = (upper.dot(&lower) - fixed, upper.dot(&axis.cross(&lower)));
    let (most, straight) = (cosine.hypot(sine), sine.atan2(cosine));
    let wanted = (apart.norm_squared() - upper.norm_squared() - lower.norm_squared()) / 2.0;
    let share = (wanted - fixed) / most;
    if !share.is_finite() {
        return [Matrix3::identity(); 2];
    }
    let bent = Rotation3::new(axis * (straight + share.clamp(-1.0, 1.0).acos()));
    let reached = upper + bent * lower;
    let swung = smallest_turn(reached, apart);
    [swung.into_inner(), (swung * bent).into_inner()]
}
