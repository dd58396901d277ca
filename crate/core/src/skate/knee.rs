//! Inverse kinematics of the leg: two bones, in closed form.

use nalgebra::{Matrix3, Rotation3, Vector3};

use crate::skate::leg::{Leg, smallest_rotation};

/// Minimum bend up to which a knee may always be straightened, in radians.
const MIN_BEND: f64 = 0.15;

/// Bend of a knee with unit stiffness, in radians.
const EASY_BEND: f64 = 0.5;

/// Weight of the hinge in the axis of the knee; the axis of a nearly straight knee is inaccurate.
const HINGE_WEIGHT: f64 = 0.1;

/// Returns the lengths of thigh and shank and the bend of the knee, which is 0 when straight.
fn bones(leg: &Leg, frame: usize) -> (f64, f64, f64) {
    let thigh = leg.knee[frame] - leg.hip[frame];
    let shank = leg.ankle[frame] - leg.knee[frame];
    (thigh.norm(), shank.norm(), thigh.cross(&shank).norm().atan2(thigh.dot(&shank)))
}

/// Returns the distance from hip to ankle of a knee bent by `bend`.
fn distance(thigh: f64, shank: f64, bend: f64) -> f64 {
    (thigh * thigh + shank * shank + 2.0 * thigh * shank * bend.cos()).max(0.0).sqrt()
}

/// Returns the maximum distance of the ankle from the hip joint: with the knee as straight as it
/// is, or nearly straight (Kovar et al. 2002, section 4.3: a straightening knee moves ever faster).
pub(crate) fn reach(leg: &Leg, frame: usize) -> f64 {
    let (thigh, shank, bend) = bones(leg, frame);
    distance(thigh, shank, bend.min(MIN_BEND))
}

/// Returns the change of the knee angle per change of leg length, relative to a knee bent by
/// [`EASY_BEND`]; it increases for straighter knees.
pub(crate) fn stiffness(leg: &Leg, frame: usize) -> f64 {
    let (_, _, bend) = bones(leg, frame);
    (EASY_BEND.sin() / bend.sin().max(MIN_BEND)).powi(2)
}

/// Returns the rotations of thigh and shank, in the file's axes, that place the ankle at `target`
/// relative to the hip joint.
///
/// The knee bends about its axis, then the leg rotates by the smallest angle, so that the direction
/// of the knee is preserved. If the target is out of reach, the leg gets as near as it can.
pub(crate) fn rotations(
    leg: &Leg,
    frame: usize,
    hinge: Vector3<f64>,
    target: Vector3<f64>,
) -> [Matrix3<f64>; 2] {
    let upper = leg.knee[frame] - leg.hip[frame];
    let lower = leg.ankle[frame] - leg.knee[frame];
    let axis_in_frame = upper.cross(&lower) / (upper.norm() * lower.norm());
    // A nearly straight knee bends forwards; a knee that is clearly bent backwards remains so.
    let hinge = if axis_in_frame.dot(&hinge) < -HINGE_WEIGHT { -hinge } else { hinge };
    let axis = (axis_in_frame + hinge * HINGE_WEIGHT * 1.5).try_normalize(1e-9).unwrap_or_default();
    // If the shank rotates by an angle about the axis, the dot product of thigh and shank, which
    // determines the distance, is `fixed` + `amplitude` · cos(angle − `straight`).
    let fixed = upper.dot(&axis) * lower.dot(&axis);
    let (cosine, sine) = (upper.dot(&lower) - fixed, upper.dot(&axis.cross(&lower)));
    let (amplitude, straight) = (cosine.hypot(sine), sine.atan2(cosine));
    let product = (target.norm_squared() - upper.norm_squared() - lower.norm_squared()) / 2.0;
    let cos_angle = (product - fixed) / amplitude;
    if !cos_angle.is_finite() {
        return [Matrix3::identity(); 2];
    }
    let bend = Rotation3::new(axis * (straight + cos_angle.clamp(-1.0, 1.0).acos()));
    let reached = upper + bend * lower;
    let swing = smallest_rotation(reached, target);
    [swing.into_inner(), (swing * bend).into_inner()]
}
