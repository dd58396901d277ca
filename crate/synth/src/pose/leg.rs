//! Inverse kinematics of the legs: two bones and a foot, in closed form.

use plantigrade::foot::Side;

use super::Pose;
use crate::character::{Bone, Proportions, lateral_sign};
use crate::foot_path::FootPose;
use crate::math::{Vec3, forward, from_columns, heading_rotation, rotation_about, rotation_between};
use crate::pelvis::{PelvisPose, hip};

/// Maximum length of a leg from hip to ankle, as a fraction of its full length.
pub const MAX_LEG_EXTENSION: f64 = 0.99;

/// Length above which the extension of a swinging leg is limited softly, as a fraction of its full
/// length.
const SOFT_EXTENSION: f64 = 0.95;

/// Fraction of the foot's heading relative to the pelvis that comes from the hip joint.
const HIP_ROTATION_FRACTION: f64 = 0.65;

/// Poses the leg of one side so that the ankle is at the position of `foot`.
pub fn solve_leg(
    pose: &mut Pose,
    pelvis: &PelvisPose,
    foot: &FootPose,
    side: Side,
    proportions: &Proportions,
) {
    let hip = hip(pelvis, side, proportions);
    let to_ankle = foot.ankle - hip;
    let distance = to_ankle.norm();
    let down = to_ankle / distance;
    let reach = limited_length(distance / proportions.leg_length(), foot.freedom) * proportions.leg_length();

    // Knee axis: the left of the pelvis, rotated with the foot and with the deviation of the leg
    // from vertical.
    let yaw =
        HIP_ROTATION_FRACTION * wrapped(foot.heading - pelvis.heading) + lateral_sign(side) * foot.turnout;
    let facing = heading_rotation(pelvis.heading + yaw);
    let deviation = rotation_between(-Vec3::y(), down) * facing;
    let hinge = deviation * Vec3::x();

    let (thigh, shank) = (proportions.thigh, proportions.shank);
    let cosine = (thigh * thigh + reach * reach - shank * shank) / (2.0 * thigh * reach);
    let lift = libm::acos(cosine.clamp(-1.0, 1.0));
    let ahead = hinge.cross(&down) * -1.0;
    let knee = thigh * (libm::cos(lift) * down + libm::sin(lift) * ahead);
    let lower = (reach * down - knee) / shank;

    let frame = |along: Vec3| from_columns(hinge, -along, hinge.cross(&-along));
    let (thigh, shank) = (frame(knee / thigh), frame(lower));
    pose.set_rotation(Bone::Thigh(side), pelvis.rotation.inverse() * thigh);
    pose.set_rotation(Bone::Shank(side), thigh.inverse() * shank);
    pose.set_rotation(Bone::Foot(side), shank.inverse() * foot.rotation());
    pose.set_rotation(Bone::Toe(side), rotation_about(0, -foot.bend));
}

/// Returns the length of a leg for a requested length, both as fractions of its full length: never
/// above the limit, and with a soft limit in the air.
fn limited_length(requested: f64, freedom: f64) -> f64 {
    let hard = requested.min(MAX_LEG_EXTENSION);
    if requested <= SOFT_EXTENSION {
        return hard.max(0.25);
    }
    let range = MAX_LEG_EXTENSION - SOFT_EXTENSION;
    let soft = SOFT_EXTENSION + range * (1.0 - libm::exp((SOFT_EXTENSION - requested) / range));
    hard + (soft - hard) * freedom
}

/// Blends an airborne foot towards a pose relative to the body. `leg_pose` is the position of the
/// ankle outward of, above and ahead of the hip in leg lengths, the pitch of the foot and the
/// outward rotation of the knee in degrees; `weight` is the blend weight.
pub fn apply_leg_pose(
    foot: &mut FootPose,
    pelvis: &PelvisPose,
    leg_pose: [f64; 5],
    weight: f64,
    side: Side,
    proportions: &Proportions,
) {
    let [out, up, ahead, pitch, turnout] = leg_pose;
    let left = heading_rotation(pelvis.heading) * Vec3::x();
    let target = lateral_sign(side) * out * left + up * Vec3::y() + ahead * forward(pelvis.heading);
    let ankle = hip(pelvis, side, proportions) + proportions.leg_length() * target;
    foot.ankle = foot.ankle.lerp(&ankle, weight);
    foot.pitch += (pitch.to_radians() - foot.pitch) * weight;
    foot.bend *= 1.0 - weight;
    foot.turnout = turnout.to_radians() * weight;
    let outwards = pelvis.heading + lateral_sign(side) * turnout.to_radians();
    foot.heading += wrapped(outwards - foot.heading) * weight;
    foot.freedom = foot.freedom.max(weight);
}

/// Returns the equivalent angle between −π and π.
fn wrapped(angle: f64) -> f64 {
    angle - std::f64::consts::TAU * (angle / std::f64::consts::TAU).round()
}
