//! Ground and recording artefacts that are applied to whole poses.
//!
//! Only the root is moved and rotated, so bone lengths do not change and the truth of the plan
//! stays valid: planted feet are still relative to the ground under them.

use std::f64::consts::TAU;

use crate::character::Bone;
use crate::math::{Vec3, nlerp, rotation_about};
use crate::pose::Pose;

/// Transformation of the poses of a clip before export.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Environment {
    /// Level ground at rest; poses do not change.
    #[default]
    Level,
    /// Ground that rises forward by this angle, in degrees. The body is rotated with the ground;
    /// the motion itself must lean into the slope.
    Slope(f64),
    /// Treadmill belt that moves backward at this speed, in m/s.
    Treadmill(f64),
    /// Platform that oscillates forward and vertically; the value is its maximum forward speed, in
    /// m/s.
    Platform(f64),
    /// Jump to another position and heading halfway through the clip.
    Teleport {
        /// Translation, in metres.
        translation: Vec3,
        /// Rotation to the left, in degrees.
        rotation: f64,
    },
    /// Filter ringing after a leading T-pose. The two frames after the T-pose overshoot and
    /// undershoot the motion. The T-pose floats above the ground, as in many recordings, so the
    /// first of the two frames dips below the ground.
    Ringing,
}

/// Period of the platform's forward motion, in seconds.
const PLATFORM_PERIOD: f64 = 7.0;

/// Vertical amplitude of the platform, in metres, and its frequency relative to the forward motion.
const PLATFORM_HEAVE: (f64, f64) = (0.06, 1.7);

/// Height of the leading T-pose above the ground, in metres.
const T_POSE_HEIGHT: f64 = 0.3;

/// Overshoot of the frames after a T-pose, as fractions of the jump.
const RINGING: [f64; 2] = [0.13, -0.05];

impl Environment {
    /// Applies the environment to poses that are `frame_time` seconds apart.
    pub fn apply(self, poses: &mut [Pose], frame_time: f64) {
        let count = poses.len();
        let timed = || (0..count).map(|frame| frame as f64 * frame_time);
        match self {
            Environment::Level => {}
            Environment::Slope(degrees) => {
                let tilt = rotation_about(0, -degrees.to_radians());
                for pose in poses {
                    pose.root = tilt * pose.root;
                    pose.set_rotation(Bone::Hips, tilt * pose.rotation(Bone::Hips));
                }
            }
            Environment::Treadmill(speed) => {
                for (pose, time) in poses.iter_mut().zip(timed()) {
                    pose.root.z -= speed * time;
                }
            }
            Environment::Platform(speed) => {
                let amplitude = speed * PLATFORM_PERIOD / TAU;
                for (pose, time) in poses.iter_mut().zip(timed()) {
                    let phase = TAU * time / PLATFORM_PERIOD;
                    pose.root.z += amplitude * libm::sin(phase);
                    pose.root.y += PLATFORM_HEAVE.0 * libm::sin(PLATFORM_HEAVE.1 * phase);
                }
            }
            Environment::Teleport { translation, rotation } => {
                teleport(&mut poses[count / 2..], translation, rotation)
            }
            Environment::Ringing => add_ringing(poses),
        }
    }

    /// Returns the height of the ground in metres, or `None` if it is not constant.
    pub fn ground_height(self) -> Option<f64> {
        match self {
            Environment::Slope(_) | Environment::Platform(_) => None,
            _ => Some(0.0),
        }
    }
}

/// Translates poses and rotates them about the root of the first.
fn teleport(poses: &mut [Pose], translation: Vec3, rotation: f64) {
    let Some(first) = poses.first() else { return };
    let (centre, rotation) = (first.root, rotation_about(1, rotation.to_radians()));
    for pose in poses {
        pose.root = centre + rotation * (pose.root - centre) + translation;
        pose.set_rotation(Bone::Hips, rotation * pose.rotation(Bone::Hips));
    }
}

fn add_ringing(poses: &mut [Pose]) {
    let [lead_in, rest @ ..] = poses else { return };
    lead_in.root.y += T_POSE_HEIGHT;
    for (pose, fraction) in rest.iter_mut().zip(RINGING) {
        pose.root += fraction * (pose.root - lead_in.root);
        for bone in Bone::all() {
            pose.set_rotation(bone, nlerp(&pose.rotation(bone), &lead_in.rotation(bone), -fraction));
        }
    }
}
