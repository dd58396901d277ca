//! How the body is carried, as one pose of its tracks.

use super::Actor;
use crate::plan::ArmStyle;

/// One key of each track of the [`Body`](crate::plan::Body). Angles in degrees, lengths in
/// metres for an average body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Carriage {
    /// How far the pelvis is lowered.
    pub sink: f64,
    /// The trunk: forward, left turn, lean to the left.
    pub trunk: [f64; 3],
    /// The pelvis: forward tilt, left turn, lean to the left.
    pub pelvis: [f64; 3],
    /// Shift of the pelvis: left, forward.
    pub shift: [f64; 2],
    /// Where the eyes go: left, down.
    pub look: [f64; 2],
    /// The left arm and the right.
    pub arms: [[f64; 5]; 2],
    /// Swing of the arms with the steps, in degrees per metre.
    pub arm_swing: f64,
}

impl Default for Carriage {
    /// Standing at ease, as a plan begins.
    fn default() -> Carriage {
        Carriage {
            sink: 0.0,
            trunk: [3.0, 0.0, 0.0],
            pelvis: [2.0, 0.0, 0.0],
            shift: [0.0, 0.0],
            look: [0.0, 4.0],
            arms: [ArmStyle::LOOSE.angles(); 2],
            arm_swing: 30.0,
        }
    }
}

impl Carriage {
    /// The same with both arms like `arm`.
    pub fn with_arms(self, arm: [f64; 5]) -> Carriage {
        Carriage { arms: [arm; 2], ..self }
    }

    /// The same with the trunk bent forward and the pelvis tilted with it.
    pub fn bent(self, pitch: f64) -> Carriage {
        Carriage { trunk: [pitch, 0.0, 0.0], pelvis: [0.35 * pitch, 0.0, 0.0], ..self }
    }

    /// The same with the pelvis lowered by `sink`.
    pub fn sunk(self, sink: f64) -> Carriage {
        Carriage { sink, ..self }
    }
}

impl Actor<'_> {
    /// The body is carried so at `time`.
    pub fn carry(&mut self, time: f64, carriage: &Carriage) {
        let scale = self.scale;
        let body = self.planner.body();
        body.sink.key(time, [carriage.sink * scale]);
        body.trunk.key(time, carriage.trunk);
        body.pelvis.key(time, carriage.pelvis);
        body.shift.key(time, carriage.shift.map(|shift| shift * scale));
        body.look.key(time, carriage.look);
        for (arm, angles) in body.arms.iter_mut().zip(carriage.arms) {
            arm.key(time, angles);
        }
        body.arm_swing.key(time, [carriage.arm_swing]);
    }

    /// Goes through poses `after` seconds from now, from ease to ease; `seconds` later the
    /// actor is at ease again.
    pub fn go_through(&mut self, poses: &[(f64, Carriage)], seconds: f64) {
        let begin = self.now();
        self.carry(begin, &Carriage::default());
        for (after, carriage) in poses {
            self.carry(begin + after, carriage);
        }
        self.wait(seconds);
        self.carry(self.now(), &Carriage::default());
    }
}
