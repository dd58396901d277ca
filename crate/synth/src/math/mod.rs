//! Vectors, rotations, keyframes, filters and random numbers with reproducible results.
//!
//! Trigonometric functions come from `libm` instead of the platform's library, so that results are
//! identical on all machines.

mod ease;
mod filter;
mod random;
mod time_grid;
mod track;

pub use ease::{bump, ease_in_out, hermite, smooth_rise, smooth_step};
pub use filter::{gaussian_blur, smooth_noise};
pub use random::Random;
pub use time_grid::{GRID_RATE, TimeGrid};
pub use track::{Keyframe, Track};

use nalgebra::{Matrix3, Quaternion, Rotation3, Unit, UnitQuaternion, Vector3};

/// Point or direction in metres: x left, y up, z forward.
pub type Vec3 = Vector3<f64>;

/// Rotation.
pub type Rot = UnitQuaternion<f64>;

/// Standard gravity, in m/s².
pub const GRAVITY: f64 = 9.81;

/// Returns the rotation by `angle` radians about coordinate axis 0, 1 or 2.
pub fn rotation_about(axis: usize, angle: f64) -> Rot {
    let (sin, cos) = libm::sincos(angle / 2.0);
    let mut vector = Vec3::zeros();
    vector[axis] = sin;
    Unit::new_unchecked(Quaternion::from_parts(cos, vector))
}

/// Returns the rotation about the vertical axis by `heading` radians to the left.
pub fn heading_rotation(heading: f64) -> Rot {
    rotation_about(1, heading)
}

/// Returns the horizontal unit vector along `heading`.
pub fn forward(heading: f64) -> Vec3 {
    let (sin, cos) = libm::sincos(heading);
    Vec3::new(sin, 0.0, cos)
}

/// Returns the horizontal unit vector to the left of `heading`.
pub fn leftward(heading: f64) -> Vec3 {
    let (sin, cos) = libm::sincos(heading);
    Vec3::new(cos, 0.0, -sin)
}

/// Returns the smallest rotation that takes the unit vector `from` to `to`.
pub fn rotation_between(from: Vec3, to: Vec3) -> Rot {
    let scalar = (1.0 + from.dot(&to)).max(1e-9);
    normalised(Quaternion::from_parts(scalar, from.cross(&to)))
}

/// Returns the rotation whose matrix has these orthonormal columns.
pub fn from_columns(x: Vec3, y: Vec3, z: Vec3) -> Rot {
    let matrix = Rotation3::from_matrix_unchecked(Matrix3::from_columns(&[x, y, z]));
    Rot::from_rotation_matrix(&matrix)
}

/// Interpolates between two rotations along the shorter arc by normalised linear interpolation:
/// exact at `t` = 0, ½ and 1.
pub fn nlerp(a: &Rot, b: &Rot, t: f64) -> Rot {
    let sign = if a.coords.dot(&b.coords) < 0.0 { -1.0 } else { 1.0 };
    normalised(a.into_inner() * (1.0 - t) + b.into_inner() * (t * sign))
}

fn normalised(quaternion: Quaternion<f64>) -> Rot {
    Unit::new_unchecked(quaternion / quaternion.coords.dot(&quaternion.coords).sqrt())
}

/// Linear interpolation: `a` + `t` × (`b` − `a`).
pub fn lerp(a: f64, b: f64, t: f64) -> f64 {
    a + (b - a) * t
}
