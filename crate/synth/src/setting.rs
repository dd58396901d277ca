//! What becomes of a motion as a whole: where it takes place, and what its recording
//! does to it.
//!
//! Whole bodies are moved and turned, so bones stay as long as they are, and the truth
//! stays what the plan says: still against the ground that the foot stands on.

use std::f64::consts::TAU;

use crate::character::Bone;
use crate::maths::{Vec3, between, turn};
use crate::pose::Pose;

/// What happens to the poses of a clip before they are written.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Setting {
    /// Nothing: level ground at rest.
    #[default]
    Level,
    /// The ground rises ahead, by so many degrees. The body is turned with the ground:
    /// the motion itself has to lean into it.
    Slope(f64),
    /// A belt carries the ground back, at so many metres per second.
    Belt(f64),
    /// A platform carries the ground to and fro and up and down; its greatest speed ahead
    /// is so many metres per second.
    Platform(f64),
    /// In the middle of the clip the body is all at once somewhere else.
    Teleport {
        /// By how much it moved, in metres.
        by: Vec3,
        /// By how much it turned to the left, in degrees.
        turned: f64,
    },
    /// The filter of the recording rings after the T-pose that the clip begins with: the
    /// two frames after it swing past the motion and back. The T-pose hangs above the
    /// ground, as it often does, so the first of them dips below it.
    Ringing,
}

/// Seconds in which the platform comes back.
const PERIOD: f64 = 7.0;

/// Rise and fall of the platform, in metres, and how often while it goes once to and fro.
const HEAVE: (f64, f64) = (0.06, 1.7);

/// Height of a T-pose above the ground, in metres.
const HANGING: f64 = 0.3;

/// How far the frames after a T-pose swing past the motion, as shares of the jump.
const RINGS: [f64; 2] = [0.13, -0.05];

impl Setting {
    /// Applies the setting to poses that are `frame_time` seconds apart.
    pub fn apply(self, poses: &mut [Pose], frame_time: f64) {
        let count = poses.len();
        let timed = || (0..count).map(|frame| frame as f64 * frame_time);
        match self {
            Setting::Level => {}
            Setting::Slope(degrees) => {
                let tilt = turn(0, -degrees.to_radians());
                for pose in poses {
                    pose.root = tilt * pose.root;
                    pose.set(Bone::Hips, tilt * pose.turn(Bone::Hips));
                }
            }
            Setting::Belt(speed) => {
                for (pose, time) in poses.iter_mut().zip(timed()) {
                    pose.root.z -= speed * time;
                }
            }
            Setting::Platform(speed) => {
                let way = speed * PERIOD / TAU;
                for (pose, time) in poses.iter_mut().zip(timed()) {
                    let phase = TAU * time / PERIOD;
                    pose.root.z += way * libm::sin(phase);
                    pose.root.y += HEAVE.0 * libm::sin(HEAVE.1 * phase);
                }
            }
            Setting::Teleport { by, turned } => teleport(&mut poses[count / 2..], by, turned),
            Setting::Ringing => ring(poses),
        }
    }

    /// Height of the ground in metres, where it has one height.
    pub fn floor(self) -> Option<f64> {
        match self {
            Setting::Slope(_) | Setting::Platform(_) => None,
            _ => Some(0.0),
        }
    }
}

/// Puts poses elsewhere, turned about where the first of them is.
fn teleport(poses: &mut [Pose], by: Vec3, turned: f64) {
    let Some(first) = poses.first() else { return };
    let (centre, turned) = (first.root, turn(1, turned.to_radians()));
    for pose in poses {
        pose.root = centre + turned * (pose.root - centre) + by;
        pose.set(Bone::Hips, turned * pose.turn(Bone::Hips));
    }
}

fn ring(poses: &mut [Pose]) {
    let [lead_in, rest @ ..] = poses else { return };
    lead_in.root.y += HANGING;
    for (pose, share) in rest.iter_mut().zip(RINGS) {
        pose.root += share * (pose.root - lead_in.root);
        for bone in Bone::all() {
            pose.set(bone, between(&pose.turn(bone), &lead_in.turn(bone), -share));
        }
    }
}
