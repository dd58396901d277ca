//! Body proportions.

/// Body dimensions, in metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Proportions {
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

impl Proportions {
    /// Creates average proportions of a body of `height` metres, with leg lengths and shoulder
    /// width multiplied by the factors `legs` and `shoulders`.
    pub fn new(height: f64, legs: f64, shoulders: f64) -> Proportions {
        Proportions {
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

    /// Returns the length from hip to ankle with a straight knee.
    pub fn leg_length(&self) -> f64 {
        self.thigh + self.shank
    }

    /// Returns the height of the pelvis joint above the hip joints.
    pub fn pelvis_above_hips(&self) -> f64 {
        0.15 * self.hip
    }

    /// Returns the height of the pelvis joint in relaxed standing, knees slightly bent.
    pub fn standing_height(&self) -> f64 {
        self.ankle + 0.984 * self.leg_length() + self.pelvis_above_hips()
    }

    /// Returns the scale of movements relative to a person of average size.
    pub fn scale(&self) -> f64 {
        self.leg_length() / 0.85
    }
}
