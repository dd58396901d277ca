//! Legs: two bones and a foot, solved in closed form.

use plantigrade::foot::Side;

use super::Pose;
use crate::character::{Bone, Build, outward};
use crate::feet::FootPose;
use crate::maths::{Vec3, forward, from_columns, heading, smallest_turn, turn};
use crate::pelvis::{PelvisPose, hip};

/// Greatest length of a leg from hip to ankle, as a share of its full length.
pub const STRETCH_LIMIT: f64 = 0.99;

/// Length above which a leg that swings freely begins to resist being stretched.
const SOFT_STRETCH: f64 = 0.95;

/// Share of the foot's turn against the pelvis that comes from the hip joint.
const KNEE_FOLLOWS_FOOT: f64 = 0.65;

/// Poses the leg of one side so that the ankle is where `foot` has it.
pub fn leg(pose: &mut Pose, pelvis: &PelvisPose, foot: &FootPose, side: Side, build: &Build) {
    let hip = hip(pelvis, side, build);
    let apart = foot.ankle - hip;
    let distance = apart.norm();
    let down = apart / distance;
    let reach = reach(distance / build.leg(), foot.freedom) * build.leg();

    // The hinge of the knee: the pelvis's left, turned with the foot, carried along as
    // the leg leaves the vertical.
    let yaw = KNEE_FOLLOWS_FOOT * wrapped(foot.heading - pelvis.heading) + outward(side) * foot.turnout;
    let facing = heading(pelvis.heading + yaw);
    let carried = smallest_turn(-Vec3::y(), down) * facing;
    let hinge = carried * Vec3::x();

    let (thigh, shank) = (build.thigh, build.shank);
    let cosine = (thigh * thigh + reach * reach - shank * shank) / (2.0 * thigh * reach);
    let lift = libm::acos(cosine.clamp(-1.0, 1.0));
    let ahead = hinge.cross(&down) * -1.0;
    let knee = thigh * (libm::cos(lift) * down + libm::sin(lift) * ahead);
    let lower = (reach * down - knee) / shank;

    let frame = |along: Vec3| from_columns(hinge, -along, hinge.cross(&-along));
    let (thigh, shank) = (frame(knee / thigh), frame(lower));
    pose.set(Bone::Thigh(side), pelvis.rotation.inverse() * thigh);
    pose.set(Bone::Shank(side), thigh.inverse() * shank);
    pose.set(Bone::Foot(side), shank.inverse() * foot.rotation());
    pose.set(Bone::Toe(side), turn(0, -foot.bend));
}

/// The length a leg takes, from the length it is asked for, both as shares of its full
/// length: never above the limit, and approaching it softly in the air.
fn reach(asked: f64, freedom: f64) -> f64 {
    let hard = asked.min(STRETCH_LIMIT);
    if asked <= SOFT_STRETCH {
        return hard.max(0.25);
    }
    let room = STRETCH_LIMIT - SOFT_STRETCH;
    let soft = SOFT_STRETCH + room * (1.0 - libm::exp((SOFT_STRETCH - asked) / room));
    hard + (soft - hard) * freedom
}

/// Poses a leg in the air relative to the body: `held` is the ankle outward of, above
/// and ahead of the hip in leg lengths, the pitch of the foot and the outward turn of
/// the knee in degrees; `share` is how far the leg is in that pose.
pub fn hold(foot: &mut FootPose, pelvis: &PelvisPose, held: [f64; 5], share: f64, side: Side, build: &Build) {
    let [out, up, ahead, pitch, turnout] = held;
    let left = heading(pelvis.heading) * Vec3::x();
    let target = outward(side) * out * left + up * Vec3::y() + ahead * forward(pelvis.heading);
    let ankle = hip(pelvis, side, build) + build.leg() * target;
    foot.ankle = foot.ankle.lerp(&ankle, share);
    foot.pitch += (pitch.to_radians() - foot.pitch) * share;
    foot.bend *= 1.0 - share;
    foot.turnout = turnout.to_radians() * share;
    let outwards = pelvis.heading + outward(side) * turnout.to_radians();
    foot.heading += wrapped(outwards - foot.heading) * share;
    foot.freedom = foot.freedom.max(share);
}

/// The angle between −π and π that differs by whole turns.
fn wrapped(angle: f64) -> f64 {
    angle - std::f64::consts::TAU * (angle / std::f64::consts::TAU).round()
}
