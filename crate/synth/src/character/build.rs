//! The proportions of a body.

/// Lengths of a body, in metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Build {
    /// Hip to knee.
    pub thigh: f64,
    /// Knee to ankle.
    pub shank: f64,
    /// Ankle above the sole.
    pub ankle: f64,
    /// Ball of the foot (the toe joint) above the sole.
    pub ball: f64,
    /// Ankle to ball, along the foot.
    pub instep: f64,
    /// Ball to the tip of the toes.
    pub toes: f64,
    /// Ankle back to the edge of the heel.
    pub heel: f64,
    /// Centre line to hip joint.
    pub hip: f64,
    /// Pelvis joint to the joint at the base of the neck.
    pub trunk: f64,
    /// Centre line to shoulder joint.
    pub shoulder: f64,
    /// Shoulder to elbow.
    pub upper_arm: f64,
    /// Elbow to wrist.
    pub forearm: f64,
    /// Wrist to fingertips.
    pub hand: f64,
    /// Base of the neck to the top of the head.
    pub head: f64,
}

impl Build {
    /// A body of `height` metres with average proportions, the legs longer by the
    /// factor `legs` and the shoulders broader by the factor `shoulders`.
    pub fn new(height: f64, legs: f64, shoulders: f64) -> Build {
        Build {
            thigh: 0.242 * height * legs,
            shank: 0.243 * height * legs,
            ankle: 0.046 * height,
            ball: 0.014 * height,
            instep: 0.076 * height,
            toes: 0.042 * height,
            heel: 0.026 * height,
            hip: 0.053 * height,
            trunk: 0.288 * height,
            shoulder: 0.108 * height * shoulders,
            upper_arm: 0.166 * height,
            forearm: 0.146 * height,
            hand: 0.100 * height,
            head: 0.178 * height,
        }
    }

    /// Hip to ankle with a straight knee.
    pub fn leg(&self) -> f64 {
        self.thigh + self.shank
    }

    /// How far the pelvis joint lies above the hip joints.
    pub fn pelvis_rise(&self) -> f64 {
        0.15 * self.hip
    }

    /// Height of the pelvis joint in easy standing, the knees hardly bent.
    pub fn standing(&self) -> f64 {
        self.ankle + 0.984 * self.leg() + self.pelvis_rise()
    }

    /// Lengths of movements relative to a person of average size.
    pub fn scale(&self) -> f64 {
        self.leg() / 0.85
    }
}
