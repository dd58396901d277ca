//! Static postures of the body.

use super::Actor;
use crate::plan::ArmPose;

/// One keyframe for every track of [`BodyTracks`](crate::plan::BodyTracks). Angles in degrees; lengths in metres for an
/// average body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Posture {
    /// Lowering of the pelvis.
    pub lowering: f64,
    /// Trunk: forward pitch, left rotation, left lean.
    pub trunk: [f64; 3],
    /// Pelvis: forward tilt, left rotation, left lean.
    pub pelvis: [f64; 3],
    /// Horizontal shift of the pelvis: left, forward.
    pub shift: [f64; 2],
    /// Gaze direction: left, down.
    pub gaze: [f64; 2],
    /// Left and right arm; see [`ArmPose`](crate::plan::ArmPose).
    pub arms: [[f64; 5]; 2],
    /// Arm swing with the steps, in degrees per metre of stride.
    pub arm_swing: f64,
}

impl Default for Posture {
    /// Relaxed standing, the posture at the start of a plan.
    fn default() -> Posture {
        Posture {
            lowering: 0.0,
            trunk: [3.0, 0.0, 0.0],
            pelvis: [2.0, 0.0, 0.0],
            shift: [0.0, 0.0],
            gaze: [0.0, 4.0],
            arms: [ArmPose::RELAXED.angles(); 2],
            arm_swing: 30.0,
        }
    }
}

impl Posture {
    /// Returns the posture with both arms in the pose `arm`.
    pub fn with_arms(self, arm: [f64; 5]) -> Posture {
        Posture { arms: [arm; 2], ..self }
    }

    /// Returns the posture with the trunk pitched forward and the pelvis tilted accordingly.
    pub fn bent_forward(self, pitch: f64) -> Posture {
        Posture { trunk: [pitch, 0.0, 0.0], pelvis: [0.35 * pitch, 0.0, 0.0], ..self }
    }

    /// Returns the posture with the pelvis lowered by `lowering`.
    pub fn lowered(self, lowering: f64) -> Posture {
        Posture { lowering, ..self }
    }
}

impl Actor<'_> {
    /// Sets a keyframe of the posture at `time`.
    pub fn set_posture(&mut self, time: f64, posture: &Posture) {
        let scale = self.scale;
        let body = self.planner.body();
        body.lowering.set_key(time, [posture.lowering * scale]);
        body.trunk.set_key(time, posture.trunk);
        body.pelvis.set_key(time, posture.pelvis);
        body.shift.set_key(time, posture.shift.map(|shift| shift * scale));
        body.gaze.set_key(time, posture.gaze);
        for (arm, angles) in body.arms.iter_mut().zip(posture.arms) {
            arm.set_key(time, angles);
        }
        body.arm_swing.set_key(time, [posture.arm_swing]);
    }

    /// Plays postures at times relative to now. The actor starts in the relaxed posture and returns
    /// to it after `seconds`.
    pub fn play_postures(&mut self, poses: &[(f64, Posture)], seconds: f64) {
        let start = self.now();
        self.set_posture(start, &Posture::default());
        for (after, posture) in poses {
            self.set_posture(start + after, posture);
        }
        self.wait(seconds);
        self.set_posture(self.now(), &Posture::default());
    }
}
