//! Pose of the pelvis.

use crate::math::{Rot, Vec3};

/// Pose of the pelvis, with the quantities that drive the upper body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PelvisPose {
    /// Position of the pelvis joint, in metres.
    pub position: Vec3,
    /// Orientation.
    pub rotation: Rot,
    /// Heading of the body to the left, in radians.
    pub heading: f64,
    /// Distance that the left foot is ahead of the right, in metres.
    pub stride: f64,
    /// Load on the left foot minus that on the right, as fractions of the total.
    pub balance: f64,
}
